//! What a command does, one phase after another.

use std::time::Instant;

use serde::Serialize;

/// The phases of a command by one clock. Each begins where the one before ends, so that their sum is the time from the start to the
/// last mark.
#[derive(Debug, Clone)]
pub struct Phases {
    last: Instant,
    list: Vec<Phase>,
}

/// A part of a command and how long it took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Phase {
    /// Name of what was done, as in `performance.json`.
    pub phase: String,
    /// Wall time of the phase (s).
    pub seconds: f64,
}

impl Phases {
    /// No phases yet, of a command that began at `start`.
    pub fn since(start: Instant) -> Self {
        Self { last: start, list: Vec::new() }
    }

    /// Ends the phase `name` now and returns how long it took (s). A phase that was there before grows by as much.
    pub fn mark(&mut self, name: &str) -> f64 {
        self.mark_at(name, Instant::now())
    }

    fn mark_at(&mut self, name: &str, now: Instant) -> f64 {
        let seconds = now.duration_since(self.last).as_secs_f64();
        self.last = now;
        match self.list.iter_mut().find(|known| known.phase == name) {
            Some(known) => known.seconds += seconds,
            None => self.list.push(Phase { phase: name.into(), seconds }),
        }
        seconds
    }

    /// The phases in the order in which they first ended.
    pub fn list(&self) -> &[Phase] {
        &self.list
    }
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use super::Phases;

    #[test]
    fn phases_fill_the_time_between_the_start_and_the_last_mark() {
        let start = Instant::now();
        let mut phases = Phases::since(start);
        let marks = [("read", 125), ("others", 375), ("draw", 1000), ("others", 1250), ("page", 2000)];
        let lengths = marks.map(|(name, at)| phases.mark_at(name, start + Duration::from_millis(at)));
        assert_eq!(lengths, [0.125, 0.25, 0.625, 0.25, 0.75]);
        let list: Vec<_> = phases.list().iter().map(|phase| (phase.phase.as_str(), phase.seconds)).collect();
        assert_eq!(list, [("read", 0.125), ("others", 0.5), ("draw", 0.625), ("page", 0.75)]);
        assert_eq!(list.iter().map(|(_, seconds)| seconds).sum::<f64>(), 2.0);
    }
}
