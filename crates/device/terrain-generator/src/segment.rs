//! Expansion of a region's polynomial along a straight stretch of a sweep.

use signal::Number;

use crate::Region;

/// A stretch between two events, in ramp coordinates; one, or several side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span<T = f64> {
    /// Ramps X and Y at its middle, 0..=1.
    pub middle: [T; 2],
    /// Change of X and Y from the middle to its far end.
    pub half: [T; 2],
    /// Half its length on the ground (m), above 0.
    pub half_length: T,
    /// Weights of `dh/dX` and `dh/dY` in the slope across the sweep, positive to the right (1/m):
    /// `-sin theta s_x / d` and `cos theta s_y / d`.
    pub across: [T; 2],
}

/// Height and slopes along one stretch, or along several side by side, as polynomials in s, -1..=1 over it.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment<T = f64> {
    /// Height (m), ascending powers of s.
    pub height: [T; 11],
    /// Slope along the sweep (m/m).
    pub along: [T; 10],
    /// Slope across the sweep, positive to the right (m/m).
    pub across: [T; 10],
}

impl<T: Number> Segment<T> {
    /// Expands a region's polynomial along a stretch: `sum rows[i](s) (X - 1/2)^i` by Horner on polynomials.
    #[inline(always)]
    pub fn expand(region: &Region<T>, span: &Span<T>) -> Self {
        let number = |value: usize| span.half_length.like(value as f64);
        let (above, across) = along_y(&region.rows()[5], span);
        let mut sums = Sums { height: [number(0); 11], across: [number(0); 11], above };
        sums.height[..6].copy_from_slice(&above);
        sums.across[..6].copy_from_slice(&across);
        // Each written out, of its own degree: loops of degrees that change are not unrolled.
        sums.add_row::<4, 6>(region, span);
        sums.add_row::<3, 7>(region, span);
        sums.add_row::<2, 8>(region, span);
        sums.add_row::<1, 9>(region, span);
        sums.add_row::<0, 10>(region, span);
        let (height, slope_across) = (sums.height, sums.across);
        // A loop: what `from_fn` is handed is not always compiled for the width of the vectors.
        let (mut along, mut across) = ([number(0); 10], [number(0); 10]);
        for k in 0..10 {
            along[k] = number(k + 1) * height[k + 1] / span.half_length;
            across[k] = slope_across[k];
        }
        Self { height, along, across }
    }
}

/// A row in `Y - 1/2` as a polynomial in s, and its share of the slope across.
#[inline(always)]
fn along_y<T: Number>(row: &[T; 6], span: &Span<T>) -> ([T; 6], [T; 6]) {
    let number = |value: f64| span.half_length.like(value);
    let (y, half) = (span.middle[1] - number(0.5), span.half[1]);
    let mut shifted = *row;
    for i in 0..5 {
        for j in (i..5).rev() {
            shifted[j] = shifted[j] + y * shifted[j + 1];
        }
    }
    let (mut values, mut across) = ([number(0.0); 6], [number(0.0); 6]);
    let mut power = number(1.0);
    for k in 0..6 {
        values[k] = shifted[k] * power;
        if k < 5 {
            across[k] = span.across[1] * number((k + 1) as f64) * shifted[k + 1] * power;
        }
        power = power * half;
    }
    (values, across)
}

/// Horner's sums on the way from row to row.
struct Sums<T> {
    height: [T; 11],
    across: [T; 11],
    /// Values of the row before.
    above: [T; 6],
}

impl<T: Number> Sums<T> {
    /// Goes on to row `I`, which makes both sums polynomials of degree `DEGREE`.
    #[inline(always)]
    fn add_row<const I: usize, const DEGREE: usize>(&mut self, region: &Region<T>, span: &Span<T>) {
        let (values, mut across) = along_y(&region.rows()[I], span);
        let rate = span.across[0] * span.half_length.like((I + 1) as f64);
        for k in 0..6 {
            across[k] = across[k] + rate * self.above[k];
        }
        let x = [span.middle[0] - span.half_length.like(0.5), span.half[0]];
        times_x_and::<T, DEGREE>(&mut self.height, x, &values);
        times_x_and::<T, DEGREE>(&mut self.across, x, &across);
        self.above = values;
    }
}

/// `sum` becomes a polynomial of degree `DEGREE`: what it was times `x[0] + x[1] s`, and `row`.
#[inline(always)]
fn times_x_and<T: Number, const DEGREE: usize>(sum: &mut [T; 11], x: [T; 2], row: &[T; 6]) {
    for k in (1..=DEGREE).rev() {
        sum[k] = sum[k] * x[0] + sum[k - 1] * x[1];
    }
    sum[0] = sum[0] * x[0];
    for k in 0..6 {
        sum[k] = sum[k] + row[k];
    }
}

#[cfg(test)]
mod tests {
    use super::{Segment, Span};
    use crate::Region;
    use crate::region::tests::horner;
    use landscape::basis::{derivatives, values};

    /// One word at one corner, each of the four polarities: height is `e_x^p e_y^q g_p(X_a) g_q(Y_b)` alone
    /// (the cartridge "one coefficient, 36 x 4").
    #[test]
    fn one_word_alone_is_its_product() {
        let span = Span {
            middle: [0.37, 0.58],
            half: [0.21, -0.33],
            half_length: 100.0,
            across: [-0.004 * 0.6, 0.004 * 0.8],
        };
        for case in 0..36 * 4 {
            let (colour, word, signs) = (case % 4, case / 4 % 9, case / 36);
            let polarity = [if signs & 1 == 0 { 1.0 } else { -1.0 }, if signs & 2 == 0 { 1.0 } else { -1.0 }];
            let mut hold = [[0.0; 9]; 4];
            hold[colour][word] = 1.0;
            let segment = Segment::expand(&Region::of(hold.each_ref(), polarity), &span);
            for s in [-1.0, -0.4, 0.0, 0.9] {
                let (a, b, p, q) = (colour & 1, colour >> 1, word / 3, word % 3);
                let at = |axis: usize, far: usize| {
                    let ramp = span.middle[axis] + s * span.half[axis];
                    let sign = if far == 1 { -polarity[axis] } else { polarity[axis] };
                    (if far == 1 { 1.0 - ramp } else { ramp }, sign)
                };
                let ((x, ex), (y, ey)) = (at(0, a), at(1, b));
                let odd = if p == 1 { ex } else { 1.0 } * if q == 1 { ey } else { 1.0 };
                let expected = odd * values(x)[p] * values(y)[q];
                assert!((horner(&segment.height, s) - expected).abs() < 1e-15, "case {case}");
                let (mirror_x, mirror_y) = (1.0 - 2.0 * a as f64, 1.0 - 2.0 * b as f64);
                let by_x = odd * mirror_x * derivatives(x)[p] * values(y)[q];
                let by_y = odd * mirror_y * values(x)[p] * derivatives(y)[q];
                let along = (by_x * span.half[0] + by_y * span.half[1]) / span.half_length;
                assert!((horner(&segment.along, s) - along).abs() < 1e-16, "case {case}");
                let across = span.across[0] * by_x + span.across[1] * by_y;
                assert!((horner(&segment.across, s) - across).abs() < 1e-16, "case {case}");
            }
        }
    }
}
