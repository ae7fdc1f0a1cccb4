//! Run parameters at fault are told, each by one problem.

use diagnostics::{Layers, Problems, TomlFile};
use sampled::ROW;

/// What the row says to a table of run parameters.
fn told(lines: &str) -> String {
    let problems = Problems::new();
    let gear = ROW.gear.expect("it ran on something");
    let gear = TomlFile::parse(gear.file, gear.text, &problems).unwrap();
    let file = TomlFile::parse("test.toml", &format!("[sampled]\n{lines}\n"), &problems).unwrap();
    let layers = Layers::new([gear, file]);
    let root = layers.root(&problems);
    let generator = (ROW.configure)(&root);
    root.finish();
    match problems.resolve(generator) {
        Ok(_) => String::new(),
        Err(faults) => {
            assert_eq!(faults.len(), 1, "{}", faults.render(false));
            faults.render(false)
        }
    }
}

#[test]
fn good_parameters_are_taken() {
    for lines in
        ["", "least_diameter_px = 0.8", "translucent = -1\nlights = 0", "pattern = \"16\"\nrotate = true"]
    {
        assert_eq!(told(lines), "", "{lines}");
    }
}

#[test]
fn each_fault_is_one_problem_that_says_what_to_do() {
    for (lines, words) in [
        ("least_diameter_px = 0.75", ["`4`", "0.790569"]),
        ("pattern = \"1\"\nleast_diameter_px = 1.4", ["`1`", "1.41421"]),
        ("rotate = true\nleast_diameter_px = 1.3", ["least_diameter_px", "1.41421"]),
        ("translucent = -2", ["sampled.translucent", "-1 is without limit"]),
        ("lights = -2", ["sampled.lights", "-1 is without limit"]),
        ("lights = 1001", ["sampled.lights", "1000"]),
        ("rotate = true\nfilter = \"tent\"", ["rotate", "filter = \"box\""]),
        ("rotate = true\npattern = \"off-centre16\"", ["rotate", "pattern"]),
        ("ground_cells = 30", ["sampled.ground_cells", "multiple of 4"]),
        ("ground_error_px = -0.1", ["sampled.ground_error_px", "100"]),
        ("spot_px = 0.0", ["sampled.spot_px", "0.05"]),
        ("patern = \"4\"", ["patern", "pattern"]),
        ("pattern = \"5\"", ["sampled.pattern", "lattice32"]),
    ] {
        let told = told(lines);
        assert!(words.iter().all(|word| told.contains(word)), "{lines}: {told}");
    }
}
