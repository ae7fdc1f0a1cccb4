//! Control characters of files never reach a terminal: they are shown.

use crate::build::{doubles, npy};
use crate::room::{Room, TINY};

/// What would steer a terminal, or turn the order of letters.
const STEERS: [char; 6] = ['\u{1b}', '\u{7}', '\u{9b}', '\u{7f}', '\u{202e}', '\u{2066}'];

fn is_plain(text: &str, what: &str) {
    let found = text.chars().find(|c| STEERS.contains(c) || (c.is_control() && *c != '\n' && *c != '\t'));
    assert_eq!(found, None, "{what}: {text:?}");
}

#[test]
fn titles_names_and_values_are_shown() {
    let room = Room::new();
    // Characters of control are refused in a title; those that turn the direction of writing are not.
    let title = "Tiny \\u202eback";
    room.write("t.toml", TINY.replace("title = \"Tiny\"", &format!("title = \"{title}\"")));
    room.done(&["bank", "generate", "t.toml", "-o", "x.bank"]);
    let shown = room.done(&["bank", "show", "x.bank"]);
    is_plain(&shown, "bank show");
    assert!(shown.contains("Tiny \\u{202e}back"), "{shown}");
    let json = room.done(&["bank", "show", "x.bank", "--json"]);
    is_plain(&json, "bank show --json");
    serde_json::from_str::<serde_json::Value>(&json).expect("the same document");
    room.done(&["replay", "t.toml", "-q", "--out", "r", "--frames", "0"]);
    is_plain(&room.done(&["info", "r"]), "info");
    is_plain(&String::from_utf8(room.read("r/index.html")).unwrap().replace('\r', ""), "index.html");
    room.run(&["probe", "t.toml", "--frame", "0", "--sweep", "5", "--signals", "tg.height", "-o", "w.csv"]);
    is_plain(&String::from_utf8(room.read("w.csv")).unwrap(), "w.csv");
}

#[test]
fn errors_show_what_they_quote() {
    let room = Room::new();
    room.write("e\u{1b}[1m.toml", TINY.replace("sweeps = 40", "sweeps = \"\u{9b}31m\u{202e}\""));
    let values = npy("<f8", "(3, 3, 9)", &doubles(&[0.0; 81]));
    room.write("c\u{1b}.npy", values);
    let commands: [&[&str]; 5] = [
        &["check", "e\u{1b}[1m.toml"],
        &["check", "gone\u{1b}[2J.toml"],
        &["replay", "tiny.toml", "-m", "x\u{1b}[2J", "--out", "r"],
        &["survey", "c\u{1b}.npy", "-o", "x.bank"],
        &["info", "gone\u{9b}.png"],
    ];
    for command in commands {
        let said = room.run(command);
        assert_ne!(said.code, Some(0), "{command:?}");
        is_plain(&(said.err + &said.out), &format!("{command:?}"));
    }
}
