//! Where two JSON documents differ.

use serde_json::{Map, Value};

/// A member that is not the same in both.
pub(crate) struct Difference {
    /// Its name, after those of the objects that hold it.
    pub(crate) path: String,
    /// Its values; null where it is missing.
    pub(crate) there: Value,
    pub(crate) here: Value,
}

/// Every member that differs: those of `there` first, in their order.
pub(crate) fn differences(there: &Value, here: &Value) -> Vec<Difference> {
    let mut found = Vec::new();
    walk("", there, here, &mut found);
    found
}

fn walk(path: &str, there: &Value, here: &Value, found: &mut Vec<Difference>) {
    let (Value::Object(left), Value::Object(right)) = (there, here) else {
        if there != here {
            found.push(Difference {
                path: match path {
                    "" => "the document".to_owned(),
                    path => path.to_owned(),
                },
                there: there.clone(),
                here: here.clone(),
            });
        }
        return;
    };
    let more = right.keys().filter(|name| !left.contains_key(*name));
    for name in left.keys().chain(more) {
        let of = |map: &Map<String, Value>| map.get(name).cloned().unwrap_or_default();
        let path = match path {
            "" => name.clone(),
            path => format!("{path}.{name}"),
        };
        walk(&path, &of(left), &of(right), found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn paths(there: Value, here: Value) -> Vec<String> {
        let found = differences(&there, &here);
        found.into_iter().map(|one| one.path).collect()
    }

    #[test]
    fn every_member_that_differs_is_named() {
        let there = json!({ "a": 1, "b": { "c": [1, 2], "d": null }, "e": 5 });
        assert!(paths(there.clone(), there.clone()).is_empty());
        let here = json!({ "a": 2, "b": { "c": [1], "f": 1 }, "e": 5 });
        assert_eq!(paths(there.clone(), here), ["a", "b.c", "b.f"]);
        assert_eq!(paths(there.clone(), json!({})), ["a", "b", "e"]);
        assert_eq!(paths(there, json!(3)), ["the document"]);
    }
}
