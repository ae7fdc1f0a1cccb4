//! A known TOML tool reads the shipped files by their schemas, and refuses broken ones in the line in which `check` does.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use hardware_model::{HardwareModel, ModelSource};
use scenario::Scenario;

use super::{files, root};

/// Where the tool is: `npm install @taplo/cli` puts it into `node_modules/.bin/taplo`.
const VARIABLE: &str = "LUNOID_TAPLO";

/// The first line of a scenario here: the schema lies in the repository.
fn with_schema(text: &str, schema: &str) -> String {
    let rest = text.split_once('\n').expect("a first line").1;
    format!(
        "#:schema {}\n{rest}",
        root().join("docs/schema").join(schema).canonicalize().expect("a schema").display()
    )
}

/// Whether the tool takes `paths`, and what it says.
fn lint(tool: &Path, paths: &[PathBuf]) -> (bool, String) {
    let output =
        Command::new(tool).arg("lint").args(paths).env("NO_COLOR", "1").output().expect("the tool runs");
    (output.status.success(), String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned())
}

/// Changes of `full-drive.toml`, one each, and of the model `pra-nominal`.
const BROKEN: [(&str, &str); 12] = [
    ("format = 1", "format = 2"),
    ("title = ", "titel = "),
    ("azimuth_deg = ", "azimuth_rad = "),
    ("elevation_deg = ", "elevation_deg = 900 #"),
    ("machine = ", "machine = 4 #"),
    ("seed = ", "seed = -1 #"),
    ("rms_height_m = ", "rms_height_m = [1] #"),
    ("programme = ", "programme = 'geometrical' #"),
    ("start_m = ", "start_m = 'near' #"),
    ("gamma = ", "gamma = 40 #"),
    ("white = ", "white = true #"),
    ("albedo = ", "albedo = -0.5 #"),
];
const BROKEN_MODELS: [(&str, &str); 8] = [
    ("format = ", "format = 7 #"),
    ("[loader]", "[lauder]"),
    ("sweeps = ", "sweeps = 'many' #"),
    ("bandwidth_mhz = ", "bandwidth_mhz = -3 #"),
    ("words_per_access = ", "words_per_access = 1.5 #"),
    ("access_ns = ", "access_ns = -1 #"),
    ("late_policy = ", "late_policy = 'never' #"),
    ("segments = ", "segments = 0 #"),
];

#[test]
fn a_toml_tool_takes_shipped_files_and_refuses_broken_ones_in_their_line() {
    let Some(tool) = std::env::var_os(VARIABLE).map(PathBuf::from) else {
        eprintln!("SKIPPED: {VARIABLE} does not name the TOML tool `taplo` (npm install @taplo/cli)");
        return;
    };
    let folders = ["scenarios", "scenarios/real", "hardware-models", "hardware-models/faults"];
    let shipped: Vec<PathBuf> = folders.into_iter().flat_map(files).collect();
    let (takes, said) = lint(&tool, &shipped);
    assert!(takes, "{said}");

    let folder = tempfile::tempdir().expect("a folder");
    let beside = root().join("scenarios/a.toml").display().to_string();
    let text = fs::read_to_string(root().join("scenarios/full-drive.toml")).expect("a text");
    for (from, to) in BROKEN {
        let broken = with_schema(&text, "scenario.schema.json").replacen(from, to, 1);
        let faults = Scenario::parse(&beside, &broken).expect_err(to).records();
        expect_same_line(&tool, folder.path(), &broken, faults.iter().filter_map(|fault| fault.line));
    }
    let text = fs::read_to_string(root().join("hardware-models/pra-nominal.toml")).expect("a text");
    for (from, to) in BROKEN_MODELS {
        let broken = with_schema(&text, "hardware-model.schema.json").replacen(from, to, 1);
        let path = folder.path().join("model.toml");
        fs::write(&path, &broken).expect("a file");
        let faults = HardwareModel::load(&ModelSource::File(path), &[], &[]).expect_err(to).records();
        expect_same_line(&tool, folder.path(), &broken, faults.iter().filter_map(|fault| fault.line));
    }
}

/// The tool refuses `broken`, and one of the lines that it names is one of `expected`.
fn expect_same_line(tool: &Path, folder: &Path, broken: &str, expected: impl Iterator<Item = usize>) {
    let path = folder.join("broken.toml");
    fs::write(&path, broken).expect("a file");
    let (takes, said) = lint(tool, std::slice::from_ref(&path));
    assert!(!takes, "accepted:\n{broken}");
    let expected: Vec<usize> = expected.collect();
    let named = |line: &usize| said.contains(&format!("broken.toml:{line}:"));
    assert!(expected.iter().any(named), "`check` names lines {expected:?}, the tool says\n{said}");
}
