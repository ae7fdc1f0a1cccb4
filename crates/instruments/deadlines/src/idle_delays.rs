//! Delays of the model that never met their word.

use hardware_model::LoadDelay;
use machine::{EventWord, FrameSweeps, Register};

use crate::{DeadlineError, Rehearsal};

impl Rehearsal {
    /// Delays of the loader that met their word in none of `frames`, ascending, in words: no fold of that number asked for that
    /// register of that colour.
    ///
    /// # Errors
    /// If a frame cannot be drawn.
    pub fn idle_delays(&self, frames: &[u64]) -> Result<Vec<String>, DeadlineError> {
        let mut idle: Vec<&LoadDelay> = self.stage.settings.loader.delays.iter().collect();
        for (&frame, row) in frames.iter().zip(self.poses(frames)?) {
            if idle.is_empty() {
                break;
            }
            let sweeps = self.control.sweeps(frame, &row.pose)?;
            let count = self.stage.settings.raster.sweeps;
            idle.retain(|delay| !(is_of(delay, frame) && delay.sweep < count && meets(delay, &sweeps)));
        }
        Ok(idle.into_iter().map(told).collect())
    }
}

fn is_of(delay: &LoadDelay, frame: u64) -> bool {
    delay.frame.is_none_or(|wanted| wanted == frame)
}

/// Whether the fold asks for the word that is held back.
fn meets(delay: &LoadDelay, sweeps: &FrameSweeps<'_>) -> bool {
    let wanted = Some(Register::Preload(delay.register));
    sweeps.events(delay.sweep).iter().any(|event| {
        let place = (event.crossing, event.colour, event.register);
        event.event == EventWord::Wanted
            && event.level == Some(0)
            && place == (Some(delay.crossing), Some(delay.colour), wanted)
    })
}

fn told(delay: &LoadDelay) -> String {
    let LoadDelay { frame, sweep, crossing, colour, register, word, .. } = *delay;
    let frame = frame.map_or_else(String::new, |frame| format!("frame {frame}, "));
    format!(
        "loader.delay: word [{}, {}] of {} {} at {frame}sweep {sweep}, crossing {crossing}: never met in these frames; no such fold \
         asks for this register",
        word / 3,
        word % 3,
        colour.name(),
        Register::Preload(register).name()
    )
}
