//! The numbers of `docs/link-study.md` are those of the pictures.

use std::path::Path;

use lunoid_tests::link::figures;

#[test]
fn the_page_has_what_is_measured_in_the_figures() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/link-study.md");
    let page = std::fs::read_to_string(file).expect("the page");
    let is_row = |line: &&str| ["| figure-", "| dropped-"].iter().any(|head| line.starts_with(head));
    let found: Vec<&str> = page.lines().filter(is_row).collect();
    let measured: Vec<String> = figures().iter().flat_map(|figure| figure.rows(&figure.stills())).collect();
    assert_eq!(found, measured, "docs/link-study.md should have:\n{}", measured.join("\n"));
    for figure in figures() {
        assert!(page.contains(&format!("pictures/link/{}.png", figure.name)), "{}", figure.name);
    }
}
