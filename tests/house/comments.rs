//! A doc comment says what its item is: never a riddle of three words.

use std::fs;

use crate::metadata::root;
use crate::sources::sources;

/// Words that a doc comment has at least.
const FEWEST: usize = 4;

/// Text of a doc comment, if the line is one.
fn doc<'a>(line: Option<&&'a str>) -> Option<&'a str> {
    line.and_then(|line| line.trim_start().strip_prefix("///"))
}

/// Doc comments of one line with fewer words, with their line numbers.
fn riddles(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for (number, line) in lines.iter().enumerate() {
        let Some(comment) = doc(Some(line)) else { continue };
        let before = number.checked_sub(1).and_then(|before| doc(lines.get(before)));
        let is_alone = before.is_none() && doc(lines.get(number + 1)).is_none();
        if is_alone && comment.split_whitespace().count() < FEWEST {
            found.push(format!("line {}: {}", number + 1, comment.trim()));
        }
    }
    found
}

#[test]
fn no_doc_comment_is_a_riddle() {
    let mut files = Vec::new();
    ["crates", "tests"].iter().for_each(|folder| sources(&root().join(folder), &mut files));
    assert!(files.len() > 500, "{} files", files.len());
    let mut found = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file");
        found.extend(riddles(&text).into_iter().map(|riddle| format!("{}: {riddle}", file.display())));
    }
    assert!(found.is_empty(), "doc comments of fewer than {FEWEST} words:\n{}", found.join("\n"));
}

#[test]
fn a_riddle_is_found() {
    let text = "/// Which limit.\npub a: u8,\n/// Height of the eye (m).\npub b: u8,\n/// One.\n/// And more.\npub c: u8,\n";
    assert_eq!(riddles(text), ["line 1: Which limit."]);
}
