//! The file format: the schema, and what is refused.

use schemars::schema_for;
use serde_json::Value;

use crate::file::File;
use crate::folder::{CARRIED, SCHEMA, carried, of_folder};
use crate::{Cartridge, Summary, junit};

fn text_of(name: &str) -> &'static str {
    CARRIED.iter().find(|(carried, _)| *carried == name).map_or_else(|| panic!("{name}"), |(_, text)| *text)
}

/// What a cartridge with a change is refused for.
fn refused(name: &str, from: &str, to: &str) -> String {
    let text = text_of(name);
    assert!(text.contains(from), "{name} has no {from}");
    let parsed = Cartridge::parse(name, "some/cartridge.toml", &text.replacen(from, to, 1));
    parsed.expect_err("a refusal").to_string()
}

/// The committed schema is that of the structs. To write it anew:
/// `LUNOID_WRITE_SCHEMA=1 cargo test -p cartridge the_schema`.
#[test]
fn the_schema_is_that_of_the_structs() {
    let schema = serde_json::to_string_pretty(&schema_for!(File)).unwrap() + "\n";
    if std::env::var_os("LUNOID_WRITE_SCHEMA").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../tests/cartridges/cartridge.schema.json");
        std::fs::write(path, &schema).unwrap();
        return;
    }
    let other = SCHEMA.lines().zip(schema.lines()).find(|(committed, made)| committed != made);
    assert!(
        SCHEMA == schema,
        "tests/cartridges/cartridge.schema.json is of other structs; first of its lines: {other:?}"
    );
}

/// As much of JSON schema as the schema uses; what is wrong, with its place.
fn faults(schema: &Value, root: &Value, value: &Value, place: &str) -> Vec<String> {
    const KNOWN: [&str; 22] = [
        "$defs",
        "$ref",
        "$schema",
        "additionalProperties",
        "anyOf",
        "const",
        "default",
        "description",
        "enum",
        "format",
        "items",
        "maxItems",
        "minItems",
        "minimum",
        "oneOf",
        "properties",
        "required",
        "title",
        "type",
        "maximum",
        "unevaluatedProperties",
        "examples",
    ];
    let Some(schema) = schema.as_object() else { return Vec::new() };
    for key in schema.keys() {
        assert!(KNOWN.contains(&key.as_str()), "the schema uses {key}, which this test does not know");
    }
    let mut found = Vec::new();
    if let Some(name) = schema.get("$ref").and_then(Value::as_str) {
        let target = root.pointer(name.trim_start_matches('#')).unwrap_or_else(|| panic!("{name}"));
        found.extend(faults(target, root, value, place));
    }
    if let Some(choices) = schema.get("oneOf").or(schema.get("anyOf")).and_then(Value::as_array) {
        let all: Vec<Vec<String>> = choices.iter().map(|one| faults(one, root, value, place)).collect();
        let fitting = all.iter().filter(|faults| faults.is_empty()).count();
        if fitting == 0 {
            found.push(format!("{place}: fits none of {} choices: {:?}", choices.len(), all));
        }
    }
    if let Some(types) = schema.get("type") {
        let is = |name: &Value| match name.as_str().unwrap_or_default() {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "integer" => value.is_i64() || value.is_u64(),
            "number" => value.is_number(),
            "boolean" => value.is_boolean(),
            _ => value.is_null(),
        };
        let fits = types.as_array().map_or_else(|| is(types), |types| types.iter().any(is));
        if !fits {
            found.push(format!("{place}: expected {types}, found {value}"));
        }
    }
    if schema.get("const").is_some_and(|meant| meant != value)
        || schema.get("enum").and_then(Value::as_array).is_some_and(|words| !words.contains(value))
    {
        found.push(format!("{place}: {value} is none of the words"));
    }
    if let Some(object) = value.as_object() {
        let properties = schema.get("properties").and_then(Value::as_object);
        for key in schema.get("required").and_then(Value::as_array).into_iter().flatten() {
            if !object.contains_key(key.as_str().unwrap_or_default()) {
                found.push(format!("{place}: lacks {key}"));
            }
        }
        for (key, value) in object {
            match properties.and_then(|properties| properties.get(key)) {
                Some(below) => found.extend(faults(below, root, value, &format!("{place}.{key}"))),
                None if schema.get("additionalProperties") == Some(&Value::Bool(false)) => {
                    found.push(format!("{place}: no key {key}"));
                }
                None => {}
            }
        }
    }
    if let (Some(items), Some(values)) = (schema.get("items"), value.as_array()) {
        for (index, value) in values.iter().enumerate() {
            found.extend(faults(items, root, value, &format!("{place}[{index}]")));
        }
        let bound = |key: &str| schema.get(key).and_then(Value::as_u64).map(|count| count as usize);
        if bound("minItems").is_some_and(|least| values.len() < least)
            || bound("maxItems").is_some_and(|most| values.len() > most)
        {
            found.push(format!("{place}: {} items", values.len()));
        }
    }
    found
}

