//! Output amplifiers of the main signals: `[wires]` of a model (hardware-1969, section 3.2).
//!
//! ```text
//! TG ─▶ height, slopes ─▶ ▷ ─┬─▶ light ─▶ ▷ ──┐
//! FG ─▶ height, slopes ─▶ ▷ ─┴─▶ light ─▶ ▷ ──┼─▶ MU ─▶ height, reflectivity ─▶ ▷ ─▶ DPP, SM
//!                                              └ heights
//! ```
//!
//! **Law.** [`Driver`]: a lag, its rate bounded; at rest on the first sample. What lags is what the next block has: there is no
//! second, ideal copy of a wire.
//! **Slopes** are those to the north and to the east, each on a wire of its own; the machine has them along and across the sweep.
//! **Elaboration.** A wire without an amplifier is passed by; a machine without any has none of this.
//! **Our choices.** Kinks of features keep their instants. Beyond its footprint the video of a feature is the ground's, as that of
//! a chain of parts is; presence is a gate. Where a profile ends its height drops out of sight at once: the control plane blanks.

mod features;
mod terrain;

use control_plane::{MachineStage, WrittenRaster};
use fearless_simd::prelude::SimdBase;
use fearless_simd::{Level, Simd, dispatch};
use feature_generator::FeatureProfile;
use hardware_model::MAIN_WIRES;
use mixing_unit::{DriverScratch, Mixed, OutputDrivers};
use parts::{Driver, Jumps, Spread, Tolerance, relative_sigma, time_constant};
use signal::{LANES, Lanes, Real};
use terrain_generator::{OUT_OF_SIGHT, Profile};

use crate::scales::Scales;
use crate::signal_table::signals;

/// The drivers of a machine.
#[derive(Debug)]
pub struct OutputAmplifiers<S> {
    terrain: Generator<S>,
    features: Generator<S>,
    mixed: OutputDrivers<S>,
}

/// Drivers of a generator's outputs.
#[derive(Debug, Clone, Copy)]
struct Generator<S> {
    height: Option<Driver<S>>,
    /// To the north and to the east.
    slopes: [Option<Driver<S>>; 2],
    reflectivity: Option<Driver<S>>,
}

impl<S: Real> Generator<S> {
    /// Height and slopes without kinks behind their amplifiers; sweeps run in `directions`.
    fn drive(&self, directions: &[[f64; 2]; LANES], [height, along, across]: [&mut [Lanes<S>]; 3]) {
        let [north, east] = &self.slopes;
        let turns = north.is_some() || east.is_some();
        let axes = Axes::new(directions);
        if turns {
            axes.to_map(along, across);
        }
        let drivers = [self.height.as_ref(), north.as_ref(), east.as_ref()];
        Driver::pass_together(drivers, [height, &mut *along, &mut *across]);
        if turns {
            axes.to_sweep(along, across);
        }
    }
}

/// Lists that drivers need; used again from group to group.
#[derive(Debug, Clone, Default)]
pub struct AmplifierScratch<S> {
    jumps: Jumps,
    mixed: DriverScratch<S>,
}

/// Where the profiles of a group end: their first samples out of sight.
pub type Ends = [usize; LANES];

impl<S: Real> OutputAmplifiers<S> {
    /// The amplifiers that the model of `stage` names, for samples that are `step` seconds apart.
    pub fn new(stage: &MachineStage, step: f64, raster: &WrittenRaster) -> Self {
        let (parts, seed) = (&stage.settings.analog, stage.settings.seed);
        let scales = Scales::of(stage, raster);
        let spread = Spread::new(seed);
        let figure = |name: &str, nominal: f64, sigma: f64| {
            let sigma = if parts.spread { sigma } else { 0.0 };
            spread.figure(name, 0, &Tolerance { nominal, sigma })
        };
        let driver = |name: &str| {
            let signal = signals().iter().find(|signal| signal.name == name)?;
            let wire = scales.wire(signal);
            let tau = parts.wires.bandwidth.map_or(0.0, |bandwidth| {
                time_constant(figure(&format!("{name}.driver"), bandwidth, relative_sigma::BANDWIDTH))
            });
            let rate = parts.wires.slew.map_or(f64::INFINITY, |slew| {
                let slew = figure(&format!("{name}.driver.slew"), slew, relative_sigma::SLEW);
                slew / wire.volts * wire.full_scale
            });
            parts.wires.drives(name).then(|| Driver::new(step, tau, rate))
        };
        let [th, tu, tv, tr, fh, fu, fv, fr, mh, mr] = MAIN_WIRES.map(driver);
        Self {
            terrain: Generator { height: th, slopes: [tu, tv], reflectivity: tr },
            features: Generator { height: fh, slopes: [fu, fv], reflectivity: fr },
            mixed: OutputDrivers { height: mh, video: mr },
        }
    }

