//! Run folders that hold something else, or a run that is damaged.

use std::fs;

use crate::room::{INPUT, OUTPUT, Room, content};

const REPLAY: [&str; 5] = ["replay", "tiny.toml", "-q", "--out", "r"];

fn with<'a>(options: &[&'a str]) -> Vec<&'a str> {
    [&REPLAY[..], options].concat()
}

#[test]
fn a_folder_of_another_run_is_left_alone() {
    let room = Room::new();
    room.done(&REPLAY);
    room.vary("tiny.toml", "seed = 3", "seed = 4");
    let words = ["holds another run", "choose another --out", "--fresh"];
    room.refused(OUTPUT, &REPLAY, &words);
    room.vary("tiny.toml", "seed = 3", "seed = 3");
    room.refused(OUTPUT, &with(&["--sweeps", "20"]), &words);
    room.refused(OUTPUT, &with(&["--machine", "exact"]), &words);
    room.done(&REPLAY);
}

#[test]
fn folders_and_files_of_somebody_else_are_left_alone() {
    let room = Room::new();
    room.write("folder/chapter.tex", "mine");
    room.write("file", "mine");
    let out = |out| ["replay", "tiny.toml", "--fresh", "--out", out];
    room.refused(
        OUTPUT,
        &["replay", "tiny.toml", "--out", "folder"],
        &["chapter.tex", "choose another --out"],
    );
    room.refused(OUTPUT, &out("file"), &["file", "expected a folder"]);
    room.refused(OUTPUT, &out("file/below"), &["file/below"]);
    fs::create_dir(room.join("folder/frames")).unwrap();
    room.write("folder/frames/frame-000001.png", "mine");
    room.refused(OUTPUT, &out("folder"), &["which no run wrote"]);
}

#[test]
fn records_that_are_damaged_or_newer_are_said_to_be_so() {
    let room = Room::new();
    room.done(&REPLAY);
    let whole = String::from_utf8(room.read("r/run.json")).unwrap();
    let elsewhere = whole.replacen("frames/frame-000000.png", "../../tiny.toml", 1);
    let absolute = whole.replacen("frames/frame-000000.png", "/etc/passwd", 1);
    for (text, word) in [
        (&whole[..whole.len() / 2], "EOF while parsing"),
        ("{\"schema\": \"lunoid.run/2\"}", "missing field `format`"),
        (&whole.replace("lunoid.run/2", "lunoid.run/3"), "lunoid.run/3"),
        (&whole.replace("lunoid.run/2", "lunoid.run/1"), "lunoid.run/1"),
        (&elsewhere, "it lists `../../tiny.toml`, expected files of its folder"),
        (&absolute, "it lists `/etc/passwd`"),
    ] {
        room.write("r/run.json", text);
        for arguments in [&REPLAY[..], &["compare", "r", "r"], &["info", "r"]] {
            room.refused(INPUT, arguments, &["r/run.json", "not the record of a run", word]);
        }
    }
    room.done(&with(&["--fresh"]));
    assert_eq!(room.read("r/run.json"), whole.as_bytes());
}

/// A run is known by its other files, and what is not of it stays.
#[test]
fn a_run_whose_record_is_lost_is_drawn_anew_and_nothing_else_is_removed() {
    let room = Room::new();
    room.done(&REPLAY);
    let whole = room.read("r/run.json");
    room.write("r/notes.txt", "mine");
    room.write("r/frames/notes.txt", "mine");
    for text in [Some("{\n"), Some(""), Some("\0\u{1}"), None] {
        let word = match text {
            Some(text) => {
                room.write("r/run.json", text);
                "not the record of a run"
            }
            None => {
                fs::remove_file(room.join("r/run.json")).unwrap();
                "other files of a run are there"
            }
        };
        for arguments in [&REPLAY[..], &["compare", "r", "r"], &["info", "r"], &["page", "r"]] {
            room.refused(INPUT, arguments, &["r/run.json", word, "the same replay with --fresh"]);
        }
        room.done(&with(&["--fresh"]));
        assert_eq!(room.read("r/run.json"), whole);
    }
    assert_eq!((room.read("r/notes.txt"), room.read("r/frames/notes.txt")), (b"mine".into(), b"mine".into()));
}

