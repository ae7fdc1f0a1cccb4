//! The later layer wins key by key, and nothing forgets where it came from.

use diagnostics::{Layers, Problems, TomlFile};

fn layers(texts: &[(&str, &str)]) -> Layers {
    let problems = Problems::new();
    let files: Vec<_> =
        texts.iter().filter_map(|(name, text)| TomlFile::parse(name, text, &problems)).collect();
    assert_eq!(problems.into_result().map_err(|list| list.to_string()), Ok(()));
    Layers::new(files)
}

const IDEAL: &str = "format = 1\n[dac]\nbits = 12\ngain = 1.0\n[[delay]]\nticks = 1\n[[delay]]\nticks = 2\n";

#[test]
fn tables_merge_and_arrays_are_replaced() {
    let merged = layers(&[
        ("ideal", IDEAL),
        ("mine", "dac.bits = 8\n[[delay]]\nticks = 9\n"),
        ("set", "dac.bits = 6"),
    ]);
    let problems = Problems::new();
    let root = merged.root(&problems);
    assert!(root.format_version(1));
    let dac = root.table("dac").expect("it is there");
    assert_eq!((dac.u64("bits").required(), dac.f64("gain").required()), (Some(6), Some(1.0)));
    let delays = root.tables("delay");
    assert_eq!(delays.iter().map(|delay| delay.u64("ticks").required()).collect::<Vec<_>>(), [Some(9)]);
    root.finish();
    assert!(problems.is_empty());
}

#[test]
fn origins_are_those_of_the_winning_layer() {
    let merged = layers(&[("ideal", IDEAL), ("mine", "\ndac.bits = 8\n")]);
    let lines: Vec<String> = merged
        .origins()
        .iter()
        .map(|(path, origin)| format!("{path} = {} # {origin}", origin.text.replace('\n', " ")))
        .collect();
    assert_eq!(lines[..2], ["dac.bits = 8 # mine:2", "dac.gain = 1.0 # ideal:4"]);
    assert_eq!(lines[3], "format = 1 # ideal:1");
    assert_eq!(merged.origin("dac.none"), None);
    assert_eq!(merged.origin("format.below"), None);
}

#[test]
fn a_table_and_a_value_replace_one_another() {
    let merged = layers(&[("a", "part = 'ideal'\n[other]\nx = 1"), ("b", "other = 'ideal'\n[part]\ny = 2")]);
    let problems = Problems::new();
    let root = merged.root(&problems);
    assert_eq!(root.table("part").and_then(|part| part.u64("y").required()), Some(2));
    assert_eq!(root.string("other").required().as_deref(), Some("ideal"));
}

#[test]
fn problems_stand_in_the_layer_that_made_them() {
    let merged =
        layers(&[("a", "wrong = 1\n[dac]\nbits = 0\nbitz = 1"), ("b", "\nwrong = 2\n[dac]\ngian = 1")]);
    let problems = Problems::new();
    let root = merged.root(&problems);
    let dac = root.table("dac").expect("it is there");
    dac.u64("bits").at_least(4).required();
    dac.f64("gain").required();
    root.finish();
    let list = problems.into_result().expect_err("six problems");
    let places: Vec<_> = list.iter().map(|p| (p.record().file, p.record().line, p.title.clone())).collect();
    let expected = [
        ("a", 1, "unknown key `wrong`"),
        ("a", 3, "`dac.bits` must be a whole number of at least 4, not 0"),
        ("a", 4, "unknown key `dac.bitz`"),
        ("b", 2, "unknown key `wrong`"),
        ("b", 3, "missing key `dac.gain`"),
        ("b", 4, "unknown key `dac.gian`"),
    ];
    assert_eq!(places, expected.map(|(file, line, title)| (file.to_owned(), Some(line), title.to_owned())));
}

#[test]
fn no_file_reads_as_an_empty_one() {
    let problems = Problems::new();
    let nothing = Layers::new([]);
    assert_eq!(nothing.root(&problems).u64("x").default(3), Some(3));
    assert!(nothing.origins().is_empty());
}
