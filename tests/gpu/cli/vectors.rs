//! `corput vectors`.

use super::Desk;
use super::refused::assert_refused;
use serde_json::Value;

/// A sequence's file is what its command makes.
#[test]
fn published_points_are_made_again_by_their_commands() {
    let desk = Desk::new();
    let said = desk.say("vectors --out v");
    assert!(said.contains("vectors.json"), "{said}");
    let manifest: Value = serde_json::from_slice(&desk.bytes("v/vectors.json")).unwrap();
    let mut made = 0;
    for entry in manifest["entries"].as_array().unwrap() {
        if let Some(command) = entry["command"].as_str() {
            let line = command.strip_prefix("corput ").unwrap();
            desk.say(&format!("{line} --device cpu --out p.npy"));
            let file = entry["table"]["file"].as_str().unwrap();
            assert!(
                desk.bytes("p.npy") == desk.bytes(&format!("v/{file}")),
                "{command}"
            );
            made += 1;
        }
    }
    assert!(made >= 14, "{made}");
}

#[test]
fn a_folder_that_cannot_be_made_is_refused() {
    assert_refused("vectors --out file/below", &["file/below", "folder"]);
}
