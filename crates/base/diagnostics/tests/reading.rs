//! Every fault of a file is listed, each at its place.

use diagnostics::{PartTable, Place, Problem, ProblemRecord, Problems, Reader, TomlFile};
use proptest::prelude::{any, proptest};

/// Titles of all problems that reading `text` gives, in order.
fn titles(text: &str, read: impl Fn(&Reader)) -> Vec<String> {
    records(text, read).into_iter().map(|record| record.title).collect()
}

fn records(text: &str, read: impl Fn(&Reader)) -> Vec<ProblemRecord> {
    let problems = Problems::new();
    if let Some(file) = TomlFile::parse("t.toml", text, &problems) {
        let root = file.root(&problems);
        read(&root);
        root.finish();
    }
    problems.into_result().map_or_else(|list| list.iter().map(Problem::record).collect(), |()| Vec::new())
}

#[test]
fn a_right_file_has_no_problem() {
    let text = "a = 3\nb = -2\nc = true\nd = 'x'\ne = [1, 2.5]\nf = [1, 2]\ng = ['p']\n[h]\n[[i]]\nk = 1\n";
    let found = titles(text, |root| {
        assert_eq!(root.f64("a").at_least(3.0).at_most(3.0).required(), Some(3.0));
        assert_eq!(root.i64("b").required(), Some(-2));
        assert_eq!(root.bool("c").required(), Some(true));
        assert_eq!(root.string("d").required(), Some("x".into()));
        assert_eq!(root.f64_list("e").required(), Some(vec![1.0, 2.5]));
        assert_eq!(root.u64_list("f").between(1, 2).required(), Some(vec![1, 2]));
        assert_eq!(root.string_list("g").required(), Some(vec!["p".into()]));
        assert!(root.table("h").is_some());
        assert_eq!(root.tables("i")[0].u32("k").required(), Some(1));
        assert_eq!(root.u64("absent").default(7), Some(7));
        assert_eq!(root.u64("absent").optional(), None);
        assert!(root.optional_table("absent").is_none());
        assert!(root.tables("absent").is_empty());
    });
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn bounds_hold_at_their_edges() {
    let found = titles("a = 0.0\nb = 1\nc = [1, 5]", |root| {
        assert_eq!(root.f64("a").above(0.0).required(), None);
        assert_eq!(root.f64("a").at_least(0.0).required(), Some(0.0));
        assert_eq!(root.u64("b").below(1).required(), None);
        assert_eq!(root.f64_array::<2>("c").above(1.0).below(6.0).unit("m").required(), None);
    });
    assert_eq!(
        found,
        [
            "`a` must be a number above 0, not 0.0",
            "`b` must be a whole number below 1, not 1",
            "`c` must be an array of 2 numbers above 1 and below 6 m, not 1",
        ]
    );
}

#[test]
fn infinite_and_undefined_numbers_are_refused() {
    let found = titles("a = nan\nb = -inf\nc = [0, inf]", |root| {
        root.f64("a").required();
        root.f64("b").required();
        root.f64_list("c").required();
    });
    assert_eq!(found.len(), 3);
    assert_eq!(found[2], "`c` must be an array of numbers, not inf");
}

#[test]
fn wrong_types_are_named() {
    let text = "a = '1'\nb = 1.5\nc = [1]\nd = 1\ne = 1\nf = -1\ng = 2024-01-01\nh = ''\n";
    let found = titles(text, |root| {
        root.f64("a").required();
        root.u64("b").required();
        root.f64_array::<2>("c").required();
        root.table("d");
        root.tables("e");
        root.usize("f").required();
        root.bool("g").required();
        root.string("h").required();
    });
    assert_eq!(
        found,
        [
            "`a` must be a number, not '1'",
            "`b` must be a whole number, not 1.5",
            "`c` must be an array of 2 numbers, not 1 of them",
            "`d` must be a table, not 1",
            "`e` must be an array of tables, not 1",
            "`f` must be a whole number, not -1",
            "`g` must be true or false, not a date or time",
            "`h` must be one line of text in quotes, not ''",
        ]
    );
}

#[test]
fn a_text_is_one_line_that_can_be_shown() {
    let found = records("a = \"two\\nlines\"\nb = \"\\u001b[31mred\"\nc = 'Mare, äöü'\n", |root| {
        for key in ["a", "b", "c"] {
            root.string(key).required();
        }
    });
    let keys: Vec<_> = found.iter().filter_map(|problem| problem.key.as_deref()).collect();
    assert_eq!(keys, ["a", "b"]);
}

#[test]
fn places_are_lines_and_columns_in_characters() {
    let found = records("title = 'äöü'\n[a]\n  b = { c = 'ß', d = 2 }\n", |root| {
        root.string("title").required();
        let b = root.table("a").and_then(|a| a.table("b")).expect("a.b is there");
        b.string("c").required();
        b.u64("d").at_least(3).help("raise it").required();
    });
    assert_eq!((found[0].line, found[0].column), (Some(3), Some(22)));
    assert_eq!(found[0].key.as_deref(), Some("a.b.d"));
    assert_eq!(found[0].found.as_deref(), Some("2"));
    assert_eq!(found[0].expected.as_deref(), Some("a whole number of at least 3"));
    assert_eq!(found[0].help.as_deref(), Some("raise it"));
}

#[test]
fn unknown_keys_are_found_in_every_table() {
    let text = "titel = 'x'\n[a]\nzzz = 1\n[[b]]\nk = 1\nl = 2\n[unread]\nq = 1\n[kind]\nanything = 1\n";
    let found = titles(text, |root| {
        root.string("title").optional();
        root.table("a");
        root.tables("b").iter().for_each(|b| assert_eq!(b.u64("k").required(), Some(1)));
        root.table("kind").expect("it is there").ignore_rest();
    });
    assert_eq!(
        found,
        ["unknown key `titel`", "unknown key `a.zzz`", "unknown key `b[0].l`", "unknown key `unread`"]
    );
}

#[test]
fn finishing_twice_reports_once() {
    let found = titles("[a]\nx = 1", |root| root.table("a").expect("it is there").finish());
    assert_eq!(found, ["unknown key `a.x`"]);
}

#[test]
fn format_is_checked() {
    let format = |text| titles(text, |root| _ = root.format_version(2));
    assert!(format("format = 2").is_empty());
    assert_eq!(format(""), ["missing key `format`"]);
    assert_eq!(format("format = 3"), ["format 3 is newer than the format 2 that this program reads"]);
    assert_eq!(format("format = 1"), ["format 1 is older than the format 2 that this program reads"]);
    assert_eq!(format("format = '2'"), ["`format` must be a whole number, not '2'"]);
}

#[test]
fn words_stand_for_values_and_parts() {
    let found = titles("a = 'ideal'\nb = 2\nc = 'idea'\nd = 'ideal'\ne = 3\n[f]", |root| {
        assert_eq!(root.f64("a").above(0.0).or_word("ideal").required(), Some(None));
        assert_eq!(root.f64("b").or_word("ideal").required(), Some(Some(2.0)));
        assert_eq!(root.f64("c").or_word("ideal").required(), None);
        assert!(matches!(root.table_or_word("d", "ideal"), Some(PartTable::Word)));
        assert!(root.table_or_word("e", "ideal").is_none());
        assert!(matches!(root.table_or_word("f", "ideal"), Some(PartTable::Table(_))));
        assert!(root.table_or_word("absent", "ideal").is_none());
    });
    assert_eq!(
        found,
        [
            "`c` must be a number, or the word \"ideal\", not 'idea'",
            "`e` must be a table, or the word \"ideal\", not 3",
        ]
    );
}

#[test]
fn later_rules_point_at_values() {
    let found = records("near_m = 9\nfar_m = 3\n", |root| {
        let near = root.f64("near_m").placed().required().expect("near_m is there");
        let far = root.f64("far_m").map(|far| 2.0 * far).must("not 7", |far| *far != 7.0).required();
        assert_eq!(far, Some(6.0));
        root.report(Problem::of(&near, "near is beyond far").expected("less than far_m"));
        root.report(root.problem("far_m", "far is nearer than near"));
    });
    assert_eq!((found[0].line, found[0].found.as_deref()), (Some(1), Some("9")));
    assert_eq!((found[1].line, found[1].column), (Some(2), Some(9)));
}

#[test]
fn faults_of_syntax_and_of_encoding_have_a_place() {
    assert_eq!(records("a = 1\n[b\n", |_| ())[0].line, Some(2));
    let problems = Problems::new();
    assert!(TomlFile::parse_bytes("x.toml", b"a = \xff", &problems).is_none());
    let list = problems.into_result().expect_err("not UTF-8");
    assert_eq!(
        list.to_string(),
        "error: not text: byte 4 is not UTF-8\n--> x.toml\n = help: save the file as UTF-8"
    );
}

#[test]
fn pairs_of_numbers() {
    let read = |text: &str| {
        let problems = Problems::new();
        let file = TomlFile::parse("t", text, &problems).unwrap();
        let pairs = file.root(&problems).f64_pairs("a").required();
        problems
            .into_result()
            .map_err(|list| list.iter().next().unwrap().found.clone())
            .map(|()| pairs.unwrap())
    };
    assert_eq!(read("a = [[1, 2.5], [-3, 4]]"), Ok(vec![[1.0, 2.5], [-3.0, 4.0]]));
    assert_eq!(read("a = []"), Ok(vec![]));
    for (text, found) in [("a = [[1, 2], [3, nan]]", "nan"), ("a = [[1, 2], 3]", "3"), ("a = 1", "1")] {
        assert_eq!(read(text), Err(Some(found.to_owned())), "{text}");
    }
    assert!(read("a = [[1, 2, 3]]").is_err());
}

#[test]
fn colour_only_when_asked_for() {
    let list = diagnostics::ProblemList::from(Problem::of_file("a.toml", "no such file"));
    assert!(list.render(true).contains('\u{1b}'));
    assert!(!list.render(false).contains('\u{1b}'));
}

proptest! {
    /// Whatever stands in a file, reading ends with a value or with problems that can be drawn.
    #[test]
    fn any_text_is_read_or_refused(text in "[a-c\\[\\]={}'\".0-9, \nä-]{0,60}") {
        let problems = Problems::new();
        if let Some(file) = TomlFile::parse("t", &text, &problems) {
            let root = file.root(&problems);
            root.tables("a").iter().for_each(|a| _ = a.f64("b").required());
            root.table("b").map(|b| b.string("c").required());
            root.finish();
        }
        if let Err(list) = problems.into_result() {
            assert!(list.render(true).len() > list.len());
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..80)) {
        let problems = Problems::new();
        assert_eq!(TomlFile::parse_bytes("t", &bytes, &problems).is_some(), problems.is_empty());
        problems.into_result().map_or_else(|list| assert!(!list.render(false).is_empty()), |()| ());
    }
}

/// The place of every fault is found in one walk, and a line is not shown whole where a file is one line.
#[test]
fn many_faults_in_one_line_are_shown_in_little_text() {
    let (count, head) = (3000, "\"é\" = [");
    let text = format!("{head}{}]", "1, ".repeat(count));
    let problems = Problems::new();
    let file = TomlFile::parse("t.toml", &text, &problems).unwrap();
    for at in 0..count {
        let start = head.len() + 3 * at;
        let place = Place { source: file.source().clone(), span: start..start + 1 };
        problems.push(Problem::at(&place, format!("fault {at}")).expected("2"));
    }
    let list = problems.into_result().unwrap_err();
    let columns: Vec<_> = list.records().iter().map(|record| record.column.unwrap()).collect();
    assert_eq!(columns, (0..count).map(|at| 8 + 3 * at).collect::<Vec<_>>());
    assert_eq!(list.records(), list.iter().map(Problem::record).collect::<Vec<_>>());
    let shown = list.render(false);
    assert!(shown.len() < 2000 * count, "{} bytes", shown.len());
    assert!(
        shown.contains(&format!("--> t.toml:1:{}\n", 8 + 3 * (count - 1))),
        "{}",
        &shown[shown.len() - 2000..]
    );
}

#[test]
fn control_characters_of_a_file_are_shown() {
    let text = "title = 1 # \u{9b}31m\u{202e}";
    let problems = Problems::new();
    let file = TomlFile::parse("a\u{1b}[31m.toml", text, &problems).unwrap();
    let root = file.root(&problems);
    root.string("title").help("see \u{1b}[1m").required();
    let shown = problems.into_result().unwrap_err().render(false);
    assert!(!shown.contains(['\u{1b}', '\u{9b}', '\u{202e}']), "{shown:?}");
    for word in ["a\\u{1b}[31m.toml:1:9", "\\u{9b}31m\\u{202e}", "see \\u{1b}[1m"] {
        assert!(shown.contains(word), "{word}: {shown}");
    }
}
