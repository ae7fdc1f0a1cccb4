//! Outputs that cannot be written: 4, and what was there stays.

use std::fs;
#[cfg(target_os = "linux")]
use std::process::Command;

use crate::build::{Tiff, doubles, npy};
use crate::room::{OUTPUT, Room};
#[cfg(target_os = "linux")]
use crate::room::{content, said};

/// Every command that writes, without its output; the room must have what it reads.
const WRITERS: [&[&str]; 7] = [
    &["replay", "tiny.toml", "-q", "--y4m"],
    &["bank", "generate", "tiny.toml", "-o"],
    &["bank", "import", "corners.npy", "--region-size-m", "100", "-o"],
    &["bank", "export", "a.bank", "-o"],
    &["bank", "show", "a.bank", "-o"],
    &["survey", "plane.tif", "--region-size-m", "40", "-o"],
    &["survey", "plane.tif", "--region-size-m", "40", "-o", "s.bank", "--picture"],
];

fn room() -> Room {
    let room = Room::new();
    room.done(&["bank", "generate", "tiny.toml", "-o", "a.bank"]);
    room.write("corners.npy", npy("<f8", "(3, 3, 9)", &doubles(&[0.0; 81])));
    room.write("plane.tif", Tiff::plane().bytes());
    room
}

#[test]
fn folders_that_are_not_there_and_folders_in_the_way() {
    let room = room();
    for writer in WRITERS {
        room.refused(
            OUTPUT,
            &[writer, &["gone/out"]].concat(),
            &["gone/out", "cannot write here", "make the folder"],
        );
        room.refused(OUTPUT, &[writer, &["folder"]].concat(), &["folder", "expected a file name"]);
    }
    let probe = ["probe", "tiny.toml", "--frame", "0", "--sweep", "0", "-o", "gone/w.csv"];
    room.refused(OUTPUT, &probe, &["gone/w.csv", "make the folder"]);
}

/// A bank and its description are two files: neither is written where the other cannot be.
#[test]
fn a_description_that_cannot_be_written_stops_the_bank() {
    let room = room();
    fs::create_dir(room.join("b.bank.toml")).unwrap();
    for writer in [WRITERS[1], WRITERS[2], WRITERS[5]] {
        room.refused(OUTPUT, &[writer, &["b.bank"]].concat(), &["b.bank.toml", "expected a file name"]);
    }
}

/// No permission, where the tests are not run by somebody who has every permission.
#[cfg(unix)]
#[test]
fn folders_that_nobody_may_write() {
    use std::os::unix::fs::PermissionsExt;

    let room = room();
    let allow = |mode| fs::set_permissions(room.join("folder"), fs::Permissions::from_mode(mode)).unwrap();
    allow(0o555);
    let may_anyway = fs::write(room.join("folder/x"), "").is_ok();
    if !may_anyway {
        for writer in WRITERS {
            room.refused(OUTPUT, &[writer, &["folder/out"]].concat(), &["folder/out"]);
        }
        room.refused(OUTPUT, &["replay", "tiny.toml", "--out", "folder/run"], &["folder/run"]);
    }
    allow(0o755);
}

/// A system folder in which nobody can make a file.
#[cfg(target_os = "linux")]
#[test]
fn folders_where_nothing_can_be_made() {
    let room = room();
    for writer in WRITERS {
        room.refused(OUTPUT, &[writer, &["/proc/out"]].concat(), &["/proc/out", "cannot write here"]);
    }
    room.refused(OUTPUT, &["replay", "tiny.toml", "--out", "/proc/run"], &["/proc/run", "cannot make"]);
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_one_error() {
    let room = room();
    for writer in [WRITERS[0], WRITERS[3], WRITERS[4], WRITERS[6]] {
        let said = room.run(&[writer, &["/dev/full"]].concat());
        said.is_one_error(OUTPUT, &["/dev/full", "no space left"], writer[0]);
    }
    assert!(!room.join("s.bank").exists() || room.join("s.bank.toml").exists());
}

/// Files may grow to a limit (512-byte blocks), and the write beyond it fails instead of ending the process.
#[cfg(target_os = "linux")]
fn limited(room: &Room, blocks: u32, arguments: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.current_dir(room.path()).args([
        "-c",
        &format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\""),
        "sh",
    ]);
    command.arg(env!("CARGO_BIN_EXE_lunoid")).args(arguments);
    command
}

/// Wherever in a run the disk is full: one error, no torn file, and the same command goes on when there is room.
#[cfg(target_os = "linux")]
#[test]
fn a_run_that_fills_the_disk_goes_on_later() {
    let room = Room::new();
    fn replay(out: &str) -> [&str; 7] {
        ["replay", "tiny.toml", "-q", "--sweeps", "300", "--out", out]
    }
    room.done(&replay("whole"));
    let whole = content(&room.join("whole"));
    let largest = whole.values().flatten().map(Vec::len).max().unwrap();
    for blocks in [0, 1, 2, 4, 8, largest as u32 / 512 - 1] {
        let out = format!("r{blocks}");
        let limit = said(limited(&room, blocks, &replay(&out)));
        limit.is_one_error(OUTPUT, &[&out], &format!("{blocks} blocks"));
        for (path, bytes) in content(&room.join(&out)) {
            let name = path.strip_prefix(room.join(&out)).unwrap();
            // The journal is on its way, and what a run took is of that run alone.
            let is_ours =
                name.extension().is_some_and(|kind| kind != "journal") && !name.ends_with("performance.json");
            let reference = whole.get(&room.join("whole").join(name));
            assert!(!is_ours || reference == Some(&bytes), "{blocks}: {}", path.display());
        }
        room.done(&replay(&out));
        assert_eq!(room.read(&format!("{out}/run.json")), room.read("whole/run.json"), "{blocks}");
    }
}

/// The old file stays where the new one has no room.
#[cfg(target_os = "linux")]
#[test]
fn an_old_output_survives_a_full_disk() {
    let room = room();
    room.write("old", "old");
    room.write("old.bank", "old");
    room.write("old.png", "old");
    let before = content(room.path());
    let banks = [1, 2, 3, 5].map(|writer| (WRITERS[writer], "old.bank"));
    let pictures = [4, 6].map(|writer| (WRITERS[writer], "old.png"));
    for (writer, out) in banks.into_iter().chain(pictures).chain([(WRITERS[3], "old")]) {
        let arguments = [writer, &[out][..]].concat();
        said(limited(&room, 1, &arguments)).is_one_error(OUTPUT, &["cannot write"], &arguments.join(" "));
        assert_eq!(content(room.path()), before, "{arguments:?}");
    }
}
