//! Banks and arrays of corners that are damaged or are none.

use crate::build::{doubles, npy};
use crate::room::{INPUT, Room, USAGE};

/// 3 x 3 corners of a plain.
const CORNERS: [f64; 81] = [0.0; 81];

fn corners(value: f64) -> Vec<u8> {
    let mut words = CORNERS;
    words[40] = value;
    npy("<f8", "(3, 3, 9)", &doubles(&words))
}

#[test]
fn damaged_banks_are_refused_by_every_reader() {
    let room = Room::new();
    room.done(&["bank", "generate", "tiny.toml", "-o", "whole.bank"]);
    let whole = room.read("whole.bank");
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 1;
    let mut newer = whole.clone();
    newer[8] = 2;
    let longer = [&whole[..], b"more"].concat();
    for (bytes, word) in [
        (&whole[..0], "not a bank"),
        (&whole[..40], "has 40 bytes, expected 64; copy it again"),
        (&whole[..whole.len() / 2], "copy it again"),
        (&whole[..whole.len() - 1], "copy it again"),
        (&longer, "copy it again"),
        (&flipped, "section 0 (level)"),
        (&newer, "format 2, expected 1: use a newer lunoid"),
        (b"hello", "not a bank: byte 0: found \"hello\", expected \"LUNOBANK\""),
    ] {
        room.write("b.bank", bytes);
        for arguments in [
            &["replay", "tiny.toml", "--bank", "b.bank"][..],
            &["probe", "tiny.toml", "--bank", "b.bank", "--frame", "0", "--sweep", "0", "-o", "w.csv"],
            &["bank", "show", "b.bank", "-o", "b.png"],
            &["bank", "export", "b.bank", "-o", "b.npy"],
        ] {
            room.refused(INPUT, arguments, &["b.bank", word]);
        }
    }
    for missing in ["gone.bank", "folder"] {
        room.refused(INPUT, &["replay", "tiny.toml", "--bank", missing], &[missing]);
        room.refused(INPUT, &["bank", "show", missing], &[missing]);
    }
    room.refused(USAGE, &["bank", "export", "whole.bank", "--level", "1", "-o", "x.npy"], &["levels 0..1"]);
}

#[test]
fn arrays_that_are_no_corners() {
    let room = Room::new();
    let zeros = |count: usize| doubles(&CORNERS[..count]);
    let singles = [0.0_f32; 81].iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let whole = corners(0.0);
    let cases = [
        (
            "flat",
            npy("<f8", "(3, 27)", &zeros(81)),
            "shape [3, 27]: expected [corners north, corners east, 9",
        ),
        ("eight", npy("<f8", "(3, 3, 8)", &zeros(72)), "shape [3, 3, 8]"),
        ("words-first", npy("<f8", "(9, 3, 3)", &zeros(81)), "shape [9, 3, 3]: expected"),
        ("row", npy("<f8", "(1, 9, 9)", &zeros(81)), "1 x 9 corners: expected at least 2 x 2"),
        ("none", npy("<f8", "(0, 3, 9)", &[]), "0 x 3 corners"),
        ("f32", npy("<f4", "(3, 3, 9)", &singles), "type f32: expected f64"),
        ("object", npy("|O", "(3, 3, 9)", &zeros(81)), "'|O'"),
        ("nan", corners(f64::NAN), "corner (1, 1), word 4: NaN"),
        ("infinite", corners(f64::NEG_INFINITY), "corner (1, 1), word 4: -inf"),
        ("vast", corners(1e308), "corner (1, 1), word 4: 1e308: expected a number of at most 1e12 m"),
        ("short", whole[..whole.len() - 9].to_vec(), "needs 648 bytes"),
        ("long", [&whole[..], b"x"].concat(), "needs 648 bytes"),
        ("empty", vec![], "not an NPY file"),
    ];
    for (name, bytes, word) in cases {
        let file = format!("{name}.npy");
        room.write(&file, bytes);
        room.refused(
            INPUT,
            &["bank", "import", &file, "--region-size-m", "100", "-o", "x.bank"],
            &[&file, word],
        );
    }
    room.refused(
        INPUT,
        &["bank", "import", "gone.npy", "--region-size-m", "9", "-o", "x.bank"],
        &["gone.npy"],
    );
    room.write("whole.npy", whole);
    for options in [
        &["--region-size-m", "0"][..],
        &["--region-size-m", "nan"],
        &["--region-size-m", "9", "--origin-m", "inf,0"],
        &["--region-size-m", "9", "--origin-m", "0"],
    ] {
        let arguments = [&["bank", "import", "whole.npy", "-o", "x.bank"], options].concat();
        room.refused(USAGE, &arguments, &["invalid value"]);
    }
    room.done(&["bank", "import", "whole.npy", "--region-size-m", "100", "-o", "x.bank"]);
}
