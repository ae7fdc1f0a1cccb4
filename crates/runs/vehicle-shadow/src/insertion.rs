//! How the shadow gets into the picture (section 19.6).

use picture::GreyPicture;

use crate::gate::{Gate, Gates};

/// Shares of each element of a raster that are dark, 0..=1, line by line from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Shade {
    columns: usize,
    shares: Vec<f64>,
}

/// What stands between computer and video.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// The computer finds where lines cross outlines; D/A converters hold these places against the deflection, and
    /// the video is blanked in between.
    Synchronised {
        /// Bits of the converters, over the width of the picture.
        dac_bits: u32,
    },
    /// Outlines are written as areas into a scan converter, which is read at the picture's rate.
    ScanConverter(ScanConverter),
}

/// A storage tube that is written and read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScanConverter {
    /// Limiting resolution (television lines a picture height): response 50 % there.
    pub tv_lines: u32,
    /// By how much what is read lies off to the right and down (share of the picture's height).
    pub registration: [f64; 2],
    /// How much of the video a fully written area takes away; 1 is black.
    pub gain: f64,
}

/// D/A converters of 1969 (hardware table 3.1).
pub const DAC_BITS: u32 = 10;

impl Default for ScanConverter {
    /// A dual-gun tube of 1969 (hardware table 3.8).
    fn default() -> Self {
        Self { tv_lines: 650, registration: [0.007, 0.007], gain: 1.0 }
    }
}

/// Sigma of the spot over the picture's height, times the limiting resolution (hardware section 6).
const SPOT: f64 = 0.375;

impl Method {
    /// Columns and lines in which outlines are wanted for a picture of `size`.
    pub fn raster(&self, size: [usize; 2]) -> [usize; 2] {
        match self {
            Self::Synchronised { .. } => size,
            Self::ScanConverter(tube) => tube.raster(size),
        }
    }

    /// Which line of [`Self::raster`] stands at the height of `line` of the `lines` of a picture.
    pub(crate) fn raster_line(&self, line: usize, lines: usize) -> usize {
        match self {
            Self::Synchronised { .. } => line,
            Self::ScanConverter(tube) => (2 * line + 1) * tube.tv_lines as usize / (2 * lines),
        }
    }

    /// How dark each pixel of a picture of `size` becomes under gates in [`Self::raster`], one for each point of the sun.
    pub fn shade(&self, suns: &[Gates], half_width: f64, size: [usize; 2]) -> Shade {
        match self {
            Self::Synchronised { dac_bits } => {
                Shade::of(suns, size, |gate| converted(gate, half_width, *dac_bits))
            }
            Self::ScanConverter(tube) => {
                let raster = tube.raster(size);
                let lines = raster[1] as f64;
                let written = Shade::of(suns, raster, |gate| unit(gate, half_width));
                let spot = written.blurred(SPOT * lines / f64::from(tube.tv_lines));
                spot.read(size, tube.registration.map(|offset| offset * lines)).times(tube.gain)
            }
        }
    }
}

impl ScanConverter {
    /// As many lines as the tube resolves; square elements.
    fn raster(&self, [columns, lines]: [usize; 2]) -> [usize; 2] {
        let tube_lines = self.tv_lines as usize;
        [(tube_lines * columns).div_ceil(lines), tube_lines]
    }
}

/// Stretches as shares of the width.
pub(crate) fn unit(gate: &Gate, half_width: f64) -> Vec<[f64; 2]> {
    let share = |x: f64| (0.5 + 0.5 * x / half_width).clamp(0.0, 1.0);
    gate.stretches().iter().map(|stretch| stretch.map(share)).collect()
}

/// The same at the nearest places that the converters have.
pub(crate) fn converted(gate: &Gate, half_width: f64, bits: u32) -> Vec<[f64; 2]> {
    let steps = f64::from(1u32 << bits);
    let nearest = |share: f64| (share * steps).round() / steps;
    unit(gate, half_width).into_iter().map(|stretch| stretch.map(nearest)).collect()
}

