//! The ground-range programme: how far each sample of a sweep lies (specification, section 22; hardware section 4.8).

/// How ground range grows along the sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RangeLaw {
    /// At a constant rate, as reported: half the picture lies in the first few samples.
    ConstantRate,
    /// A fine ramp to `switch` over a share of the samples, then a coarse one (the modified terrain generator).
    TwoRate {
        /// Ground range of the switch (m).
        switch: f64,
        /// Share of the samples that the fine ramp takes, 0..1.
        fine_share: f64,
    },
    /// Level ground crosses display lines at a constant rate: `1/z` is linear in time.
    ConstantElevation,
    /// Range grows by a constant factor a step.
    Geometric,
}

/// Law and ends of a ground-range programme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeProgramme {
    /// Law by which range grows from sample to sample.
    pub law: RangeLaw,
    /// Range of the first sample (m); `ConstantRate` and `TwoRate` start at one step instead.
    pub start: f64,
    /// Range of the last sample (m).
    pub end: f64,
}

impl RangeProgramme {
    /// Range of sample `sample` of `samples`, at least 2 (m): ascends, and ends at `end` exactly.
    pub fn at_sample(&self, sample: usize, samples: usize) -> f64 {
        let last = samples - 1;
        if sample == last {
            return self.end;
        }
        let share = sample as f64 / last as f64;
        match self.law {
            RangeLaw::ConstantRate => self.end * (sample + 1) as f64 / samples as f64,
            RangeLaw::TwoRate { switch, fine_share } => self.two_rate(sample, last, switch, fine_share),
            RangeLaw::ConstantElevation => {
                1.0 / (1.0 / self.start + (1.0 / self.end - 1.0 / self.start) * share)
            }
            RangeLaw::Geometric => self.start * libm::exp(libm::log(self.end / self.start) * share),
        }
    }

    /// A fine ramp from one fine step to `switch`, then a coarse one to the end.
    fn two_rate(&self, sample: usize, last: usize, switch: f64, fine_share: f64) -> f64 {
        let (sample, last) = (sample as f64, last as f64);
        let fine = (fine_share * last).round().min(last - 1.0).max(1.0);
        if sample <= fine {
            return switch * (sample + 1.0) / (fine + 1.0);
        }
        switch + (self.end - switch) * (sample - fine) / (last - fine)
    }
}

/// Where the modified terrain generator goes over from the fine level to the coarse one (section 8).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelSwitch {
    /// Ground range from which on the coarse level draws (m).
    pub range: f64,
    /// Stretch before it over which the fine level fades into the coarse one (m); 0 switches at once.
    pub blend: f64,
}
