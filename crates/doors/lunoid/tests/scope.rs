//! The shipped pictures of single sweeps and of a row, drawn again by the commands that docs/scope.md gives for them.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;

const PAGE: &str = "docs/scope.md";
const PICTURES: [&str; 6] =
    ["height-and-reflectivity", "shadow-gates", "projection", "lunsim-row", "sweep-x-over-y", "scan-line"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// The command that the page gives for a picture, word by word, without the program and without its `--out`.
fn command_of(name: &str) -> Vec<String> {
    let page = fs::read_to_string(root().join(PAGE)).unwrap();
    let out = format!("--out docs/pictures/scope/{name}.svg");
    let line = page.lines().find(|line| line.starts_with("lunoid ") && line.ends_with(&out));
    let line = line.unwrap_or_else(|| panic!("{PAGE}: no command ends in {out}"));
    let words = line.strip_suffix(&out).unwrap().replace('\'', "");
    words.split_whitespace().skip(1).map(str::to_owned).collect()
}

fn draw(name: &str, out: &Path) {
    let mut command = Command::cargo_bin("lunoid").unwrap();
    command.current_dir(root()).args(command_of(name)).arg("--out").arg(out).assert().success();
}

fn pixels(path: &Path) -> (u32, u32, Vec<u8>) {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgb).unwrap();
    (info.width, info.height, rgb)
}

#[test]
fn shipped_pictures_are_what_their_commands_draw() {
    let folder = tempfile::tempdir().unwrap();
    for name in PICTURES {
        let shipped = |end: &str| root().join(format!("docs/pictures/scope/{name}.{end}"));
        let [svg, png] = ["svg", "png"].map(|end| folder.path().join(format!("{name}.{end}")));
        draw(name, &svg);
        let [found, expected] = [&svg, &shipped("svg")].map(|path| fs::read(path).unwrap());
        assert!(found == expected, "{name}.svg: draw it again by its command in {PAGE}, and look at it");
        draw(name, &png);
        assert!(pixels(&png) == pixels(&shipped("png")), "{name}.png: draw it again, and look at it");
    }
}

#[test]
fn places_that_cannot_be_are_refused() {
    let refused = |options: &[&str], expected: &str| {
        let folder = tempfile::tempdir().unwrap();
        let mut command = Command::cargo_bin("lunoid").unwrap();
        command.current_dir(root()).args([
            "probe",
            "scenarios/profile.toml",
            "--frame",
            "0",
            "--sweep",
            "120",
        ]);
        command.args(options).arg("--out").arg(folder.path().join("page.svg"));
        let output = command.assert().code(2).get_output().stderr.clone();
        let output = String::from_utf8_lossy(&output).into_owned();
        assert!(output.contains(expected), "{output}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    };
    refused(
        &["--signals", "tg.height", "--cursor", "5000"],
        "--cursor 5000 m: the samples lie from 2.500 to 900.000 m",
    );
    refused(&["--signals", "tg.height", "--cursor", "10,20,30"], "cursors");
    refused(&["--signals", "tg.height", "--cursor", "near"], "ground range in metres");
    refused(&["--signals", "tg.height", "--from", "50", "--to", "20"], "upper end above the lower");
    refused(&["--signals", "sm.write"], "none of them runs along the sweep");
    refused(&["--signals", "sweep.x", "--axis", "xy"], "--signals names 1; expected two analog signals");
    refused(&["--signals", "sweep.x,sc.gate", "--axis", "xy"], "sc.gate is no analog signal along a sweep");
    refused(&["--signals", "sweep.x,sweep.y", "--axis", "xy", "--linear"], "--axis xy has no ground range");
    refused(&["--signals", "sweep.x,sweep.y", "--axis", "xy", "--cursor", "5000"], "the samples lie from");
}
