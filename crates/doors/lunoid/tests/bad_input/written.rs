//! Files that people write: scenarios, paths, machines. Every fault is told at once, each with its place.

use crate::room::{INPUT, KEYFRAMES, Room, TINY};

/// A replay and a check of a scenario with one thing wrong.
fn refused(room: &Room, old: &str, new: &str, words: &[&str]) {
    room.vary("s.toml", old, new);
    room.refused(INPUT, &["replay", "s.toml"], &[&["s.toml"][..], words].concat());
    assert_eq!(room.run(&["check", "s.toml"]).code, Some(INPUT), "{new}");
}

#[test]
fn scenarios_with_one_fault() {
    let room = Room::new();
    for (old, new, words) in [
        ("format = 1", "format = 2", &["s.toml:1:10", "format 2 is newer than the format 1"][..]),
        ("format = 1\n", "", &["missing key `format`", "write `format = 1`"]),
        ("frames = 4", "frames = \"4\"", &["s.toml:4:10", "`frames`", "whole number from 1", "\"4\""]),
        ("frames = 4", "frames = 4.5", &["s.toml:4:10", "4.5"]),
        ("frames = 4", "frames = 0", &["s.toml:4:10", "from 1 to 10000000"]),
        ("frames = 4", "frames = 99999999999999999999", &["s.toml:4:10"]),
        ("rms_height_m = 2", "rms_height_m = inf", &["s.toml:11:16", "rms_height_m", "inf"]),
        ("x_m = 108", "x_m = nan", &["s.toml:24:20", "path.keyframes[1].x_m", "nan"]),
        ("t_s = 5", "t_s = 0", &["s.toml:24"]),
        ("extent_m = [400, 400]", "extent_m = [0, 400]", &["s.toml:8:13", "above 0 m"]),
        ("region_size_m = 50", "region_size_m = 1e-9", &["s.toml:9:17", "enlarge the regions"]),
        ("waves = 20", "waves = 2000000000", &["from 1 to 20000"]),
        ("sweeps = 40", "sweeps = 0", &["s.toml:28:10", "from 1 to 8192"]),
        ("refresh_hz = 30", "refresh_hz = 7", &["s.toml:31:14", "whole multiple of 10 Hz"]),
        ("end_m = 300", "end_m = 1", &["`range.end_m` = 1", "`range.start_m` = 2"]),
        ("\"geometric\"", "\"geometrc\"", &["geometrc", "two-rate", "did you mean \"geometric\""]),
        ("title = \"Tiny\"", "title = ", &["s.toml:2", "TOML"]),
        ("[sun]", "[sun]\n[sun]", &["duplicate key"]),
        (KEYFRAMES, "file = \"../up.csv\"", &["path.file", "stays in the scenario's folder"]),
        (KEYFRAMES, "file = \"/etc/passwd\"", &["path.file", "stays in the scenario's folder"]),
    ] {
        refused(&room, old, new, words);
    }
}

#[test]
fn files_that_are_no_text() {
    let room = Room::new();
    room.write("bytes.toml", [0xff, 0xfe, 0x00]);
    room.write("deep.toml", "a = ".to_owned() + &"[".repeat(100_000));
    for (file, words) in [
        ("bytes.toml", &["bytes.toml", "UTF-8"][..]),
        ("deep.toml", &["deep.toml:1:"]),
        ("gone.toml", &["gone.toml", "no such file", "check the spelling"]),
        ("folder", &["folder", "this is a folder, expected a file"]),
    ] {
        room.refused(INPUT, &["replay", file], words);
        room.refused(INPUT, &["check", file], words);
    }
}

#[test]
fn all_faults_are_told_at_once() {
    let room = Room::new();
    room.vary("key.toml", "elevation_deg", "elevaton_deg");
    room.write(
        "two.toml",
        TINY.replace("azimuth_deg = 100", "azimuth_deg = nan").replace("seed = 3", "seed = -3"),
    );
    room.write("empty.toml", "");
    for (file, errors, words) in [
        (
            "key.toml",
            2,
            &["unknown key `sun.elevaton_deg`", "did you mean `elevation_deg`", "missing key"][..],
        ),
        ("two.toml", 2, &["two.toml:7:8", "two.toml:18:15"]),
        ("empty.toml", 7, &["missing table `path`", "missing key `title`"]),
    ] {
        let said = room.run(&["replay", file]);
        assert_eq!((said.code, said.errors(), &*said.out), (Some(INPUT), errors, ""), "{}", said.err);
        assert!(words.iter().all(|word| said.err.contains(word)), "{}", said.err);
        assert!(!said.err.contains("panicked") && !room.join("runs").exists());
    }
}

