//! Stretches of one or two samples, straight through the array: eight stretches side by side.

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Simd, f64x8};
use landscape::CornerWords;
use signal::{LANES, Real, eight, pair, turn_square};

use crate::array::array;
use crate::registers::words_of;
use crate::stretches::{Stretch, Walk};
use crate::{Profile, Registers, TerrainGenerator};

/// Stretches that wait for the array, by their samples: the words of two samples are brought once.
#[derive(Debug, Clone, Default)]
pub(crate) struct Points {
    ones: Waiting<1>,
    twos: Waiting<2>,
    /// First sample that is not wanted.
    end: usize,
}

/// Up to eight stretches of `N` samples, and what the array is fed with there.
#[derive(Debug, Clone)]
struct Waiting<const N: usize> {
    count: usize,
    lanes: [usize; LANES],
    /// First sample of each stretch.
    firsts: [usize; LANES],
    /// Corners whose words are held, by place and colour; `None` where a register has words of several.
    corners: [Option<[u32; 4]>; LANES],
    /// Words of the places that have no corners.
    mixed: [[CornerWords; 4]; LANES],
    polarity: [[f64; LANES]; 2],
    direction: [[f64; LANES]; 2],
    ramps: [[[f64; LANES]; 2]; N],
    /// Ground ranges of the samples (m).
    ranges: [[f64; LANES]; N],
}

/// Height, slopes along and across (m, m/m) of eight samples.
type HeightAndSlopes<T> = [T; 3];

impl<const N: usize> Default for Waiting<N> {
    fn default() -> Self {
        let eight = [0.0; LANES];
        Self {
            count: 0,
            lanes: [0; LANES],
            firsts: [0; LANES],
            corners: [None; LANES],
            mixed: [[[0.0; 9]; 4]; LANES],
            polarity: [eight; 2],
            direction: [eight; 2],
            ramps: [[eight; 2]; N],
            ranges: [eight; N],
        }
    }
}

impl Points {
    /// Begins a group of which samples from `end` on are not wanted.
    pub(crate) fn begin(&mut self, end: usize) {
        self.end = end;
    }

    /// A stretch of sweep `lane`, with the words that `walk` holds in it.
    #[inline(always)]
    pub(crate) fn add<L: Simd, S: Real>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        (lane, walk): (usize, &Walk<'_>),
        stretch: &Stretch,
        profile: &mut Profile<S>,
    ) {
        let first = stretch.samples.start;
        if stretch.samples.len() == 1 {
            self.ones.add(generator, (lane, walk), first);
            if self.ones.count == LANES {
                self.ones.work_out(simd, generator, self.end, profile);
            }
        } else {
            self.twos.add(generator, (lane, walk), first);
            if self.twos.count == LANES {
                self.twos.work_out(simd, generator, self.end, profile);
            }
        }
    }

    /// Puts all that wait into `profile`.
    #[inline(always)]
    pub(crate) fn work_out<L: Simd, S: Real>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        profile: &mut Profile<S>,
    ) {
        if self.ones.count > 0 {
            self.ones.work_out(simd, generator, self.end, profile);
        }
        if self.twos.count > 0 {
            self.twos.work_out(simd, generator, self.end, profile);
        }
    }
}

impl Waiting<1> {
    #[inline(always)]
    fn work_out<L: Simd, S: Real>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        end: usize,
        profile: &mut Profile<S>,
    ) {
        let [[height, along, across]] = self.through_the_array(simd, generator);
        // A polynomial has no -0.
        let zero = S::Vector::<L>::simd_from(simd, S::ZERO);
        let ground =
            [zero + S::narrow(height - generator.datum), zero + S::narrow(along), zero + S::narrow(across)];
        self.put([ground], end, profile);
    }
}

