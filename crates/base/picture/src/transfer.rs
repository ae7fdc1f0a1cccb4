//! From linear intensity to codes.

use crate::error::PictureError;
use crate::pixels::{ColourPicture, Depth, GreyPicture, Picture};

/// The law between linear intensity I and the code v of a display:
/// `v = round(max * clamp(I / white, 0, 1)^(1 / gamma))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transfer {
    white: f32,
    gamma: f32,
}

impl Transfer {
    /// The intensity `white` (1e-6 to 1e6) that gets the largest code, and the exponent `gamma` of the display
    /// (0.25 to 4; 1 is linear).
    ///
    /// # Errors
    /// [`PictureError::Transfer`] outside these bounds.
    pub fn new(white: f32, gamma: f32) -> Result<Self, PictureError> {
        let bounded = |name, found: f32, low, high| match (low..=high).contains(&found) {
            true => Ok(()),
            false => Err(PictureError::Transfer { name, found, low, high }),
        };
        bounded("white", white, 1e-6, 1e6)?;
        bounded("gamma", gamma, 0.25, 4.0)?;
        Ok(Self { white, gamma })
    }

    /// The intensity that gets the largest code.
    pub fn white(&self) -> f32 {
        self.white
    }

    /// The exponent of the display.
    pub fn gamma(&self) -> f32 {
        self.gamma
    }

    /// The intensity that a code stands for.
    pub fn intensity(&self, code: u16, depth: Depth) -> f32 {
        self.intensity_of_level(f64::from(code) / f64::from(depth.white()))
    }

    fn intensity_of_level(&self, level: f64) -> f32 {
        (f64::from(self.white) * libm::pow(level, f64::from(self.gamma))) as f32
    }

    /// The law, straight from its formula.
    fn code(&self, intensity: f32, depth: Depth) -> u16 {
        let share = (f64::from(intensity) / f64::from(self.white)).clamp(0.0, 1.0);
        let level = libm::pow(share, 1.0 / f64::from(self.gamma));
        (level * f64::from(depth.white()) + 0.5).floor() as u16
    }

    /// The smallest intensity that gets `code` (1 or more).
    fn threshold(&self, code: u16, depth: Depth) -> f32 {
        let guess = self.intensity_of_level((f64::from(code) - 0.5) / f64::from(depth.white()));
        let mut threshold = guess;
        while self.code(threshold.next_down(), depth) >= code {
            threshold = threshold.next_down();
        }
        while self.code(threshold, depth) < code {
            threshold = threshold.next_up();
        }
        threshold
    }
}

/// A transfer law made ready for whole planes: the intensity at which each code begins is found once, and a
/// pixel costs one look-up and a few comparisons instead of a power (1000 x 575 pixels: 1.0 ms for 8 bits,
/// 1.6 ms for 16; the tables 0.1 ms and 26 ms).
#[derive(Clone, Debug)]
pub struct Encoder {
    transfer: Transfer,
    depth: Depth,
    /// `thresholds[v]` is the smallest intensity of code v + 1; the last is infinite.
    thresholds: Vec<f32>,
    buckets: Buckets,
}

/// Codes by the leading bits of an intensity. The bits of positive floats are in the order of their values.
#[derive(Clone, Debug)]
struct Buckets {
    shift: u32,
    first: u32,
    /// Code at the lower edge of each bucket.
    codes: Vec<u16>,
    /// Most thresholds inside one bucket.
    steps: usize,
}

impl Encoder {
    /// Makes the table of thresholds for one transfer law and depth.
    pub fn new(transfer: Transfer, depth: Depth) -> Self {
        let mut thresholds: Vec<f32> =
            (1..=depth.white()).map(|code| transfer.threshold(code, depth)).collect();
        thresholds.push(f32::INFINITY);
        let buckets = Buckets::new(&thresholds, depth);
        Self { transfer, depth, thresholds, buckets }
    }

    /// The law this encoder follows.
    pub fn transfer(&self) -> Transfer {
        self.transfer
    }

    /// Bits of the codes it makes.
    pub fn depth(&self) -> Depth {
        self.depth
    }

    /// The picture of a plane of linear intensity, line by line. Below 0 is black, above `white` is white.
    ///
    /// # Errors
    /// [`PictureError::Size`], [`PictureError::NotFinite`] with the first pixel that is no number.
    pub fn encode(&self, plane: &[f32], columns: usize, lines: usize) -> Result<GreyPicture, PictureError> {
        check(plane, columns, lines)?;
        let codes = plane.iter().map(|intensity| self.code(*intensity)).collect();
        Ok(GreyPicture::from_parts(columns, lines, self.depth, codes))
    }