#[test]
fn a_run_that_is_not_finished_is_said_to_be_so() {
    let room = Room::new();
    room.done(&REPLAY);
    let record = room.read("r/run.json");
    room.write("r/frames.journal", journal(&record));
    fs::remove_file(room.join("r/run.json")).unwrap();
    for arguments in [&["compare", "r", "r"][..], &["info", "r"], &["page", "r"]] {
        room.refused(INPUT, arguments, &["r: this run is not finished", "the same replay again"]);
    }
    room.done(&REPLAY);
    assert_eq!(room.read("r/run.json"), record);

    let lines = journal(&record).split_off(1);
    room.write("r/frames.journal", lines);
    for name in ["run.json", "performance.json", "camera.json"] {
        fs::remove_file(room.join("r").join(name)).unwrap();
    }
    for arguments in [&REPLAY[..], &["info", "r"]] {
        room.refused(INPUT, arguments, &["r/frames.journal", "not the record of a run", "--fresh"]);
    }
    room.done(&with(&["--fresh"]));
    assert_eq!(room.read("r/run.json"), record);
}

#[test]
fn what_is_not_there_to_be_compared_is_named() {
    let room = Room::new();
    room.done(&REPLAY);
    let picture = "r/frames/frame-000000.png";
    for arguments in [["r", "gone"], ["gone", "r"], [picture, "gone"], ["gone", "there"]] {
        let arguments = [&["compare"], &arguments[..]].concat();
        room.refused(INPUT, &arguments, &["gone: no such file or folder"]);
    }
    room.refused(INPUT, &["compare", "r", picture], &["one is a folder and one a file"]);
}

#[test]
fn damaged_frames_are_drawn_again_and_nothing_else() {
    let room = Room::new();
    room.done(&REPLAY);
    let whole = content(&room.join("r"));
    let frame = |index| format!("r/frames/frame-{index:06}.png");
    let short = room.read(&frame(1))[..50].to_vec();
    room.write(&frame(1), short);
    room.write(&frame(2), "");
    fs::remove_file(room.join(&frame(3))).unwrap();
    fs::remove_file(room.join("r/contact-sheet.png")).unwrap();
    let said = room.run(&["replay", "tiny.toml", "--out", "r"]);
    assert!(said.code == Some(0) && said.out.contains("3 drawn now"), "{said:?}");
    let ours = |run: crate::room::Content| {
        run.into_iter().filter(|(path, _)| !path.ends_with("performance.json")).collect::<Vec<_>>()
    };
    assert_eq!(ours(content(&room.join("r"))), ours(whole));
}

/// The journal of a run that stops before its record is written.
fn journal(record: &[u8]) -> Vec<u8> {
    let run: run_record::RunRecord = serde_json::from_slice(record).unwrap();
    let heading = format!("{{\"schema\":\"lunoid.journal/1\",\"fingerprint\":\"{}\"}}\n", run.fingerprint);
    let lines = run.frames.iter().map(|frame| serde_json::to_string(frame).unwrap() + "\n");
    lines.fold(heading, |text, line| text + &line).into_bytes()
}

/// Whatever is in a record or a journal: the run goes on, or one error says why not.
#[test]
fn no_damage_of_a_record_or_journal_panics() {
    let room = Room::new();
    room.done(&REPLAY);
    let record = room.read("r/run.json");
    let journal = journal(&record);
    for (name, whole) in [("r/run.json", &record), ("r/frames.journal", &journal)] {
        for at in (0..whole.len()).step_by(whole.len() / 25) {
            let mut flipped = whole.clone();
            flipped[at] ^= 0x15;
            for bytes in [&flipped, &whole[..at]] {
                let _ = fs::remove_file(room.join("r/frames.journal"));
                room.write("r/run.json", &record);
                room.write(name, bytes);
                let said = room.run(&REPLAY);
                assert!(!said.err.contains("panicked"), "{name}, byte {at}: {}", said.err);
                match said.code {
                    Some(0) => assert_eq!(said.err, "", "{name}, byte {at}"),
                    Some(INPUT | OUTPUT) => {
                        assert_eq!((said.errors(), &*said.out), (1, ""), "{name}, byte {at}")
                    }
                    code => panic!("{name}, byte {at}: {code:?}"),
                }
            }
        }
    }
}
