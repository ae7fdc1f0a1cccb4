//! The page of trust says what was measured.

use std::path::Path;

use lunoid_tests::trust::page;

#[test]
fn the_page_is_made_of_the_kept_results() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let written = std::fs::read_to_string(docs.join("trust.md")).expect("the page is there");
    let made = page(&docs.join("trust")).expect("results can be read");
    assert!(written == made, "docs/trust.md differs from its results: cargo run -p lunoid-tests --bin trust");
}
