//! Light of real parts: from slopes to reflectivity (section 7; report II.B).
//!
//! ```text
//! slope to the north ─▶ ┬ × word n ─┐
//! slope to the east ──▶ ┼ × word e ─┴─ - ─▶ summer: N.S ─────────────────────▶ ÷ ─▶ n.s ─▶ albedo, law
//! reference ──────────▶ ┼ × word u ─── + ─▶                                    ▲
//!                       └ squarers ────────▶ summer: 1 + hx^2 + hy^2 ─▶ root: |N| ┘
//! ```
//!
//! **Law.** That of section 7 with the figures of [`hardware_model::ReflectivityParts`]. Products and squarers are multipliers with
//! static errors, feedthrough and a lag; a summer is a lag. The root has a squarer in its feedback and the divider a multiplier: what
//! these are off by counts by the inverse of the root, and so does their slowness ([`parts::LoopLag`]). Every wire clips.
//! **Units.** Shares of full scale. Slopes have a full scale F of their own; with `R^2 = 1 + 2 F^2`, which is the square of the longest
//! normal in scale, N.S and |N| have the full scale R.
//! **Timing.** All parts see their inputs as straight lines between samples. The height waits for the light (our choice: a sane machine
//! is trimmed so): the stage sees the slopes of as much later as its own nominal delay over level ground. What is left is spread, and
//! that root and divider are quicker where the ground is steeper.
//! **State.** Everything is at rest under the slopes of the first sample. Beyond the end of a profile slopes stay.
//! **Other laws of reflection** have no circuit in the report. Their factor is its algebra, of what the divider gives and of the slopes
//! as they are.

mod figures;
mod stage;
#[cfg(test)]
mod tests;

use fearless_simd::prelude::SimdBase;
use fearless_simd::{Level, Simd, dispatch, f64x8};
use hardware_model::AnalogParts;
use landscape::{GroupLight, SweepLight};
use signal::{LANES, Lanes, Real, eight};

use self::stage::{Stage, State};
use crate::Profile;

/// Wires of the stage.
pub(crate) const WIRES: usize = 9;

/// The stage, its parts drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsLight {
    stage: Stage,
    /// By how many samples its inputs run ahead of the beam.
    ahead: f64,
    vectors: Level,
}

/// A group of sweeps as it is lit.
#[derive(Debug, Clone, Copy)]
pub struct LitGroup<'a> {
    /// Unit vector to the sun: north, east, up.
    pub sun: [f64; 3],
    /// Light in the axes of each sweep; the albedo is that of the first.
    pub light: &'a [SweepLight; LANES],
    /// Cosine and sine of the azimuth of each sweep.
    pub directions: &'a [[f64; 2]; LANES],
    /// First samples beyond the profiles.
    pub ends: &'a [usize; LANES],
    /// Ground range of each sample (m).
    pub ranges: &'a [f64],
}

/// Full scales of the wires of the stage, in the order of [`crate::LIGHT`].
pub fn light_full_scales(parts: &AnalogParts) -> [f64; WIRES] {
    let slope = parts.reflectivity.slope_full_scale;
    let span = span(slope);
    [slope, slope, 1.0, span, slope * slope, slope * slope, span * span, span, 1.0]
}

/// Waveforms of the wires of an ideal stage, in the order of [`crate::LIGHT`]: the law itself, over the slopes of lane `lane`, whose sweep
/// runs along `direction`; `sun` is the unit vector to it (north, east, up).
pub fn light_wires<S: Real>(
    sun: [f64; 3],
    direction: [f64; 2],
    profile: &Profile<S>,
    lane: usize,
) -> [Vec<f64>; WIRES] {
    let mut wires = [const { Vec::new() }; WIRES];
    for (along, across) in profile.along.iter().zip(&profile.across) {
        let [x, y] = to_map(direction, [along[lane].to_f64(), across[lane].to_f64()]);
        let [north, east, up] = [x * sun[0], y * sun[1], sun[2]];
        let (facing, squares) = (up - north - east, 1.0 + x * x + y * y);
        let now = [north, east, up, facing, x * x, y * y, squares, squares.sqrt(), facing / squares.sqrt()];
        wires.iter_mut().zip(now).for_each(|(wire, value)| wire.push(value));
    }
    wires
}

/// Slopes to the north and to the east from those along and across a sweep.
fn to_map([cos, sin]: [f64; 2], [along, across]: [f64; 2]) -> [f64; 2] {
    [along * cos - across * sin, along * sin + across * cos]
}

/// Length of the longest normal of slopes in scale: full scale of N.S and of |N|.
fn span(slope: f64) -> f64 {
    (1.0 + 2.0 * slope * slope).sqrt()
}

/// Whoever looks at the wires of a group, sample by sample; `()` is nobody.
trait Look {
    /// Whether it asks for the wires.
    const LOOKS: bool = true;
    /// The wires at the next sample, in their units.
    fn see(&mut self, wires: [[f64; LANES]; WIRES]);
}

