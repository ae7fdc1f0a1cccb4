//! Options without effect and files of the wrong kind: one error that says what was expected.

use crate::scene::{Scene, lunoid};

/// Ends with `code`, and says all `words` in few lines.
fn refused(scene: &Scene, code: i32, arguments: &[&str], words: &[&str]) {
    let (out, err) = scene.expect(code, arguments);
    assert!(out.is_empty() && err.lines().count() < 8, "{arguments:?}: {out}{err}");
    assert!(words.iter().all(|word| err.contains(word)), "{arguments:?}: {err}");
}

#[test]
fn options_without_effect_are_refused() {
    let scene = Scene::new();
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "tiny.bank"]);
    let probe = ["probe", "tiny.toml", "--frame", "0", "--sweep", "3", "--out"];
    for option in [
        &["--cursor", "30"][..],
        &["--from", "30"],
        &["--to", "30"],
        &["--axis", "time"],
        &["--linear"],
        &["--width", "700"],
        &["--height", "200"],
        &["--theme", "dark"],
    ] {
        let arguments = [&probe[..], &["a.csv"], option].concat();
        refused(&scene, 2, &arguments, &[option[0], "a.csv is no picture", ".png or .svg"]);
    }
    refused(&scene, 2, &[&probe[..], &["a.png", "--dry-run"]].concat(), &["--dry-run", "a.png", "waveforms"]);
    for arguments in [
        &["bank", "show", "tiny.bank", "--sun", "100,20"][..],
        &["bank", "show", "tiny.bank", "--regions"],
        &["bank", "show", "tiny.bank", "--pixels", "400"],
        &["bank", "show", "tiny.bank", "--level", "0"],
        &["compare", "a.png", "b.png", "--factor", "3"],
    ] {
        refused(&scene, 2, arguments, &["not provided", "--out"]);
    }
    for option in ["--region-size-m", "--range-m"] {
        refused(&scene, 2, &["model", "show", "ideal", option, "200"], &["not provided", "--budget"]);
    }
    for option in ["--lossless", "--everything"] {
        refused(&scene, 2, &["study", "economy", "tiny.toml", option], &["--lossless, --everything", "both"]);
    }
    refused(&scene, 2, &["study", "stability", "--seed", "3"], &["not provided", "--mixtures"]);
    for machine in ["exact", "lunsim"] {
        let replay = ["replay", "tiny.toml", "-m", machine, "--set", "loader.access_ns=90", "--out", "r"];
        let words = [&format!("{machine} has no such part"), "--set loader.access_ns", "leave it out"];
        refused(&scene, 2, &replay, &words);
    }
    refused(&scene, 2, &["trigger", "tiny.toml", "--on", "fold x = 7"], &["`7`", "a stop, 0 or 1"]);
    assert_eq!(scene.list("."), ["tiny.bank", "tiny.bank.toml", "tiny.toml"]);
}

#[test]
fn values_that_cannot_be_are_refused() {
    let scene = Scene::new();
    for (arguments, words) in [
        (&["replay", "tiny.toml", "--sweeps", "-3"][..], &["'-3'", "--sweeps", "from 1 to 8192"]),
        (&["replay", "tiny.toml", "--frames", "-1..2"], &["'-1..2'", "--frames", "expected A..B"]),
        (
            &["replay", "tiny.toml", "--raise", "crater=3"],
            &["--raise crater: there is no such limit", "there are corners", "craters"],
        ),
        (&["compare", "a.png", "b.png", "--max-rmse", "-1"], &["'-1'", "--max-rmse", "0 or more"]),
        (
            &["compare", "a.png", "b.png", "--tolerance", "2", "--share", "101"],
            &["'101'", "--share", "0 to 100"],
        ),
        (
            &["explain", "tiny.toml", "--frame", "0", "--pixel", "-3,3"],
            &["'-3,3'", "--pixel", "column and line"],
        ),
        (&["bank", "show", "a.bank", "-o", "a.png", "--sun", "100,-20"], &["'100,-20'", "--sun", "0 to 90"]),
        (
            &["survey", "a.tif", "-o", "a.bank", "--area", "2,0,1,9"],
            &["'2,0,1,9'", "--area", "south below north"],
        ),
        (&["bank", "generate", "tiny.toml", "-o", "-"], &["-:", "/dev/stdout", "./-"]),
        (
            &["model", "show", "ideal", "--budget", "--region-size-m", "1e-300"],
            &["'1e-300'", "--region-size-m", "0.001 to 1e7"],
        ),
        (
            &["bank", "import", "a.npy", "-o", "a.bank", "--region-size-m", "1e300"],
            &["'1e300'", "--region-size-m", "0.001 to 1e7"],
        ),
        (
            &["bank", "import", "a.npy", "-o", "a.bank", "--region-size-m", "9", "--origin-m", "1e300,0"],
            &["'1e300,0'", "--origin-m", "-1e9 to 1e9"],
        ),
        (
            &["survey", "a.npy", "-o", "a.bank", "--spacing-m", "1e300"],
            &["'1e300'", "--spacing-m", "0.001 to 1e7"],
        ),
    ] {
        refused(&scene, 2, arguments, words);
    }
    // Not drawn first and refused then.
    refused(&scene, 2, &["replay", "tiny.toml", "--check", "161"], &["--check 161", "160 sweeps"]);
    assert!(scene.list("runs/tiny").is_empty(), "{:?}", scene.list("runs/tiny"));
}

