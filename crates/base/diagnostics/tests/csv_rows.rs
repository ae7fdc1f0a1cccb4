//! CSV texts: cells, their places, quotes.

use diagnostics::CsvRows;
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

/// Every row as its cells, and what stands at their places.
fn rows(text: &str) -> Vec<Vec<(String, String)>> {
    let (mut rows, mut found) = (CsvRows::new(text), Vec::new());
    while let Some(row) = rows.next_row() {
        assert_eq!(row.spans().len(), row.width());
        let shown = row.spans().into_iter().map(|span| text[span].to_owned());
        found.push(row.texts().map(str::to_owned).zip(shown).collect());
    }
    found
}

fn pair(text: &str, shown: &str) -> (String, String) {
    (text.to_owned(), shown.to_owned())
}

#[test]
fn quotes_hold_commas_and_quotes() {
    let found = rows("\"a,b\",\"say \"\"c\"\"\", d ,, \"e\"\n");
    let expected = [
        pair("a,b", "\"a,b\""),
        pair("say \"c\"", "\"say \"\"c\"\"\""),
        pair("d", "d"),
        pair("", ""),
        pair("e", "\"e\""),
    ];
    assert_eq!(found, [expected]);
}

#[test]
fn comments_and_empty_lines_are_passed_over_and_places_stay_right() {
    let text = "\u{feff}# one\r\n\r\n  # two, \r\n1,2\r\n   \r\n# three\r\n3,4";
    assert_eq!(rows(text), [[pair("1", "1"), pair("2", "2")], [pair("3", "3"), pair("4", "4")]]);
    let mut rows = CsvRows::new(text);
    let first = rows.next_row().map(|row| row.whole()).expect("a row");
    assert_eq!(&text[first], "1,2");
}

#[test]
fn open_quotes_are_seen_where_they_begin() {
    let open = |text: &str| {
        let mut rows = CsvRows::new(text);
        let mut found = None;
        while let Some(row) = rows.next_row() {
            found = found.or(row.open_quote());
        }
        found
    };
    assert_eq!(open("1,\"2\n3,4\n"), Some(2..3));
    assert_eq!(open("1,2\n3,\"4"), Some(6..7));
    assert_eq!(open("1,\"2\"\n3,\"4\""), None);
    // A quote within a word is a letter.
    assert_eq!(open("1,5\"\n3,4"), None);
}

proptest! {
    /// What is written by the rules comes back, whatever the cells hold.
    #[test]
    fn cells_come_back(cells in proptest::collection::vec("[a-z,\"# ]{0,6}", 1..5)) {
        let quote = |cell: &String| format!("\"{}\"", cell.replace('"', "\"\""));
        let text = "head\n".to_owned() + &cells.iter().map(quote).collect::<Vec<_>>().join(",") + "\n1,2\n";
        let mut rows = CsvRows::new(&text);
        rows.next_row();
        if cells.iter().any(|cell| !cell.trim().is_empty()) || cells.len() > 1 {
            let row = rows.next_row().expect("the row");
            prop_assert_eq!(row.width(), cells.len());
            prop_assert!(row.open_quote().is_none());
        }
        let last = rows.next_row().expect("the last row");
        prop_assert_eq!(last.texts().collect::<Vec<_>>(), ["1", "2"]);
    }

    #[test]
    fn any_text_comes_to_an_end(text in "[-0-9a-z,\"#\\r\n \u{e4}\u{feff}]{0,60}") {
        let mut rows = CsvRows::new(&text);
        while let Some(row) = rows.next_row() {
            prop_assert_eq!(row.spans().len(), row.width());
            prop_assert!(row.spans().iter().all(|span| text.get(span.clone()).is_some()));
            let _ = row.open_quote();
        }
    }
}
