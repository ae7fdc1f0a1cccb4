//! Sub-generators one by one: their wires.

use std::sync::LazyLock;

use signal::{Signal, Unit};

/// Sub-generators of each crater type that have wires of their own. Real machines have at most as many (hardware section 3.7: 2 to 16).
const TOLD: u32 = 16;

/// Number of crater types.
const TYPES: u32 = 3;

/// One of the sub-generators.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubGeneratorPlace {
    /// Crater type that it makes, 1 to 3.
    pub kind: u32,
    /// Which one of that type, from 0.
    pub number: u32,
}

/// Wires of every sub-generator that has its own: what it adds to the sum, and what its comparator answers. Number n is number
/// `n mod 16` of those of type `n / 16 + 1`.
pub static UNIT_SIGNALS: LazyLock<Vec<Signal>> = LazyLock::new(|| {
    let of_unit = |n: u32| {
        let (kind, number) = (n / TOLD + 1, n % TOLD);
        // Names and meanings live as long as the program: the table is made once.
        let told = |text: String| -> &'static str { text.leak() };
        [
            Signal::ground(
                told(format!("fg.height.{n}")),
                Unit::Metre,
                told(format!("height that sub-generator {number} of crater type {kind} adds to the sum")),
                "section 10",
            ),
            Signal::ground(
                told(format!("fg.comparator.{n}")),
                Unit::Gate,
                told(format!(
                    "1 inside the footprint of what is in that sub-generator, behind its comparator: number {number} of type {kind}"
                )),
                "section 14",
            ),
        ]
    };
    (0..TYPES * TOLD).flat_map(of_unit).collect()
});

/// The sub-generator whose wire has this name; none of another wire.
pub fn place_of(name: &str) -> Option<SubGeneratorPlace> {
    let number = name.strip_prefix("fg.height.").or_else(|| name.strip_prefix("fg.comparator."))?;
    let n: u32 = number.parse().ok()?;
    (n < TYPES * TOLD).then_some(SubGeneratorPlace { kind: n / TOLD + 1, number: n % TOLD })
}
