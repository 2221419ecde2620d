//! A folder that reports are written into, one after the other.

use super::page::estimators;
use super::plain;

/// A folder that has a report gets another: old figures go, what is not ours stays.
#[test]
fn figures_of_an_earlier_report_go() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let names = || {
        let entries = std::fs::read_dir(folder.path()).unwrap();
        let names = entries.map(|one| one.unwrap().file_name().into_string().unwrap());
        names.collect::<std::collections::BTreeSet<String>>()
    };
    corput::converge::write(&estimators(), folder.path()).unwrap();
    assert!(path("01-light-mis-time.svg").exists() && names().len() == 15);
    let own = ["02-own-time.svg", "thesis.png", "unfinished.jsonl"];
    for name in own {
        std::fs::write(path(name), "mine").unwrap();
    }
    let files = corput::converge::write(&plain(), folder.path()).unwrap();
    let ours = files
        .iter()
        .map(|file| file.file_name().unwrap().to_str().unwrap());
    let expected = ours.chain(own).map(str::to_owned);
    assert_eq!(names(), expected.collect());
    // Names that are no figure's are not believed, nor is a document of another form.
    let text = std::fs::read_to_string(path("results.json")).unwrap();
    let named = text.replace("\"01-one-time.svg\"", "\"thesis.png\",\"01-one-time.svg\"");
    assert_ne!(named, text);
    std::fs::write(path("results.json"), &named).unwrap();
    corput::converge::write(&estimators(), folder.path()).unwrap();
    assert!(path("thesis.png").exists() && !path("01-one-time.svg").exists());
    let text = std::fs::read_to_string(path("results.json")).unwrap();
    let other = text.replace("corput-converge/", "something-else/");
    std::fs::write(path("results.json"), other).unwrap();
    corput::converge::write(&plain(), folder.path()).unwrap();
    assert!(path("01-light-mis-time.svg").exists());
}
