//! The video amplifier: correction, bandwidth, noise.

use hardware_model::AnalogParts;
use parts::{BandNoise, LagStep, NoiseSource, Spread, Tolerance, relative_sigma, time_constant};

/// Deviations of noise in the step between two shades that can be told apart.
const APART: f64 = 6.0;

/// From what is read along a line to the video in front of the tube.
#[derive(Debug, Clone)]
pub(crate) struct VideoAmplifier {
    /// Exponent of the correction.
    exponent: f32,
    lag: LagStep<f32>,
    noise: Option<VideoNoise>,
}

/// Noise in the band of the amplifier.
#[derive(Debug, Clone)]
struct VideoNoise {
    source: NoiseSource,
    band: BandNoise<f32>,
}

/// Video of one line, and the deviates of its noise.
#[derive(Debug, Clone)]
pub(crate) struct VideoLine {
    /// Video in front of the tube, pixel by pixel.
    pub video: Vec<f32>,
    deviates: Vec<f32>,
}

impl VideoLine {
    /// A line of `columns` pixels.
    pub fn new(columns: usize) -> Self {
        Self { video: vec![0.0; columns], deviates: vec![0.0; columns] }
    }
}

impl VideoAmplifier {
    /// The amplifier of `parts`, for pixels that are `step` (s) apart on their line.
    pub fn new(parts: &AnalogParts, step: f64, seed: u64) -> Self {
        let sigma = if parts.spread { relative_sigma::BANDWIDTH } else { 0.0 };
        let drawn =
            |nominal| Spread::new(seed).figure("picture-tube.video", 0, &Tolerance { nominal, sigma });
        let tau = parts.picture_tube.bandwidth.map_or(0.0, |bandwidth| time_constant(drawn(bandwidth)));
        Self {
            exponent: (1.0 / parts.picture_tube.correction) as f32,
            lag: LagStep::new(step, tau),
            noise: parts.memory.grey.map(|shades| VideoNoise {
                source: NoiseSource::new(seed, "picture-tube.video", 0),
                band: BandNoise::new(step, tau, 1.0 / (APART * f64::from(shades.max(1)))),
            }),
        }
    }

    /// Whether two showings of one line differ.
    pub fn is_noisy(&self) -> bool {
        self.noise.is_some()
    }

    /// The video of a line that reads `read`; `address` is that of its noise: a number for each line of each field.
    pub fn amplify(&self, read: &[f32], address: u64, line: &mut VideoLine) {
        self.pass(read, &mut line.video);
        if let Some(noise) = &self.noise {
            noise.join(address, line);
        }
    }

    /// Correction and lag, which has settled at the first pixel.
    fn pass(&self, read: &[f32], video: &mut [f32]) {
        let corrected = |value: f32| libm::powf(value.max(0.0), self.exponent);
        let mut before = read.first().map_or(0.0, |value| corrected(*value));
        let mut out = before;
        for (video, value) in video.iter_mut().zip(read) {
            let now = corrected(*value);
            out = self.lag.step(out, before, now);
            before = now;
            *video = out;
        }
    }
}

impl VideoNoise {
    /// Adds the noise of the line with this address.
    fn join(&self, address: u64, VideoLine { video, deviates }: &mut VideoLine) {
        self.source.fill(address, deviates);
        let mut before = None;
        for (video, &deviate) in video.iter_mut().zip(deviates.iter()) {
            let noise = before.map_or_else(|| self.band.begin(deviate), |x| self.band.step(x, deviate));
            before = Some(noise);
            *video += noise;
        }
    }
}
