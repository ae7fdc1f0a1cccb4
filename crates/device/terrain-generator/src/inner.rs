//! The inner wires of an array: their names, and what full scale means on each (fig. 17, 19).

use std::collections::HashMap;
use std::sync::LazyLock;

use signal::{Kind, Signal, Unit};
use sweep_program::Colour;

use crate::Scale;
use crate::of_parts::{PEAKS, SLOPE_PEAKS};
use crate::terms::{TERMS, factors, word_of};

/// One continuous wire between the accumulators and the sums of an array.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InnerWire {
    /// Accumulator of an axis (0 is X), in front of its D/A converter and smoother.
    Accumulator(usize),
    /// Ramp of an axis, behind them.
    Ramp(usize),
    /// Function generator of order 0 to 2, fed with X, 1-X, Y or 1-Y; the polarity has not yet given it its sign.
    Function {
        /// `2 axis + end`.
        fed: usize,
        /// Order of the derivative that the function weighs, 0 to 2.
        order: usize,
    },
    /// The slope of such a function generator, by what feeds it.
    Derivative {
        /// `2 axis + end`.
        fed: usize,
        /// Order of the derivative that the function weighs, 0 to 2.
        order: usize,
    },
    /// Multiplier of a sum (height, slopes along X and Y): `6 p + q`, the order of X first.
    Product {
        /// Which sum: height, slope along X, slope along Y.
        sum: usize,
        /// Which term of the sum, 0 to 35.
        term: usize,
    },
    /// Multiplying D/A behind that multiplier.
    Converter {
        /// Which sum: height, slope along X, slope along Y.
        sum: usize,
        /// Which term of the sum, 0 to 35.
        term: usize,
    },
    /// What the nine D/As of a colour add to the height.
    Colour(usize),
    /// Output of a summing tree: height, slope to the north, slope to the east.
    Sum(usize),
}

/// The inner wires of one level, with the words of its hold registers.
#[derive(Debug)]
pub struct InnerSignals {
    /// Continuous wires, in the order of the figure.
    pub wires: Vec<(InnerWire, Signal)>,
    /// Words of the hold registers, colour by colour, nine each.
    pub words: Vec<Signal>,
    by_name: HashMap<&'static str, InnerWire>,
}

/// Inner signals of the fine level, which is the only one of many machines.
pub static FINE: LazyLock<InnerSignals> = LazyLock::new(|| InnerSignals::of(""));

/// Inner signals of the coarse level.
pub static COARSE: LazyLock<InnerSignals> = LazyLock::new(|| InnerSignals::of("coarse."));

const AXES: [&str; 2] = ["x", "y"];
const FED: [&str; 4] = ["x", "cx", "y", "cy"];
/// What stands before the name of a wire of each sum.
const SUMS: [&str; 3] = ["", "u.", "v."];

impl InnerSignals {
    /// Those of a level whose names have `level` behind the block.
    fn of(level: &str) -> Self {
        let every = |count: usize| move |sum: usize| (0..count).map(move |term| (sum, term));
        let wires = (0..2)
            .map(InnerWire::Accumulator)
            .chain((0..2).map(InnerWire::Ramp))
            .chain((0..4).flat_map(every(3)).map(|(fed, order)| InnerWire::Function { fed, order }))
            .chain((0..4).flat_map(every(3)).map(|(fed, order)| InnerWire::Derivative { fed, order }))
            .chain((0..3).flat_map(every(TERMS)).map(|(sum, term)| InnerWire::Product { sum, term }))
            .chain((0..3).flat_map(every(TERMS)).map(|(sum, term)| InnerWire::Converter { sum, term }))
            .chain((0..4).map(InnerWire::Colour))
            .chain((0..3).map(InnerWire::Sum))
            .map(|wire| (wire, wire.signal(level)))
            .collect::<Vec<_>>();
        let words = Colour::ALL.into_iter().flat_map(|colour| (0..9).map(move |word| (colour, word)));
        let words = words.map(|(colour, word)| word_signal(level, colour, word)).collect();
        let by_name = wires.iter().map(|(wire, signal)| (signal.name, *wire)).collect();
        Self { wires, words, by_name }
    }

    /// The wire called `name`, if it is one of these.
    pub fn find(&self, name: &str) -> Option<InnerWire> {
        self.by_name.get(name).copied()
    }
}

fn word_signal(level: &str, colour: Colour, word: usize) -> Signal {
    let meaning = "word 3p + q of the hold register: height, slopes and higher derivatives of a region";
    Signal::digital(
        named(format!("tg.{level}{}.word{word}", colour.name())),
        Unit::Metre,
        Kind::Bus,
        meaning,
        "fig. 22",
    )
}

/// Names of wires live as long as the program: a table is made once.
fn named(name: String) -> &'static str {
    name.leak()
}

impl InnerWire {
    fn signal(self, level: &str) -> Signal {
        let (unit, meaning, figure) = self.described();
        Signal::ground(named(self.name(level)), unit, meaning, figure)
    }

