//! What STL may say wrongly.

use crate::made::{read, refused, stl, stl_text};

#[test]
fn stl_that_is_damaged_or_coloured() {
    let whole = stl("", [0; 2]);
    let short = refused("a.stl", &whole[..whole.len() - 1]);
    assert!(short.contains("binary STL with 12 facets has 600 bytes behind its head, not 599"), "{short}");
    assert!(refused("a.stl", [0; 83]).contains("83 bytes: binary STL has a head of 84 bytes"));
    let mut bad = whole;
    bad[84 + 50 + 12..][..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let said = refused("a.stl", bad);
    assert!(said.contains("facet 2: a coordinate must be a finite number, not inf"), "{said}");
    let coloured = read("a.stl", stl("", [1, 2])).unwrap();
    assert!(coloured.notes[0].contains("12 facets have a word of attributes"), "{:?}", coloured.notes);
    assert!(
        coloured.notes[1].contains("read as metres, 1.0000 x 2.0000 x 0.2500 m large"),
        "{:?}",
        coloured.notes
    );
    let text = stl_text();
    for (wrong, said) in [
        (text.replacen("vertex", "corner", 1), "statement `corner` is not read"),
        (text.replacen("-5e-1", "nan", 1), "a coordinate must be a finite number, not nan"),
        (text.replacen("  endfacet\n", "", 1), "this facet does not end"),
        (text.replacen("    endloop", "vertex 0 0 0", 1), "a facet of 4 vertices"),
        (format!("{text}vertex 0 0 0"), "a vertex outside a facet"),
        (text.replacen(" -1e0", "", 1), "a vertex of 2 numbers"),
    ] {
        assert!(refused("a.stl", &wrong).contains(said), "{said}: {}", refused("a.stl", &wrong));
    }
    assert_eq!(read("a.stl", format!("\u{feff}{text}")).unwrap(), read("a.stl", &text).unwrap());
    let both = format!("{text}{}", text.replace("2.5e-1", "9e0"));
    assert_eq!(read("a.stl", both).unwrap().solids.len(), 2, "two solids of one file");
}