impl Waiting<2> {
    #[inline(always)]
    fn work_out<L: Simd, S: Real>(
        &mut self,
        simd: L,
        generator: &TerrainGenerator<'_>,
        end: usize,
        profile: &mut Profile<S>,
    ) {
        let [near, far] = pair(simd, &self.ranges);
        let [first, last] = self.through_the_array(simd, generator);
        let zero = S::Vector::<L>::simd_from(simd, S::ZERO);
        let middle = S::narrow(0.5 * (near + far));
        let inverse_half = S::narrow(1.0 / (0.5 * (far - near)));
        let places = [(S::narrow(near) - middle) * inverse_half, (S::narrow(far) - middle) * inverse_half];
        // Straight lines in s, -1 and 1 at the samples, as a polynomial has them.
        let mut ground = [[zero; 3]; 2];
        for signal in 0..3 {
            let datum = if signal == 0 { generator.datum } else { 0.0 };
            let level = S::narrow(0.5 * (first[signal] + last[signal]) - datum);
            let slope = S::narrow(0.5 * (last[signal] - first[signal]));
            for n in 0..2 {
                ground[n][signal] = (zero * places[n] + slope) * places[n] + level;
            }
        }
        self.put(ground, end, profile);
    }
}

impl<const N: usize> Waiting<N> {
    #[inline(always)]
    fn add(&mut self, generator: &TerrainGenerator<'_>, (lane, walk): (usize, &Walk<'_>), first: usize) {
        let (place, registers): (usize, &Registers) = (self.count, &walk.registers);
        (self.lanes[place], self.firsts[place]) = (lane, first);
        self.corners[place] = registers.corners_held();
        if self.corners[place].is_none() {
            self.mixed[place] = registers.hold(generator.buffer).map(|words| *words);
        }
        let (polarity, direction) = (registers.polarity(), walk.direction());
        for axis in 0..2 {
            self.polarity[axis][place] = polarity[axis];
            self.direction[axis][place] = direction[axis];
        }
        for n in 0..N {
            let range = generator.ranges[first + n];
            let ramps = walk.ramps(range / generator.region_size);
            self.ranges[n][place] = range;
            for axis in 0..2 {
                self.ramps[n][axis][place] = ramps[axis].0;
            }
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

    /// Height and slopes of all eight, sample by sample.
    #[inline(always)]
    fn through_the_array<L: Simd>(
        &self,
        simd: L,
        generator: &TerrainGenerator<'_>,
    ) -> [HeightAndSlopes<f64x8<L>>; N] {
        let (size, zero) = (generator.region_size, f64x8::simd_from(simd, 0.0));
        let mut hold = [[zero; 9]; 4];
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
        let (polarity, [cos, sin]) = (pair(simd, &self.polarity), pair(simd, &self.direction));
        let mut ground = [[zero; 3]; N];
        for n in 0..N {
            let ramps = pair(simd, &self.ramps[n]);
            let [height, hu, hv] = array([&hold[0], &hold[1], &hold[2], &hold[3]], polarity, ramps);
            ground[n] = [height, (hu * cos + hv * sin) / size, (hv * cos - hu * sin) / size];
        }
        ground
    }

    /// Puts the samples before `end` into `profile`, and forgets all.
    #[inline(always)]
    fn put<L: Simd, S: Real>(
        &mut self,
        ground: [HeightAndSlopes<S::Vector<L>>; N],
        end: usize,
        profile: &mut Profile<S>,
    ) {
        let mut values = [[[S::ZERO; LANES]; 3]; N];
        for n in 0..N {
            for signal in 0..3 {
                ground[n][signal].store_slice(&mut values[n][signal]);
            }
        }
        for place in 0..std::mem::take(&mut self.count) {
            let (lane, first) = (self.lanes[place], self.firsts[place]);
            let wanted = values.iter().enumerate().take(end - first);
            for (n, [height, along, across]) in wanted {
                profile.height[first + n].0[lane] = height[place];
                profile.along[first + n].0[lane] = along[place];
                profile.across[first + n].0[lane] = across[place];
            }
        }
    }
}
