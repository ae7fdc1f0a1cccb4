//! Ticks of frames and sweeps on the master clock.

use hardware_model::Settings;
use quantities::{SweepTime, Tick};

use crate::stage::MachineStage;

/// Start of sweep `sweep` of frame `frame`; one more than the last is the end of the frame.
pub(crate) fn start_of(stage: &MachineStage, frame: u64, sweep: u32) -> Tick {
    stage.settings.timebase.sweep_clock(frame, sweep).tick_at_or_after(SweepTime(0.0))
}

/// First tick of frame `frame`, and that of the next frame.
pub(crate) fn frame_ticks(stage: &MachineStage, frame: u64) -> [Tick; 2] {
    [start_of(stage, frame, 0), start_of(stage, frame, stage.settings.raster.sweeps)]
}

/// Master ticks of a sweep, retrace included.
pub(crate) fn sweep_ticks(settings: &Settings) -> i64 {
    let timebase = &settings.timebase;
    (timebase.ticks_per_sample() * f64::from(timebase.sweep_samples())) as i64
}
