//! Command lines that cannot be: 2, before a file is written.

use crate::room::{Room, USAGE};

#[test]
fn replays_that_cannot_be() {
    let room = Room::new();
    for (arguments, word) in [
        (&["--frames", "5..2"][..], "expected A..B"),
        (&["--frames", "2..2"], "expected A..B"),
        (&["--frames", "x"], "expected A..B"),
        (&["--frames", "0..5"], "the scenario has frames 0..4"),
        (&["--frames", "9"], "the scenario has frames 0..4"),
        (&["--frames=-1"], "--frames"),
        (&["--check", "-1"], "a whole number of 0 or more"),
        (&["--jobs", "0"], "a whole number from 1 to 1024"),
        (&["--jobs", "99999"], "from 1 to 1024"),
        (&["--sweeps", "0"], "a whole number from 1 to 8192"),
        (&["--sweeps", "99999"], "from 1 to 8192"),
        (&["--sweeps", "1e9"], "from 1 to 8192"),
        (&["--samples", "1"], "a whole number from 2 to 65536"),
        (&["--depth", "9"], "possible values: 8, 16"),
        (&["--scalar", "f16"], "possible values: f32, f64"),
        (&["--set", "sweeps"], "expected part.key=value"),
        (&["--y4m", "-", "--json"], "give the film a file name"),
        (&["--sweps", "9"], "'--sweeps'"),
    ] {
        room.refused(USAGE, &[&["replay", "tiny.toml"], arguments].concat(), &[word]);
    }
    room.refused(
        USAGE,
        &["lockstep", "--random", "2", "--seed", "-3"],
        &["--seed", "a whole number of 0 or more"],
    );
    room.refused(USAGE, &["replay"], &["<SCENARIO>"]);
    room.refused(USAGE, &["rplay"], &["'replay'"]);
}

#[test]
fn probes_and_comparisons_that_cannot_be() {
    let room = Room::new();
    let probe = |frame, sweep, out| ["probe", "tiny.toml", "--frame", frame, "--sweep", sweep, "-o", out];
    room.refused(USAGE, &probe("99", "0", "x.npz"), &["the scenario has frames 0..4"]);
    room.refused(USAGE, &probe("0", "40", "x.npz"), &["a frame has sweeps 0..40"]);
    room.refused(USAGE, &probe("0", "3..1", "x.npz"), &["expected"]);
    room.refused(USAGE, &probe("0", "0", "x.txt"), &["ends in .csv, .vcd", "or --format"]);
    let named = [&probe("0", "0", "x.csv")[..], &["--signals", "zz"]].concat();
    room.refused(USAGE, &named, &["no signal of this name", "lunoid signals"]);
    let compare = |options: &[&'static str]| [&["compare", "a.png", "b.png"], options].concat();
    room.refused(USAGE, &compare(&["--tolerance", "300"]), &["from 0 to 255"]);
    room.refused(USAGE, &compare(&["--max-rmse", "nan"]), &["expected a finite number"]);
    room.refused(USAGE, &compare(&["--share", "1"]), &["--tolerance"]);
}

/// A document that tells errors is a result; nothing else is on standard output.
#[test]
fn json_is_no_way_around() {
    let room = Room::new();
    room.vary("s.toml", "frames = 4", "frames = 0");
    room.refused(3, &["replay", "s.toml", "--json"], &["s.toml:4:10"]);
    let said = room.run(&["check", "s.toml", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!((said.code, document["files"][0]["problems"][0]["line"].as_u64()), (Some(3), Some(4)));
}