fn schema_faults(text: &str) -> Vec<String> {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let value: Value = toml::from_str(text).unwrap();
    faults(&schema, &schema, &value, "cartridge")
}

#[test]
fn every_cartridge_fits_the_schema() {
    for (name, text) in CARRIED {
        assert_eq!(schema_faults(text), Vec::<String>::new(), "{name}");
    }
}

#[test]
fn the_schema_refuses_what_the_reader_refuses() {
    for (from, to) in [
        ("albedo =", "albido ="),
        ("title =", "titel ="),
        ("kind = \"brightness\"", "kind = \"darkness\""),
        ("first_line = 165", "first_line = \"165\""),
        ("eye_m = [7900.0, 8300.0, 9.0]", "eye_m = [7900.0, 8300.0]"),
        ("engines = [\"machine-f64\", \"exact\"]", "engines = [\"machine-f16\"]"),
        ("kind = \"plane\"", "kind = \"plain\""),
        ("models = [\"ideal\"]", "models = [\"ideal\"]\nfiles = []"),
        ("pitch_deg = 5.0\n", ""),
    ] {
        assert!(!refused("flat-plane", from, to).is_empty());
        assert!(!schema_faults(&text_of("flat-plane").replacen(from, to, 1)).is_empty(), "{to}");
    }
}

#[test]
fn one_error_names_file_and_place() {
    let message = |from: &str, to: &str| refused("flat-plane", from, to);
    for (from, to, parts) in [
        ("format = 2", "format = 3", &["some/cartridge.toml: ", "format = 3: expected 2"][..]),
        ("format = 2\n", "", &["format", "expected"]),
        ("title = \"A flat", "title = A flat", &["line 3"]),
        ("albedo =", "albido =", &["albido", "albedo"]),
        ("albedo = 0.8", "albedo = 1.8", &["scene: albedo = 1.8: expected 0 to 1"]),
        ("albedo = 0.8", "albedo = nan", &["scene.albedo = NaN: expected a number"]),
        ("region_size_m = 2000.0", "region_size_m = 0.0", &["scene: ground: region size 0 m: expected"]),
        ("corners = [9, 9]", "corners = [9000, 9]", &["corners = [9000, 9]: expected at most"]),
        ("headings_deg = [0.0, 37.0, 200.0]", "headings_deg = []", &["a list of it is empty"]),
        ("models = [\"ideal\"]", "models = [\"idol\"]", &["hardware.models", "`idol`", "pra-nominal"]),
        ("sweeps = 45", "sweps = 45", &["raster.sweps"]),
        ("sweeps = 45", "sweeps = 0", &["raster.sweeps"]),
        ("tolerance = 0.02", "tolerance = -1.0", &["expect 1: tolerance = -1"]),
        (
            "kind = \"horizon-line\", formula = \"plane\"",
            "kind = \"output\"",
            &["expect 1", "kind \"machine\""],
        ),
        (
            "kind = \"horizon-line\", formula = \"plane\"",
            "kind = \"signal\", signal = \"tg.hight\", formula = \"nothing\"",
            &["expect 1", "engine \"exact\""],
        ),
        ("scene = { pitch_deg = 5.1 }", "scene = { pitch_degrees = 5.1 }", &["must_fail 1", "pitch_degrees"]),
        (
            "scene = { pitch_deg = 5.1 }",
            "scene = { headings_deg = [1.0] }",
            &["must_fail 1: 1 runs instead of 3"],
        ),
        ("scene = { pitch_deg = 5.1 }", "scene = { eye_m = [inf, 0.0, 0.0] }", &["eye_m = inf"]),
    ] {
        let found = message(from, to);
        assert!(parts.iter().all(|part| found.contains(part)), "{to}: {found}");
        assert!(!found.trim_end().contains('\n') || to.contains("sw"), "{to}: several lines: {found}");
    }
    let many = refused("pixel-ray-pixel", "raster = [25, 17]", "raster = [60000, 60000]");
    assert!(many.contains("raster = ") && many.contains("expected 1 to 10000000"), "{many}");
    let signal = refused("axis-parallel", "signal = \"tg.height\"", "signal = \"tg.hight\"");
    assert!(signal.contains("expect 1: the machine has no signal `tg.hight`"), "{signal}");
}

