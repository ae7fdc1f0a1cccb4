//! Noise by address: a sample of it is a function of seed, part, sweep and sample, and of nothing before it.
//!
//! **Law.** [`NoiseSource`]: normal deviates (Box and Muller) of a hash of the address; two neighbouring samples share
//! one hash. White noise of one deviate a sample has the band `1 / (2 h)`. [`BandNoise`] bounds it by a lag:
//! `x1 = k x0 + sigma sqrt(1 - k^2) n`, `k = e^(-h / tau)`, which has the deviation sigma at every sample and the
//! correlation of a lag between them.
//! **Parameters.** sigma in shares of full scale, tau in seconds.
//! **State and timing.** Band noise: one value, begun at `sigma n` in every sweep, so a sweep needs none before it.
//! **Our choices.** 32 bits each for radius and angle: no deviate beyond [`NoiseSource::LARGEST`]. Logarithm, sine
//! and cosine are series of our own, which many deviates at once ([`GroupNoise`], [`NoiseSource::fill`]) take side by side.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2, PI};

use fearless_simd::{Level, dispatch};
use quantities::{hash_on, hash_words};
use signal::{LANES, Real};

use crate::Wire;
use crate::whole::WHOLE;

/// Deviates of one part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoiseSource {
    seed: u64,
    part: u64,
}

impl NoiseSource {
    /// No deviate is larger: `sqrt(2 ln 2^33)`.
    pub const LARGEST: f64 = 6.77;

    /// The source of the part called `part`, number `index` of its kind.
    pub fn new(seed: u64, part: &str, index: u64) -> Self {
        Self { seed, part: hash_words(part_key(part), &[index]) }
    }

    /// The standard normal deviate of `sample` of `sweep` (counted over all frames).
    pub fn normal(&self, sweep: u64, sample: u64) -> f64 {
        self.pair(sweep, sample / 2)[(sample % 2) as usize]
    }

    /// No deviate of this address is larger, without working it out: the radius by its power of two.
    pub fn most(&self, sweep: u64, sample: u64) -> f64 {
        bound(hash_words(self.seed, &[self.part, sweep, sample / 2]))
    }

    /// [`NoiseSource::most`] of samples 0, 1, 2 ... of `sweep`.
    pub fn fill_most(&self, sweep: u64, samples: &mut [f64]) {
        let prefix = hash_words(self.seed, &[self.part, sweep]);
        dispatch!(Level::new(), _ => fill_bounds(prefix, samples));
    }

    /// The deviates of samples 0, 1, 2 ... of `sweep`: to the bit those of [`NoiseSource::normal`].
    pub fn fill<S: Real>(&self, sweep: u64, samples: &mut [S]) {
        let prefix = hash_words(self.seed, &[self.part, sweep]);
        for (first, out) in (0..).step_by(LANES).zip(samples.chunks_mut(2 * LANES)) {
            let [even, odd] = side_by_side(|pair| hash_on(prefix, first + pair as u64));
            for (pair, out) in out.chunks_mut(2).enumerate() {
                out.iter_mut().zip([even[pair], odd[pair]]).for_each(|(out, n)| *out = S::from_f64(n));
            }
        }
    }

    fn pair(&self, sweep: u64, pair: u64) -> [f64; 2] {
        deviates(hash_words(self.seed, &[self.part, sweep, pair]))
    }

    /// The source for the group of sweeps that begins at `first`.
    pub fn of_group(&self, first: u64) -> GroupNoise {
        self.of_sweeps(&std::array::from_fn(|lane| first + lane as u64))
    }

    /// The source for the sweeps of a group.
    pub fn of_sweeps(&self, sweeps: &[u64; LANES]) -> GroupNoise {
        GroupNoise { sweeps: sweeps.map(|sweep| hash_words(self.seed, &[self.part, sweep])) }
    }
}

/// Deviates of one part for a group of sweeps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct GroupNoise {
    /// Hash of all but the sample.
    sweeps: [u64; LANES],
}

impl GroupNoise {
    /// The deviates of samples `2 pair` and `2 pair + 1`: to the bit those of [`NoiseSource::normal`].
    #[inline(always)]
    pub fn pair(&self, pair: u64) -> [[f64; LANES]; 2] {
        side_by_side(|lane| hash_on(self.sweeps[lane], pair))
    }

