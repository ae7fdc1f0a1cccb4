//! Tables as people and programs write them: what is read, and what is said about the rest.

use diagnostics::Problems;
use proptest::prelude::{prop_assert_eq, proptest};
use tables::{Clock, Column, Form, Table, decode};

const FORM: Form = Form {
    what: "table of points",
    columns: &[
        Column::needed("t_s").also(&[("t_ms", 1e-3)]),
        Column::needed("x_m"),
        Column::optional("angle_deg").also(&[("angle_rad", 57.295_779_513_082_32)]),
    ],
    harmless: &["colour"],
};

/// Time, x and angle of each row, and the notes.
type Rows = (Vec<(f64, f64, Option<f64>)>, Vec<String>);

/// What is read of a text; else line, column and title of each fault.
fn read(bytes: impl AsRef<[u8]>) -> Result<Rows, Vec<String>> {
    let problems = Problems::new();
    let rows = decode("t.csv", bytes.as_ref().to_vec(), &problems).and_then(|source| {
        let (mut table, mut rows, mut clock) =
            (Table::with_header(source, &FORM), Vec::new(), Clock::from_zero());
        while let Some(mut row) = table.next_row() {
            let (time, x) = (row.time(0, &mut clock), row.number(1, -1e4..=1e4));
            let angle = row.optional_number(2, -3600.0..=3600.0);
            rows.extend(time.zip(x).zip(angle.ok()).map(|((time, x), angle)| (time, x, angle)));
        }
        table.finish(rows, &problems)
    });
    let notes = problems.take_notes();
    let said = problems.resolve(rows).map_err(|list| {
        let one = |problem: &diagnostics::Problem| {
            let record = problem.record();
            let [line, column] = [record.line, record.column].map(|at| at.unwrap_or(0));
            format!("{line}:{column} {}", record.title)
        };
        list.iter().map(one).collect::<Vec<_>>()
    });
    said.map(|rows| (rows, notes))
}

/// Rows that are read without a note.
fn rows(text: impl AsRef<[u8]>) -> Vec<(f64, f64, Option<f64>)> {
    let (rows, notes) = read(&text).unwrap_or_else(|faults| panic!("{faults:?}"));
    assert_eq!(notes, [""; 0]);
    rows
}

fn faults(text: impl AsRef<[u8]>) -> Vec<String> {
    read(text).expect_err("it has faults")
}

const PLAIN: &str = "t_s,x_m,angle_deg\n0,1.5,\n1,-2,90\n";

#[test]
fn one_table_in_many_dresses() {
    let expected = [(0.0, 1.5, None), (1.0, -2.0, Some(90.0))];
    assert_eq!(rows(PLAIN), expected);
    let quoted = "\"t_s\",\"x_m\",\"angle_deg\"\n\"0\",\"1.5\",\"\"\n\"1\",\"-2\",\"90\"\n";
    let dresses = [
        PLAIN.replace('\n', "\r\n"),
        PLAIN.replace('\n', "\r"),
        PLAIN.trim_end().to_owned(),
        format!("\u{feff}{PLAIN}"),
        PLAIN.replace("t_s", "T_S").replace("x_m", "X_m"),
        PLAIN.replace(',', ";"),
        PLAIN.replace(',', ";").replace('.', ","),
        PLAIN.replace(',', "\t"),
        PLAIN.replace(',', "\t").replace('.', ","),
        PLAIN.replace(',', " , "),
        quoted.to_owned(),
        quoted.replace('\n', "\r"),
        format!("\u{feff}{}", quoted.replace('\n', "\r\n")),
        quoted.replace(',', ";").replace('.', ","),
        quoted.replace(',', " , "),
        format!("# by hand\n\n  # twice\n{PLAIN}"),
        format!("sep=;\n{}", PLAIN.replace(',', ";")),
        "t_s,x_m,angle_deg,\n0,1.5,,\n1,-2,90,\n,,,\n".into(),
        "x_m,colour,angle_deg,t_s\n1.5,red,,0\n-2,\"bl,ue\",90,1\n".into(),
        "t_ms,x_m,angle_deg\n0,1.5,\n1000,-2,90\n".into(),
        "t_s,x_m,angle_rad\n0,1.5,\n1,-2,1.5707963267948966\n".into(),
        PLAIN.replace("1.5", "+15e-1"),
    ];
    for text in dresses {
        assert_eq!(rows(&text), expected, "{text:?}");
    }
}

#[test]
fn other_encodings_are_refused_by_name() {
    let wide: Vec<u8> = PLAIN.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = PLAIN.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let widest: Vec<u8> = PLAIN.chars().flat_map(|letter| u32::from(letter).to_le_bytes()).collect();
    for (mark, text, name) in [
        (&[0xff, 0xfe][..], &wide, "UTF-16"),
        (&[0xfe, 0xff], &big, "UTF-16"),
        (&[], &wide, "UTF-16"),
        (&[], &big, "UTF-16"),
        (&[0xff, 0xfe, 0, 0], &widest, "UTF-32"),
    ] {
        assert_eq!(faults([mark, text].concat()), [format!("0:0 the file is {name} text")]);
    }
    // A degree sign of Windows in the second line.
    assert_eq!(faults(b"t_s,x_m\r\n0,1\xb0\r\n"), ["2:4 not text: byte 12 is not UTF-8"]);
}

