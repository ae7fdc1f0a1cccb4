//! A sea of false normals beside a sea of true waves: contrast and spectrum of both, read from pictures.
//!
//! **Law.** The *imitation* is what a generator draws of the scenario, the *waves* are what `exact` draws of it. Some columns are looked
//! at, spread evenly. A pixel counts if both show the sea there in every frame. *Contrast* is Michelson's, `(b - a) / (b + a)`, with a
//! and b the 5th and 95th percentile over the pixels of a frame; its mean over the frames counts. The *spread* is the standard deviation
//! over all pixels and frames, over the mean. The *spectrum* is the periodogram of each pixel over time, over the square of the mean of
//! all, averaged over pixels. Its sum times its step is the square of the *spread in time*.
//! **Theory.** A slope s along the sun changes Lambert's light by `s cot e`, e the elevation of the sun, to first order. So waves much
//! longer than a pixel have the spectrum `cot^2 e k^2 S` times the share of the slope along the sun: `1/4 + 1/2 cos^2` of the angle
//! between sun and wind.
//! **Not an error.** A sea of false normals stands for the look of water: nothing here says that it should have the spectrum of waves.

use std::f64::consts::TAU;

use exact::Columns;
use generator::{FrameError, Generator, Label, PlaneKind, Planes, Stage};
use landscape::Sun;
use rayon::prelude::*;
use scenario::Pose;
use serde::Serialize;
use signal::Probe;
use wind_waves::{GRAVITY, Wind, WindSpectrum, wave_number};

use crate::StudyError;

/// Planes that the study reads.
const KINDS: [PlaneKind; 2] = [PlaneKind::Intensity, PlaneKind::Label];

/// Which part of which frames is looked at.
#[derive(Debug, Clone)]
pub struct SeaLook {
    /// Stage that both generators draw.
    pub stage: Stage,
    /// Columns of the picture.
    pub columns: Vec<usize>,
    /// Numbers of the frames with their poses, evenly spaced.
    pub frames: Vec<(u64, Pose)>,
    /// Time between two of them (s).
    pub step: f64,
}

/// Light of a sea over frames.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaFilm {
    /// Name of the generator that drew.
    pub name: String,
    /// Light of each pixel, column by column, frame by frame.
    pub light: Vec<Vec<f64>>,
    /// Whether a pixel shows the sea in every frame.
    pub is_sea: Vec<bool>,
}

/// Figures of a film.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeaFigures {
    /// Name of the generator that drew.
    pub name: String,
    /// Mean light of all pixels and frames.
    pub mean: f64,
    /// Michelson contrast of 5th and 95th percentile, mean of the frames.
    pub contrast: f64,
    /// Standard deviation over the mean, of all pixels and frames.
    pub spread: f64,
    /// The same of each pixel over time: root of the mean square.
    pub spread_in_time: f64,
    /// Frequency of the highest bin of the spectrum (Hz).
    pub peak_hz: f64,
    /// Mean frequency of the spectrum (Hz).
    pub mean_hz: f64,
    /// Spectrum (1/Hz) at multiples of its step.
    #[serde(skip)]
    pub spectrum: Vec<f64>,
}

impl SeaLook {
    /// The film that a generator draws.
    ///
    /// # Errors
    /// If the generator cannot draw the stage or a pose.
    pub fn imitation(&self, generator: &dyn Generator) -> Result<SeaFilm, StudyError> {
        let view = &self.stage.view;
        let (columns, lines) = (view.columns as usize, view.lines as usize);
        let session = generator.prepare(self.stage.clone())?;
        let mut planes = Planes::new(columns, lines, &KINDS);
        let mut film = SeaFilm::new(generator.name(), self.columns.len() * lines);
        for (frame, pose) in &self.frames {
            session.frame(*frame, pose, &mut planes, &mut Probe::off())?;
            let at = |column: usize| (0..lines).map(move |line| line * columns + column);
            let pixels = self.columns.iter().copied().flat_map(at);
            film.add(pixels.map(|pixel| read(&planes, pixel)));
        }
        Ok(film)
    }

    /// The film that `exact` draws.
    ///
    /// # Errors
    /// If a pose cannot be drawn.
    pub fn waves(&self) -> Result<SeaFilm, StudyError> {
        let lines = self.stage.view.lines as usize;
        let judge = Columns::new(self.stage.clone());
        let mut film = SeaFilm::new("exact", self.columns.len() * lines);
        for (frame, pose) in &self.frames {
            let column = |column: &usize| judge.column(*frame, pose, *column, &KINDS);
            let drawn: Result<Vec<Planes>, FrameError> = self.columns.par_iter().map(column).collect();
            let drawn = drawn?;
            film.add(drawn.iter().flat_map(|planes| (0..lines).map(|line| read(planes, line))));
        }
        Ok(film)
    }