    /// Bounds of the deviates of `sample`, without working them out: each deviate lies between 0 and its bound.
    #[inline(always)]
    pub fn bounds(&self, sample: u64) -> [f64; LANES] {
        let (pair, turn) = (sample / 2, (sample % 2) << 30);
        let mut bounds = [0.0; LANES];
        for lane in 0..LANES {
            let word = hash_on(self.sweeps[lane], pair);
            // A sine is the cosine of a quarter less.
            bounds[lane] = bound(word) * cos_bound(word.wrapping_sub(turn));
        }
        bounds
    }
}

/// Both deviates of some hashes.
#[inline(always)]
fn side_by_side(hash: impl Fn(usize) -> u64) -> [[f64; LANES]; 2] {
    let mut words = [0; LANES];
    for (lane, word) in words.iter_mut().enumerate() {
        *word = hash(lane);
    }
    let mut out = [[0.0; LANES]; 2];
    for lane in 0..LANES {
        [out[0][lane], out[1][lane]] = deviates(words[lane]);
    }
    out
}

/// The bounds of samples whose hash begins with `prefix`.
#[inline(always)]
fn fill_bounds(prefix: u64, samples: &mut [f64]) {
    for (first, out) in (0..).step_by(LANES).zip(samples.chunks_mut(2 * LANES)) {
        let mut bounds = [0.0; 2 * LANES];
        for pair in 0..LANES {
            let bound = bound(hash_on(prefix, first + pair as u64));
            (bounds[2 * pair], bounds[2 * pair + 1]) = (bound, bound);
        }
        out.copy_from_slice(&bounds[..out.len()]);
    }
}

/// The largest size of the deviates of a hash by the power of two of `2 n + 1`, n its 32 bits of radius.
#[inline(always)]
fn bound(word: u64) -> f64 {
    let power = (2.0 * number(word >> 32) + 1.0).to_bits() >> 52;
    // Of a radius of 2^-33 times that. Rounding of logarithm and root is far below the last factor.
    (2.0 * LN_2 * number(1023 + 33 - power)).sqrt() * (1.0 + 1e-9)
}

/// The end of a cosine's range away from 0, by the eighth of the circle in which the angle of a hash lies.
#[inline(always)]
fn cos_bound(word: u64) -> f64 {
    let eighth = word >> 29;
    let size = if (eighth + 1) & 2 == 2 { FRAC_1_SQRT_2 } else { 1.0 };
    if (eighth + 2) & 4 == 4 { -size } else { size }
}

/// Two deviates from 32 bits of radius and 32 of angle, without a branch or a table: lanes go side by side.
#[inline(always)]
fn deviates(word: u64) -> [f64; 2] {
    // The radius is of `(2 n + 1) / 2^33`, which is never 0.
    let radius = (-2.0 * (ln(2.0 * number(word >> 32) + 1.0) - 33.0 * LN_2)).sqrt();
    let [sin, cos] = sin_cos(word & 0xffff_ffff);
    [radius * cos, radius * sin]
}

/// A whole number below 2^32.
#[inline(always)]
fn number(bits: u64) -> f64 {
    f64::from_bits(WHOLE.to_bits() | bits) - WHOLE
}

/// Natural logarithm of `x`, 1 or more: of the power of two nearest in ratio, and `2 artanh s`, `s = (m - 1) / (m + 1)`,
/// of the rest m, root 1/2 to root 2. Good to 1e-15 of a unit.
#[inline(always)]
fn ln(x: f64) -> f64 {
    let above = x.to_bits() - FRAC_1_SQRT_2.to_bits();
    let power = above >> 52;
    let m = f64::from_bits(x.to_bits() - (power << 52));
    let s = (m - 1.0) / (m + 1.0);
    number(power) * LN_2 + 2.0 * s * polynomial(s * s, &ARTANH)
}

