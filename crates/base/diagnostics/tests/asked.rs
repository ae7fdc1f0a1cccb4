//! What readers ask for, while somebody records.

use diagnostics::asked::{Asked, Shape, ShapeKind, record};
use diagnostics::{Problems, Reader, TomlFile};

/// Any value of a type.
fn any(kind: ShapeKind) -> Shape {
    Shape { kind, low: None, high: None, unit: None, rules: Vec::new(), or_words: Vec::new() }
}

fn asked(text: &str, read: impl Fn(&Reader)) -> Vec<Asked> {
    let problems = Problems::new();
    let file = TomlFile::parse("some.toml", text, &problems).expect("no fault of syntax");
    record(|| read(&file.root(&problems))).1
}

#[test]
fn every_key_is_noted_with_its_bounds_unit_and_words() {
    let found = asked("[raster]\nsweeps = 3\n", |root| {
        let table = root.table("raster").expect("a table");
        let _ = table.f64("blank").above(0.0).at_most(0.5).unit("s").or_word("never").optional();
        let _ = table.u32("sweeps").between(1, 9).must("odd", |n| n % 2 == 1).required();
    });
    let keys: Vec<_> = found.iter().map(|asked| (asked.path.as_str(), asked.is_required)).collect();
    assert_eq!(keys, [("raster", true), ("raster.blank", false), ("raster.sweeps", true)]);
    let blank = Shape {
        low: Some((0.0, false)),
        high: Some((0.5, true)),
        unit: Some("s".into()),
        or_words: vec!["never".into()],
        ..any(ShapeKind::Number)
    };
    assert_eq!(found[1].shape, blank);
    let sweeps = Shape {
        low: Some((1.0, true)),
        high: Some((9.0, true)),
        rules: vec!["odd".into()],
        ..any(ShapeKind::Count)
    };
    assert_eq!(found[2].shape, sweeps);
}

#[test]
fn elements_of_an_array_have_their_number_and_nothing_is_noted_outside() {
    let text = "[[object]]\nid = 'a'\n[[object]]\nid = 'b'\n";
    let read = |root: &Reader| {
        root.tables("object").iter().for_each(|table| drop(table.string("id").required()));
    };
    let paths: Vec<String> = asked(text, read).into_iter().map(|asked| asked.path).collect();
    assert_eq!(paths, ["object", "object[0].id", "object[1].id"]);
    let problems = Problems::new();
    read(&TomlFile::parse("some.toml", text, &problems).expect("no fault").root(&problems));
    assert!(record(|| ()).1.is_empty());
}
