//! What the clocks allow: the arithmetic of hardware section 4 for one model over one ground.
//!
//! Its formulas are for straight sweeps over one level at a constant rate of ground range, averaged over azimuth; a
//! run counts what really happens.

mod digital;
mod lines;

use std::f64::consts::{PI, SQRT_2};

pub(crate) use digital::sector_corners;
pub use digital::{CpuBudget, DrumBudget, LoaderBudget};
pub use lines::BudgetLine;
pub(crate) use lines::four_digits;

use crate::HardwareModel;

/// Words of one coefficient set.
const SET: f64 = 9.0;
/// Sets that a crossing uses, and sets that it asks for anew (hardware section 4.4).
const SETS_USED: f64 = 2.0;
const SETS_LOADED: f64 = 4.0;

/// The ground that a model is held against; a scenario has the last word on both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundScale {
    /// Side of a region (m).
    pub region_size: f64,
    /// Ground range of a sweep (m).
    pub range: f64,
}

/// Timing budget of one model over one ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Ground that the budget is for.
    pub ground: GroundScale,
    /// Times of one sweep.
    pub sweep: SweepBudget,
    /// Crossings of region boundaries.
    pub crossings: CrossingBudget,
    /// The way of coefficient words.
    pub loader: LoaderBudget,
    /// Shares of the processor's time.
    pub cpu: CpuBudget,
    /// The drums, where there are any.
    pub drum: Option<DrumBudget>,
}

/// One sweep (hardware section 4.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepBudget {
    /// From one sweep to the next (s).
    pub period: f64,
    /// The part that is drawn (s).
    pub active: f64,
    /// Time of one sample (s).
    pub sample: f64,
    /// Video bandwidth that shows every sample (Hz).
    pub video_bandwidth: f64,
    /// New picture to new picture (s).
    pub frame: f64,
}

/// Crossings of one sweep (hardware sections 4.2 and 4.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingBudget {
    /// Ground-range rate, if it were constant (m/s).
    pub rate: f64,
    /// Ground-range rate at the end of the model's own programme (m/s), whatever the ground.
    pub end_rate: f64,
    /// Crossings, mean over azimuth.
    pub mean: f64,
    /// Crossings along a diagonal.
    pub worst: f64,
    /// From stop to stop of one axis, along that axis (s).
    pub axis: f64,
    /// Mean time between crossings (s).
    pub interval: f64,
    /// Slope of a ramp along its axis (V/s).
    pub ramp: f64,
    /// Coefficient words used (1/s).
    pub words_used: f64,
    /// Coefficient words asked for (1/s).
    pub words_loaded: f64,
}

impl HardwareModel {
    /// Regions of 300 m ("a few hundred metres", section 3) out to the end of the model's own range.
    pub fn usual_ground(&self) -> GroundScale {
        GroundScale { region_size: 300.0, range: self.range.end }
    }

    /// The timing budget over `ground`.
    pub fn budget(&self, ground: GroundScale) -> Budget {
        let sweep = SweepBudget::of(self);
        let crossings = CrossingBudget::of(self, &sweep, ground);
        let loader = LoaderBudget::of(self, ground, &sweep, &crossings);
        let cpu = CpuBudget::of(self, &sweep, &crossings, &loader);
        let drum = DrumBudget::of(self, ground);
        Budget { ground, sweep, crossings, loader, cpu, drum }
    }

    /// Seconds that `ticks` of the master clock take.
    fn seconds(&self, ticks: u64) -> f64 {
        ticks as f64 / self.master_clock.hertz()
    }
}

impl SweepBudget {
    fn of(model: &HardwareModel) -> Self {
        let raster = &model.raster;
        let drawn = f64::from(raster.samples);
        let frame = 1.0 / raster.update.hertz();
        let period = frame / f64::from(raster.sweeps);
        let active = period * drawn / (drawn + f64::from(raster.retrace_samples()));
        Self { period, active, sample: active / drawn, video_bandwidth: 0.5 * drawn / active, frame }
    }
}

impl CrossingBudget {
    fn of(model: &HardwareModel, sweep: &SweepBudget, ground: GroundScale) -> Self {
        let GroundScale { region_size, range } = ground;
        let rate = range / sweep.active;
        let mean = 4.0 * range / (PI * region_size);
        let interval = sweep.active / mean;
        let samples = model.raster.samples as usize;
        let last_step = model.range.end - model.range.at_sample(samples - 2, samples);
        Self {
            rate,
            end_rate: last_step / sweep.sample,
            mean,
            worst: SQRT_2 * range / region_size,
            axis: region_size / rate,
            interval,
            ramp: model.analog.full_scale * rate / region_size,
            words_used: SETS_USED * SET / interval,
            words_loaded: SETS_LOADED * SET / interval,
        }
    }
}
