//! Texture generator (report III.C.7; section 13): small detail against ground range.
//!
//! ```text
//! sweep.x, sweep.y ─▶ lattice numbers ─▶ store | hash ─▶ join in the cell ─▶ × fading ramp ─▶ + ─▶ txg.texture
//!                                                         (once a layer)      ▲ ground range
//! ```
//!
//! **Law.** [`landscape::Texture`]: each layer adds `amplitude (1 - range / reach) pattern(x, y)` up to its reach. The
//! mixing unit adds the sum to reflectivity; that is before projection, so perspective and occlusion treat it as ground.
//! **Parameters.** Layers: cell (m), amplitude (reflectivity), reach (m); the source: one stored region read through the
//! folded ramps (variant 1), or a routine of the lattice numbers and a seed (variant 2).
//! **State and timing.** None: a sample depends on its place and range alone, so the pattern stands still on the ground
//! whatever the path. It is as fast as the sweep clock; a shift register of the time runs at 5 to 20 MHz.
//! **Precision.** Place and lattice number are f64, so that a cell of centimetres keeps its edge 10 km from the origin;
//! the signal is of the run's scalar. In f64 it equals [`landscape::Texture::at`] to the bit, in f32 to 3e-7 of the
//! amplitude a layer.
//! **Elaboration.** Nothing is computed beyond the reach of the farthest layer; a layer ends at its own reach. In preview only
//! samples that are seen. Without texture the block is not there.
//! **Craters.** [`scale`]: the grain is as coarse in craters as their type's parameter says (fg.grain of the feature generator).
//! **Parts.** [`PartsTexture`]: bits of the D/A converter, filter.
//! **Our choices.** Layers of several grains; smooth-step between lattice values; zero mean over a region; a mirrored
//! pattern as the reading of "symmetric along its edges"; the whole clipped by the mixing unit (section 22, rows 29, 30).

mod gain;
mod of_parts;

pub use gain::scale;
pub use of_parts::PartsTexture;

use std::ops::Range;

use fearless_simd::prelude::{ExtractToken, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch, f64x8};
use landscape::{Lattice, MOST_LAYERS, Texture};
use signal::{Double, LANES, Lanes, Real, Signal, Unit, eight};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[Signal::ground(
    "txg.texture",
    Unit::Reflectivity,
    "what texture adds to reflectivity; none beyond its reach",
    "fig. 28",
)];

/// The block, set for one stage.
#[derive(Debug, Clone, Copy)]
pub struct TextureGenerator<'a> {
    /// Texture that the block makes.
    pub texture: &'a Texture,
    /// Ground range of each sample (m), ascending.
    pub ranges: &'a [f64],
}

impl TextureGenerator<'_> {
    /// Texture along the sweeps of a group that leave `eye` (north, east, m) in `directions` (cosine, sine of azimuth
    /// against north). Returns the number of samples that have any; `out` then holds exactly these, of which those outside
    /// `runs` are 0.
    pub fn run<S: Real>(
        &self,
        eye: [f64; 2],
        directions: &[[f64; 2]; LANES],
        runs: &[Range<usize>],
        out: &mut Vec<Lanes<S>>,
    ) -> usize {
        let reach = self.texture.reach();
        let samples = self.ranges.partition_point(|&range| range < reach);
        out.clear();
        out.resize(samples, Lanes::default());
        dispatch!(Level::new(), simd => self.fill(simd, eye, directions, runs, out));
        samples
    }

    /// Two samples at a time: the last of an odd number stands beside itself.
    #[inline(always)]
    fn fill<L: Simd, S: Real>(
        &self,
        simd: L,
        eye: [f64; 2],
        directions: &[[f64; 2]; LANES],
        runs: &[Range<usize>],
        out: &mut [Lanes<S>],
    ) {
        let sweeps = Sweeps::new(simd, [eye, self.texture.origin()], directions);
        let fading = Fading::new(simd, self.texture);
        let samples = out.len();
        for run in runs.iter().filter(|run| run.start < samples) {
            let run = run.start..run.end.min(samples);
            let (ranges, out) = (&self.ranges[run.clone()], &mut out[run]);
            for (ranges, out) in ranges.chunks(2).zip(out.chunks_mut(2)) {
                let sum = self.sum::<L, S>(&sweeps, &fading, [ranges[0], ranges[ranges.len() - 1]]);
                for (out, sum) in out.iter_mut().zip(sum.halves()) {
                    sum.store_slice(&mut out.0);
                }
            }
        }
    }

    /// All layers at two samples; one that ends between them has an amplitude of 0 at the farther.
    #[inline(always)]
    fn sum<L: Simd, S: Real>(
        &self,
        sweeps: &Sweeps<L>,
        fading: &Fading<L>,
        [near, far]: [f64; 2],
    ) -> S::Double<L> {
        let simd = sweeps.north.token();
        let (places, amplitudes) = ([sweeps.at(near), sweeps.at(far)], [fading.at(near), fading.at(far)]);
        let mut sum = S::Double::splat(simd, S::ZERO);
        for (layer, grain) in self.texture.grains().iter().enumerate() {
            if near < grain.layer().range {
                let amplitude =
                    |at: usize| S::Vector::<L>::simd_from(simd, S::from_f64(amplitudes[at][layer]));
                let amplitude = S::Double::of(amplitude(0), amplitude(1));
                sum = sum + amplitude * pattern::<L, S>(grain.lattice(), places);
            }
        }
        sum
    }
}

