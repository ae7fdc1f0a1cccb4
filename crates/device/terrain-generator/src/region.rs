//! The 36 terms of a region as one polynomial of both ramps.

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Simd, f64x8};
use landscape::CornerWords;
use landscape::basis::NEAR;
use signal::{LANES, turn_square};

use crate::Registers;

/// Height of a region (m): `sum rows[i][j] (X - 1/2)^i (Y - 1/2)^j`; of one, or of several side by side.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Region<T = f64>([[T; 6]; 6]);

impl Region {
    /// The sum of 6.4 from the words in `hold`, by colour, with the present `polarity`.
    #[inline(always)]
    pub fn of(hold: [&CornerWords; 4], polarity: [f64; 2]) -> Self {
        let mut rows = [[0.0; 6]; 6];
        for a in 0..2 {
            let ex = if a == 1 { -polarity[0] } else { polarity[0] };
            for p in 0..3 {
                let sign = if p == 1 { ex } else { 1.0 };
                let in_y = words_along_y(hold, polarity[1], a, p);
                for i in 0..6 {
                    let weight = sign * CENTRED[a][p][i];
                    for j in 0..6 {
                        rows[i][j] += weight * in_y[j];
                    }
                }
            }
        }
        Self(rows)
    }
}

impl<T> Region<T> {
    /// Coefficients: row i has those of `(X - 1/2)^i`, ascending powers of `Y - 1/2`.
    #[inline(always)]
    pub fn rows(&self) -> &[[T; 6]; 6] {
        &self.0
    }
}

/// The six terms in Y that share `g_p(X_a)`, as a polynomial in `Y - 1/2`.
#[inline(always)]
fn words_along_y(hold: [&CornerWords; 4], polarity: f64, a: usize, p: usize) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for b in 0..2 {
        let words = hold[a + 2 * b];
        let ey = if b == 1 { -polarity } else { polarity };
        for q in 0..3 {
            let word = if q == 1 { ey * words[3 * p + q] } else { words[3 * p + q] };
            for j in 0..6 {
                sum[j] += word * CENTRED[b][q][j];
            }
        }
    }
    sum
}

/// Regions that are found again.
const KEPT: usize = 32;

/// Regions that stay: more than neighbouring sweeps meet in turns, and few enough for the cache.
const MOST: usize = 64;

/// Regions that the sweeps of a group meet: neighbours meet the same ones, and find them made. One is found by the corners that
/// the hold registers have and by the polarity, which are all that it is made from. Each has a number, and stays until there are
/// too many, or the next group.
#[derive(Debug, Clone)]
pub(crate) struct GroupRegions {
    /// What the regions that are found again are made of, and their numbers.
    made_of: [([u32; 4], [f64; 2], u32); KEPT],
    regions: Vec<Region>,
}

/// Equal to no polarity: nothing is found before it is made.
const NOTHING: ([u32; 4], [f64; 2], u32) = ([0; 4], [f64::NAN; 2], 0);

impl Default for GroupRegions {
    fn default() -> Self {
        Self { made_of: [NOTHING; KEPT], regions: Vec::new() }
    }
}

impl GroupRegions {
    /// The corners may have other words from now on.
    pub fn forget(&mut self) {
        self.made_of = [NOTHING; KEPT];
        self.regions.clear();
    }

    /// Makes room for those of the next stretches: numbers that were told before may mean others from now on.
    pub fn make_room(&mut self) {
        if self.regions.len() > MOST {
            self.forget();
        }
    }

    /// The number of the region of the words that the registers hold; `buffer` is the storage buffer.
    #[inline(always)]
    pub fn of(&mut self, registers: &Registers, buffer: &[CornerWords]) -> u32 {
        // Late words, of several corners in one register, no other sweep need have.
        let made_of = registers.corners_held().map(|corners| (corners, registers.polarity()));
        let place = made_of.map_or(0, |(corners, _)| place_of(&corners));
        let (corners, polarity, number) = self.made_of[place];
        if made_of == Some((corners, polarity)) {
            return number;
        }
        let number = self.regions.len() as u32;
        self.regions.push(Region::of(registers.hold(buffer), registers.polarity()));
        if let Some((corners, polarity)) = made_of {
            self.made_of[place] = (corners, polarity, number);
        }
        number
    }

    /// Eight regions by their numbers, as one.
    #[inline(always)]
    pub fn side_by_side<L: Simd>(&self, simd: L, numbers: &[u32; LANES]) -> Region<f64x8<L>> {
        let first = numbers[0];
        let is_one = numbers.iter().fold(0, |other, &number| other | (number ^ first)) == 0;
        let mut rows = [[f64x8::simd_from(simd, 0.0); 6]; 6];
        if is_one {
            // Neighbours are over the same region most of the time.
            let region = self.regions[first as usize].0.as_flattened();
            for (all, &one) in rows.as_flattened_mut().iter_mut().zip(region) {
                *all = f64x8::simd_from(simd, one);
            }
        } else {
            self.turn(simd, numbers, rows.as_flattened_mut());
        }
        Region(rows)
    }

