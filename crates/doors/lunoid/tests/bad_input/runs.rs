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

/// A name does not make a file a run's: it is neither removed nor replaced.
#[test]
fn files_of_somebody_else_with_names_of_a_run_stay() {
    let room = Room::new();
    room.done(&REPLAY);
    let whole = content(&room.join("r"));
    let write = |name: &str, text: &str| {
        let path = room.join("r").join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    let remove = |name: &str| {
        let path = room.join("r").join(name);
        fs::remove_file(&path).unwrap();
        let _ = fs::remove_dir(path.parent().unwrap());
    };
    for name in ["frames/frame-000099.png", "animation.png", "scopes/frame-000000-sweep-0005.svg"] {
        write(name, "mine");
        room.done(&REPLAY);
        assert_eq!(room.read(&format!("r/{name}")), b"mine", "{name}");
        room.refused(OUTPUT, &with(&["--fresh"]), &[name, "which no run wrote"]);
        remove(name);
    }
    for (name, options) in [("animation.png", &["--apng"][..]), ("truth/poses.csv", &["--truth", "pose"])] {
        write(name, "mine");
        room.refused(OUTPUT, &with(options), &[name, "which no run wrote"]);
        remove(name);
    }
    for name in ["index.html", "poses.csv", "page.json"] {
        fs::rename(room.join("r").join(name), room.join("kept")).unwrap();
        fs::create_dir(room.join("r").join(name)).unwrap();
        room.refused(OUTPUT, &with(&["--fresh"]), &[name]);
        fs::remove_dir(room.join("r").join(name)).unwrap();
        fs::rename(room.join("kept"), room.join("r").join(name)).unwrap();
    }
    write("index.html", "<title>mine</title>");
    room.refused(OUTPUT, &REPLAY, &["index.html", "which no run wrote"]);
    room.done(&with(&["--no-page"]));
    fs::remove_file(room.join("r/index.html")).unwrap();
    room.done(&REPLAY);
    assert_eq!(content(&room.join("r")).len(), whole.len());
}

/// Frames of a run without record and journal are still a run's.
#[test]
fn a_killed_run_without_its_journal_is_drawn_anew() {
    let room = Room::new();
    room.done(&REPLAY);
    let record = room.read("r/run.json");
    let beside =
        ["poses.csv", "camera.json", "performance.json", "contact-sheet.png", "index.html", "page.json"];
    for journal in [Some(""), None] {
        for name in ["run.json"].iter().chain(&beside) {
            fs::remove_file(room.join("r").join(name)).unwrap();
        }
        journal.into_iter().for_each(|text| room.write("r/frames.journal", text));
        room.refused(INPUT, &REPLAY, &["--fresh"]);
        room.done(&with(&["--fresh"]));
        assert_eq!(room.read("r/run.json"), record);
    }
}

#[test]
fn records_that_are_damaged_or_newer_are_said_to_be_so() {
    let room = Room::new();
    room.done(&REPLAY);
    let whole = String::from_utf8(room.read("r/run.json")).unwrap();
    let leads_to = |place| sealed_again(&whole.replacen("frames/frame-000000.png", place, 1));
    let (elsewhere, absolute) = (leads_to("../../tiny.toml"), leads_to("/etc/passwd"));
    for (text, word) in [
        (&whole[..whole.len() / 2], "EOF while parsing"),
        ("{\"schema\": \"lunoid.run/2\"}", "missing field `format`"),
        (&whole.replace("lunoid.run/2", "lunoid.run/3"), "lunoid.run/3"),
        (&whole.replace("lunoid.run/2", "lunoid.run/1"), "lunoid.run/1"),
        (&whole.replacen("\"format\": 2", "\"format\": 3", 1), "format 3, expected 1 to 2"),
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

/// The record as somebody seals it who has changed it.
fn sealed_again(record: &str) -> String {
    let end = record.rfind(",\n  \"seal\"").unwrap();
    run_record::sealed(&format!("{}\n}}\n", &record[..end]))
}

/// The journal of a run that stops before its record is written.
fn journal(record: &[u8]) -> Vec<u8> {
    let run: run_record::RunRecord = serde_json::from_slice(record).unwrap();
    let heading = format!("{{\"schema\":\"lunoid.journal/1\",\"fingerprint\":\"{}\"}}\n", run.fingerprint);
    let lines =
        run.frames.iter().map(|frame| run_record::sealed(&serde_json::to_string(frame).unwrap()) + "\n");
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
