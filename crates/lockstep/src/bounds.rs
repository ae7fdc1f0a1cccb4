//! How far two right answers may be apart, as a part of full scale.

use scenario::Scalar;

/// In f64. Between two folds the machine evaluates a polynomial in ground range (degree 10 for height), the interpreter
/// 36 products at the folded place: the order of operations differs. Rounding of the place, 1e-16 of up to a hundred
/// regions, counts with the slope of the ground, a few full scales a region, and each of the 11 terms adds its own.
pub const F64: f64 = 1e-12;

/// In f32: a sample's range is rounded to 24 bits, that is, by 6e-8 of up to 20 regions; height answers with its slope,
/// and the sum of 11 terms adds its own. Craters with rims a tenth of their radius wide add 2e-5.
pub const F32: f64 = 2e-5;

/// The bound of a scalar.
pub fn of(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F64 => F64,
        Scalar::F32 => F32,
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
