//! The array as drawn: twelve function generators, 36 products, 36 multiplying D/As, one sum (fig. 19).

use landscape::CornerWords;
use landscape::basis::{derivatives, values};

/// Height, `h_u` and `h_v` (all metres) at the ramps `[x, y]`, from the words in `hold`, by colour.
pub fn array(hold: &[CornerWords; 4], polarity: [f64; 2], [x, y]: [f64; 2]) -> [f64; 3] {
    let (gx, dx) = function_generators(x, polarity[0]);
    let (gy, dy) = function_generators(y, polarity[1]);
    let mut sums = [0.0; 3];
    for ap in 0..6 {
        let (mut value, mut slope) = (0.0, 0.0);
        for bq in 0..6 {
            let word = hold[ap / 3 + 2 * (bq / 3)][3 * (ap % 3) + bq % 3];
            value += word * gy[bq];
            slope += word * dy[bq];
        }
        sums[0] += gx[ap] * value;
        sums[1] += dx[ap] * value;
        sums[2] += gx[ap] * slope;
    }
    sums
}

/// `g_p` fed with the ramp and with its complement, and the slope generators, with the signs of section 6.4: odd
/// terms of value, even terms of slope carry `s` at the near corner and `-s` at the far one. Index `3 a + p`.
fn function_generators(ramp: f64, polarity: f64) -> ([f64; 6], [f64; 6]) {
    let ends = [(ramp, polarity), (1.0 - ramp, -polarity)];
    let (mut value, mut slope) = ([0.0; 6], [0.0; 6]);
    for (a, (fed, sign)) in ends.into_iter().enumerate() {
        let (g, dg) = (values(fed), derivatives(fed));
        for p in 0..3 {
            let odd = p == 1;
            value[3 * a + p] = if odd { sign * g[p] } else { g[p] };
            slope[3 * a + p] = if odd { dg[p] } else { sign * dg[p] };
        }
    }
    (value, slope)
}

#[cfg(test)]
mod tests {
    use super::array;
    use crate::{Segment, Span};
    use proptest::prelude::{any, prop_assert, proptest};

    proptest! {
        /// The array and its expansion are the same ground.
        #[test]
        fn array_and_expansion_agree(
            words in proptest::collection::vec(-1.0..1.0f64, 36),
            signs in any::<[bool; 2]>(),
            ramp in proptest::array::uniform2(0.0..=1.0f64),
            angle in 0.0..6.3f64,
        ) {
            let hold = std::array::from_fn(|colour| std::array::from_fn(|word| words[9 * colour + word]));
            let polarity = signs.map(|positive| if positive { 1.0 } else { -1.0 });
            let (sin, cos) = quantities::sin_cos(angle);
            // Terrain axes: u = s_x X, so the rates of the ramps carry the polarity.
            let span = Span {
                middle: ramp,
                half: [0.01 * cos * polarity[0], 0.01 * sin * polarity[1]],
                half_length: 0.01,
                across: [-sin * polarity[0], cos * polarity[1]],
            };
            let segment = Segment::expand(&hold, polarity, &span);
            let [height, hu, hv] = array(&hold, polarity, ramp);
            prop_assert!((segment.height[0] - height).abs() < 1e-13);
            prop_assert!((segment.along[0] - (hu * cos + hv * sin)).abs() < 1e-12);
            prop_assert!((segment.across[0] - (hv * cos - hu * sin)).abs() < 1e-12);
        }
    }
}
