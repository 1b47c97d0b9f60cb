//! Every reviewed SARIF log satisfies the schema. That the command writes these logs, `tests/integration/verdict.rs` shows.

use std::fs;
use std::path::Path;

use serde_json::Value;

fn json(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// REQ-CHECK-004
#[test]
fn logs_when_held_to_the_schema_then_they_satisfy_it_and_a_broken_one_does_not() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut schema = json(&here.join("schema/sarif-2.1.0.json"));
    // The published pattern of these members has a bracket too many, which is no regular expression to a strict reader.
    for holder in ["run", "toolComponent"] {
        schema["definitions"][holder]["properties"]["language"]["pattern"] = "^[a-zA-Z]{2}(-[a-zA-Z]{2})?$".into();
    }
    let validator = jsonschema::validator_for(&schema).unwrap();
    let logs: Vec<_> = fs::read_dir(here.join("../verdict"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "sarif"))
        .collect();
    assert!(logs.len() >= 4, "{logs:?}");
    for path in logs {
        let mut log = json(&path);
        let wrong: Vec<String> = validator.iter_errors(&log).map(|error| error.to_string()).collect();
        assert!(wrong.is_empty(), "{}: {wrong:#?}", path.display());
        log["runs"][0]["tool"]["driver"]["name"] = Value::Null;
        assert!(!validator.is_valid(&log), "the schema is not looked at");
    }
}
