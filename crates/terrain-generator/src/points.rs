//! Stretches of one or two samples, straight through the array: eight samples side by side.

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Simd, f64x8};
use landscape::CornerWords;
use signal::{LANES, Real, eight, pair, turn_square};

use crate::array::array;
use crate::registers::words_of;
use crate::stretches::{Stretch, Walk};
use crate::sweeps::Sweeps;
use crate::{Registers, TerrainGenerator};

/// Samples that wait for the array, and what it made of those before.
#[derive(Debug, Clone)]
pub(crate) struct Points {
    waiting: Waiting,
    /// Height, slopes along and across (m, m/m) of all samples that came before those that wait.
    values: Vec<[f64; 3]>,
    stretches: Vec<Short>,
}

/// A stretch of one or two samples.
#[derive(Debug, Clone, Copy)]
struct Short {
    lane: usize,
    first: usize,
    samples: usize,
}

/// What the array is fed with at eight samples.
#[derive(Debug, Clone)]
struct Waiting {
    count: usize,
    /// Corners whose words are held, by place and colour; `None` where a register has words of several.
    corners: [Option<[u32; 4]>; LANES],
    /// Words of the places that have no corners.
    mixed: [[CornerWords; 4]; LANES],
    polarity: [[f64; LANES]; 2],
    ramps: [[f64; LANES]; 2],
    direction: [[f64; LANES]; 2],
}

impl Default for Points {
    fn default() -> Self {
        let (pair, mixed) = ([[0.0; LANES]; 2], [[[0.0; 9]; 4]; LANES]);
        let corners = [None; LANES];
        let waiting = Waiting { count: 0, corners, mixed, polarity: pair, ramps: pair, direction: pair };
        Self { waiting, values: Vec::new(), stretches: Vec::new() }
    }
}

impl Points {
    /// A stretch of sweep `lane`, with the words that `walk` holds in it.
    #[inline(always)]
    pub(crate) fn add<L: Simd>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        (lane, walk): (usize, &Walk<'_>),
        stretch: &Stretch,
    ) {
        let samples = stretch.samples.clone();
        self.stretches.push(Short { lane, first: samples.start, samples: samples.len() });
        for sample in samples {
            let ramps = walk.ramps(generator.ranges[sample] / generator.region_size).map(|(value, _)| value);
            self.waiting.add(&walk.registers, generator.buffer, ramps, walk.direction());
            if self.waiting.count == LANES {
                self.work_out(simd, generator);
            }
        }
    }

    #[inline(always)]
    fn work_out<L: Simd>(&mut self, simd: L, generator: &TerrainGenerator<'_>) {
        let values = self.waiting.through_the_array(simd, generator);
        let count = std::mem::take(&mut self.waiting.count);
        self.values.extend((0..count).map(|k| values.map(|signal| signal[k])));
    }

    /// Puts all stretches into `sweeps`, and forgets them.
    #[inline(always)]
    pub(crate) fn finish<L: Simd, S: Real>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        sweeps: &mut Sweeps<S>,
    ) {
        self.work_out(simd, generator);
        let mut values = self.values.as_slice();
        for Short { lane, first, samples } in self.stretches.drain(..) {
            let (of_stretch, rest) = values.split_at(samples);
            values = rest;
            let mut put = |sample: usize, values: [S; 3]| {
                sweeps
                    .of_sweep(lane)
                    .into_iter()
                    .zip(values)
                    .for_each(|(signal, value)| signal[sample] = value);
            };
            match of_stretch {
                [near, far] => {
                    let line =
                        Line::through([near, far], &generator.ranges[first..first + 2], generator.datum);
                    (first..first + 2)
                        .for_each(|sample| put(sample, line.at(S::from_f64(generator.ranges[sample]))));
                }
                // A polynomial has no -0.
                of_one => of_one.iter().for_each(|&[height, along, across]| {
                    let values = [height - generator.datum, along, across];
                    put(first, values.map(|value| S::ZERO + S::from_f64(value)));
                }),
            }
        }
        self.values.clear();
    }
}

impl Waiting {
    #[inline(always)]
    fn add(&mut self, registers: &Registers, buffer: &[CornerWords], ramps: [f64; 2], direction: [f64; 2]) {
        let (place, polarity) = (self.count, registers.polarity());
        self.corners[place] = registers.corners_held();
        if self.corners[place].is_none() {
            self.mixed[place] = registers.hold(buffer).map(|words| *words);
        }
        for axis in 0..2 {
            self.polarity[axis][place] = polarity[axis];
            self.ramps[axis][place] = ramps[axis];
            self.direction[axis][place] = direction[axis];
        }
        self.count += 1;
    }

    /// Words of a place and colour.
    #[inline(always)]
    fn words<'w>(&'w self, buffer: &'w [CornerWords], place: usize, colour: usize) -> &'w CornerWords {
        match self.corners[place] {
            Some(corners) => words_of(corners[colour], buffer),
            None => &self.mixed[place][colour],
        }
    }

    /// Height, slopes along and across of all eight.
    #[inline(always)]
    fn through_the_array<L: Simd>(&self, simd: L, generator: &TerrainGenerator<'_>) -> [[f64; LANES]; 3] {
        let size = generator.region_size;
        let mut hold = [[f64x8::simd_from(simd, 0.0); 9]; 4];
        for (colour, words) in hold.iter_mut().enumerate() {
            let (square, last) = words.split_at_mut(LANES);
            let mut lasts = [0.0; LANES];
            for place in 0..LANES {
                let (first, rest) = self.words(generator.buffer, place, colour).split_at(LANES);
                (square[place], lasts[place]) = (f64x8::from_slice(simd, first), rest[0]);
            }
            turn_square(square.try_into().expect("eight of nine"));
            last[0] = eight(simd, &lasts);
        }
        let (polarity, ramps) = (pair(simd, &self.polarity), pair(simd, &self.ramps));
        let [height, hu, hv] = array([&hold[0], &hold[1], &hold[2], &hold[3]], polarity, ramps);
        let [cos, sin] = pair(simd, &self.direction);
        let (along, across) = ((hu * cos + hv * sin) / size, (hv * cos - hu * sin) / size);
        [height.to_array(), along.to_array(), across.to_array()]
    }
}

/// Height and slopes as straight lines in s, -1 and 1 at two samples.
struct Line<S> {
    lines: [[S; 2]; 3],
    middle: S,
    inverse_half: S,
}

impl<S: Real> Line<S> {
    fn through([first, last]: [&[f64; 3]; 2], ranges: &[f64], datum: f64) -> Self {
        let (near, far) = (ranges[0], ranges[1]);
        let mut lines: [[f64; 2]; 3] = std::array::from_fn(|signal| {
            [0.5 * (first[signal] + last[signal]), 0.5 * (last[signal] - first[signal])]
        });
        lines[0][0] -= datum;
        Self {
            lines: lines.map(|line| line.map(S::from_f64)),
            middle: S::from_f64(0.5 * (near + far)),
            inverse_half: S::from_f64(1.0 / (0.5 * (far - near))),
        }
    }

    fn at(&self, range: S) -> [S; 3] {
        let s = (range - self.middle) * self.inverse_half;
        self.lines.map(|[middle, slope]| (S::ZERO * s + slope) * s + middle)
    }
}
