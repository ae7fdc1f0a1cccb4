//! One sweep as it was recorded.

use signal::{Axis, Kind, Waveform};

use crate::condition::Per;

/// The ground range of every sample.
pub const RANGE: &str = "sweep.range";

/// The signals of one sweep.
#[derive(Debug, Clone, Copy)]
pub struct Sweep<'w> {
    pub waveforms: &'w [Waveform],
    /// Samples of the sweep, or lines.
    pub samples: usize,
    /// Length of a sample (µs).
    pub sample_us: f64,
}

impl<'w> Sweep<'w> {
    /// The sweep whose samples are those of `axis`.
    pub fn new(waveforms: &'w [Waveform], axis: Axis, sample_us: f64) -> Self {
        let own = waveforms.iter().filter(|waveform| waveform.signal.axis == axis);
        let samples = own.map(|waveform| waveform.values.len()).max().unwrap_or(0);
        Self { waveforms, samples, sample_us }
    }

    /// A signal, if it was recorded.
    pub fn of(&self, name: &str) -> Option<Points<'w>> {
        self.waveforms
            .iter()
            .find(|waveform| waveform.signal.name == name)
            .map(|waveform| Points { waveform })
    }

    /// Ground range at an instant, from 0 at -1 on (m).
    pub fn range_at(&self, time: f64) -> Option<f64> {
        let ranges = self.ranges()?;
        let last = ranges.len().checked_sub(1)?;
        let of = |sample: f64| if sample < 0.0 { 0.0 } else { ranges[(sample as usize).min(last)] };
        let (before, share) = (time.floor(), time - time.floor());
        Some(of(before) + share * (of(before + 1.0) - of(before)))
    }

    fn ranges(&self) -> Option<&'w [f64]> {
        self.of(RANGE).map(|points| points.values())
    }

    /// The instant `width` after `time`; none if it is beyond the sweep.
    pub fn after(&self, time: f64, width: f64, per: Per) -> Option<f64> {
        match per {
            Per::Sample => Some(time + width),
            Per::Microsecond => Some(time + width / self.sample_us),
            Per::Metre => {
                let (ranges, wanted) = (self.ranges()?, self.range_at(time)? + width);
                let next = ranges.partition_point(|&range| range < wanted);
                let above = *ranges.get(next)?;
                let below = next.checked_sub(1).map_or(0.0, |before| ranges[before]);
                Some(next as f64 - (above - wanted) / (above - below))
            }
        }
    }
}

/// A signal of a sweep: its values, each with its instant.
#[derive(Debug, Clone, Copy)]
pub struct Points<'w> {
    pub waveform: &'w Waveform,
}

impl<'w> Points<'w> {
    pub fn values(&self) -> &'w [f64] {
        &self.waveform.values
    }

    /// Instant of value `index`.
    pub fn time(&self, index: usize) -> f64 {
        match self.waveform.signal.axis {
            Axis::Changes => self.waveform.times[index],
            Axis::Ground | Axis::Line | Axis::Display => index as f64,
        }
    }

    /// The first sample that has value `index`.
    pub fn sample(&self, index: usize) -> usize {
        sample_of(self.time(index))
    }

    /// Whether there are values between two.
    pub fn is_curve(&self) -> bool {
        self.waveform.signal.kind == Kind::Analog
    }
}

/// What a recorded signal is at a sample: a wire told when it changes holds what it was told last, an event is told at the
/// first sample at or after it and at no other. `None` where there is nothing.
pub fn value_at(waveform: &Waveform, sample: usize) -> Option<f64> {
    let points = Points { waveform };
    let mut told = (0..waveform.values.len()).rev();
    let index = match (waveform.signal.axis, waveform.signal.kind) {
        (Axis::Ground | Axis::Line | Axis::Display, _) => return waveform.values.get(sample).copied(),
        (Axis::Changes, Kind::Event) => told.find(|&index| points.sample(index) == sample),
        (Axis::Changes, _) => told.find(|&index| points.sample(index) <= sample),
    };
    index.map(|index| waveform.values[index])
}

/// The first sample at or after an instant.
pub fn sample_of(time: f64) -> usize {
    // The cast takes what is before the first sample to it.
    time.ceil() as usize
}
