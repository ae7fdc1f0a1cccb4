//! `lunoid cartridge`: tables, JSON, JUnit, other people's folders, exit codes.

use std::fs;

use serde_json::Value;

use crate::scene::Scene;

const LAG: &str = include_str!("../../../../../tests/cartridges/lag-step/cartridge.toml");

/// A folder `mine` with one cartridge.
fn folder(text: &str) -> Scene {
    let scene = Scene::new();
    fs::create_dir_all(scene.join("mine/lag")).unwrap();
    scene.write("mine/lag/cartridge.toml", text);
    scene
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn some_of_those_that_the_program_carries() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["cartridge", "run", "two-pole-*", "--junit", "c.xml"]);
    assert!(out.starts_with("cartridge      engine  reading  found"), "{out}");
    assert!(out.contains("two-pole-fold  part    output   "), "{out}");
    assert!(out.contains("2 of 2 cartridges passed, 2 answers; 4 of 4 overlays caught"), "{out}");
    let xml = fs::read_to_string(scene.join("c.xml")).unwrap();
    assert!(xml.contains("<testcase classname=\"cartridges\" name=\"two-pole-step\"/>"), "{xml}");

    let (out, _) = scene.expect(0, &["cartridge", "run", "late-word", "--json", "--jobs", "1"]);
    let document = json(&out);
    assert_eq!(document["schema"], "lunoid.cartridge.run/1");
    assert_eq!(document["summary"]["passed"], 1);
    let answer = &document["cartridges"][0]["answers"][0];
    assert_eq!((&answer["engine"], &answer["passed"]), (&Value::from("machine-f64"), &Value::from(true)));
    assert!(answer["derivation"].as_str().unwrap().contains("row 6"), "{answer}");
    let (again, _) = scene.expect(0, &["cartridge", "run", "late-word", "--json", "--jobs", "3"]);
    assert_eq!(out, again);

    let (_, err) = scene.expect(2, &["cartridge", "run", "no-such-*"]);
    assert!(err.contains("no-such-*: no cartridge has such a name"), "{err}");
}

#[test]
fn lists_and_schema() {
    let scene = Scene::new();
    let (out, _) = scene.expect(0, &["cartridge", "list"]);
    assert!(out.lines().count() > 30 && out.contains("crater-shadow"), "{out}");
    let (out, _) = scene.expect(0, &["cartridge", "list", "drum*", "--json"]);
    let document = json(&out);
    assert_eq!(document["cartridges"][0]["name"], "drum-wait");
    assert_eq!(document["cartridges"][0]["engines"][0], "part");
    let (out, _) = scene.expect(0, &["cartridge", "schema"]);
    assert_eq!(json(&out)["title"], "Cartridge");
}

#[test]
fn a_folder_of_ones_own() {
    let scene = folder(LAG);
    let (out, _) = scene.expect(0, &["cartridge", "run", "--folder", "mine"]);
    assert!(out.contains("1 of 1 cartridges passed"), "{out}");

    // Wrong, and deaf.
    let scene = folder(&LAG.replace("tolerance = 1e-14", "tolerance = 0.0"));
    let (out, _) = scene.expect(1, &["cartridge", "run", "--folder", "mine", "--junit", "c.xml"]);
    assert!(out.contains("WRONG") && out.contains("0 of 1 cartridges passed"), "{out}");
    assert!(out.contains("lag, output on part: output after step"), "{out}");
    assert!(fs::read_to_string(scene.join("c.xml")).unwrap().contains("failures=\"1\""));
    let scene = folder(&LAG.replace("tolerance = 1e-14", "tolerance = 1e3"));
    let (out, _) = scene.expect(1, &["cartridge", "run", "--folder", "mine"]);
    assert!(out.contains("0 of 2 overlays caught") && out.contains("lag does not notice on part"), "{out}");
}

#[test]
fn bad_input_is_one_error_with_its_place() {
    let scene = folder(&LAG.replace("part = \"lag\"", "part = \"leg\""));
    let (_, err) = scene.expect(3, &["cartridge", "run", "--folder", "mine"]);
    assert!(err.starts_with("error: mine/lag/cartridge.toml: ") && err.contains("leg"), "{err}");
    assert_eq!(err.lines().count(), 1, "{err}");
    let (_, err) = scene.expect(3, &["cartridge", "list", "--folder", "nowhere"]);
    assert!(err.contains("error: nowhere: cannot read this folder"), "{err}");
    let (_, err) = scene.expect(4, &["cartridge", "run", "--junit", "mine"]);
    assert!(err.contains("mine: this is a folder"), "{err}");
    let folder = folder("format = 2\n");
    folder.expect(3, &["cartridge", "run", "--folder", "mine"]);
}
