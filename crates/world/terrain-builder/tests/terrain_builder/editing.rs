//! Edits of the text, and the journal that undoes them.

use proptest::prelude::{prop_assert_eq, proptest};
use terrain_builder::{EditError, Journal, JournalError, add, remove};

use crate::{FEATURES, HEAD, file_of};

#[test]
fn adding_and_removing_keep_comments_of_the_others() {
    let text = file_of(&[0, 1]);
    let added = add(&text, FEATURES[4]).unwrap();
    assert!(added.starts_with(&text) && added.ends_with(FEATURES[4]));
    let without = remove(&added, "hill").unwrap();
    assert!(without.contains("# The large one.") && without.contains("a-rock") && !without.contains("hill"));
    let without = remove(&without, "north-crater").unwrap();
    assert!(!without.contains("# The large one."), "{without}");
    assert_eq!(remove(&without, "a-rock").unwrap().trim_end(), HEAD.trim_end());
}

#[test]
fn edits_that_cannot_be_are_refused() {
    let text = file_of(&[0]);
    assert_eq!(add(&text, FEATURES[0]), Err(EditError::Taken("north-crater".into())));
    let twice = format!("{0}{0}", FEATURES[1]);
    assert_eq!(add(&text, &twice), Err(EditError::Taken("hill".into())));
    let missing = remove(&text, "hill").expect_err("refused").to_string();
    assert_eq!(missing, "no feature \"hill\": expected one of north-crater");
    assert!(matches!(add(&text, "[base]\nheight_m = 1\n"), Err(EditError::Block { .. })));
    assert!(matches!(add(&text, ""), Err(EditError::Block { .. })));
    assert!(matches!(add(&text, "[[feature]]\nkind = \"crater\"\n"), Err(EditError::Block { .. })));
    assert!(matches!(add(&text, "[[feature"), Err(EditError::Syntax { what: "the block", .. })));
    assert!(matches!(remove("a = = 1", "b"), Err(EditError::Syntax { .. })));
    assert_eq!(remove("feature = [{ id = \"a\" }]", "a"), Err(EditError::Inline));
}

#[test]
fn edits_are_undone_to_the_byte_the_last_one_first() {
    let mut journal = Journal::default();
    let first = file_of(&[0, 1]);
    let second = add(&first, FEATURES[2]).unwrap();
    journal.push("add small-craters", &first, &second);
    let third = remove(&second, "north-crater").unwrap();
    journal.push("remove north-crater", &second, &third);
    let mut read = Journal::parse(&journal.text()).unwrap();
    assert_eq!(read, journal);
    assert_eq!(read.edits().len(), 2);
    assert_eq!(read.undo(&third), Ok((second.clone(), "remove north-crater".into())));
    assert_eq!(read.undo(&second), Ok((first.clone(), "add small-craters".into())));
    assert_eq!(read.undo(&first), Err(JournalError::Empty));
}

#[test]
fn a_text_changed_by_hand_is_not_undone() {
    let mut journal = Journal::default();
    let second = add(HEAD, FEATURES[2]).unwrap();
    journal.push("add small-craters", HEAD, &second);
    for (from, to) in
        [("seed = 5", "seed = 6"), ("Test ground", "Best ground"), ("Test ground", "A longer title")]
    {
        let changed = second.replace(from, to);
        assert_eq!(journal.undo(&changed), Err(JournalError::Changed("add small-craters".into())));
    }
    assert_eq!(journal.edits().len(), 1);
}

#[test]
fn a_damaged_journal_is_told_by_its_line() {
    let mut journal = Journal::default();
    journal.push("add", "a", "ab");
    let text = format!("{}{{\"what\": 3}}\n", journal.text());
    let told = Journal::parse(&text).expect_err("refused").to_string();
    assert!(told.starts_with("line 2 of the journal: keys are missing"), "{told}");
    assert!(matches!(Journal::parse("no"), Err(JournalError::Line { line: 1, .. })));
}

proptest! {
    #[test]
    fn any_edit_is_undone(from: String, to: String) {
        let mut journal = Journal::default();
        journal.push("edit", &from, &to);
        let mut read = Journal::parse(&journal.text()).unwrap();
        prop_assert_eq!(read.undo(&to), Ok((from, "edit".into())));
    }
}