impl Shade {
    /// Shares of the elements that lie in the stretches which `place` makes of each gate, the mean over the suns.
    fn of(suns: &[Gates], [columns, lines]: [usize; 2], place: impl Fn(&Gate) -> Vec<[f64; 2]>) -> Self {
        let mut shares = vec![0.0; columns * lines];
        let weight = 1.0 / suns.len() as f64;
        for gates in suns {
            for (line, gate) in shares.chunks_mut(columns).zip(&gates.lines) {
                for stretch in place(gate) {
                    darken(line, stretch.map(|share| share * columns as f64), weight);
                }
            }
        }
        Self { columns, shares }
    }

    /// Shares, line by line from the top.
    pub fn shares(&self) -> &[f64] {
        &self.shares
    }

    /// The same through a Gaussian spot of `sigma` elements.
    fn blurred(&self, sigma: f64) -> Self {
        let reach = (4.0 * sigma).ceil() as usize;
        let weights: Vec<f64> =
            (0..=reach).map(|k| libm::exp(-0.5 * (k * k) as f64 / (sigma * sigma))).collect();
        let whole = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
        let lines = self.shares.len() / self.columns;
        let along =
            self.folded(&weights, whole, |column, line, k| [column.wrapping_add_signed(k), line], lines);
        along.folded(&weights, whole, |column, line, k| [column, line.wrapping_add_signed(k)], lines)
    }

    fn folded(
        &self,
        weights: &[f64],
        whole: f64,
        place: impl Fn(usize, usize, isize) -> [usize; 2],
        lines: usize,
    ) -> Self {
        let reach = weights.len() as isize - 1;
        let at = |index: usize| {
            let [column, line] = [index % self.columns, index / self.columns];
            let term = |k: isize| weights[k.unsigned_abs()] * self.get(place(column, line, k));
            (-reach..=reach).map(term).sum::<f64>() / whole
        };
        Self { columns: self.columns, shares: (0..self.columns * lines).map(at).collect() }
    }

    /// An element; nothing is written beyond the edge.
    fn get(&self, [column, line]: [usize; 2]) -> f64 {
        if column >= self.columns {
            0.0
        } else {
            self.shares.get(line.saturating_mul(self.columns).saturating_add(column)).copied().unwrap_or(0.0)
        }
    }

    /// Read at the middles of the pixels of a picture of `size`, displaced by `offset` elements to the right and down;
    /// linear between middles of elements.
    fn read(&self, [columns, lines]: [usize; 2], offset: [f64; 2]) -> Self {
        let own = [self.columns, self.shares.len() / self.columns];
        let middle = |index: usize, axis: usize, count: usize| {
            (index as f64 + 0.5) * own[axis] as f64 / count as f64 - 0.5 - offset[axis]
        };
        let at = |index: usize| {
            let (x, y) = (middle(index % columns, 0, columns), middle(index / columns, 1, lines));
            let (left, top) = (x.floor(), y.floor());
            let element = |i: f64, j: f64| {
                let is_there = left + i >= 0.0 && top + j >= 0.0;
                if is_there { self.get([(left + i) as usize, (top + j) as usize]) } else { 0.0 }
            };
            let across = |j: f64| element(0.0, j) + (x - left) * (element(1.0, j) - element(0.0, j));
            across(0.0) + (y - top) * (across(1.0) - across(0.0))
        };
        Self { columns, shares: (0..columns * lines).map(at).collect() }
    }

    fn times(mut self, gain: f64) -> Self {
        self.shares.iter_mut().for_each(|share| *share = (*share * gain).clamp(0.0, 1.0));
        self
    }

    /// Video of a picture with the dark taken out, line by line: codes times what is left, not yet codes again.
    pub fn video(&self, picture: &GreyPicture) -> impl Iterator<Item = f64> {
        picture.codes().iter().zip(&self.shares).map(|(code, share)| f64::from(*code) * (1.0 - share))
    }

