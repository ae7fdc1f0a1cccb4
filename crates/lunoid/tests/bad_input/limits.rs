//! What is too much is refused with the name by which it is allowed; allowed, it is taken.

use crate::room::{INPUT, Room, TINY, USAGE};

#[test]
fn one_more_than_a_limit_needs_its_name() {
    let room = Room::new();
    room.vary("long.toml", "frames = 4", "frames = 10000001");
    let padding = "#".repeat((16 << 20) + 1 - TINY.len() - 1);
    room.write("wordy.toml", format!("{TINY}{padding}\n"));
    for (file, limit, first) in
        [("long.toml", "frames", "10000001"), ("wordy.toml", "text-bytes", "16777217")]
    {
        let told = format!("--raise {limit}=N allows more");
        room.refused(INPUT, &["check", file], &[file, &told]);
        room.done(&["check", file, "--raise", &format!("{limit}={first}")]);
    }
}

#[test]
fn ground_names_its_limit_too() {
    let room = Room::new();
    room.vary("s.toml", "extent_m = [400, 400]", "extent_m = [100000, 100050]");
    let words = ["2001 x 2002 corners: expected at most 4000000", "--raise corners=N allows more"];
    room.refused(INPUT, &["replay", "s.toml"], &words);
}

#[test]
fn what_is_no_limit_is_wrong_usage() {
    let room = Room::new();
    let refused = |assignment: &str, words: &[&str]| {
        room.refused(USAGE, &["check", "tiny.toml", "--raise", assignment], words);
    };
    refused("holes=3", &["--raise", "there is no limit `holes`", "corners"]);
    refused("frames=3", &["--raise frames: expected a whole number from 10000000", "found `3`"]);
    refused("frames", &["expected NAME=VALUE"]);
    let listed = room.done(&["list", "limits", "--raise", "rocks=200000"]);
    assert!(listed.contains("rocks") && listed.contains("200000, can be raised to"), "{listed}");
}