    /// The picture of three planes of linear red, green and blue, each by the law of [`Encoder::encode`].
    ///
    /// # Errors
    /// As [`Encoder::encode`], for the first plane at fault.
    pub fn encode_colour(
        &self,
        planes: [&[f32]; 3],
        columns: usize,
        lines: usize,
    ) -> Result<ColourPicture, PictureError> {
        planes.iter().try_for_each(|plane| check(plane, columns, lines))?;
        let [red, green, blue] = planes;
        let pixels = red.iter().zip(green).zip(blue);
        let codes = pixels.flat_map(|((red, green), blue)| [red, green, blue].map(|light| self.code(*light)));
        Ok(Picture::from_parts(columns, lines, self.depth, codes.collect()))
    }

    fn code(&self, intensity: f32) -> u16 {
        let mut code = self.buckets.code_below(intensity);
        for _ in 0..self.buckets.steps {
            code += u16::from(intensity >= self.thresholds[usize::from(code)]);
        }
        code
    }
}

/// The plane fills the picture, and all of it are numbers.
fn check(plane: &[f32], columns: usize, lines: usize) -> Result<(), PictureError> {
    if columns.checked_mul(lines) != Some(plane.len()) || plane.is_empty() {
        return Err(PictureError::Size { columns, lines, codes: plane.len() });
    }
    // All are looked at: one pass without branches is faster than one that stops.
    match plane.iter().fold(false, |bad, value| bad | !value.is_finite()) {
        true => Err(not_finite(plane, columns)),
        false => Ok(()),
    }
}

fn not_finite(plane: &[f32], columns: usize) -> PictureError {
    let at = plane.iter().position(|value| !value.is_finite()).unwrap_or_default();
    PictureError::NotFinite { column: at % columns, line: at / columns, value: plane[at] }
}

impl Buckets {
    fn new(thresholds: &[f32], depth: Depth) -> Self {
        // Leading mantissa bits kept: fine enough for one or two thresholds a bucket at gamma 2.2.
        let shift = 23 - if depth == Depth::Eight { 8 } else { 14 };
        let last_code = thresholds.len() - 1;
        let first = thresholds[0].to_bits() >> shift;
        let last = (thresholds[last_code - 1].to_bits() >> shift) + 1;
        let edges = (first..=last).map(|bucket| f32::from_bits(bucket << shift));
        let codes: Vec<u16> = edges.map(|edge| thresholds.partition_point(|t| *t <= edge) as u16).collect();
        let steps = codes.windows(2).map(|pair| usize::from(pair[1] - pair[0])).max().unwrap_or(0);
        Self { shift, first, codes, steps }
    }

    fn code_below(&self, intensity: f32) -> u16 {
        // Not `max`, which may take either of two zeros: the bits of -0 are above those of white.
        let bright = if intensity > 0.0 { intensity } else { 0.0 };
        let bucket = bright.to_bits() >> self.shift;
        let index = bucket.saturating_sub(self.first) as usize;
        self.codes[index.min(self.codes.len() - 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::{prop_assert_eq, proptest};

    #[test]
    fn every_code_begins_at_its_threshold() {
        for (gamma, depth) in
            [(2.2, Depth::Eight), (1.0, Depth::Eight), (4.0, Depth::Sixteen), (0.25, Depth::Sixteen)]
        {
            let encoder = Encoder::new(Transfer::new(0.3, gamma).expect("a good law"), depth);
            for code in 1..=depth.white() {
                let threshold = encoder.thresholds[usize::from(code) - 1];
                assert!(encoder.code(threshold) >= code, "gamma {gamma}, code {code}");
                assert!(encoder.code(threshold.next_down()) < code, "gamma {gamma}, code {code}");
            }
        }
    }

    #[test]
    fn codes_and_intensities_go_both_ways() {
        for depth in [Depth::Eight, Depth::Sixteen] {
            let transfer = Transfer::new(0.8, 2.2).expect("a good law");
            let encoder = Encoder::new(transfer, depth);
            for code in 0..=depth.white() {
                assert_eq!(encoder.code(transfer.intensity(code, depth)), code);
            }
        }
    }

    #[test]
    fn black_is_black_whatever_its_sign() {
        for depth in [Depth::Eight, Depth::Sixteen] {
            let encoder = Encoder::new(Transfer::new(0.8, 2.2).expect("a good law"), depth);
            assert_eq!([-1.0, -f32::MIN_POSITIVE, -0.0, 0.0].map(|black| encoder.code(black)), [0; 4]);
        }
    }

    proptest! {
        #[test]
        fn the_table_follows_the_law(intensity in -0.2_f32..1.5, gamma in 0.25_f32..4.0, white in 0.01_f32..2.0) {
            let transfer = Transfer::new(white, gamma).expect("a good law");
            let encoder = Encoder::new(transfer, Depth::Eight);
            prop_assert_eq!(encoder.code(intensity), transfer.code(intensity, Depth::Eight));
        }
    }
}