    /// Step of the spectra (Hz).
    pub fn step_hz(&self) -> f64 {
        1.0 / (self.step * self.frames.len() as f64)
    }
}

/// Light and label of a pixel.
fn read(planes: &Planes, pixel: usize) -> (f64, bool) {
    let [light, label] = KINDS.map(|kind| planes.get(kind).map_or(0.0, |plane| plane[pixel]));
    (light.into(), label == f32::from(Label::Sea.code()))
}

impl SeaFilm {
    fn new(name: &str, pixels: usize) -> Self {
        Self { name: name.into(), light: Vec::new(), is_sea: vec![true; pixels] }
    }

    fn add(&mut self, pixels: impl Iterator<Item = (f64, bool)>) {
        let (light, is_sea): (Vec<f64>, Vec<bool>) = pixels.unzip();
        self.is_sea.iter_mut().zip(is_sea).for_each(|(all, now)| *all &= now);
        self.light.push(light);
    }

    /// Pixels that show the sea in every frame of both films.
    pub fn shared(&self, other: &Self) -> Vec<usize> {
        (0..self.is_sea.len()).filter(|&pixel| self.is_sea[pixel] && other.is_sea[pixel]).collect()
    }

    /// Figures of some pixels, at least one; frames are `step` (s) apart.
    pub fn figures(&self, pixels: &[usize], step: f64) -> SeaFigures {
        let frames = self.light.len() as f64;
        let all = || self.light.iter().flat_map(|light| pixels.iter().map(|&pixel| light[pixel]));
        let count = frames * pixels.len() as f64;
        let mean = all().sum::<f64>() / count;
        let variance = all().map(|light| (light - mean) * (light - mean)).sum::<f64>() / count;
        let contrasts = self.light.iter().map(|light| contrast(pixels.iter().map(|&pixel| light[pixel])));
        let spectrum = self.spectrum(pixels, step, mean);
        let step_hz = 1.0 / (step * frames);
        let power: f64 = spectrum.iter().sum();
        let hertz = |bin: usize| (bin + 1) as f64 * step_hz;
        let first = spectrum.iter().enumerate().map(|(bin, power)| hertz(bin) * power).sum::<f64>();
        let peak = (0..spectrum.len()).max_by(|&a, &b| spectrum[a].total_cmp(&spectrum[b]));
        SeaFigures {
            name: self.name.clone(),
            mean,
            contrast: contrasts.sum::<f64>() / frames,
            spread: variance.sqrt() / mean,
            spread_in_time: (power * step_hz).sqrt(),
            peak_hz: peak.map_or(0.0, hertz),
            mean_hz: if power > 0.0 { first / power } else { 0.0 },
            spectrum,
        }
    }

    /// Mean periodogram of pixels (1/Hz) over the square of `mean`, from the first multiple of the step to half of the frame rate.
    fn spectrum(&self, pixels: &[usize], step: f64, mean: f64) -> Vec<f64> {
        let frames = self.light.len();
        let wheel: Vec<(f64, f64)> =
            (0..frames).map(|k| quantities::sin_cos(TAU * k as f64 / frames as f64)).collect();
        let of_pixel = |&pixel: &usize| -> Vec<f64> {
            let middle = self.light.iter().map(|light| light[pixel]).sum::<f64>() / frames as f64;
            let power = |bin: usize| {
                let (mut sine, mut cosine) = (0.0, 0.0);
                for (number, light) in self.light.iter().enumerate() {
                    let (sin, cos) = wheel[bin * number % frames];
                    sine += (light[pixel] - middle) * sin;
                    cosine += (light[pixel] - middle) * cos;
                }
                // The last bin of an even number stands for itself alone, every other for two.
                let sides = if 2 * bin == frames { 1.0 } else { 2.0 };
                sides * step / frames as f64 * (sine * sine + cosine * cosine)
            };
            (1..=frames / 2).map(power).collect()
        };
        let all: Vec<Vec<f64>> = pixels.par_iter().map(of_pixel).collect();
        let scale = 1.0 / (mean * mean * pixels.len() as f64);
        (0..frames / 2).map(|bin| scale * all.iter().map(|of| of[bin]).sum::<f64>()).collect()
    }
}