/// A name that does not say what is in the file, a place that is not there.
#[test]
fn pictures_of_what_is_not_there_are_refused() {
    let scene = Scene::new();
    scene.expect(0, &["bank", "generate", "tiny.toml", "-o", "tiny.bank"]);
    let timeline = ["timing", "show", "tiny.toml", "--frame", "0", "--sweep", "3", "--out"];
    for arguments in [
        &[&timeline[..], &["x.txt"]].concat()[..],
        &["timing", "show", "tiny.toml", "--slack", "x.txt"],
        &["timing", "show", "tiny.toml", "--utilisation", "x"],
        &["timing", "columns", "tiny.toml", "--frame", "0", "--out", "x.jpg"],
        &["bank", "show", "tiny.bank", "--out", "x.txt"],
        &["survey", "a.tif", "-o", "a.bank", "--picture", "x.txt"],
    ] {
        refused(&scene, 2, arguments, &["expected a name that ends in .png or .svg"]);
    }
    refused(&scene, 2, &["compare", "a.png", "b.png", "--out", "x.svg"], &["--out x.svg", "ends in .png"]);
    let beyond = [&timeline[..], &["x.png", "--range-m", "1e6,2e6"]].concat();
    refused(&scene, 2, &beyond, &["--range-m 1000000,2000000", "sweep 3 goes to 300.0 m", "nearer"]);
    let probe = ["probe", "tiny.toml", "--frame", "0", "--sweep", "3", "--out", "x.png"];
    for (option, place, low_high) in [
        ("--cursor", "5000", "2.000 to 300.000 m"),
        ("--from", "1m", "2.000 to"),
        ("--to", "1e9us", "0.000 to"),
    ] {
        refused(&scene, 2, &[&probe[..], &[option, place]].concat(), &[option, low_high, "a place there"]);
    }
    assert_eq!(scene.list("."), ["tiny.bank", "tiny.bank.toml", "tiny.toml"]);
    scene.expect(0, &[&timeline[..], &["X.PNG"]].concat());
}

/// The variable is named, and not the option that it stands for.
#[test]
fn a_variable_that_is_no_number_is_named() {
    let scene = Scene::new();
    let run = |value: &str, arguments: &[&str]| {
        let mut command = lunoid();
        let output = command.current_dir(scene.path()).env("LUNOID_THREADS", value).args(arguments).output();
        let output = output.unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let (code, err) = run("abc", &["replay", "tiny.toml"]);
    assert_eq!(code, Some(2));
    assert_eq!(err, "error: LUNOID_THREADS=abc: expected a whole number from 1 to 1024; mend or unset it\n");
    assert_eq!(run("abc", &["replay", "tiny.toml", "-q", "--jobs", "1"]).0, Some(0));
    assert_eq!(run("", &["replay", "tiny.toml", "-q"]).0, Some(0));
}

#[test]
fn files_of_another_kind_are_named_as_what_they_are() {
    let scene = Scene::new();
    scene.write("model.toml", "format = 1\nname = \"mine\"\nbase = \"ideal\"\n");
    scene.write("edge.toml", "format = 1\n[loader]\naccess_ns = 90\n");
    scene.write("note.txt", "hello\n");
    let model = "model.toml: this is a hardware model (--machine), expected a scenario";
    for command in [&["replay"][..], &["sizing"], &["timing", "show"], &["lockstep"]] {
        refused(&scene, 3, &[command, &["model.toml"]].concat(), &[model]);
    }
    refused(&scene, 3, &["bank", "generate", "model.toml", "-o", "a.bank"], &[model]);
    let scenario = "tiny.toml: this is a scenario, expected a hardware model";
    refused(&scene, 3, &["replay", "tiny.toml", "--machine", "./tiny.toml"], &[scenario]);
    refused(&scene, 3, &["model", "show", "tiny.toml"], &[scenario]);
    let differences =
        "edge.toml: this is differences from a hardware model (--overlay), expected a hardware model";
    refused(&scene, 3, &["model", "check", "edge.toml"], &[differences]);
    let gear = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../hardware-models/programs/lunsim.toml");
    refused(&scene, 3, &["replay", gear], &["this is what lunsim ran on, expected a scenario"]);
    let unknown =
        ["note.txt: starts with 68 65", "a bank", "elevation file", "scenario", "PNG", "folder of a run"];
    refused(&scene, 3, &["info", "note.txt"], &unknown);
    refused(&scene, 4, &["study", "stability", "--only", "corner", "--out", "note.txt"], &["--out note.txt"]);
    refused(&scene, 3, &["page", "note.txt"], &["note.txt/run.json: no such file"]);
}
