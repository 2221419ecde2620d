//! A validator that knows the words of JSON Schema which the schemas of `docs/schemas` use, and
//! refuses others.

use serde_json::{Value, json};

/// Where a value is not as its schema says.
pub fn faults(root: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (word, rule) in schema.as_object().expect("a schema is an object") {
        let number = |limit: &Value| value.as_f64().zip(limit.as_f64());
        let fault = match word.as_str() {
            "description" | "title" | "$schema" | "$id" | "$defs" => continue,
            "type" => {
                let types = rule.as_array().cloned().unwrap_or(vec![rule.clone()]);
                !types.iter().any(|one| is(value, one.as_str().unwrap()))
            }
            "const" => value != rule,
            "enum" => !rule.as_array().unwrap().contains(value),
            "minimum" => number(rule).is_some_and(|(value, limit)| value < limit),
            "maximum" => number(rule).is_some_and(|(value, limit)| value > limit),
            "exclusiveMinimum" => number(rule).is_some_and(|(value, limit)| value <= limit),
            "minItems" => value
                .as_array()
                .is_some_and(|items| (items.len() as u64) < rule.as_u64().unwrap()),
            "required" => {
                let names = rule.as_array().unwrap().iter();
                for name in names.filter_map(Value::as_str) {
                    if value.is_object() && value.get(name).is_none() {
                        found.push(format!("{at}: no {name}"));
                    }
                }
                false
            }
            "properties" => {
                for (name, schema) in rule.as_object().unwrap() {
                    if let Some(value) = value.get(name) {
                        found.extend(faults(root, schema, value, &format!("{at}/{name}")));
                    }
                }
                false
            }
            "additionalProperties" => {
                assert_eq!(rule, &json!(false));
                let known = schema["properties"].as_object().unwrap();
                let names = value.as_object().into_iter().flatten();
                names.into_iter().any(|(name, _)| !known.contains_key(name))
            }
            "items" => {
                for (index, item) in value.as_array().into_iter().flatten().enumerate() {
                    found.extend(faults(root, rule, item, &format!("{at}/{index}")));
                }
                false
            }
            "anyOf" => !rule
                .as_array()
                .unwrap()
                .iter()
                .any(|one| faults(root, one, value, at).is_empty()),
            "$ref" => {
                let place = rule.as_str().unwrap().strip_prefix('#').unwrap();
                let schema = root.pointer(place).expect("a definition");
                found.extend(faults(root, schema, value, at));
                false
            }
            other => panic!("the validator does not know `{other}`"),
        };
        if fault {
            found.push(format!("{at}: {word} {rule}"));
        }
    }
    found
}

fn is(value: &Value, kind: &str) -> bool {
    match kind {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("no type `{other}`"),
    }
}