/// Michelson contrast of 5th and 95th percentile.
fn contrast(light: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = light.collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| sorted[(share * (sorted.len() - 1) as f64).round() as usize];
    let [low, high] = [at(0.05), at(0.95)];
    if high + low > 0.0 { (high - low) / (high + low) } else { 0.0 }
}

/// What theory says of the light of waves under a wind and a sun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveTheory {
    spectrum: WindSpectrum,
    /// Square of the light that a slope changes, over the mean, times the share of the slope along the sun.
    factor: f64,
    /// Frequency of the shortest wave (Hz).
    shortest_hz: f64,
}

impl WaveTheory {
    /// The theory of a wind under a sun.
    ///
    /// # Errors
    /// If the wind is out of range, or the sun is not above the horizon.
    pub fn new(wind: &Wind, sun: Sun) -> Result<Self, StudyError> {
        if sun.elevation.is_nan() || sun.elevation <= 0.0 {
            return Err(StudyError::Ladder("the sun is not above the horizon: raise its elevation".into()));
        }
        let spectrum =
            WindSpectrum::new(wind.speed).map_err(|fault| StudyError::Ladder(fault.to_string()))?;
        let cot = 1.0 / libm::tan(sun.elevation);
        let along = libm::cos(sun.azimuth - wind.towards);
        let shortest_hz = (GRAVITY * TAU / wind.shortest).sqrt() / TAU;
        Ok(Self { spectrum, factor: cot * cot * (0.25 + 0.5 * along * along), shortest_hz })
    }

    /// Spectrum (1/Hz) of light over its mean at a frequency (Hz); 0 beyond the shortest wave.
    pub fn at(&self, hertz: f64) -> f64 {
        if hertz > self.shortest_hz {
            return 0.0;
        }
        let slope = wave_number(TAU * hertz);
        self.factor * slope * slope * self.spectrum.density(TAU * hertz) * TAU
    }

    /// Standard deviation of light over its mean.
    pub fn spread(&self) -> f64 {
        (self.factor * self.spectrum.slope_variance_below(TAU * self.shortest_hz)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two pixels of mean 2 that follow sines of 0.25 Hz and 1 Hz, 16 frames of 0.25 s; a third is no sea.
    fn film() -> SeaFilm {
        let mut film = SeaFilm::new("it", 3);
        for number in 0..16 {
            let turns = f64::from(number) * 0.25;
            let light = |hertz: f64| 2.0 + 0.4 * libm::sin(TAU * hertz * turns);
            film.add([(light(0.25), true), (light(1.0), true), (9.0, number % 2 == 0)].into_iter());
        }
        film
    }

    #[test]
    fn figures_are_those_of_two_sines() {
        let film = film();
        let pixels = film.shared(&film);
        assert_eq!(pixels, [0, 1]);
        let figures = film.figures(&pixels, 0.25);
        assert!((figures.mean - 2.0).abs() < 1e-12);
        // Amplitude 0.2 of the mean: variance 0.02, half of it at each frequency, on bins 1 and 4 of 0.25 Hz.
        assert!((figures.spread - 0.02_f64.sqrt()).abs() < 1e-12);
        assert!((figures.spread_in_time - figures.spread).abs() < 1e-12);
        for (bin, power) in figures.spectrum.iter().enumerate() {
            let expected = if bin == 0 || bin == 3 { 0.01 / 0.25 } else { 0.0 };
            assert!((power - expected).abs() < 1e-12, "{bin}: {power}");
        }
        assert!((figures.mean_hz - 0.625).abs() < 1e-12);
    }

    #[test]
    fn contrast_is_that_of_the_percentiles() {
        let ramp = (0..=100).map(|k| 1.0 + f64::from(k) / 100.0);
        assert!((contrast(ramp) - 0.9 / 3.0).abs() < 1e-12);
        assert_eq!(contrast([0.0, 0.0].into_iter()), 0.0);
    }

    #[test]
    fn theory_adds_up_to_its_spread() {
        let wind = Wind { speed: 8.0, towards: 0.3, seed: 1, components: 64, shortest: 4.0 };
        let theory = WaveTheory::new(&wind, Sun { azimuth: 1.1, elevation: 0.7 }).unwrap();
        let step = 1e-4;
        let sum: f64 = (1..20_000).map(|k| theory.at(step * f64::from(k)) * step).sum();
        assert!((sum.sqrt() / theory.spread() - 1.0).abs() < 1e-3, "{sum}");
        assert!(WaveTheory::new(&wind, Sun { azimuth: 0.0, elevation: 0.0 }).is_err());
    }
}
