//! The master clock as one sweep sees it.

use crate::scene::SceneData;

/// Ticks and instants; instants are in accumulator steps from the first sample of the sweep.
#[derive(Debug, Clone, Copy)]
pub struct Clock {
    /// Ticks that have passed when the sweep begins.
    pub begun: i64,
    /// Part of a tick that has passed beyond them, 0..1.
    phase: f64,
    /// Ticks in one step.
    ticks_per_step: f64,
}

impl Clock {
    /// The clock of sweep `sweep`: steps and ticks are whole counts since the start of the mission.
    pub fn of(scene: &SceneData<'_>, sweep: u32) -> Self {
        let timebase = &scene.settings.timebase;
        let ([ticks, in_seconds], [frames, seconds]) =
            (timebase.master.fraction(), timebase.update.fraction());
        let steps_a_sweep = u64::from(timebase.active_samples + timebase.retrace_samples);
        let steps_a_frame = u64::from(timebase.sweeps) * steps_a_sweep;
        let first_step = scene.frame * steps_a_frame + u64::from(sweep) * steps_a_sweep;
        // ticks a step = (ticks / in_seconds) / (frames * steps_a_frame / seconds)
        let above = u128::from(ticks) * u128::from(seconds);
        let below = u128::from(in_seconds) * u128::from(frames) * u128::from(steps_a_frame);
        let passed = u128::from(first_step) * above;
        Self {
            begun: (passed / below) as i64,
            phase: (passed % below) as f64 / below as f64,
            ticks_per_step: above as f64 / below as f64,
        }
    }

    /// The first tick at or after `time`; what happens before the mission begins is seen as it begins, at tick 0.
    pub fn seen(&self, time: f64) -> i64 {
        (self.begun + (self.phase + time * self.ticks_per_step).ceil() as i64).max(0)
    }

    /// The last tick at or before `time`.
    pub fn last_before(&self, time: f64) -> i64 {
        self.begun + (self.phase + time * self.ticks_per_step).floor() as i64
    }

    /// When a tick falls.
    pub fn time_of(&self, tick: i64) -> f64 {
        ((tick - self.begun) as f64 - self.phase) / self.ticks_per_step
    }

    /// How far, in ticks, `time` is from a tick: next to none, rounding decides which one sees it.
    pub fn distance_to_tick(&self, time: f64) -> f64 {
        let ticks = self.phase + time * self.ticks_per_step;
        (ticks - ticks.round()).abs()
    }
}

/// Ticks at which the sweeps of frame `frame` begin, and at last that at which it ends.
pub fn starts(scene: &SceneData<'_>, frame: u64) -> Vec<i64> {
    let scene = SceneData { frame, ..*scene };
    (0..=scene.settings.raster.sweeps).map(|sweep| Clock::of(&scene, sweep).seen(0.0)).collect()
}
