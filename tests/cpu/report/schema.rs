//! `docs/schemas/file-1.json` describes the sidecars that are written.

use super::json_schema::faults;
use super::*;
use corput::report::{SIDECAR_SCHEMA, Sidecar};

fn check(document: &Value) -> Vec<String> {
    let text = include_str!("../../../docs/schemas/file-1.json");
    let schema: Value = serde_json::from_str(text).unwrap();
    faults(&schema, &schema, document, "")
}

fn sidecar(format: Format, rows: u64) -> (Value, Sidecar) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p");
    let words = vec![7; rows as usize];
    save(&path, format, layout(rows, 1, Element::U32), &[&words]).unwrap();
    let text = fs::read(Sidecar::path_of(&path)).unwrap();
    let read = Sidecar::of(&path).unwrap();
    (serde_json::from_slice(&text).unwrap(), read)
}

#[test]
fn sidecars_are_as_the_schema_says_and_read_back() {
    for format in FORMATS {
        for rows in [0, 1, 5] {
            let (document, read) = sidecar(format, rows);
            assert_eq!(check(&document), Vec::<String>::new());
            assert_eq!(read.origin.arguments, json!({ "count": rows }));
            assert_eq!(
                (read.format, read.layout),
                (format, layout(rows, 1, Element::U32))
            );
            assert_eq!(read.chunks.len(), usize::from(rows > 0));
            assert_eq!(document["schema"], SIDECAR_SCHEMA);
        }
    }
}

#[test]
fn broken_sidecars_are_not() {
    let (whole, _) = sidecar(Format::Npy, 5);
    let breaks = [
        ("/schema", json!("corput-file/0")),
        ("/format", json!("zip")),
        ("/type", json!("<i4")),
        ("/shape", json!([5])),
        ("/shape/0", json!("5")),
        ("/bytes", json!(-1)),
        ("/chunks/0/bytes", json!("20")),
        ("/chunks/0/sha256", json!(null)),
        ("/sha256", json!(5)),
        ("/version", json!(1)),
        ("/chunk_rows", json!(1.5)),
    ];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.npy");
    let refused = |document: &Value, place: &str| {
        assert_ne!(check(document), Vec::<String>::new(), "{place}");
        fs::write(Sidecar::path_of(&path), document.to_string()).unwrap();
        let error = Sidecar::of(&path).unwrap_err();
        assert_eq!(error.exit_code(), 2, "{place}: {error}");
        let name = place.split('/').find(|name| !name.is_empty()).unwrap();
        assert!(error.to_string().contains(name), "{place}: {error}");
    };
    for (place, value) in breaks {
        let mut broken = whole.clone();
        *broken.pointer_mut(place).unwrap() = value;
        refused(&broken, place);
    }
    for name in whole.as_object().unwrap().keys() {
        let mut broken = whole.clone();
        broken.as_object_mut().unwrap().remove(name);
        refused(&broken, name);
    }
    for text in ["", "{", "[]", "null"] {
        fs::write(Sidecar::path_of(&path), text).unwrap();
        assert_eq!(Sidecar::of(&path).unwrap_err().exit_code(), 2, "`{text}`");
    }
    fs::remove_file(Sidecar::path_of(&path)).unwrap();
    let message = Sidecar::of(&path).unwrap_err().to_string();
    assert!(
        message.contains("p.npy.json") && message.contains("beside it"),
        "{message}"
    );
}