    /// Composite height and reflectivity behind their amplifiers.
    pub fn drive_mixed(&self, ends: &Ends, mixed: &mut Mixed<S>, scratch: &mut AmplifierScratch<S>) {
        if self.mixed.height.is_some() {
            hold_beyond(ends, &mut mixed.height);
        }
        self.mixed.run(mixed, &mut scratch.mixed);
        if self.mixed.height.is_some() {
            drop_beyond(ends, &mut mixed.height);
        }
    }
}

impl<S: Real> OutputAmplifiers<S> {
    /// The same where nothing lies between samples; the composite landscape stands in `profile`.
    pub fn drive_preview(&self, ends: &Ends, profile: &mut Profile<S>) {
        let OutputDrivers { height, video } = &self.mixed;
        if video.is_some() {
            // Black is the lower end of what it is given.
            for value in &mut profile.reflectivity {
                *value = value.map(|value| value.at_least(S::ZERO));
            }
        }
        if height.is_some() {
            hold_beyond(ends, &mut profile.height);
        }
        let drivers = [height.as_ref(), video.as_ref()];
        Driver::pass_together(drivers, [&mut profile.height, &mut profile.reflectivity]);
        if height.is_some() {
            drop_beyond(ends, &mut profile.height);
        }
    }

    /// Height and slopes of features without kinks behind their amplifiers; sweeps run in `directions`.
    pub fn drive_preview_features(&self, directions: &[[f64; 2]; LANES], profile: &mut FeatureProfile<S>) {
        let FeatureProfile { height, along, across, .. } = profile;
        self.features.drive(directions, [height, along, across]);
    }
}

/// Heights stay where their profiles end, so that a driver has nothing to follow.
fn hold_beyond<S: Real>(ends: &Ends, height: &mut [Lanes<S>]) {
    for (lane, &end) in ends.iter().enumerate() {
        let Some(last) = end.checked_sub(1).and_then(|last| height.get(last)) else { continue };
        let value = last[lane];
        height.iter_mut().skip(end).for_each(|height| height[lane] = value);
    }
}

/// Heights are out of sight where their profiles have ended.
fn drop_beyond<S: Real>(ends: &Ends, height: &mut [Lanes<S>]) {
    for (lane, &end) in ends.iter().enumerate() {
        height.iter_mut().skip(end).for_each(|height| height[lane] = S::from_f64(OUT_OF_SIGHT));
    }
}

/// `[along, across]` of a sweep as slopes to the north and to the east, for each of a group.
#[derive(Debug, Clone, Copy)]
struct Axes<S> {
    cos: Lanes<S>,
    sin: Lanes<S>,
}

impl<S: Real> Axes<S> {
    /// Sweeps in `directions`: unit vectors, north and east.
    fn new(directions: &[[f64; 2]; LANES]) -> Self {
        let part = |axis: usize| Lanes::from_fn(|lane| S::from_f64(directions[lane][axis]));
        Self { cos: part(0), sin: part(1) }
    }

    /// From along and across to north and east.
    fn to_map(self, along: &mut [Lanes<S>], across: &mut [Lanes<S>]) {
        dispatch!(Level::new(), simd => self.turn(simd, along, across));
    }

    #[inline(always)]
    fn turn<L: Simd>(self, simd: L, along: &mut [Lanes<S>], across: &mut [Lanes<S>]) {
        let [cos, sin] = [&self.cos, &self.sin].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
        for (a, b) in along.iter_mut().zip(across) {
            let from = [&a.0, &b.0].map(|lanes| S::Vector::<L>::from_slice(simd, lanes));
            (from[0] * cos - from[1] * sin).store_slice(&mut a.0);
            (from[0] * sin + from[1] * cos).store_slice(&mut b.0);
        }
    }

    /// Turns slopes from north and east back to along and across.
    fn to_sweep(self, north: &mut [Lanes<S>], east: &mut [Lanes<S>]) {
        Self { sin: Lanes::default() - self.sin, ..self }.to_map(north, east);
    }
}
