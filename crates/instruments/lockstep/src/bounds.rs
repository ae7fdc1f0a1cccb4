//! How far two right answers may be apart, as a part of full scale.

use scenario::Scalar;

/// In f64. Between two folds the machine evaluates a polynomial in ground range (degree 10 for height), the interpreter
/// 36 products at the folded place: the order of operations differs. Rounding of the place, 1e-16 of up to a hundred
/// regions, counts with the slope of the ground, a few full scales a region, and each of the 11 terms adds its own.
pub const F64: f64 = 1e-12;

/// In f32: a sample's range is rounded to 24 bits, that is, by 6e-8 of up to 20 regions; height answers with its slope,
/// and the sum of 11 terms adds its own. Largest found on terrain over 400 random scenes: 3.8e-6.
pub const F32: f64 = 8e-6;

/// Behind real parts, in f64: the machine divides steps by an exponential that is right to 1e-12, the interpreter sums a series, and
/// a lag of many steps adds up what each of them rounds.
const OF_PARTS: f64 = 1e-9;

/// Light of real parts: a slope is off by its own bound, and root, divider and the quotient of the lunar law answer with more than that
/// where they are steep. Largest found on the shipped scenarios under the shipped models: 6.5e-9.
const LIGHT_OF_PARTS_F64: f64 = 1e-8;

/// The same in f32. Largest found on full drive: 4.4e-5.
const LIGHT_OF_PARTS_F32: f64 = 1e-4;

/// Edges of real video switches, in f32: an edge lies between samples, its instant is off by up to 1e-4 of a step, and a switch of a
/// tenth of a step makes ten times that of it. Largest found likewise: 4.7e-4.
const EDGES_OF_PARTS_F32: f64 = 1e-3;

/// What craters with rims a tenth of their radius wide add in f32 (sheet of the feature generator).
const CRATERS_F32: f64 = 2e-5;

/// The bound of a scalar.
pub fn of(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => F64,
        Scalar::F32 => F32,
    }
}

/// Accumulators nearer than this to where a converter takes another word: rounding says which it takes (full scales).
pub fn between_words(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => 1e-12,
        Scalar::F32 => 1e-7,
    }
}

/// The bound behind real parts.
pub fn of_parts(scalar: Scalar) -> f64 {
    of(scalar).max(OF_PARTS)
}

/// The bound of light behind real parts.
pub fn of_light_of_parts(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => LIGHT_OF_PARTS_F64,
        Scalar::F32 => LIGHT_OF_PARTS_F32,
    }
}

/// The bound of light and video behind real video switches.
pub fn of_edges_of_parts(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => LIGHT_OF_PARTS_F64,
        Scalar::F32 => EDGES_OF_PARTS_F32,
    }
}

/// What rounding of the place adds where the narrowest ring of a crater is `ring` wide and the sweep ends at `end` (m): four
/// units in the last place of the range, as a part of the ring; nothing without craters, whose ring is infinite.
pub fn of_craters(scalar: Scalar, ring: f64, end: f64) -> f64 {
    match scalar {
        Scalar::F64 => 4.0 * f64::EPSILON * end / ring,
        Scalar::F32 if ring.is_finite() => CRATERS_F32,
        Scalar::F32 => 0.0,
    }
}

/// Margins below this are undecided: rounding says on which side of a threshold a value lies. They are parts of full
/// scale or of a radius; places along a sweep are rounded by more than either.
pub fn undecided(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => 1e-9,
        Scalar::F32 => 1e-4,
    }
}