/// The pattern of a layer at the places of two samples.
#[inline(always)]
fn pattern<L: Simd, S: Real>(lattice: &Lattice, places: [[f64x8<L>; 2]; 2]) -> S::Double<L> {
    match lattice {
        Lattice::Stored(lattice) => {
            S::Double::of(lattice.eight::<L, S>(places[0]), lattice.eight::<L, S>(places[1]))
        }
        Lattice::Hashed(lattice) => lattice.sixteen::<L, S>(places),
    }
}

/// Layers of a texture as lanes: how they fade with range.
struct Fading<L: Simd> {
    /// Amplitudes at range 0; 0 where there is no layer.
    amplitude: f64x8<L>,
    /// Ranges at which the layers have faded (m).
    range: f64x8<L>,
}

const _: () = assert!(MOST_LAYERS <= LANES);

impl<L: Simd> Fading<L> {
    #[inline(always)]
    fn new(simd: L, texture: &Texture) -> Self {
        let (mut amplitude, mut range) = ([0.0; LANES], [1.0; LANES]);
        for (layer, grain) in texture.grains().iter().enumerate() {
            (amplitude[layer], range[layer]) = (grain.layer().amplitude, grain.layer().range);
        }
        Self { amplitude: eight(simd, &amplitude), range: eight(simd, &range) }
    }

    /// [`Layer::amplitude_at`](landscape::Layer::amplitude_at) of all layers.
    #[inline(always)]
    fn at(&self, range: f64) -> [f64; LANES] {
        let simd = self.range.token();
        let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
        let left = one - f64x8::splat(simd, range) / self.range;
        (self.amplitude * left.max(zero)).to_array()
    }
}

/// Straight ways over the ground, side by side.
struct Sweeps<L: Simd> {
    eye: [f64; 2],
    origin: [f64; 2],
    north: f64x8<L>,
    east: f64x8<L>,
}

impl<L: Simd> Sweeps<L> {
    #[inline(always)]
    fn new(simd: L, [eye, origin]: [[f64; 2]; 2], directions: &[[f64; 2]; LANES]) -> Self {
        let part = |axis: usize| eight(simd, &directions.map(|direction| direction[axis]));
        Self { eye, origin, north: part(0), east: part(1) }
    }

    /// Places of the sweeps at a range (m), from the origin of the texture.
    #[inline(always)]
    fn at(&self, range: f64) -> [f64x8<L>; 2] {
        let [north, east] = [self.eye[0] + self.north * range, self.eye[1] + self.east * range];
        [north - self.origin[0], east - self.origin[1]]
    }
}

#[cfg(test)]
mod tests {
    use std::slice::from_ref;