#[test]
fn headers_say_what_is_wrong_with_them() {
    assert_eq!(faults(""), ["1:1 an empty table of points"]);
    assert_eq!(faults("t_s,x_m\n# none\n"), ["1:1 a table of points without rows"]);
    assert_eq!(faults("t_s,x_m\n,\n"), ["1:1 a table of points without rows"]);
    assert_eq!(faults("t_s,x_m,colour,depth\n0,1,2,3\n"), ["1:16 unknown column `depth`"]);
    assert_eq!(faults("t_s,X_m,x_M\n0,1,2\n"), ["1:9 column `x_m` stands twice"]);
    assert_eq!(faults("t_s,t_ms,x_m\n0,1,2\n"), ["1:5 columns `t_s` and `t_ms` say the same"]);
    assert_eq!(faults("t_s\n0\n"), ["1:1 missing column `x_m`"]);
    assert_eq!(faults("0,1,2\n1,2,3\n"), ["1:1 a first row of numbers, not of names"]);
    assert_eq!(faults("t_s;x_m,angle_deg\n"), ["1:1 two kinds of separators in one header"]);
    assert_eq!(faults(",t_s,x_m\n0,0,1\n"), ["2:1 a value in a column without a name"]);
    assert_eq!(faults("t_s,\"x_m\n0,1\n").len(), 1);
    let problems = Problems::new();
    let source = decode("t.csv", b"t_s,x_mm\n0,1\n".to_vec(), &problems).unwrap();
    let nothing = Table::with_header(source, &FORM).finish((), &problems);
    let list = problems.resolve(nothing).unwrap_err().render(false);
    assert!(list.contains("did you mean `x_m`?"), "{list}");
}

#[test]
fn cells_say_what_is_wrong_with_them() {
    let of = |row: &str| faults(format!("t_s,x_m,angle_deg\n0,1,2\n{row}\n"));
    assert_eq!(of("1,nan,2"), ["3:3 `x_m` must be a number from -10000 to 10000, not nan"]);
    assert_eq!(of("1,,2"), ["3:3 `x_m` must be a number from -10000 to 10000, not nothing"]);
    assert_eq!(of("1,\"\",2"), ["3:3 `x_m` must be a number from -10000 to 10000, not nothing"]);
    assert_eq!(of("1,\"1,5\",2"), ["3:3 `x_m` must be a number from -10000 to 10000, not 1,5"]);
    assert_eq!(of("1,20000,2"), ["3:3 `x_m` must be a number from -10000 to 10000, not 20000"]);
    assert_eq!(of("1,5,north"), ["3:5 `angle_deg` must be a number from -3600 to 3600, not north"]);
    assert_eq!(of("1,5"), ["3:1 a row of 2 cells under a header of 3"]);
    assert_eq!(of("1,\"5,2"), ["3:3 a quote that is not closed"]);
    assert_eq!(of("1,\"5\"6,2"), ["3:6 text behind a quote"]);
    assert_eq!(of("noon,5,6").len(), 1);
    // The limit is told in the unit of the column.
    let in_radians = faults("t_s,x_m,angle_rad\n0,1,70\n");
    assert!(in_radians[0].starts_with("2:5 `angle_rad` must be a number from -62.8318"), "{in_radians:?}");
    let long = "9".repeat(100_000);
    assert!(of(&format!("1,{long},2")).iter().all(|title| title.len() < 200));
}

#[test]
fn decimal_commas_are_one_kind() {
    let semicolons = |rows: &str| read(format!("t_s;x_m\n{rows}\n"));
    assert_eq!(semicolons("0;1,5\n1;2.5").unwrap_err().len(), 1);
    assert_eq!(semicolons("0;1.5\n1,5;2").unwrap_err().len(), 1);
    assert_eq!(
        semicolons("0;1.234,5").unwrap_err(),
        ["2:3 `x_m` must be a number from -10000 to 10000, not 1.234,5"]
    );
    let (rows, notes) = semicolons("0;1,234\n1;5").unwrap();
    assert_eq!(rows[0].1, 1.234);
    assert_eq!(notes, ["t.csv: commas in numbers are decimal commas: 1,234 is read as 1.234"]);
    assert_eq!(semicolons("0;1,234\n1;5,5").unwrap().1, [""; 0]);
}

