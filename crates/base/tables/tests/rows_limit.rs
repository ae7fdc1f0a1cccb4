//! A table of more rows than are allowed is refused at the first row too many. A test program of its own: limits are the
//! process's.

use diagnostics::Problems;
use tables::{Column, Form, Table, decode};

const NUMBERS: Form = Form { what: "list of numbers", columns: &[Column::needed("x")], harmless: &[] };

#[test]
fn rows_beyond_the_limit_are_refused_with_its_name() {
    limits::raise("rows=2").expect("a limit");
    let read = |text: &str| {
        let problems = Problems::new();
        let source = decode("t.csv", text.into(), &problems).expect("text");
        let mut table = Table::with_header(source, &NUMBERS);
        let mut numbers = Vec::new();
        while let Some(mut row) = table.next_row() {
            numbers.extend(row.number(0, 0.0..=9.0));
        }
        let found = table.finish(numbers, &problems);
        problems.resolve(found).map_err(|list| list.render(false))
    };
    // Header, comments and empty lines are no rows.
    assert_eq!(read("x\n# a\n1\n\n2\n"), Ok(vec![1.0, 2.0]));
    let shown = read("x\n1\n2\n3\nfour\n").expect_err("three rows");
    assert!(shown.contains("t.csv:4") && shown.contains("a list of numbers of more than 2 rows"), "{shown}");
    assert!(shown.contains("--raise rows=N allows more") && !shown.contains("four"), "{shown}");
}
