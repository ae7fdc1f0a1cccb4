//! The water at one time.

/// A sine that stands still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sine {
    /// Height of its crest (m).
    pub amplitude: f64,
    /// Wave vector: north, east (rad/m).
    pub vector: [f64; 2],
    /// Phase in the origin (rad).
    pub phase: f64,
}

/// Waves at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct WaveSurface {
    sines: Vec<Sine>,
    crest: f64,
    bend: f64,
}

/// Height and slopes at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rise {
    /// Height above the calm water (m).
    pub height: f64,
    /// Slopes to the north and to the east.
    pub slopes: [f64; 2],
}

impl WaveSurface {
    /// The sum of sines.
    pub(crate) fn new(sines: Vec<Sine>) -> Self {
        let square = |of: &Sine| of.vector[0] * of.vector[0] + of.vector[1] * of.vector[1];
        Self {
            crest: sines.iter().map(|of| of.amplitude).sum(),
            bend: sines.iter().map(|of| of.amplitude * square(of)).sum(),
            sines,
        }
    }

    /// A height that no crest exceeds and no trough goes below, with its sign reversed (m).
    pub fn crest(&self) -> f64 {
        self.crest
    }

    /// The most by which a slope can change along a straight line (1/m).
    pub fn bend(&self) -> f64 {
        self.bend
    }

    /// Height and slopes at a place: north, east (m).
    pub fn at(&self, [north, east]: [f64; 2]) -> Rise {
        let (mut height, mut slopes) = (0.0, [0.0; 2]);
        for sine in &self.sines {
            let phase = sine.vector[0] * north + sine.vector[1] * east + sine.phase;
            let (sin, cos) = libm::sincos(phase);
            height += sine.amplitude * cos;
            slopes[0] -= sine.amplitude * sine.vector[0] * sin;
            slopes[1] -= sine.amplitude * sine.vector[1] * sin;
        }
        Rise { height, slopes }
    }
}
