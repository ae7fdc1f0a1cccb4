//! The sines that make up a sea.

use std::f64::consts::{PI, TAU};

use quantities::{sin_cos, unit_interval};

use crate::spectrum::{GRAVITY, WaveError, WindSpectrum, wave_number};
use crate::surface::{Sine, WaveSurface};

/// The long end of the band as a share of the peak (chosen): less than 1e-8 of the variance lies below.
const LONG_END: f64 = 0.5;

/// What each random number is for.
const PHASE: u64 = 0;
const DIRECTION: u64 = 1;

/// The wind over a sea, and how its waves are cut into sines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wind {
    /// Speed at 19.5 m above the water (m/s).
    pub speed: f64,
    /// Azimuth to which the wind blows, from north towards east (rad).
    pub towards: f64,
    /// Number that names phases and directions.
    pub seed: u64,
    /// Number of sines, 1 to 4096.
    pub components: u32,
    /// Length of the shortest wave (m).
    pub shortest: f64,
}

/// One travelling sine of the sum.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Component {
    /// Height of its crest (m).
    amplitude: f64,
    /// Wave vector: north, east (rad/m).
    vector: [f64; 2],
    /// Frequency of its travel (rad/s).
    frequency: f64,
    /// Phase at time 0 in the origin (rad).
    phase: f64,
}

/// Waves under a wind: a sum of travelling sines.
#[derive(Debug, Clone, PartialEq)]
pub struct WindWaves {
    components: Vec<Component>,
}

impl WindWaves {
    /// The waves of a wind.
    ///
    /// # Errors
    /// If a figure is out of range, or the shortest wave is not shorter than those at the peak of the spectrum.
    pub fn new(wind: &Wind) -> Result<Self, WaveError> {
        let figure = |what, found, expected| Err(WaveError::Figure { what, found, expected });
        if !wind.towards.is_finite() {
            return figure("azimuth of the wind (rad)", wind.towards, "a finite number");
        }
        if !(1..=4096).contains(&wind.components) {
            return figure("number of sines", f64::from(wind.components), "1 to 4096");
        }
        let spectrum = WindSpectrum::new(wind.speed)?;
        let [long, short] = band(&spectrum, wind.shortest)?;
        let ratio = short / long;
        let end = |number: u32| long * libm::pow(ratio, f64::from(number) / f64::from(wind.components));
        let component = |number| of_band(&spectrum, [end(number), end(number + 1)], wind, number);
        Ok(Self { components: (0..wind.components).map(component).collect() })
    }

    /// Variance of the height (m^2).
    pub fn variance(&self) -> f64 {
        self.components.iter().map(|of| of.amplitude * of.amplitude / 2.0).sum()
    }

    /// Variance of the slope along an azimuth (rad).
    pub fn slope_variance(&self, azimuth: f64) -> f64 {
        let (sin, cos) = sin_cos(azimuth);
        let slope = |of: &Component| of.amplitude * (of.vector[0] * cos + of.vector[1] * sin);
        self.components.iter().map(|of| slope(of) * slope(of) / 2.0).sum()
    }

    /// The surface at a time (s).
    pub fn at(&self, time: f64) -> WaveSurface {
        let sine = |of: &Component| Sine {
            amplitude: of.amplitude,
            vector: of.vector,
            phase: of.phase - (of.frequency * time) % TAU,
        };
        WaveSurface::new(self.components.iter().map(sine).collect())
    }
}

/// Both ends of the band (rad/s).
fn band(spectrum: &WindSpectrum, shortest: f64) -> Result<[f64; 2], WaveError> {
    if !(shortest.is_finite() && shortest > 0.0) {
        return Err(WaveError::Figure {
            what: "length of the shortest wave (m)",
            found: shortest,
            expected: "a finite number above 0",
        });
    }
    let short = (GRAVITY * TAU / shortest).sqrt();
    if short > spectrum.peak() {
        return Ok([LONG_END * spectrum.peak(), short]);
    }
    Err(WaveError::NoBand { shortest, peak: TAU / wave_number(spectrum.peak()) })
}

/// The sine of a part of the band (rad/s): it has the variance and the slope variance of the part.
fn of_band(spectrum: &WindSpectrum, ends: [f64; 2], wind: &Wind, number: u32) -> Component {
    let within = |of: &dyn Fn(f64) -> f64| of(ends[1]) - of(ends[0]);
    let variance = within(&|end| spectrum.variance_below(end));
    let slopes = within(&|end| spectrum.slope_variance_below(end));
    let length = (slopes / variance).sqrt().clamp(wave_number(ends[0]), wave_number(ends[1]));
    let random = |of: u64| unit_interval(wind.seed, &[u64::from(number), of]);
    let (sin, cos) = sin_cos(wind.towards + off_wind(random(DIRECTION)));
    Component {
        amplitude: (2.0 * variance).sqrt(),
        vector: [length * cos, length * sin],
        frequency: (GRAVITY * length).sqrt(),
        phase: TAU * random(PHASE),
    }
}

/// Angle to the wind (rad) below which a share of the waves goes, for a density of `2 / pi cos^2` between quarter turns.
fn off_wind(share: f64) -> f64 {
    let below = |angle: f64| 0.5 + (angle + 0.5 * libm::sin(2.0 * angle)) / PI;
    let [mut low, mut high] = [-PI / 2.0, PI / 2.0];
    // Halvings down to rounding.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if below(middle) < share { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}