#[test]
fn paths_that_cannot_be_driven() {
    let room = Room::new();
    for (old, new, words) in [
        (
            "x_m = 108",
            "x_m = 9000",
            &["s.toml: frame 2", "outside the problem area", "x 0..400 m, y 0..400 m"][..],
        ),
        ("x_m = 100", "x_m = 0", &["frame 0", "a wheel is outside the problem area"]),
        (KEYFRAMES, "file = \"gone.csv\"", &["gone.csv", "no such file"]),
        (
            KEYFRAMES,
            "file = \"folder\"",
            &["folder", "expected a name that ends in .csv, .tsv, .tum or .gpx"],
        ),
    ] {
        room.vary("s.toml", old, new);
        room.refused(INPUT, &["replay", "s.toml"], words);
    }
}

#[test]
fn path_tables_that_cannot_be() {
    let room = Room::new();
    room.vary("s.toml", KEYFRAMES, "file = \"p.csv\"");
    let heading = "t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n";
    let first = "0,100,200,9,0,0,0\n";
    for (text, words) in [
        (String::new(), &["p.csv", "an empty path file"][..]),
        (heading.into(), &["p.csv", "without rows"]),
        (
            format!("{heading}{first}9,nan,205,9,0,0,0\n"),
            &["p.csv:3:3", "`x_m`", "a number from -10000000 to 10000000, not nan"],
        ),
        (format!("{heading}{first}9,108,-inf,9,0,0,0\n"), &["p.csv:3:7", "`y_m`", "-inf"]),
        (format!("{heading}{first}9,abc,205,9,0,0,0\n"), &["p.csv:3:3", "not abc"]),
        (format!("{heading}{first}9,108,205\n"), &["p.csv:3:1", "3 cells under a header of 7"]),
        (format!("{heading}{first}0,108,205,9,0,0,0\n"), &["p.csv:3:1", "times must ascend"]),
        (
            format!("{heading}0,100,200,-500,0,0,0\n"),
            &["p.csv: frame 0", "eye under ground", "z = -500.000 m", "raise z_m"],
        ),
        (format!("{heading}0,100,200,9,0,95,0\n"), &["pitch of 95.0 deg"]),
        (format!("{heading}0,1e6,200,9,0,0,0\n"), &["outside the problem area"]),
    ] {
        room.write("p.csv", &text);
        room.refused(INPUT, &["replay", "s.toml"], words);
    }
}

#[test]
fn machines_that_cannot_be() {
    let room = Room::new();
    room.write("newer.toml", "format = 2\nname = \"mine\"\nbase = \"ideal\"\n");
    room.write("typo.toml", "format = 1\nname = \"mine\"\nbase = \"ideal\"\n[raster]\nsweps = 500\n");
    room.write("type.toml", "format = 1\nname = \"mine\"\nbase = \"ideal\"\n[raster]\nsweeps = true\n");
    room.write("base.toml", "format = 1\nname = \"mine\"\nbase = \"idael\"\n");
    room.write("self.toml", "format = 1\nname = \"mine\"\nbase = \"./self.toml\"\n");
    for (arguments, words) in [
        (&["--machine", "idael"][..], &["unknown machine `idael`", "did you mean `ideal`"][..]),
        (&["--machine", "./gone.toml"], &["gone.toml", "no such file"]),
        (&["--machine", "folder"], &["unknown machine `folder`"]),
        (&["--machine", "newer.toml"], &["newer.toml:1:10", "format 2 is newer"]),
        (&["--machine", "typo.toml"], &["typo.toml:5:1", "`raster.sweps`", "did you mean `sweeps`"]),
        (&["--machine", "type.toml"], &["type.toml:5:10", "`raster.sweeps`", "true"]),
        (&["--machine", "base.toml"], &["idael", "ideal"]),
        (&["--machine", "self.toml"], &["self.toml"]),
        (&["--overlay", "gone.toml"], &["gone.toml", "no such file"]),
        (&["--overlay", "folder"], &["folder", "expected a file"]),
        (&["--set", "raster.sweps=1"], &["sweps", "did you mean `sweeps`"]),
        (&["--set", "raster.sweeps=nan"], &["raster.sweeps", "not nan"]),
        (&["--set", "dpp.projection=\"exakt\""], &["exakt", "did you mean \"exact\""]),
    ] {
        room.refused(INPUT, &[&["replay", "tiny.toml"], arguments].concat(), words);
    }
}