    fn name(self, level: &str) -> String {
        match self {
            Self::Accumulator(axis) => format!("sweep.{level}accumulator.{}", AXES[axis]),
            Self::Ramp(axis) => format!("sweep.{level}{}", AXES[axis]),
            Self::Function { fed, order } => format!("tg.{level}fn.{}.g{order}", FED[fed]),
            Self::Derivative { fed, order } => format!("tg.{level}fn.{}.d{order}", FED[fed]),
            Self::Product { sum, term } => {
                format!("tg.{level}{}product.{}{}", SUMS[sum], term / 6, term % 6)
            }
            Self::Converter { sum, term } => {
                let [colour, word] = word_of(term);
                format!("tg.{level}{}{}.dac{word}", SUMS[sum], Colour::ALL[colour].name())
            }
            Self::Colour(colour) => format!("tg.{level}{}.height", Colour::ALL[colour].name()),
            Self::Sum(sum) => format!("tg.{level}sum.{}", ["height", "u", "v"][sum]),
        }
    }

    fn described(self) -> (Unit, &'static str, &'static str) {
        let of_sum = |sum: usize, meanings: [&'static str; 3]| {
            (
                if sum == 0 { Unit::Metre } else { Unit::Slope },
                meanings[sum],
                if sum == 0 { "fig. 19" } else { "section 6.4" },
            )
        };
        match self {
            Self::Accumulator(0) => (
                Unit::Region,
                "accumulator of the ramp to the north, before converter and smoother",
                "fig. 17",
            ),
            Self::Accumulator(_) => (
                Unit::Region,
                "accumulator of the ramp to the east, before converter and smoother",
                "fig. 17",
            ),
            Self::Ramp(0) => (Unit::Region, "folded ramp to the north", "fig. 17"),
            Self::Ramp(_) => (Unit::Region, "folded ramp to the east", "fig. 17"),
            Self::Function { .. } => {
                (Unit::Number, "basis function of order g of a ramp, or of 1 less a ramp (cx, cy)", "fig. 19")
            }
            Self::Derivative { .. } => {
                (Unit::Number, "slope of the basis function of order d, by what feeds it", "section 6.4")
            }
            Self::Product { sum, .. } => {
                let meanings = [
                    "product of function generators p of X and q of Y, with their signs; 3 to 5 are those of 1-X, 1-Y",
                    "the same for the slope along X: generators of slopes of X",
                    "the same for the slope along Y: generators of slopes of Y",
                ];
                (Unit::Number, meanings[sum], of_sum(sum, meanings).2)
            }
            Self::Converter { sum, .. } => of_sum(
                sum,
                [
                    "what the D/A of word 3p + q sends to the sum of the height",
                    "what the D/A of word 3p + q sends to the sum of the slope to the north",
                    "what the D/A of word 3p + q sends to the sum of the slope to the east",
                ],
            ),
            Self::Colour(_) => (Unit::Metre, "what the nine words of a colour add to the height", "fig. 19"),
            Self::Sum(sum) => of_sum(
                sum,
                [
                    "height that the array puts out, above the tangent plane",
                    "slope to the north that the array puts out",
                    "slope to the east that the array puts out",
                ],
            ),
        }
    }

    /// Value at 0 V, and value at full scale from there, of an array of this scale over regions of side `region_size` (m).
    pub fn full_scale(self, scale: &Scale, region_size: f64) -> [f64; 2] {
        let peak = |unit: usize| if unit < 6 { PEAKS[unit % 3] } else { SLOPE_PEAKS[unit % 3] };
        let of_sum = |sum: usize| if sum == 0 { scale.height } else { scale.slope / region_size };
        match self {
            Self::Accumulator(_) | Self::Ramp(_) => [0.0, 1.0],
            Self::Function { order, .. } => [0.0, PEAKS[order]],
            Self::Derivative { order, .. } => [0.0, SLOPE_PEAKS[order]],
            Self::Product { sum, term } => [0.0, factors(sum, term).map(peak).iter().product()],
            Self::Converter { sum, .. } => [0.0, of_sum(sum)],
            Self::Colour(_) => [0.0, scale.height],
            Self::Sum(0) => [scale.datum, scale.height],
            Self::Sum(sum) => [0.0, of_sum(sum)],
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{COARSE, FINE, InnerWire};

    #[test]
    fn every_wire_has_a_name_of_its_own() {
        let levels = [&*FINE, &*COARSE];
        let wires = levels.iter().flat_map(|level| level.wires.iter().map(|(_, signal)| signal.name));
        let words = levels.iter().flat_map(|level| level.words.iter().map(|signal| signal.name));
        let names: BTreeSet<_> = wires.chain(words).collect();
        assert_eq!(names.len(), 2 * (2 + 2 + 12 + 12 + 108 + 108 + 4 + 3 + 36));
        for (wire, signal) in &FINE.wires {
            assert_eq!(FINE.find(signal.name), Some(*wire));
        }
        assert_eq!(FINE.find("tg.product.34"), Some(InnerWire::Product { sum: 0, term: 22 }));
        assert_eq!(COARSE.find("tg.coarse.u.red.dac8"), Some(InnerWire::Converter { sum: 1, term: 35 }));
        assert_eq!(FINE.find("tg.coarse.u.red.dac8"), None);
    }
}
