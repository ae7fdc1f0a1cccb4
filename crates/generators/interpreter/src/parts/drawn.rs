//! What a seed draws for the parts of a model.

/// Numbers that a seed draws, and the points of broken lines: taken as the machine has them.
#[derive(Debug, Clone, Copy)]
pub struct Drawn<'a> {
    /// Seed of the hardware model.
    pub seed: u64,
    /// Deviate of a figure of a part, by seed, name of the figure and number of the part: normal, at most 4 either way.
    pub deviate: fn(u64, &str, u64) -> f64,
    /// Deviate of noise, by seed, name of the source, its number, the sweep over all frames and the sample.
    pub noise: fn(u64, (&str, u64), [u64; 2]) -> f64,
    /// Points of the six broken lines at equal distances over 0..=1, shares of their peaks: values of the three orders, then
    /// slopes. Empty where function generators are exact.
    pub broken_lines: &'a [Vec<f64>],
}

impl Drawn<'_> {
    /// Figure of a part that cannot be negative: its median is `nominal`, its relative deviation `sigma`.
    pub fn figure(&self, part: &str, number: usize, nominal: f64, sigma: f64) -> f64 {
        if sigma == 0.0 {
            return nominal;
        }
        let width = libm::log(1.0 + sigma * sigma).sqrt();
        nominal * libm::exp(width * (self.deviate)(self.seed, part, number as u64))
    }

    /// Static error of a part whose deviation is `sigma`.
    pub fn error(&self, part: &str, number: usize, sigma: f64) -> f64 {
        sigma * (self.deviate)(self.seed, part, number as u64)
    }
}