    /// Squares of eight coefficients of eight regions, and the last four coefficients.
    #[inline(always)]
    fn turn<L: Simd>(&self, simd: L, numbers: &[u32; LANES], coefficients: &mut [f64x8<L>]) {
        let of = |lane: usize| self.regions[numbers[lane] as usize].0.as_flattened();
        let first = coefficients.len() - coefficients.len() % LANES;
        let (squares, last) = coefficients.as_chunks_mut();
        for (number, square) in squares.iter_mut().enumerate() {
            for lane in 0..LANES {
                square[lane] = f64x8::from_slice(simd, &of(lane)[LANES * number..][..LANES]);
            }
            turn_square(square);
        }
        for (number, coefficients) in (first..).zip(last) {
            let mut eight = [0.0; LANES];
            for lane in 0..LANES {
                eight[lane] = of(lane)[number];
            }
            *coefficients = f64x8::from_slice(simd, &eight);
        }
    }

    /// Returns the region called `number`, counted from 0.
    #[cfg(test)]
    fn get(&self, number: u32) -> &Region {
        &self.regions[number as usize]
    }
}

/// Where regions of these corners are found again.
#[inline(always)]
fn place_of(corners: &[u32; 4]) -> usize {
    let sum = corners.iter().fold(0, |sum: u32, &corner| sum.wrapping_mul(31).wrapping_add(corner));
    (sum.wrapping_mul(0x9E37_79B9) >> 16) as usize % KEPT
}

/// `g_p(X_a)` about the middle of the region, by `[a][p]`, ascending powers of `X - 1/2`.
const CENTRED: [[[f64; 6]; 3]; 2] = centred();

const fn centred() -> [[[f64; 6]; 3]; 2] {
    let mut out = [[[0.0; 6]; 3]; 2];
    let mut p = 0;
    while p < 3 {
        // Horner's Taylor shift by 1/2; g_p(1 - X) mirrors it.
        let mut c = NEAR[p];
        let mut i = 0;
        while i < 5 {
            let mut j = 4;
            while j + 1 > i {
                c[j] += 0.5 * c[j + 1];
                if j == 0 {
                    break;
                }
                j -= 1;
            }
            i += 1;
        }
        out[0][p] = c;
        let mut k = 0;
        while k < 6 {
            out[1][p][k] = if k % 2 == 0 { c[k] } else { -c[k] };
            k += 1;
        }
        p += 1;
    }
    out
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{CENTRED, GroupRegions, Region};
    use crate::Registers;
    use crate::programs::program;
    use landscape::basis::values;
    use landscape::{CornerWords, Level};
    use proptest::prelude::{any, prop_assert_eq, proptest};
    use sweep_program::{Colour, Fold, Load, PreloadRegister, RampAxis, Stop, Target, WordMask};

    /// A polynomial of ascending powers.
    pub(crate) fn horner(coefficients: &[f64], s: f64) -> f64 {
        coefficients.iter().rev().fold(0.0, |sum, &c| sum * s + c)
    }

    #[test]
    fn centred_basis_is_the_basis() {
        for step in 0..=20 {
            let z = f64::from(step) / 20.0;
            for p in 0..3 {
                assert!((horner(&CENTRED[0][p], z - 0.5) - values(z)[p]).abs() < 1e-15);
                assert!((horner(&CENTRED[1][p], z - 0.5) - values(1.0 - z)[p]).abs() < 1e-15);
            }
        }
    }

    proptest! {
        /// Loads, whole and word by word, into any register, and folds: what is kept is always what the words make.
        #[test]
        fn a_region_at_hand_is_the_region_of_the_words(
            events in proptest::collection::vec((0..5u8, 0..4usize, 0..70u32, any::<bool>()), 1..400),
        ) {
            let word = |k: usize| f64::from((k * 2_654_435 % 1000) as u32) / 500.0 - 1.0;
            let corner = |corner: usize| std::array::from_fn(|k| word(9 * corner + k));
            let buffer: Vec<CornerWords> = (0..64).map(corner).collect();
            let level = Level::new(250.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
            let mut registers = Registers::at_start(&program(&level, [10.0; 2], [0.8, 0.6], &[1.0, 200.0]));
            let mut made = GroupRegions::default();
            let mut numbers = Vec::new();
            for (n, (what, colour, corner, whole)) in events.into_iter().enumerate() {
                // As before each stretch of eight sweeps: numbers hold until then.
                if n.is_multiple_of(8) {
                    made.make_room();
                    numbers.clear();
                }
                let target = match what {
                    0 => Target::Hold,
                    1 => Target::Preload(PreloadRegister::XFirst),
                    _ => Target::Preload(PreloadRegister::YFirst),
                };
                let stop = if whole { Stop::One } else { Stop::Zero };
                match what {
                    3 => registers.fold(Fold { axis: RampAxis::X, stop }),
                    4 => registers.fold(Fold { axis: RampAxis::Y, stop }),
                    _ => {
                        let words = if whole { WordMask::ALL } else { WordMask::only(corner as usize % 9) };
                        registers.load(&Load { colour: Colour::ALL[colour], target, corner, words }, &buffer);
                    }
                }
                let number = made.of(&registers, &buffer);
                let expected = Region::of(registers.hold(&buffer), registers.polarity());
                prop_assert_eq!(made.get(number), &expected);
                numbers.push((number, expected));
            }
            for (number, expected) in numbers {
                prop_assert_eq!(made.get(number), &expected);
            }
        }
    }
}