impl Look for () {
    const LOOKS: bool = false;
    fn see(&mut self, _: [[f64; LANES]; WIRES]) {}
}

/// One lane of the wires.
struct Lane {
    number: usize,
    wires: [Vec<f64>; WIRES],
}

impl Look for Lane {
    fn see(&mut self, wires: [[f64; LANES]; WIRES]) {
        self.wires.iter_mut().zip(wires).for_each(|(kept, now)| kept.push(now[self.number]));
    }
}

impl PartsLight {
    /// The stage for steps of `h` seconds.
    pub fn new(h: f64, parts: &AnalogParts, seed: u64) -> Self {
        let stage = Stage::new(h, parts, seed);
        Self { ahead: stage.delay() / h, stage, vectors: Level::new() }
    }

    /// Lights a group: reflectivity of `profile` from its slopes, which are held beyond their ends.
    pub fn run<S: Real>(&self, group: &LitGroup<'_>, profile: &mut Profile<S>) {
        self.pass(group, profile, &mut ());
    }

    /// Waveforms of the wires of the stage in lane `lane`, in the order of [`crate::LIGHT`]: the group is lit once more.
    pub fn wires<S: Real>(
        &self,
        group: &LitGroup<'_>,
        profile: &Profile<S>,
        lane: usize,
    ) -> [Vec<f64>; WIRES] {
        let mut look = Lane { number: lane, wires: [const { Vec::new() }; WIRES] };
        self.pass(group, &mut profile.clone(), &mut look);
        look.wires
    }

    fn pass<S: Real>(&self, group: &LitGroup<'_>, profile: &mut Profile<S>, look: &mut impl Look) {
        self.hold(group.ends, profile);
        dispatch!(self.vectors, simd => self.pass_by(simd, group, profile, look));
    }

    /// Slopes that the stage sees beyond the end of a profile are the last of it.
    fn hold<S: Real>(&self, ends: &[usize; LANES], profile: &mut Profile<S>) {
        let seen = self.ahead.ceil().min(profile.along.len() as f64) as usize;
        for (lane, &end) in ends.iter().enumerate().filter(|(_, end)| **end > 0) {
            for signal in [&mut profile.along, &mut profile.across] {
                let last = signal[end - 1][lane];
                signal.iter_mut().skip(end).take(seen).for_each(|lanes| lanes[lane] = last);
            }
        }
    }

    #[inline(always)]
    fn pass_by<L: Simd, S: Real, K: Look>(
        &self,
        simd: L,
        group: &LitGroup<'_>,
        profile: &mut Profile<S>,
        look: &mut K,
    ) {
        let Profile { height, along, across, reflectivity } = profile;
        let light = GroupLight::new(group.light);
        let directions = [0, 1].map(|axis| eight(simd, &group.directions.map(|direction| direction[axis])));
        let wide = |value: f64| eight(simd, &[value; LANES]);
        let (words, albedo) = (group.sun.map(wide), wide(group.light[0].albedo));
        let mut state = State::at_rest(wide(0.0));
        let [cos, sin] = directions;
        let (whole, share) = (self.ahead.min(along.len() as f64) as usize, self.ahead - self.ahead.floor());
        let last = along.len().saturating_sub(1);
        for sample in 0..reflectivity.len() {
            // No closures in here: these would be compiled without the width of vectors of whoever asks.
            let (begin, end) = ((sample + whole).min(last), (sample + whole + 1).min(last));
            let x = between(simd, &along[begin], &along[end], share);
            let y = between(simd, &across[begin], &across[end], share);
            let slopes = [x * cos - y * sin, x * sin + y * cos];
            let wires = if sample == 0 {
                self.stage.advance::<_, true>(&mut state, slopes, words)
            } else {
                self.stage.advance::<_, false>(&mut state, slopes, words)
            };
            let mut lambert = Lanes::default();
            S::narrow(wires.cosine * albedo).store_slice(&mut lambert.0);
            let near = Lanes::splat(S::from_f64(1.0 / group.ranges[sample]));
            let slopes = [along[sample], across[sample]];
            reflectivity[sample] = light.beyond_lambert(lambert, slopes, height[sample] * near);
            if K::LOOKS {
                look.see(self.stage.in_units(&wires).map(|wire| {
                    let mut values = [0.0; LANES];
                    wire.store_slice(&mut values);
                    values
                }));
            }
        }
    }
}

/// A signal a `share` of the way from one sample to another.
#[inline(always)]
fn between<L: Simd, S: Real>(simd: L, begin: &Lanes<S>, end: &Lanes<S>, share: f64) -> f64x8<L> {
    let begin = S::widen(S::Vector::<L>::from_slice(simd, &begin.0));
    let end = S::widen(S::Vector::<L>::from_slice(simd, &end.0));
    begin + (end - begin) * share
}
