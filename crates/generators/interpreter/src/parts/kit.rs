//! Figures of a model's parts with what the seed makes of them, for steps of one length.

use hardware_model::AnalogParts;

use super::drawn::Drawn;
use super::figures::{sigma, time_constant};
use crate::given::Given;
use crate::scene::SceneData;

/// What parts are made from.
#[derive(Debug, Clone, Copy)]
pub struct Kit<'a> {
    /// Figures of the hardware model.
    pub analog: &'a AnalogParts,
    /// What the seed drew.
    pub drawn: &'a Drawn<'a>,
    /// Length of a sample of the machine (s).
    pub step: f64,
}

impl<'a> Kit<'a> {
    /// That of a scene.
    pub fn of(scene: &SceneData<'a>, given: &'a Given<'_>) -> Self {
        let settings = scene.settings;
        let step = given.between as f64 / settings.timebase.sample_rate().hertz();
        Self { analog: &settings.analog, drawn: &given.parts, step }
    }

    /// Figure of a part that cannot be negative; parts differ by `sigma` where the model says that they do.
    pub fn figure(&self, part: &str, number: usize, nominal: f64, sigma: f64) -> f64 {
        self.drawn.figure(part, number, nominal, if self.analog.spread { sigma } else { 0.0 })
    }

    /// Time of a part (steps); parts differ by `sigma`.
    pub fn steps(&self, part: &str, number: usize, time: f64, sigma: f64) -> f64 {
        self.figure(part, number, time, sigma) / self.step
    }

    /// Time constant of a part of a bandwidth in Hz (steps); 0 where it follows at once.
    pub fn lag(&self, part: &str, number: usize, bandwidth: Option<f64>) -> f64 {
        let drawn = |band: f64| time_constant(self.figure(part, number, band, sigma::BANDWIDTH)) / self.step;
        bandwidth.map_or(0.0, drawn)
    }

    /// Time constant of a bandwidth as it is nominally (steps).
    pub fn nominal_lag(&self, bandwidth: Option<f64>) -> f64 {
        bandwidth.map_or(0.0, |band| time_constant(band) / self.step)
    }

    /// A voltage as a share of full scale.
    pub fn share(&self, volts: f64) -> f64 {
        volts / self.analog.full_scale
    }
}
