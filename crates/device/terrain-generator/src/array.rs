//! The array as drawn: twelve function generators, 36 products, 36 multiplying D/As, one sum (fig. 19).

use landscape::basis::{derivatives, values};
use signal::Number;

/// Height, `h_u` and `h_v` (all metres) at the ramps `[x, y]`, from the nine words of each colour in `hold`; of one place, or of
/// eight side by side.
#[inline(always)]
pub fn array<T: Number>(hold: [&[T; 9]; 4], polarity: [T; 2], [x, y]: [T; 2]) -> [T; 3] {
    let zero = x.like(0.0);
    // Fed with the ramps and their complements, with the signs of section 6.4: odd terms of value, even terms of slope
    // carry `s` at the near corner and `-s` at the far one.
    let in_x = [function_generators(x, polarity[0]), function_generators(x.like(1.0) - x, -polarity[0])];
    let in_y = [function_generators(y, polarity[1]), function_generators(y.like(1.0) - y, -polarity[1])];
    let mut sums = [zero; 3];
    for a in 0..2 {
        let (gx, dx) = &in_x[a];
        for p in 0..3 {
            let (mut value, mut slope) = (zero, zero);
            for b in 0..2 {
                let (gy, dy) = &in_y[b];
                for q in 0..3 {
                    let word = hold[a + 2 * b][3 * p + q];
                    value = value + word * gy[q];
                    slope = slope + word * dy[q];
                }
            }
            sums[0] = sums[0] + gx[p] * value;
            sums[1] = sums[1] + dx[p] * value;
            sums[2] = sums[2] + gx[p] * slope;
        }
    }
    sums
}

/// `g_0p` and its derivative of one input, odd terms of the one and even terms of the other times `sign`.
#[inline(always)]
fn function_generators<T: Number>(fed: T, sign: T) -> ([T; 3], [T; 3]) {
    let (g, d) = (values(fed), derivatives(fed));
    ([g[0], sign * g[1], g[2]], [sign * d[0], d[1], sign * d[2]])
}

#[cfg(test)]
mod tests {
    use super::array;
    use crate::{Region, Segment, Span};
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
            let segment = Segment::expand(&Region::of(hold.each_ref(), polarity), &span);
            let [height, hu, hv] = array(hold.each_ref(), polarity, ramp);
            prop_assert!((segment.height[0] - height).abs() < 1e-13);
            prop_assert!((segment.along[0] - (hu * cos + hv * sin)).abs() < 1e-12);
            prop_assert!((segment.across[0] - (hv * cos - hu * sin)).abs() < 1e-12);
        }
    }
}
