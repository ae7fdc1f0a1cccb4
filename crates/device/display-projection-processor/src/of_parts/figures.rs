//! Figures of the parts of one processor, drawn from the seed of the model.

use hardware_model::AnalogParts;
use parts::{
    ComparatorLaw, NoiseSource, SampleHoldLaw, Spread, Tolerance, differentiated_noise, relative_sigma,
};

/// Band in which the noise of an amplifier is told (Hz; hardware section 3.2), and the band of a processor without one.
const NOISE_BAND: f64 = 10e6;

/// A differentiator with two lags of this over B passes as much of white noise as one that ends at B
/// (hardware section 6): `1 / (8 tau^3) = 4 pi^2 B^3 / 3`.
const LAGS: f64 = 0.211_782_714_409_354_9;

/// The differentiator's `tau_d` (s): a hysteresis of 0.1 % is then 4 full scales a millisecond, three sigma of the noise of
/// a nominal processor (0.5 mV of 10 V in 10 MHz, bandwidth 8 MHz).
pub const DERIVATIVE: f64 = 250e-9;

/// Parts, each with its own deviates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Figures<'a> {
    pub parts: &'a AnalogParts,
    pub seed: u64,
}

impl Figures<'_> {
    /// Static error of a function generator (share).
    pub fn bow(&self, part: &str) -> Option<f64> {
        let sigma = self.parts.projection.error;
        (sigma > 0.0).then(|| Spread::new(self.seed).error(part, 0, sigma))
    }

    /// Bandwidth of a function generator (Hz).
    pub fn bandwidth(&self, part: &str) -> Option<f64> {
        self.parts.projection.bandwidth.map(|b| self.draw(part, b, relative_sigma::BANDWIDTH))
    }

    /// The differentiator's lag `tau_f` (s), and what its band leaves of the delay to be trimmed.
    pub fn derivative_lags(&self, part: &str) -> [f64; 2] {
        let lag = |bandwidth: Option<f64>| bandwidth.map_or(0.0, |bandwidth| LAGS / bandwidth);
        [lag(self.bandwidth(part)), lag(self.parts.projection.bandwidth)]
    }

    /// Noise of the elevation (share, one sigma) in the processor's band.
    pub fn noise(&self) -> f64 {
        let amplifier = self.parts.amplifier.noise / self.parts.full_scale;
        amplifier * (self.band() / NOISE_BAND).sqrt()
    }

    fn band(&self) -> f64 {
        self.parts.projection.bandwidth.unwrap_or(NOISE_BAND)
    }

    /// The comparator that finds falling elevation. It needs the whole hysteresis: level ground does not fall.
    pub fn falling(&self, part: &str) -> ComparatorLaw {
        let noise = differentiated_noise(self.noise(), self.band()) * DERIVATIVE;
        let law = self.comparator(part, noise);
        ComparatorLaw { offset: law.offset + law.hysteresis / 2.0, ..law }
    }

    /// A comparator whose thresholds have `noise` (share).
    pub fn comparator(&self, part: &str, noise: f64) -> ComparatorLaw {
        ComparatorLaw { noise, ..self.parts.comparator_law(&Spread::new(self.seed), part, 0) }
    }

    pub fn source(&self, part: &str) -> NoiseSource {
        NoiseSource::new(self.seed, part, 0)
    }

    /// Draws the figures of the sample-and-hold called `part`.
    pub fn sample_hold(&self, part: &str) -> SampleHoldLaw {
        let (figures, full_scale) = (&self.parts.sample_hold, self.parts.full_scale);
        SampleHoldLaw {
            acquisition: self.draw(&format!("{part}.acquisition"), figures.acquire, relative_sigma::SETTLING),
            aperture: self.draw(&format!("{part}.aperture"), figures.aperture, relative_sigma::SWITCH_DELAY),
            jitter: figures.jitter,
            pedestal: self.draw(
                &format!("{part}.pedestal"),
                figures.pedestal / full_scale,
                relative_sigma::GLITCH,
            ),
            droop: self.draw(&format!("{part}.droop"), figures.droop / full_scale, relative_sigma::GLITCH),
        }
    }

    fn draw(&self, part: &str, nominal: f64, sigma: f64) -> f64 {
        let sigma = if self.parts.spread { sigma } else { 0.0 };
        Spread::new(self.seed).figure(part, 0, &Tolerance { nominal, sigma })
    }
}