#[test]
fn dates_are_times() {
    let text = "t_s,x_m\n2026-11-26T22:00:00Z,1\n2026-11-26T22:00:00.25Z,2\n2026-11-27T00:00:01+02:00,3\n";
    let (rows, _) = read(text).unwrap();
    assert_eq!(rows.iter().map(|row| row.0).collect::<Vec<_>>(), [0.0, 0.25, 1.0]);
    assert_eq!(read("t_s,x_m\n2026-11-26T22:00:00Z,1\n5,2\n").unwrap_err().len(), 1);
    assert_eq!(read("t_s,x_m\n26.11.2026 22:00,1\n").unwrap_err().len(), 1);
    assert_eq!(
        faults("t_s,x_m\n2026-02-30T22:00:00Z,1\n"),
        ["2:1 `t_s` must be a date with day 1 to 28, not 2026-02-30T22:00:00Z"]
    );
}

#[test]
fn leap_seconds_pass_as_seconds_do() {
    let text = "t_s,x_m\n2016-12-31T23:59:59Z,1\n2016-12-31T23:59:60Z,2\n2017-01-01T00:00:00Z,3\n";
    assert_eq!(read(text).unwrap().0.iter().map(|row| row.0).collect::<Vec<_>>(), [0.0, 1.0, 2.0]);
    let said = faults(text.replace("2016", "2017").replace("2017-01-01", "2018-01-01"));
    assert!(said[0].contains("no leap second ends that minute"), "{said:?}");
}

#[test]
fn angles_beyond_a_turn_are_told() {
    let notes = |name: &str, angle: &str| {
        read(format!("t_s,x_m,{name}\n0,1,2\n1,1,{angle}\n2,1,\n")).unwrap().1.join("; ")
    };
    assert!(notes("angle_rad", "-45").contains("t.csv: angle_rad goes up to 45, more than 2 pi"));
    assert!(notes("angle_rad", "7").contains("name the column angle_deg"));
    assert!(notes("angle_deg", "361").contains("angle_deg goes up to 361"));
    assert_eq!([notes("angle_rad", "6.28"), notes("angle_deg", "-360")], ["", ""]);
}

#[test]
fn tables_without_a_header_keep_their_order() {
    let in_order = |text: &str| {
        let problems = Problems::new();
        let source = decode("t.tum", text.as_bytes().to_vec(), &problems).unwrap();
        let mut table = Table::in_order(source, &FORM);
        let mut rows = Vec::new();
        while let Some(mut row) = table.next_row() {
            rows.extend(row.number(1, -10.0..=10.0));
        }
        let read = table.finish(rows, &problems);
        problems
            .resolve(read)
            .map_err(|list| list.iter().map(|problem| problem.title.clone()).collect::<Vec<_>>())
    };
    assert_eq!(in_order("# t x\n0 1 2\r3\t4  5\r\n"), Ok(vec![1.0, 4.0]));
    assert_eq!(in_order("0 1\n").unwrap_err(), ["a row of 2 numbers"]);
    assert_eq!(
        in_order("# x_m t_s angle_deg t_ms\n0 1 2\n").unwrap_err(),
        ["a comment that names the columns in another order"]
    );
}

/// The cells of a text by the crate `csv`.
fn by_csv(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
    reader
        .records()
        .map(|record| record.unwrap().iter().map(|cell| cell.trim().to_owned()).collect())
        .collect()
}

const WORDS: Form = Form {
    what: "table of words",
    columns: &[Column::needed("a"), Column::needed("b"), Column::needed("c")],
    harmless: &[],
};

proptest! {
    /// Cells are those that the crate `csv` reads, whatever they hold, with and without quotes.
    #[test]
    fn cells_are_those_of_another_reader(
        cells in proptest::collection::vec(("[a-z,; \"\t]{0,6}", proptest::bool::ANY), 3..=3),
        ends in "\n|\r\n|\r",
    ) {
        let write = |(cell, quoted): &(String, bool)| match *quoted || cell.contains([',', '"', ';', '\t']) {
            true => format!("\"{}\"", cell.replace('"', "\"\"")),
            false => cell.clone(),
        };
        let row = cells.iter().map(write).collect::<Vec<_>>().join(",");
        let text = format!("a,b,c{ends}{row}{ends}1,2,3{ends}");
        let problems = Problems::new();
        let source = decode("w.csv", text.clone().into_bytes(), &problems).unwrap();
        let mut table = Table::with_header(source, &WORDS);
        let mut found = Vec::new();
        while let Some(row) = table.next_row() {
            found.push((0..3).map(|column| row.text(column).unwrap().trim().to_owned()).collect::<Vec<_>>());
        }
        prop_assert_eq!(table.finish((), &problems), Some(()));
        let is_empty = |row: &Vec<String>| row.iter().all(String::is_empty);
        let expected: Vec<_> = by_csv(&text).into_iter().skip(1).filter(|row| !is_empty(row)).collect();
        prop_assert_eq!(found, expected);
    }

    /// Any bytes are read or refused, and nothing else happens.
    #[test]
    fn any_bytes_come_to_an_end(text in "[-0-9a-z_,;.\"#\\r\\n\\t \u{e4}\u{feff}]{0,80}", bytes: Vec<u8>) {
        for bytes in [text.clone().into_bytes(), format!("t_s,x_m\n{text}").into_bytes(), format!("t_s;x_m\n{text}").into_bytes(), bytes] {
            let _ = read(bytes);
        }
    }
}