#[test]
fn a_folder_of_cartridges_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let none = of_folder(folder.path()).unwrap_err().to_string();
    assert!(none.contains("no cartridge: expected folders with a cartridge.toml"), "{none}");
    let missing = of_folder(&folder.path().join("nowhere")).unwrap_err().to_string();
    assert!(missing.contains("nowhere: cannot read this folder"), "{missing}");
    for name in ["two", "one"] {
        let place = folder.path().join(name);
        std::fs::create_dir(&place).unwrap();
        std::fs::write(place.join("cartridge.toml"), text_of("lag-step")).unwrap();
    }
    let found = of_folder(folder.path()).unwrap();
    assert_eq!(found.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["one", "two"]);
    std::fs::write(folder.path().join("one/cartridge.toml"), [0xff, 0xfe]).unwrap();
    let binary = of_folder(folder.path()).unwrap_err().to_string();
    assert!(binary.contains("cartridge.toml: not in UTF-8"), "{binary}");
}

/// Readings of what is not there are errors, not panics, and no wrong answers.
#[test]
fn what_cannot_be_read_is_an_error() {
    for (name, from, to, part) in [
        ("flat-plane", "last_line = 239", "last_line = 9223372036854775807", "are not in the picture"),
        ("flat-plane", "last_line = 239", "last_line = 240", "are not in the picture"),
        ("fold-table", "at_m = [50.0, 150.0", "at_m = [50.5, 150.0", "no sample is at 50.5 m"),
        ("flat-plane", "eye_m = [7900.0, 8300.0, 9.0]", "eye_m = [7900.0, 8300.0, 5.0]", "under the ground"),
        ("lag-step", "kind = \"output\"", "kind = \"peak\", peak = \"late-by\"", "of the kind fold"),
    ] {
        let text = text_of(name).replacen(from, to, 1);
        let found = Cartridge::parse(name, name, &text).and_then(|cartridge| cartridge.run());
        let error = found.expect_err(to).to_string();
        assert!(error.contains(part) && error.starts_with(name), "{error}");
    }
}

/// A scenario in a cartridge is refused by the place of its fault, before anything is drawn.
#[test]
fn a_scenario_that_cannot_be_drawn_is_refused() {
    for (name, from, to, part) in [
        (
            "stack-of-sheets",
            "[[expect]]",
            "[scene.scenario.lunsim]\nnonsense = 5\n\n[[expect]]",
            "unknown key `lunsim.nonsense`",
        ),
        (
            "stack-of-sheets",
            "[[expect]]",
            "[scene.gear.rt]\nnonsense = 5\n\n[[expect]]",
            "unknown key `rt.nonsense`",
        ),
        (
            "stack-of-sheets",
            "sampled = { translucent = 1 }",
            "sampled = { translucend = 1 }",
            "must_fail 2: ",
        ),
        (
            "beam-budget",
            "raster = { update_hz = 50, refresh_hz = 50 }",
            "raster = { columns = 64 }",
            "must_fail 2: a picture of [64, 16] instead of [1000, 16] pixels",
        ),
        (
            "beam-budget",
            "[[must_fail]]",
            "[scene.gear.beam]\njump_ns = 1\n\n[[must_fail]]",
            "unknown key `beam.jump_ns`",
        ),
        (
            "stack-of-sheets",
            "frames = [0]",
            "frames = [0, 0]",
            "frames: 0 after 0: expected each once, in order",
        ),
        ("stack-of-sheets", "frames = [0]", "frames = [7]", "frames: 7: expected below 1"),
        ("stack-of-sheets", "tau = 0.7", "tau = 1.7", "`sheet[0].tau` must be"),
        ("stack-of-sheets", "tau = 0.7", "tao = 0.7", "unknown key `sheet[0].tao`"),
        (
            "stack-of-sheets",
            "[[expect]]",
            "[scene.gear.beem]\njump_us = 1\n\n[[expect]]",
            "gear: unknown table `beem`",
        ),
        (
            "ground-distance",
            "channel = \"tilted\"",
            "channel = \"titled\"",
            "channel: the scenario has no channel `titled`",
        ),
        (
            "ground-distance",
            "engines = [\"exact\"",
            "engines = [\"exactly\"",
            "unknown engine `exactly`, expected one of machine-f64,",
        ),
        (
            "ground-distance",
            "engines = [\"exact\"",
            "engines = [\"part\"",
            "cannot be read off the engine \"part\"",
        ),
        (
            "flat-plane",
            "\"machine-f32\", \"exact\"",
            "\"machine-f32\", \"sampled\"",
            "cannot be read off the engine \"sampled\"",
        ),
        ("ground-distance", "keyframes = [", "file = \"path.csv\", keyframes = [", "path"),
    ] {
        let found = refused(name, from, to);
        assert!(found.contains(part), "{to}: {found}");
    }
}

