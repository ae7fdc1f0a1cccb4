//! Attacks on folders: links, pipes, records that were tampered with, two writers, signals, little room. Whatever comes of the
//! command, nothing outside its folder changes by a byte.
//!
//! docs/robustness.md has the last results.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::room::{Content, INPUT, OUTPUT, Room, content, said};

const REPLAY: [&str; 5] = ["replay", "tiny.toml", "-q", "--out", "r"];
const AUGMENT: [&str; 6] = ["augment", "s/frames", "s/poses.csv", "--sun", "100,15", "-q"];

/// With a finished run `s`, and files of somebody else in `far`.
fn room() -> Room {
    let room = Room::new();
    room.done(&["replay", "tiny.toml", "-q", "--out", "s"]);
    fs::create_dir(room.join("far")).unwrap();
    for name in
        ["victim.txt", "frame-000000.png", "frame-000099.png", ".mine.1-2.tmp", ".frame-000000.png.1-2.tmp"]
    {
        room.write(&format!("far/{name}"), "precious");
    }
    room
}

/// Everything of the room but the folder `r`.
fn outside(room: &Room) -> Content {
    content(room.path()).into_iter().filter(|(path, _)| !path.starts_with(room.join("r"))).collect()
}

fn clear(room: &Room) {
    let r = room.join("r");
    if r.is_symlink() {
        fs::remove_file(r).unwrap()
    } else {
        let _ = fs::remove_dir_all(r);
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let (path, to) = (entry.as_ref().unwrap().path(), to.join(entry.as_ref().unwrap().file_name()));
        if path.is_dir() { copy(&path, &to) } else { fs::copy(path, to).map(drop).unwrap() }
    }
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// Every file and folder that a run writes, as a link to a file of somebody else, to nothing, or as a pipe; with a whole run around
/// it or without, and by every command that writes into a run folder.
#[test]
fn nothing_of_a_run_is_written_through_links_or_pipes() {
    let room = room();
    let names = [
        ".lunoid.lock",
        "poses.csv",
        "camera.json",
        "index.html",
        "page.json",
        "contact-sheet.png",
        "run.json",
        "performance.json",
        "frames.journal",
        "animation.png",
        "frames/frame-000000.png",
        "frames/frame-000003.png",
        "truth/truth.json",
        "scopes/frame-000000-sweep-0005.svg",
    ];
    let replays: [&[&str]; 3] = [&[], &["--fresh"], &["--apng", "--truth", "pose", "--probe", "0:5"]];
    for (number, name) in names.iter().enumerate() {
        for target in ["far/victim.txt", "far/new.txt", "pipe"] {
            let options = replays[number % replays.len()];
            clear(&room);
            copy(&room.join("s"), &room.join("r"));
            let path = room.join("r").join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            let _ = fs::remove_file(&path);
            match target {
                "pipe" => pipe(&path),
                target => symlink(room.join(target), &path).unwrap(),
            }
            let word = if target == "pipe" { "this is a pipe" } else { "this is a link" };
            room.refused(OUTPUT, &[&REPLAY[..], options].concat(), &[name, word]);
        }
    }
}

#[test]
fn folders_that_are_links_lose_nothing() {
    let room = room();
    for name in ["frames", "truth", "scopes"] {
        for options in [&[][..], &["--fresh"], &["--frames", "0..2"]] {
            clear(&room);
            copy(&room.join("s"), &room.join("r"));
            let _ = fs::remove_dir_all(room.join("r").join(name));
            symlink("../far", room.join("r").join(name)).unwrap();
            room.refused(OUTPUT, &[&REPLAY[..], options].concat(), &[name, "this is a link"]);
        }
    }
    clear(&room);
    symlink("far", room.join("r")).unwrap();
    for out in ["r", "r/", "r/."] {
        room.refused(OUTPUT, &["replay", "tiny.toml", "-q", "--out", out], &["r", "this is a link"]);
        room.refused(
            OUTPUT,
            &[&AUGMENT[..], &["--vehicle", "rover", "--out", out]].concat(),
            &["this is a link"],
        );
    }
    let several = ["replay", "tiny.toml", "-q", "-m", "ideal", "-m", "exact", "--out", "r"];
    room.refused(OUTPUT, &several, &["a link of this name"]);
    let pictures = ["compare", "s", "s", "--pictures", "r"];
    let before = outside(&room);
    room.run(&pictures);
    assert_eq!(outside(&room), before);
}

/// A folder in which the user has what is no run, and a lock that leads elsewhere: refused for the lock, and nothing is emptied.
#[test]
fn a_lock_that_leads_elsewhere_empties_nothing() {
    let room = room();
    for is_hard in [false, true] {
        clear(&room);
        fs::create_dir(room.join("r")).unwrap();
        room.write("r/notes.txt", "mine");
        let lock = room.join("r/.lunoid.lock");
        if is_hard {
            fs::hard_link(room.join("far/victim.txt"), lock).unwrap();
        } else {
            symlink("../far/victim.txt", lock).unwrap();
        }
        let what = if is_hard { "has another name too (a hard link)" } else { "this is a link" };
        room.refused(OUTPUT, &REPLAY, &["r/.lunoid.lock", what]);
    }
}

#[test]
fn outputs_are_never_links_or_pipes() {
    let room = room();
    room.done(&["bank", "generate", "tiny.toml", "-o", "a.bank"]);
    symlink("far/victim.txt", room.join("link")).unwrap();
    symlink("far/new.txt", room.join("dangling")).unwrap();
    symlink("far", room.join("folder-link")).unwrap();
    symlink("/dev/null", room.join("null")).unwrap();
    pipe(&room.join("pipe"));
    let writers: [&[&str]; 5] = [
        &["replay", "tiny.toml", "-q", "--out", "r", "--y4m"],
        &["bank", "generate", "tiny.toml", "-o"],
        &["bank", "export", "a.bank", "-o"],
        &["timing", "record", "tiny.toml", "--frames", "0..1", "--no-progress", "--out"],
        &["probe", "tiny.toml", "--frame", "0", "--sweep", "5", "--format", "csv", "--out"],
    ];
    for writer in writers {
        for (name, word) in [
            ("link", "link"),
            ("dangling", "link"),
            ("folder-link", "link"),
            ("null", "link"),
            ("pipe", "pipe"),
        ] {
            room.refused(OUTPUT, &[writer, &[name]].concat(), &[name, &format!("this is a {word}")]);
        }
    }
    // What stands beside an output is one too.
    symlink("far/victim.txt", room.join("b.bank.toml")).unwrap();
    room.refused(
        OUTPUT,
        &["bank", "generate", "tiny.toml", "-o", "b.bank"],
        &["b.bank.toml", "this is a link"],
    );
}

/// A pipe that nobody writes keeps nobody waiting.
#[test]
fn inputs_are_files() {
    let room = room();
    for name in ["p.toml", "p.bank", "p.tif", "p.png", "p.npy", "p.lbl"] {
        pipe(&room.join(name));
    }
    room.vary("s.toml", crate::room::KEYFRAMES, "file = \"p.csv\"");
    pipe(&room.join("p.csv"));
    let commands: [&[&str]; 9] = [
        &["check", "p.toml"],
        &["check", "s.toml"],
        &["replay", "p.toml", "--out", "r"],
        &["replay", "tiny.toml", "-m", "./p.toml", "--out", "r"],
        &["bank", "show", "p.bank"],
        &["info", "p.png"],
        &["info", "/dev/zero"],
        &["compare", "p.png", "s/frames/frame-000000.png"],
        &["survey", "p.tif", "--region-size-m", "40", "-o", "new.bank"],
    ];
    for command in commands {
        let mut bounded = Command::new("timeout");
        bounded.current_dir(room.path()).arg("60").arg(env!("CARGO_BIN_EXE_lunoid")).args(command);
        said(bounded).is_one_error(INPUT, &["p"], &command.join(" "));
    }
}

/// A scenario that came from elsewhere reads nothing but what came with it.
#[test]
fn references_do_not_leave_by_links() {
    let room = room();
    fs::create_dir(room.join("came")).unwrap();
    room.write("far/path.csv", "t_s,x_m,y_m\n0,100,200\n5,108,205\n");
    room.vary("came/file.toml", crate::room::KEYFRAMES, "file = \"path.csv\"");
    room.vary("came/folder.toml", crate::room::KEYFRAMES, "file = \"below/path.csv\"");
    symlink("../far/path.csv", room.join("came/path.csv")).unwrap();
    symlink("../far", room.join("came/below")).unwrap();
    for name in ["came/file.toml", "came/folder.toml"] {
        let words = [name, "leads out of the scenario's folder", "copy the file into the folder"];
        room.refused(INPUT, &["check", name], &words);
    }
    room.vary("near.toml", crate::room::KEYFRAMES, "file = \"near.csv\"");
    symlink("far/path.csv", room.join("near.csv")).unwrap();
    room.done(&["check", "near.toml"]);
}

fn tampered(room: &Room, change: impl Fn(&mut Value)) {
    clear(room);
    copy(&room.join("s"), &room.join("r"));
    let mut record: Value = serde_json::from_slice(&room.read("r/run.json")).unwrap();
    change(&mut record);
    // Whoever changes a record on purpose seals it again.
    record.as_object_mut().unwrap().remove("seal");
    room.write("r/run.json", run_record::sealed(&record.to_string()));
}

#[test]
fn records_that_were_changed_by_hand_are_told() {
    let room = room();
    for (old, new) in [
        ("\"samples\": ", "\"samples\": 1"),
        ("\"time_s\": 0.0", "\"time_s\": 9.0"),
        ("\"pixels_blake3\": \"", "\"pixels_blake3\": \"0"),
        ("\"title\": \"", "\"title\": \"My "),
    ] {
        clear(&room);
        copy(&room.join("s"), &room.join("r"));
        let whole = String::from_utf8(room.read("r/run.json")).unwrap();
        assert!(whole.contains(old), "{old}");
        room.write("r/run.json", whole.replacen(old, new, 1));
        for arguments in [&REPLAY[..], &["info", "r"]] {
            room.refused(INPUT, arguments, &["r/run.json", "changed since it was written", "--fresh"]);
        }
        room.done(&[&REPLAY[..], &["--fresh"]].concat());
        assert_eq!(room.read("r/run.json"), whole.as_bytes());
    }
}

#[test]
fn records_that_were_tampered_with_are_refused_within_limits() {
    let room = room();
    for (number, word) in [
        (1_000_000_u64, "frame 1000000 in place of frame 3"),
        (1_000_000_000, "frame 1000000000 in place of frame 3; expected frames 0..4"),
        (4_611_686_018_427_387_904, "frame 4611686018427387904"),
        (u64::MAX, "frame 18446744073709551615"),
        (2, "frame 2 in place of frame 3"),
    ] {
        tampered(&room, |record| record["frames"][3]["frame"] = number.into());
        room.refused(INPUT, &REPLAY, &["r/run.json", word, "--fresh"]);
    }
    tampered(&room, |record| record["range"] = serde_json::json!([0, u64::MAX]));
    room.refused(INPUT, &REPLAY, &["it lists 4 frames; expected frames 0..18446744073709551615"]);
    tampered(&room, |record| {
        record["range"] = serde_json::json!([9, 10]);
        record["frames"] = serde_json::json!([record["frames"][3]]);
        record["frames"][0]["frame"] = 9.into();
    });
    room.refused(INPUT, &REPLAY, &["holds frame 9", "the mission has frames 0..4"]);
    tampered(&room, |record| record["frames"][3]["files"][0]["file"] = "".into());
    room.refused(INPUT, &REPLAY, &["expected files of its folder"]);
    tampered(&room, |record| record["frames"][3]["counts"]["samples"] = u64::MAX.into());
    room.refused(INPUT, &REPLAY, &["frame 3 counts 18446744073709551615 samples", "--fresh"]);
    // The same in a journal.
    for (old, new, word) in [
        ("\"frame\":3,", "\"frame\":4611686018427387904,", "holds frame 4611686018427387904"),
        ("frames/frame-000003.png", "../far/victim.txt", "it lists `../far/victim.txt`"),
        ("frames/frame-000003.png", "/etc/hostname", "it lists `/etc/hostname`"),
    ] {
        clear(&room);
        copy(&room.join("s"), &room.join("r"));
        let record: Value = serde_json::from_slice(&room.read("r/run.json")).unwrap();
        let heading =
            serde_json::json!({ "schema": "lunoid.journal/1", "fingerprint": record["fingerprint"] });
        let frames = record["frames"].as_array().unwrap().iter();
        let frames = frames.map(|frame| run_record::sealed(&frame.to_string().replace(old, new)));
        let lines: Vec<String> = [heading.to_string()].into_iter().chain(frames).collect();
        fs::remove_file(room.join("r/run.json")).unwrap();
        room.write("r/frames.journal", lines.join("\n") + "\n");
        room.refused(INPUT, &REPLAY, &["r/frames.journal", word]);
    }
}

#[test]
fn a_mission_that_was_cut_and_one_that_changed_are_told() {
    let room = room();
    room.vary("tiny.toml", "frames = 4", "frames = 3");
    let replay = ["replay", "tiny.toml", "-q", "--out", "s"];
    room.refused(INPUT, &replay, &["holds frame 3", "frames 0..3", "cut to fewer frames", "--fresh"]);
    room.vary("tiny.toml", "elevation_deg = 15", "elevation_deg = 16");
    room.refused(OUTPUT, &replay, &["sun.elevation_deg (", "holds another run"]);
    room.vary("tiny.toml", "sweeps = 40", "sweeps = 20");
    room.refused(OUTPUT, &replay, &["sweeps (40 there, 20 now)"]);
    room.vary("tiny.toml", "seed = 3", "seed = 4");
    room.refused(OUTPUT, &replay, &["ground.content_blake3 (other content)"]);
    room.refused(
        OUTPUT,
        &[&replay[..], &["--machine", "exact"]].concat(),
        &["generator (", "\"exact\" now)"],
    );
}

fn start(room: &Room, arguments: &[&str]) -> Child {
    room.command(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

fn wait_for(is_there: impl Fn() -> bool) {
    let began = Instant::now();
    while !is_there() && began.elapsed() < Duration::from_secs(120) {
        sleep(Duration::from_millis(1));
    }
}

/// As `replay`: one writer, one augmentation, nothing of somebody else, no link, and no leftovers.
#[test]
fn an_augmentation_has_its_folder_for_itself() {
    let room = room();
    let augment = |vehicle, out| [&AUGMENT[..], &["--vehicle", vehicle, "--out", out]].concat();
    room.done(&augment("rover", "a"));
    room.refused(
        OUTPUT,
        &augment("lander", "a"),
        &["another augmentation", "vehicle.shape (\"rover\" there, \"lander\" now)"],
    );
    // Interrupted before its record: the pictures themselves tell.
    fs::remove_file(room.join("a/augment.json")).unwrap();
    room.refused(OUTPUT, &augment("lander", "a"), &["another augmentation", "--fresh"]);
    room.write("a/.frame-000000.png.1-2.tmp", "left");
    room.write("a/notes.txt", "mine");
    room.done(&augment("rover", "a"));
    assert!(!room.join("a/.frame-000000.png.1-2.tmp").exists() && room.join("a/notes.txt").exists());
    room.done(&[&augment("lander", "a")[..], &["--fresh"]].concat());
    assert!(room.join("a/notes.txt").exists());
    room.refused(OUTPUT, &augment("rover", "far"), &["`frame-000000.png`", "did not make"]);
    fs::remove_file(room.join("far/frame-000000.png")).unwrap();
    room.refused(OUTPUT, &augment("rover", "far"), &["did not make", "--fresh"]);
    fs::create_dir(room.join("b")).unwrap();
    symlink("../far/victim.txt", room.join("b/augment.json")).unwrap();
    room.refused(OUTPUT, &augment("rover", "b"), &["b/augment.json", "this is a link"]);
    fs::remove_file(room.join("b/augment.json")).unwrap();
    symlink("../far/victim.txt", room.join("b/frame-000002.png")).unwrap();
    room.refused(OUTPUT, &augment("rover", "b"), &["b/frame-000002.png", "this is a link"]);
}

#[test]
fn two_augmentations_do_not_mix() {
    let room = Room::new();
    room.vary("long.toml", "frames = 4", "frames = 300");
    room.done(&["replay", "long.toml", "-q", "--out", "s"]);
    let augment = |vehicle, out| [&AUGMENT[..], &["--vehicle", vehicle, "--out", out]].concat();
    room.done(&augment("rover", "alone"));
    let mut first = start(&room, &augment("rover", "m"));
    wait_for(|| room.join("m/frame-000001.png").exists());
    let stop = |name: &str| {
        let _ = Command::new("kill").args([name, &first.id().to_string()]).status().unwrap();
    };
    stop("-STOP");
    let second = room.run(&augment("lander", "m"));
    stop("-CONT");
    second.is_one_error(OUTPUT, &[&format!("process {}", first.id()), "wait for it"], "the second");
    assert!(first.wait().unwrap().success());
    assert_eq!(names_and_bytes(&room.join("m")), names_and_bytes(&room.join("alone")));
}

fn names_and_bytes(folder: &Path) -> Vec<(PathBuf, Option<Vec<u8>>)> {
    let all = content(folder).into_iter();
    all.map(|(path, bytes)| (path.strip_prefix(folder).unwrap().to_owned(), bytes)).collect()
}

/// TERM and HUP leave what INT leaves: exit code 130, whole frames, no lock, no temporary file, and a run that goes on.
#[test]
fn every_signal_that_ends_a_run_ends_it_well() {
    let room = Room::new();
    room.vary("long.toml", "frames = 4", "frames = 120");
    room.done(&["replay", "long.toml", "-q", "--samples", "1500", "--out", "whole"]);
    let whole = room.read("whole/run.json");
    for signal in ["-INT", "-TERM", "-HUP"] {
        let arguments = ["replay", "long.toml", "-q", "--samples", "1500", "--out", signal];
        let mut run = room.command(&arguments[..6]);
        let out = format!("r{signal}");
        let mut run = run.arg(&out).stderr(Stdio::null()).spawn().unwrap();
        wait_for(|| room.join(&out).join("frames/frame-000001.png").exists());
        assert!(Command::new("kill").args([signal, &run.id().to_string()]).status().unwrap().success());
        assert_eq!(run.wait().unwrap().code(), Some(130), "{signal}");
        let left = content(&room.join(&out));
        let hidden: Vec<_> =
            left.keys().filter(|path| path.file_name().unwrap().to_string_lossy().starts_with('.')).collect();
        assert!(
            hidden.is_empty() && left.keys().any(|path| path.ends_with("frames.journal")),
            "{signal}: {hidden:?}"
        );
        room.done(&["replay", "long.toml", "-q", "--samples", "1500", "--out", &out]);
        assert_eq!(room.read(&format!("{out}/run.json")), whole, "{signal}");
    }
}

/// A command that is to outlive its terminal is started to ignore HUP.
#[cfg(target_os = "linux")]
#[test]
fn a_run_under_nohup_goes_on() {
    let room = Room::new();
    room.vary("long.toml", "frames = 4", "frames = 40");
    let mut shell = Command::new("sh");
    shell.current_dir(room.path()).args([
        "-c",
        "trap '' HUP; exec \"$@\"",
        "sh",
        env!("CARGO_BIN_EXE_lunoid"),
    ]);
    shell.args(["replay", "long.toml", "-q", "--samples", "1500", "--out", "r"]);
    let mut run = shell.spawn().unwrap();
    wait_for(|| room.join("r/frames/frame-000001.png").exists());
    let _ = Command::new("kill").args(["-HUP", &run.id().to_string()]).status().unwrap();
    assert!(run.wait().unwrap().success());
    assert!(room.join("r/run.json").exists());
}

/// What a killed command left of an output goes with the next command of that output, and nothing else.
#[test]
fn leftovers_of_a_killed_command_go() {
    let room = Room::new();
    for name in [".a.bank.123-0.tmp", ".b.bank.123-0.tmp", ".a.bank.tmp"] {
        room.write(name, "left");
    }
    room.done(&["bank", "generate", "tiny.toml", "-o", "a.bank"]);
    let is_there =
        [".a.bank.123-0.tmp", ".b.bank.123-0.tmp", ".a.bank.tmp"].map(|name| room.join(name).exists());
    assert_eq!(is_there, [false, true, true]);
    fs::create_dir(room.join("r")).unwrap();
    room.done(&REPLAY);
    room.write("r/.poses.csv.7-0.tmp", "left");
    room.write("r/.mine.7-0.tmp", "mine");
    room.done(&REPLAY);
    assert!(!room.join("r/.poses.csv.7-0.tmp").exists() && room.join("r/.mine.7-0.tmp").exists());
}

/// Little room of the system: a small stack, few descriptors, no file that may grow. The run is done, or one error says why not, and
/// the same command makes a whole run of it.
#[test]
fn little_room_is_one_error_or_none() {
    let room = Room::new();
    room.done(&["replay", "tiny.toml", "-q", "--out", "whole"]);
    for (number, limit) in ["-s 256", "-s 1024", "-n 8", "-n 12", "-n 24", "-f 0", "-f 4"].iter().enumerate()
    {
        let out = format!("r{number}");
        let mut shell = Command::new("sh");
        let script = format!("trap '' XFSZ; ulimit {limit}; exec \"$@\"");
        shell.current_dir(room.path()).args(["-c", &script, "sh", env!("CARGO_BIN_EXE_lunoid")]);
        shell.args(["replay", "tiny.toml", "-q", "--jobs", "2", "--out", &out]);
        let ended = said(shell);
        assert!(!ended.err.contains("panicked"), "{limit}: {ended:?}");
        assert!(
            ended.code == Some(0) || matches!(ended.code, Some(INPUT | OUTPUT)) && ended.errors() == 1,
            "{limit}: {ended:?}"
        );
        room.done(&["replay", "tiny.toml", "-q", "--out", &out]);
        assert_eq!(room.read(&format!("{out}/run.json")), room.read("whole/run.json"), "{limit}");
    }
}