    use super::TextureGenerator;
    use landscape::{Layer, Source, Texture};
    use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
    use signal::{LANES, Lanes};

    fn texture(source: Source, seed: u64) -> Texture {
        let layers = [
            Layer { cell: 3.7, amplitude: 0.1, range: 150.0 },
            Layer { cell: 0.11, amplitude: 0.2, range: 30.0 },
        ];
        Texture::new(&layers, source, seed, 22.0, [-1000.0, 500.0]).unwrap()
    }

    proptest! {
        #[test]
        fn the_sweep_reads_the_pattern_of_the_ground(
            stored in any::<bool>(), seed in any::<u64>(), eye in proptest::array::uniform2(-2e4..2e4f64),
            azimuth in 0.0..6.3f64,
        ) {
            let texture = texture(if stored { Source::Pattern } else { Source::Random }, seed);
            let ranges: Vec<f64> = (1..60).map(|k| 0.07 * f64::from(k * k)).collect();
            let generator = TextureGenerator { texture: &texture, ranges: &ranges };
            let directions: [[f64; 2]; LANES] = std::array::from_fn(|lane| {
                let azimuth = azimuth + 0.02 * lane as f64;
                [libm::cos(azimuth), libm::sin(azimuth)]
            });
            let (mut wide, mut narrow): (Vec<Lanes<f64>>, Vec<Lanes<f32>>) = (vec![Lanes::splat(9.0); 99], Vec::new());
            let all = 0..ranges.len();
            let samples = generator.run(eye, &directions, from_ref(&all), &mut wide);
            prop_assert_eq!(samples, ranges.iter().filter(|&&range| range < 150.0).count());
            prop_assert_eq!(generator.run(eye, &directions, from_ref(&all), &mut narrow), samples);
            prop_assert_eq!([wide.len(), narrow.len()], [samples; 2]);
            for sample in 0..samples {
                for lane in 0..LANES {
                    let place: [f64; 2] = std::array::from_fn(|k| eye[k] + directions[lane][k] * ranges[sample]);
                    let expected = texture.at(place[0], place[1], ranges[sample]);
                    prop_assert_eq!(wide[sample][lane], expected);
                    prop_assert!((f64::from(narrow[sample][lane]) - expected).abs() < 3e-7 * 0.3);
                }
            }
        }
    }

    #[test]
    fn nothing_is_computed_beyond_the_reach() {
        let texture = texture(Source::Random, 1);
        let generator = TextureGenerator { texture: &texture, ranges: &[150.0, 200.0] };
        let mut out = vec![Lanes::splat(1.0f32)];
        assert_eq!(generator.run([0.0; 2], &[[1.0, 0.0]; LANES], from_ref(&(0..2)), &mut out), 0);
        assert!(out.is_empty());
    }

    #[test]
    fn what_is_not_asked_for_is_not_computed() {
        for source in [Source::Pattern, Source::Random] {
            let texture = texture(source, 7);
            // The near layer ends within the second run, the far one within the fourth.
            let ranges: Vec<f64> = (1..=60).map(|k| 3.0 * f64::from(k)).collect();
            let runs = [0..2, 5..20, 20..21, 40..55, 57..60];
            let generator = TextureGenerator { texture: &texture, ranges: &ranges };
            let directions = std::array::from_fn(|lane| [1.0, 0.1 * lane as f64]);
            let (mut all, mut some): (Vec<Lanes<f64>>, Vec<Lanes<f64>>) =
                (Vec::new(), vec![Lanes::splat(9.0); 5]);
            let samples = generator.run([4.0, -2.0], &directions, from_ref(&(0..60)), &mut all);
            assert_eq!(generator.run([4.0, -2.0], &directions, &runs, &mut some), samples);
            assert_eq!((samples, some.len()), (49, 49));
            for sample in 0..samples {
                let is_asked_for = runs.iter().any(|run| run.contains(&sample));
                assert_eq!(
                    some[sample],
                    if is_asked_for { all[sample] } else { Lanes::default() },
                    "{sample}"
                );
                assert_ne!(all[sample], Lanes::default());
            }
        }
    }
}
