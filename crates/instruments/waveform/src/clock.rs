//! Instants of a frame in picoseconds.

use quantities::{Rate, SweepTime, Tick, Timebase, TimebaseError};

use crate::Header;

/// A clock of one tick a picosecond.
const PICOSECONDS: u64 = 1_000_000_000_000;

/// Counts picoseconds from the start of the frame: nothing accumulates, since every sample is placed by itself.
#[derive(Debug, Clone, Copy)]
pub struct Clock {
    /// Has a sample for a frame, and the picosecond for a master clock.
    picoseconds: Timebase,
    sweep_samples: u64,
    /// Half a picosecond, in samples.
    half: f64,
}

impl Clock {
    /// The clock of a header.
    ///
    /// # Errors
    /// If the sample rate does not fit in 64 bits.
    pub fn new(header: &Header) -> Result<Self, TimebaseError> {
        let master = Rate::new(PICOSECONDS, 1).ok_or(TimebaseError)?;
        let picoseconds = Timebase::new(master, header.timebase.sample_rate(), 1, 1, 0)?;
        let half = 0.5 / picoseconds.ticks_per_sample();
        Ok(Self { picoseconds, sweep_samples: u64::from(header.timebase.sweep_samples()), half })
    }

    /// The picosecond nearest to `instant` (samples) of `sweep`; 0 before the frame.
    pub fn at(&self, sweep: u32, instant: f64) -> u64 {
        let whole = instant.floor();
        let step = (u64::from(sweep) * self.sweep_samples).checked_add_signed(whole as i64);
        let Some(step) = step else { return 0 };
        // The first tick at or after half a tick before it is the nearest.
        let Tick(tick) =
            self.picoseconds.sweep_clock(step, 0).tick_at_or_after(SweepTime(instant - whole - self.half));
        tick
    }
}

/// Seconds from the start of the frame to `instant` (samples) of `sweep`.
pub fn seconds(header: &Header, sweep: u32, instant: f64) -> f64 {
    let step = u64::from(sweep) * u64::from(header.timebase.sweep_samples());
    (step as f64 + instant) / header.timebase.sample_rate().hertz()
}

#[cfg(test)]
mod tests {
    use quantities::{Rate, Timebase};

    use super::Clock;
    use crate::Header;

    fn clock(update: Rate, sweeps: u32, samples: u32, retrace: u32) -> Clock {
        let timebase = Timebase::new(update, update, sweeps, samples, retrace).unwrap();
        let (title, provenance) = (String::new(), Vec::new());
        Clock::new(&Header { title, provenance, wires: vec![], timebase, lines: 1, frame: 0, sweeps: 0..1 })
            .unwrap()
    }

    /// By whole numbers alone: n * 10^12 * denominator / numerator, rounded.
    #[test]
    fn samples_stand_at_the_nearest_picosecond() {
        let ntsc = clock(Rate::new(30_000, 1001).unwrap(), 525, 1000, 208);
        for (sweep, sample) in [(0, 0), (0, 1), (3, 17), (524, 999), (100_000_u32, 1207_u32)] {
            let step = u128::from(sweep) * 1208 + u128::from(sample);
            let (over, under) = (step * 1_000_000_000_000 * 1001, 30_000 * 525 * 1208);
            let nearest = (2 * over + under) / (2 * under);
            assert_eq!(u128::from(ntsc.at(sweep, f64::from(sample))), nearest, "{sweep} {sample}");
        }
    }

    #[test]
    fn instants_between_samples_and_before_the_frame() {
        // 1 us a sample.
        let clock = clock(Rate::new(1000, 1).unwrap(), 10, 90, 10);
        assert_eq!(clock.at(2, 0.25), 200_250_000);
        assert_eq!(clock.at(2, -0.5), 199_500_000);
        assert_eq!(clock.at(2, 0.000_000_4), 200_000_000);
        assert_eq!(clock.at(2, 0.000_000_6), 200_000_001);
        assert_eq!(clock.at(0, -0.5), 0);
    }
}
