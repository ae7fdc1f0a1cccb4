//! The parts of the machine: signals, blocks, omissions, faults, planes and parameters.

use serde_json::json;

use crate::home::{Scene, ok};

#[test]
fn the_machine_tells_its_parts() {
    let mut session = Scene::by("pra-nominal").session();
    let signals = ok(&mut session, json!({ "do": "signals" }));
    let signals = signals["signals"].as_array().unwrap();
    let height = signals.iter().find(|row| row["name"] == "mu.height").unwrap();
    assert_eq!(
        (height["block"].as_str(), height["unit"].as_str(), height["is_wired"].as_bool()),
        (Some("mixing-unit"), Some("m"), Some(true))
    );
    let blocks = ok(&mut session, json!({ "do": "blocks" }));
    let blocks = blocks["blocks"].as_array().unwrap();
    let of = |name: &str| blocks.iter().find(|row| row["name"] == name).unwrap();
    // The scene has neither craters nor texture.
    assert_eq!(
        [of("mixing-unit"), of("texture-generator")].map(|row| row["left_out"].as_bool().unwrap()),
        [false, true]
    );
    let count: usize = blocks.iter().map(|row| row["signals"].as_array().unwrap().len()).sum();
    assert_eq!(count, signals.len());
    let omissions = ok(&mut session, json!({ "do": "omissions" }));
    assert!(
        omissions["omissions"]
            .as_array()
            .unwrap()
            .iter()
            .any(|row| row["block"] == "texture-generator" && row["why"].is_string())
    );
    let faults = ok(&mut session, json!({ "do": "faults" }));
    let tear = faults["faults"].as_array().unwrap().iter().find(|row| row["name"] == "tear").unwrap();
    assert_eq!(
        (&tear["keys"], &tear["proves"]),
        (&json!({ "loader.access_ns": 300 }), &json!("A1, tears; their crowding towards corners is A4"))
    );
    let planes = ok(&mut session, json!({ "do": "planes" }));
    assert_eq!(planes["planes"][0], "picture");
}

#[test]
fn parameters_have_values_units_ranges_and_sources() {
    let mut session = Scene::by("pra-nominal").session();
    ok(&mut session, json!({ "do": "set", "set": { "loader.access_ns": 123.5 } }));
    let told = ok(&mut session, json!({ "do": "parameters" }));
    let rows = told["parameters"].as_array().unwrap();
    let of = |key: &str| rows.iter().find(|row| row["key"] == key).unwrap_or_else(|| panic!("{key}"));
    let access = of("loader.access_ns");
    assert_eq!((access["value"].as_f64(), access["kind"].as_str()), (Some(123.5), Some("number")));
    assert!(access["source"].as_str().unwrap().contains("--set"), "{access}");
    assert!(access["low"].is_number(), "{access}");
    assert!(rows.iter().any(|row| row["source"].as_str().unwrap().contains("pra-nominal.toml:")));
    assert!(rows.iter().any(|row| row["kind"] == "word" && row["words"].as_array().unwrap().len() > 1));
    assert!(rows.iter().filter(|row| row["low"].is_number()).count() > 50);
}