/// Sine and cosine of the angle `2 pi (bits + 1/2) / 2^32`, `bits` below 2^32: turned by quarters to within an eighth of
/// the circle, and their series there. Good to 1e-13.
#[inline(always)]
fn sin_cos(bits: u64) -> [f64; 2] {
    let quarter = (bits + (1 << 29)) >> 30;
    let off =
        number(bits) - number(quarter << 30 & 0xffff_ffff) - if quarter == 4 { 4_294_967_296.0 } else { 0.0 };
    let x = (off + 0.5) * (PI / 2_147_483_648.0);
    let square = x * x;
    let (sin, cos) = (x * polynomial(square, &SINE), polynomial(square, &COSINE));
    let (sin, cos) = if quarter & 1 == 1 { (cos, -sin) } else { (sin, cos) };
    if quarter & 2 == 2 { [-sin, -cos] } else { [sin, cos] }
}

/// Returns a polynomial at `x`, its coefficients in ascending powers.
#[inline(always)]
fn polynomial<const N: usize>(x: f64, powers: &[f64; N]) -> f64 {
    let mut sum = powers[N - 1];
    for &power in powers[..N - 1].iter().rev() {
        sum = sum * x + power;
    }
    sum
}

/// `artanh s / s` by `s^2`, of s up to 0.172.
const ARTANH: [f64; 9] =
    [1.0, 1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0];

/// `sin x / x` and `cos x` by `x^2`, of x up to pi / 4.
const SINE: [f64; 7] = [
    1.0,
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
];
const COSINE: [f64; 8] = [
    1.0,
    -1.0 / 2.0,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
];

/// Noise with the band of a lag, for one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandNoise<S> {
    keep: S,
    kick: S,
    sigma: S,
}

impl<S: Real> BandNoise<S> {
    /// Deviation `sigma` (share of full scale) within the band of the lag `tau`; `h` and `tau` in seconds.
    pub fn new(h: f64, tau: f64, sigma: f64) -> Self {
        let ratio = h / tau;
        let kick = sigma * (-libm::expm1(-2.0 * ratio)).sqrt();
        let s = S::from_f64;
        Self { keep: s(libm::exp(-ratio)), kick: s(kick), sigma: s(sigma) }
    }

    /// Its value at the first sample of a sweep, from a deviate.
    #[inline(always)]
    pub fn begin<V: Wire<S>>(&self, deviate: V) -> V {
        deviate * self.sigma
    }

    /// Its value a step after `x`, from a new deviate.
    #[inline(always)]
    pub fn step<V: Wire<S>>(&self, x: V, deviate: V) -> V {
        x * self.keep + deviate * self.kick
    }
}

/// A number for a name: the same for ever.
pub fn part_key(name: &str) -> u64 {
    let words: Vec<u64> = name.as_bytes().chunks(8).map(word).collect();
    hash_words(name.len() as u64, &words)
}

