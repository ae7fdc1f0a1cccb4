//! Golden frames: results are equal to the bit, so not one pixel of a reference may differ.
//!
//! A failure leaves found, expected and difference side by side below `target/tmp/golden`. An intended change:
//! `LUNOID_BLESS=1 cargo test -p lunoid-tests --test golden` writes the references and fails; look at them, run
//! again without it, and commit them with the reason.

mod comparison;
mod reference;

use lunoid_tests::Shipped;
use reference::Shelf;
use scenario::Scalar;

/// Sweeps of a golden frame: files of a few kilobytes.
const SWEEPS: u32 = 160;

/// Holds a frame of a shipped scenario in both scalar types against its references.
fn hold(name: &str, frame: u64) {
    let mut shipped = Shipped::read(name, Some(SWEEPS));
    let shelf = Shelf::of_repository();
    let types = [(Scalar::F64, "f64"), (Scalar::F32, "f32")];
    let differences = types.map(|(scalar, word)| {
        shipped.settings.scalar = scalar;
        let reference = format!("{name}-{frame:06}-{word}");
        shelf
            .hold(&reference, &shipped.machine(frame).picture)
            .map_err(|differs| format!("{reference}: {differs}"))
    });
    let failures: Vec<String> = differences.into_iter().filter_map(Result::err).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn first_light() {
    hold("first-light", 0);
}

#[test]
fn descent() {
    hold("descent", 60);
}
