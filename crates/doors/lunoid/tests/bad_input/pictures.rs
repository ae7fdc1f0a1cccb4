//! Pictures that cannot be compared.

use std::fs;

use crate::build::COLOUR_PNG;
use crate::room::{INPUT, OUTPUT, Room};

#[test]
fn what_is_no_grey_picture() {
    let room = Room::new();
    room.done(&["replay", "tiny.toml", "-q", "--out", "a", "--frames", "0"]);
    fs::copy(room.join("a/frames/frame-000000.png"), room.join("good.png")).unwrap();
    let good = room.read("good.png");
    let mut flipped = good.clone();
    flipped[good.len() - 40] ^= 0x10;
    room.write("colour.png", COLOUR_PNG);
    room.write("short.png", &good[..200]);
    room.write("empty.png", "");
    room.write("flipped.png", flipped);
    for (bad, words) in [
        ("colour.png", &["1x1", "draw both on the same raster"][..]),
        ("short.png", &["not a whole PNG"]),
        ("empty.png", &["not a whole PNG"]),
        ("flipped.png", &["not a whole PNG"]),
        ("tiny.toml", &["not a whole PNG, JPEG or TIFF: it begins with 66 6F 72 6D"]),
        ("gone.png", &["no such file"]),
        ("folder", &["one is a folder and one a file"]),
        ("a", &["one is a folder and one a file"]),
    ] {
        for pair in
            [["good.png", bad], ["good.png", bad].map(|name| if name == bad { "good.png" } else { bad })]
        {
            let arguments = ["compare", pair[0], pair[1], "-o", "x.png"];
            room.refused(INPUT, &arguments, &[&[bad][..], words].concat());
        }
    }
    room.refused(
        INPUT,
        &["compare", "good.png", "good.png", "--mask", "colour.png"],
        &["a mask of 1 values"],
    );
    room.refused(INPUT, &["info", "short.png"], &["short.png", "not a whole PNG"]);
    room.refused(OUTPUT, &["compare", "good.png", "good.png", "-o", "gone/x.png"], &["gone/x.png"]);
}

#[test]
fn pictures_and_runs_that_do_not_go_together() {
    let room = Room::new();
    let draw = |out: &'static str, options: &[&'static str]| {
        room.done(&[&["replay", "tiny.toml", "-q", "--out", out], options].concat())
    };
    draw("a", &["--frames", "0"]);
    draw("b", &["--frames", "0", "--sweeps", "20"]);
    draw("c", &["--frames", "1"]);
    let frame = |run| format!("{run}/frames/frame-000000.png");
    room.refused(
        INPUT,
        &["compare", &frame("a"), &frame("b")],
        &["40x23", "20x", "draw both on the same raster"],
    );
    room.refused(INPUT, &["compare", "a", "b"], &["40x23", "20x"]);
    room.refused(
        INPUT,
        &["compare", &frame("a"), &frame("a"), "--mask", &frame("b")],
        &["mask", "expected 920"],
    );
    room.refused(INPUT, &["compare", "a", "c"], &["no frame is in both"]);
    room.refused(INPUT, &["compare", "a", "folder"], &["folder/run.json"]);
}
