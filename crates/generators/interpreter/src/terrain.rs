//! Function generators, products and sums (sections 5.2, 6.1, 6.4).

use crate::registers::CORNERS;

/// Outputs of the three kinds of function generator at z, and of their derivative generators.
#[derive(Debug, Clone, Copy)]
pub struct Generators {
    /// Values of the three orders.
    pub value: [f64; 3],
    /// Slopes of the three orders.
    pub slope: [f64; 3],
}

/// The three kinds of function generator at `z`.
pub fn generators(z: f64) -> Generators {
    let (z2, z3) = (z * z, z * z * z);
    let (z4, z5) = (z2 * z2, z2 * z3);
    Generators {
        value: [
            1.0 - 10.0 * z3 + 15.0 * z4 - 6.0 * z5,
            z - 6.0 * z3 + 8.0 * z4 - 3.0 * z5,
            (z2 - 3.0 * z3 + 3.0 * z4 - z5) / 2.0,
        ],
        slope: [
            -30.0 * z2 + 60.0 * z3 - 30.0 * z4,
            1.0 - 18.0 * z2 + 32.0 * z3 - 15.0 * z4,
            (2.0 * z - 9.0 * z2 + 12.0 * z3 - 5.0 * z4) / 2.0,
        ],
    }
}

/// What the array gives at one sample; metres.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sums {
    /// Height, and its derivatives in u and v.
    pub ground: [f64; 3],
    /// What each colour adds to the height.
    pub colours: [f64; 4],
    /// Outputs of the function generators fed X, 1 - X, Y, 1 - Y.
    pub functions: [[f64; 3]; 4],
    /// Outputs of their derivative generators.
    pub derivatives: [[f64; 3]; 4],
    /// What the multipliers of height, slope in u and slope in v put out: colour by colour, `3 p + q`.
    pub products: [[[f64; 9]; 4]; 3],
    /// The same behind the multiplying D/As.
    pub sent: [[[f64; 9]; 4]; 3],
}

/// The sums of 6.4 from what is in the hold registers.
pub fn sums(hold: &[[f64; 9]; 4], ramps: [f64; 2], polarity: [f64; 2]) -> Sums {
    let [of_x, of_one_minus_x] = [generators(ramps[0]), generators(1.0 - ramps[0])];
    let [of_y, of_one_minus_y] = [generators(ramps[1]), generators(1.0 - ramps[1])];
    let fed = [of_x, of_one_minus_x, of_y, of_one_minus_y];
    let mut sums = Sums {
        functions: fed.map(|fed| fed.value),
        derivatives: fed.map(|fed| fed.slope),
        ..Sums::default()
    };
    for (colour, [a, b]) in CORNERS.into_iter().enumerate() {
        let (gx, ex) = if a == 0 { (of_x, polarity[0]) } else { (of_one_minus_x, -polarity[0]) };
        let (gy, ey) = if b == 0 { (of_y, polarity[1]) } else { (of_one_minus_y, -polarity[1]) };
        for p in 0..3 {
            for q in 0..3 {
                let odd_x = if p == 1 { ex } else { 1.0 };
                let odd_y = if q == 1 { ey } else { 1.0 };
                let (odd, word, place) = (odd_x * odd_y, hold[colour][3 * p + q], 3 * p + q);
                let products = [
                    odd * (gx.value[p] * gy.value[q]),
                    odd * (ex * gx.slope[p] * gy.value[q]),
                    odd * (ey * gx.value[p] * gy.slope[q]),
                ];
                for (sum, product) in products.into_iter().enumerate() {
                    sums.products[sum][colour][place] = product;
                    sums.sent[sum][colour][place] = product * word;
                    sums.ground[sum] += product * word;
                }
                sums.colours[colour] += products[0] * word;
            }
        }
    }
    sums
}