    /// The same as codes.
    pub fn blank(&self, picture: &GreyPicture) -> Vec<u16> {
        self.video(picture).map(|video| (video + 0.5).floor() as u16).collect()
    }
}

/// Adds `weight` times the share of each element that lies between two places (elements).
fn darken(line: &mut [f64], [from, to]: [f64; 2], weight: f64) {
    let last = line.len();
    for index in (from.floor() as usize)..(to.ceil() as usize).min(last) {
        let overlap = to.min(index as f64 + 1.0) - from.max(index as f64);
        line[index] += weight * overlap.max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::{Method, ScanConverter};
    use crate::gate::{Gate, Gates};

    /// Dark from 1/4 to 0.65 of the width, in lines 2 and 3 of 8.
    fn gates(lines: usize) -> Gates {
        let gate = |line: usize| {
            let mut gate = Gate::default();
            if (lines / 4..lines / 2).contains(&line) {
                gate.add([-0.5, 0.3]);
            }
            (gate, 2)
        };
        Gates::of((0..lines).map(gate).collect())
    }

    #[test]
    fn blanking_between_two_places_darkens_parts_of_pixels() {
        let shade = Method::Synchronised { dac_bits: 20 }.shade(&[gates(8)], 1.0, [10, 8]);
        let line = |line: usize| &shade.shares()[line * 10..][..10];
        assert!(line(1).iter().chain(line(4)).all(|&share| share == 0.0));
        let expected = [0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 0.5, 0.0, 0.0, 0.0];
        for (found, expected) in line(2).iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{:?}", line(2));
        }
    }

    #[test]
    fn converters_round_to_their_places() {
        // Two bits over ten pixels: places 0, 2.5, 5, 7.5.
        let shade = Method::Synchronised { dac_bits: 2 }.shade(&[gates(8)], 1.0, [10, 8]);
        assert_eq!(shade.shares()[20..30], [0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 1.0, 0.5, 0.0, 0.0]);
    }

    #[test]
    fn many_suns_have_the_mean_of_their_shadows() {
        let lit = Gates::of((0..8).map(|_| (Gate::default(), 0)).collect());
        let shade = Method::Synchronised { dac_bits: 20 }.shade(&[gates(8), lit], 1.0, [10, 8]);
        assert!((shade.shares()[24] - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_scan_converter_keeps_the_area_and_moves_it() {
        let tube = |registration| {
            let method = Method::ScanConverter(ScanConverter { tv_lines: 80, registration, gain: 1.0 });
            method.shade(&[gates(80)], 1.0, [80, 80])
        };
        let area = |shade: &super::Shade| shade.shares().iter().sum::<f64>();
        let still = tube([0.0, 0.0]);
        assert!((area(&still) - 20.0 * 32.0).abs() < 1e-9, "{}", area(&still));
        let moved = tube([0.1, -0.05]);
        for (line, column) in [(25, 40), (21, 30), (30, 22)] {
            let [before, after] =
                [still.shares()[line * 80 + column], moved.shares()[(line - 4) * 80 + column + 8]];
            assert!((before - after).abs() < 1e-9, "{line} {column}: {before} {after}");
        }
        // The spot softens the edge: 1 inside, 1/2 on it.
        assert!(still.shares()[30 * 80 + 40] > 0.999);
        let edge = still.shares()[30 * 80 + 20] + still.shares()[30 * 80 + 19];
        assert!((edge - 1.0).abs() < 1e-9 && still.shares()[30 * 80 + 19] > 0.01, "{edge}");
    }

    #[test]
    fn gain_leaves_some_video() {
        let tube = ScanConverter { tv_lines: 80, registration: [0.0; 2], gain: 0.75 };
        let shade = Method::ScanConverter(tube).shade(&[gates(80)], 1.0, [80, 80]);
        let picture = picture::GreyPicture::new(80, 80, picture::Depth::Eight, vec![200; 6400]).unwrap();
        let codes = shade.blank(&picture);
        assert_eq!((codes[0], codes[30 * 80 + 40]), (200, 50));
    }
}
