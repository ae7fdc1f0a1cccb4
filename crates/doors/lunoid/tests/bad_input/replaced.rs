//! Outputs that would replace what the command reads, or another of its outputs: 2, before any work.

use std::fs;

use crate::build::{Tiff, doubles, npy};
use crate::room::{Room, TINY, USAGE};

/// With a file of every kind that the commands below read.
fn room() -> Room {
    let room = Room::new();
    room.write("c.npy", npy("<f8", "(3, 3, 9)", &doubles(&[0.0; 81])));
    room.write("dem.tif", Tiff::plane().bytes());
    ["g.lbl", "g.img"].iter().for_each(|name| room.write(name, "whatever"));
    room.done(&["bank", "generate", "tiny.toml", "-o", "x.bank"]);
    room.done(&["replay", "tiny.toml", "-q", "--out", "r", "--frames", "0..2"]);
    for name in ["A.png", "B.png"] {
        room.write(name, room.read("r/frames/frame-000000.png"));
    }
    let ground = TINY.find("[landscape.generated]").unwrap()..TINY.find("[sun]").unwrap();
    room.write("real.toml", TINY.replace(&TINY[ground], "[landscape]\nbank = \"x.bank\"\n\n"));
    room.write("mine.toml", "format = 1\nname = \"mine\"\nbase = \"ideal\"\n");
    room.write("over.toml", "format = 1\n[loader]\naccess_ns = 90\n");
    fs::create_dir_all(room.join("mc/a")).unwrap();
    room.write("mc/a/cartridge.toml", "whatever");
    room
}

#[test]
fn no_output_replaces_an_input() {
    let room = room();
    let probe = ["probe", "tiny.toml", "--frame", "0", "--sweep", "5", "--format", "csv", "--out"];
    let augment =
        ["augment", "r/frames", "r/poses.csv", "--vehicle", "rover", "--sun", "212,6", "--out", "a"];
    for (arguments, words) in [
        (
            &["survey", "dem.tif", "-o", "dem.tif"][..],
            "--out dem.tif: would replace the elevation file dem.tif",
        ),
        (&["survey", "dem.tif", "-o", "y.bank", "--picture", "dem.tif"], "--picture dem.tif: would replace"),
        (&["survey", "g.lbl", "-o", "g.img"], "the label or image g.img"),
        (
            &["bank", "generate", "tiny.toml", "-o", "tiny.toml"],
            "--out tiny.toml: would replace the scenario",
        ),
        (&["bank", "generate", "real.toml", "-o", "x.bank"], "a file of the scenario, x.bank"),
        (&["bank", "import", "c.npy", "--region-size-m", "50", "-o", "c.npy"], "the array c.npy"),
        (&["bank", "export", "x.bank", "-o", "x.bank"], "the bank x.bank"),
        (&["bank", "show", "x.bank", "-o", "x.bank"], "the bank x.bank"),
        (
            &["timing", "record", "tiny.toml", "--frames", "0..1", "--out", "tiny.toml"],
            "the scenario tiny.toml",
        ),
        (&["timing", "show", "tiny.toml", "--slack", "tiny.toml"], "--slack tiny.toml: would replace"),
        (&["timing", "columns", "tiny.toml", "--frame", "0", "--out", "tiny.toml"], "the scenario"),
        (
            &["timing", "check", "tiny.toml", "--baseline", "b", "--junit", "b"],
            "--junit b: would replace --baseline b",
        ),
        (&[&probe[..], &["tiny.toml"]].concat(), "--out tiny.toml: would replace the scenario"),
        (
            &["netlist", "tiny.toml", "--frame", "0", "--sweep", "5", "--out", "tiny.toml"],
            "--out tiny.toml: would replace the scenario",
        ),
        (&[&probe[..], &["over.toml", "--overlay", "over.toml"]].concat(), "--overlay over.toml"),
        (&[&probe[..], &["mine.toml", "--machine", "./mine.toml"]].concat(), "a file of the machine, "),
        (&[&probe[..], &["x.bank", "--bank", "x.bank"]].concat(), "--bank x.bank"),
        (
            &["replay", "tiny.toml", "--y4m", "tiny.toml", "--out", "r"],
            "--y4m tiny.toml: would replace the scenario",
        ),
        (
            &[
                "probe",
                "tiny.toml",
                "--frame",
                "0",
                "--sweep",
                "5",
                "--out",
                "w.raw",
                "--overlay",
                "w.raw.json",
            ],
            "a file written beside the waveforms, w.raw.json: would replace --overlay w.raw.json",
        ),
        (
            &["trigger", "tiny.toml", "--on", "blank", "--out", "w.fst", "--overlay", "w.fst.gtkw"],
            "a file written beside the waveforms, w.fst.gtkw: would replace --overlay w.fst.gtkw",
        ),
        (&["study", "error", "tiny.toml", "--out", ".", "--overlay", "error.csv"], "--overlay error.csv"),
        (&["study", "economy", "tiny.toml", "--out", ".", "--bank", "waste.png"], "--bank waste.png"),
        (
            &["study", "shadow", "tiny.toml", "--out", ".", "--vehicle", "shadow.md"],
            "--out .: would replace --vehicle shadow.md",
        ),
        (
            &["study", "stability", "stability.json", "--out", "."],
            "--out .: would replace the scenario stability.json",
        ),
        (&["replay", "tiny.toml", "--out", "tiny.toml"], "--out tiny.toml: would replace the scenario"),
        (&["compare", "A.png", "B.png", "--out", "A.png"], "the picture A.png"),
        (&["compare", "A.png", "A.png", "--mask", "B.png", "--out", "B.png"], "--mask B.png"),
        (&["compare", "r", "r", "--out", "r/frames/frame-000000.png"], "a file of the run r"),
        (&["cartridge", "run", "--folder", "mc", "--junit", "mc/a/cartridge.toml"], "a file of --folder mc"),
        (
            &[&augment[..], &["--timing", "r/poses.csv"]].concat(),
            "--timing r/poses.csv: would replace the poses",
        ),
        (&[&augment[..], &["--timing", "r/camera.json"]].concat(), "the camera r/camera.json"),
        (&[&augment[..], &["--timing", "r/frames/frame-000001.png"]].concat(), "the pictures in r/frames"),
    ] {
        room.refused(USAGE, arguments, &[words, "name another"]);
    }
}