fn word(bytes: &[u8]) -> u64 {
    bytes.iter().rev().fold(0, |word, &byte| word << 8 | u64::from(byte))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use quantities::unit_interval;
    use signal::LANES;

    use super::{BandNoise, NoiseSource, ln, part_key, sin_cos};

    fn moments(values: &[f64]) -> [f64; 3] {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let power = |p: i32| values.iter().map(|v| (0..p).fold(1.0, |x, _| x * (v - mean))).sum::<f64>() / n;
        [mean, power(2), power(4)]
    }

    fn deviates(count: usize) -> Vec<f64> {
        let mut values = vec![0.0; count];
        NoiseSource::new(7, "mul", 3).fill(11, &mut values);
        values
    }

    #[test]
    fn the_series_are_logarithm_sine_and_cosine() {
        let edges =
            [0, 1, (1 << 29) - 1, 1 << 29, 1 << 30, 3 << 29, (1 << 31) - 1, 1 << 31, 7 << 29, (1 << 32) - 1];
        let drawn = (0..20_000_u64).map(|n| (unit_interval(3, &[n]) * 4_294_967_296.0) as u64);
        for bits in edges.into_iter().chain(drawn) {
            let (sin, cos) = libm::sincos(2.0 * PI * (bits as f64 + 0.5) / 4_294_967_296.0);
            let [own_sin, own_cos] = sin_cos(bits);
            assert!((own_sin - sin).abs() < 1e-13 && (own_cos - cos).abs() < 1e-13, "{bits}");
            let x = 2.0 * bits as f64 + 1.0;
            assert!((ln(x) - libm::log(x)).abs() < 1e-14, "{x}");
        }
    }

    #[test]
    fn a_group_has_the_deviates_of_its_sweeps() {
        let source = NoiseSource::new(1970, "tg.noise", 2);
        let group = source.of_group(40);
        for pair in 0..200 {
            for (odd, deviates) in group.pair(pair).into_iter().enumerate() {
                let right: [f64; LANES] =
                    std::array::from_fn(|lane| source.normal(40 + lane as u64, 2 * pair + odd as u64));
                assert_eq!(deviates, right);
            }
        }
    }

    #[test]
    fn bounds_of_a_group_have_the_sign_of_its_deviates() {
        let source = NoiseSource::new(1970, "comparator", 2);
        let group = source.of_group(40);
        let mut slack = 0.0;
        for sample in 0..4000 {
            for (lane, bound) in group.bounds(sample).into_iter().enumerate() {
                let deviate = source.normal(40 + lane as u64, sample);
                assert!(deviate * bound >= 0.0 && deviate.abs() <= bound.abs(), "{deviate}, {bound}");
                slack += bound.abs() - deviate.abs();
            }
        }
        assert!(slack / 32_000.0 < 0.6, "{slack}");
    }

    #[test]
    fn deviates_are_normal() {
        let [mean, variance, fourth] = moments(&deviates(200_000));
        assert!(mean.abs() < 0.01 && (variance - 1.0).abs() < 0.015 && (fourth - 3.0).abs() < 0.12);
        let beyond = deviates(200_000).iter().filter(|v| v.abs() > 2.0).count() as f64 / 200_000.0;
        assert!((beyond - 0.0455).abs() < 0.002, "{beyond}");
    }

    #[test]
    fn a_deviate_is_its_address() {
        let source = NoiseSource::new(7, "mul", 3);
        for (i, value) in deviates(1001).iter().enumerate() {
            assert_eq!(source.normal(11, i as u64), *value);
            assert!(value.abs() < NoiseSource::LARGEST);
            let most = source.most(11, i as u64);
            assert!(source.normal(11, i as u64).abs() <= most && most < NoiseSource::LARGEST, "{i}");
        }
        let mut most = [0.0; 77];
        source.fill_most(11, &mut most);
        assert_eq!(most, std::array::from_fn(|sample| source.most(11, sample as u64)));
        // Noise is named by its address: the value never changes.
        assert_eq!(source.normal(11, 0).to_bits(), 4590721521259976376);
        assert_ne!(source.normal(12, 0), source.normal(11, 0));
        assert_ne!(NoiseSource::new(8, "mul", 3).normal(11, 0), source.normal(11, 0));
        assert_ne!(NoiseSource::new(7, "mul", 4).normal(11, 0), source.normal(11, 0));
        assert_ne!(part_key("mul"), part_key("mul\0"));
    }

    #[test]
    fn band_noise_has_its_deviation_and_its_correlation() {
        let (h, tau, sigma) = (50e-9, 100e-9, 0.02);
        let part = BandNoise::<f64>::new(h, tau, sigma);
        let deviates = deviates(200_000);
        let mut x = part.begin(deviates[0]);
        let values: Vec<f64> = deviates[1..].iter().map(|&n| (x = part.step(x, n), x).1).collect();
        let [_, variance, _] = moments(&values);
        assert!((variance / (sigma * sigma) - 1.0).abs() < 0.03, "{variance}");
        let next: f64 = values.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>() / values.len() as f64;
        assert!((next / variance - libm::exp(-h / tau)).abs() < 0.01);
    }

    #[test]
    fn band_noise_of_no_lag_is_white_and_of_an_endless_one_constant() {
        let white = BandNoise::<f64>::new(50e-9, 0.0, 0.1);
        assert_eq!(white.step(123.0, 2.0), 0.2);
        let constant = BandNoise::<f64>::new(50e-9, f64::INFINITY, 0.1);
        assert_eq!(constant.step(0.07, 2.0), 0.07);
    }
}