/// Readings of planes, pixels, counters and frames that a picture does not have.
#[test]
fn what_a_picture_lacks_is_an_error() {
    for (name, from, to, part) in [
        ("stack-of-sheets", "\"exact\"]", "\"exact\", \"machine-f64\"]", "not drawn: "),
        ("ground-distance", "height_m = 0.0", "height_m = 3.0", "not all of the part shows ground"),
        ("stack-of-sheets", "plane = \"red\"", "plane = \"rot\"", "no plane `rot` is drawn; drawn: "),
        ("stack-of-sheets", "lines = [0, 6]", "lines = [0, 16]", "lines 0 to 16 are not in the picture"),
        ("stack-of-sheets", "lines = [0, 6]", "lines = [6, 5]", "lines 6 to 5 are not in the picture"),
        (
            "beam-budget",
            "counter = \"beam_dropped\"",
            "counter = \"dropped\"",
            "no counter `dropped`; counted: ",
        ),
        (
            "lamp-by-distance",
            "values = [32.507778728809, ",
            "values = [",
            "values: 5 numbers: expected one for all frames, or 6, one a frame",
        ),
    ] {
        let text = text_of(name).replacen(from, to, 1);
        assert_ne!(text, text_of(name), "{name} has no {from}");
        let found = Cartridge::parse(name, name, &text).and_then(|cartridge| cartridge.run());
        let error = found.expect_err(to).to_string();
        assert!(error.contains(part) && error.starts_with(name), "{error}");
    }
}

/// A wrong answer, an overlay that nothing notices, and an answer that is right.
#[test]
fn what_is_wrong_is_told() {
    let text = text_of("lag-step");
    let right = Cartridge::parse("right", "", text).unwrap().run().unwrap();
    assert!(right.passed && right.faults().is_empty(), "{:?}", right.faults());
    let deaf = text.replace("tolerance = 1e-14", "tolerance = 1e3");
    let deaf = Cartridge::parse("deaf", "", &deaf).unwrap().run().unwrap();
    assert_eq!(deaf.overlays.iter().filter(|overlay| overlay.caught).count(), 0);
    assert!(!deaf.passed);
    let wrong = text.replace("tolerance = 1e-14", "tolerance = 0.0");
    let wrong = Cartridge::parse("wrong", "", &wrong).unwrap().run().unwrap();
    assert!(!wrong.answers[0].passed && wrong.answers[0].worst_error > 0.0);
    assert!(wrong.faults()[0].contains("wrong, output on part: output after step"), "{:?}", wrong.faults());
    let outcomes = [right, deaf, wrong];
    let summary = Summary::of(&outcomes);
    assert_eq!((summary.cartridges, summary.passed, summary.answers), (3, 1, 3));
    assert_eq!((summary.overlays, summary.overlays_caught), (6, 4));
    assert!(summary.worst.starts_with("wrong,") && summary.worst_tolerance_used == f64::INFINITY);
    let xml = junit(&outcomes);
    assert!(xml.contains("tests=\"3\" failures=\"2\""), "{xml}");
    assert!(xml.contains("<testcase classname=\"cartridges\" name=\"right\"/>"), "{xml}");
}

#[test]
fn the_carried_ones_are_in_order() {
    let names: Vec<String> = carried().unwrap().into_iter().map(|cartridge| cartridge.name).collect();
    assert!(names.windows(2).all(|pair| pair[0] < pair[1]), "{names:?}");
}