#[test]
fn no_output_replaces_another() {
    let room = room();
    let augment =
        ["augment", "r/frames", "r/poses.csv", "--vehicle", "rover", "--sun", "212,6", "--out", "a"];
    for (arguments, words) in [
        (
            &["survey", "dem.tif", "-o", "y.bank", "--picture", "y.bank"][..],
            "--picture y.bank: would replace --out",
        ),
        (&["survey", "dem.tif", "-o", "y.bank", "--picture", "y.bank.toml"], "the description beside --out"),
        (
            &["timing", "show", "tiny.toml", "--slack", "s.png", "--utilisation", "s.png"],
            "--slack s.png: would replace --utilisation s.png",
        ),
        (
            &["replay", "tiny.toml", "--out", "pl", "--y4m", "pl/run.json"],
            "--y4m pl/run.json: would replace a file of --out pl",
        ),
        (
            &["replay", "tiny.toml", "--out", "pl", "--y4m", "pl/frames/frame-000000.png"],
            "a file of --out pl",
        ),
        (&["replay", "tiny.toml", "--out", "pl", "--y4m", "pl"], "--out pl"),
        (&[&augment[..], &["--timing", "a/augment.json"]].concat(), "a file of --out a"),
        (
            &[&augment[..], &["--timing", "t.json", "--probe", "0:1", "--waveforms", "t.json"]].concat(),
            "--waveforms t.json: would replace --timing t.json",
        ),
        (
            &[&augment[..], &["--timing", "t.raw.json", "--probe", "0:1", "--waveforms", "t.raw"]].concat(),
            "a file written beside the waveforms, t.raw.json: would replace --timing t.raw.json",
        ),
    ] {
        room.refused(USAGE, arguments, &[words, "name another"]);
    }
}

/// Two names of one file are one file, whether or not it is there.
#[test]
fn files_are_told_by_where_they_are() {
    let room = room();
    let tiny = room.join("tiny.toml");
    let absolute = tiny.to_str().unwrap();
    let y4m = |film| ["replay", "tiny.toml", "--out", "r", "--y4m", film];
    for name in ["./tiny.toml", "folder/../tiny.toml", absolute] {
        room.refused(USAGE, &y4m(name), &["would replace the scenario tiny.toml"]);
    }
    let plots = |slack| ["timing", "show", "tiny.toml", "--utilisation", "s.png", "--slack", slack];
    for name in ["./s.png", "folder/../s.png"] {
        room.refused(USAGE, &plots(name), &["would replace --utilisation s.png"]);
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("tiny.toml", room.join("link")).unwrap();
        room.refused(USAGE, &y4m("link"), &["--y4m link: would replace the scenario tiny.toml"]);
    }
}

/// What is no input of the command is replaced as ever, and a device takes everything.
#[test]
fn older_outputs_are_replaced() {
    let room = room();
    let survey = ["survey", "dem.tif", "--region-size-m", "40", "-o", "y.bank", "--picture", "y.png"];
    room.done(&survey);
    room.done(&survey);
    let replay = ["replay", "tiny.toml", "-q", "--out", "r", "--frames", "0..2", "--y4m", "r/video.y4m"];
    room.done(&replay);
    room.done(&replay);
    room.done(&["compare", "r", "r", "--out", "r/difference.png"]);
    #[cfg(unix)]
    {
        let plots = ["--utilisation", "/dev/null", "--slack", "/dev/null"];
        room.done(&[&["timing", "show", "tiny.toml", "--no-progress"], &plots[..]].concat());
    }
}
