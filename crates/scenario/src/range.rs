//! The ground-range programme: how far each sample of a sweep lies (architecture, section 4).

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
    /// How range grows.
    pub law: RangeLaw,
    /// Range of the first sample (m); `ConstantRate` and `TwoRate` start at one step instead.
    pub start: f64,
    /// Range of the last sample (m).
    pub end: f64,
}
