//! A group of sweeps, from program to profiles.

use std::ops::Range;

use fearless_simd::{Level, dispatch};
use landscape::{CornerWords, GroupLight, SweepLight};
use signal::{LANES, Lanes, Real, Signal, Unit};
use sweep_program::SweepProgram;

use crate::Polynomials;

/// Height of a profile beyond its end (m): lower than any real ground, so nothing of it is seen. A power of two, so that
/// it is exact in f32.
pub const OUT_OF_SIGHT: f64 = -1_073_741_824.0;

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("tg.height", Unit::Metre, "terrain height above the lunoid's tangent plane", "fig. 24"),
    Signal::ground("tg.slope.u", Unit::Slope, "terrain slope to the north", "section 7"),
    Signal::ground("tg.slope.v", Unit::Slope, "terrain slope to the east", "section 7"),
    Signal::ground(
        "tg.light.product.n",
        Unit::Slope,
        "slope to the north times the sun's word for the north",
        "section 7",
    ),
    Signal::ground(
        "tg.light.product.e",
        Unit::Slope,
        "slope to the east times the sun's word for the east",
        "section 7",
    ),
    Signal::ground("tg.light.product.u", Unit::Number, "1 times the sun's word for up", "section 7"),
    Signal::ground(
        "tg.light.facing",
        Unit::Number,
        "N.S: the third product less the two of the slopes",
        "section 7",
    ),
    Signal::ground("tg.light.square.n", Unit::Number, "square of the slope to the north", "section 7"),
    Signal::ground("tg.light.square.e", Unit::Number, "square of the slope to the east", "section 7"),
    Signal::ground("tg.light.squares", Unit::Number, "1 and both squares: the square of |N|", "section 7"),
    Signal::ground("tg.light.root", Unit::Number, "length of the normal N", "section 7"),
    Signal::ground(
        "tg.light.cosine",
        Unit::Number,
        "n.s with its sign: what the divider makes of N.S and |N|",
        "section 7",
    ),
    Signal::ground(
        "tg.reflectivity",
        Unit::Reflectivity,
        "reflectivity of the terrain: n.s, factor of the law, albedo",
        "fig. 24",
    ),
];

/// Those of the stage that makes light of slopes, among [`SIGNALS`].
pub const LIGHT: &[Signal] = SIGNALS.split_at(3).1.split_at(9).0;

/// Profiles of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Profile<S> {
    /// Height above the eye (m).
    pub height: Vec<Lanes<S>>,
    /// Slope along the sweep.
    pub along: Vec<Lanes<S>>,
    /// Slope across the sweep, positive to the right.
    pub across: Vec<Lanes<S>>,
    /// Reflectivity with its sign, -1..=1 under Lambert's law (see [`SweepLight::at`] for others): below 0 the face is
    /// turned from the sun. What is drawn is 0 there; the sign tells where between two samples local shadow begins.
    pub reflectivity: Vec<Lanes<S>>,
}

impl<S: Real> Profile<S> {
    pub(crate) fn resize(&mut self, samples: usize) {
        for signal in [&mut self.height, &mut self.along, &mut self.across, &mut self.reflectivity] {
            signal.resize(samples, Lanes::default());
        }
    }

    /// Height and the slopes along and across at one sample.
    #[cfg(test)]
    pub(crate) fn ground(&self, sample: usize) -> [Lanes<S>; 3] {
        [self.height[sample], self.along[sample], self.across[sample]]
    }
}

/// What the block is set to for one frame.
#[derive(Debug, Clone, Copy)]
pub struct TerrainGenerator<'a> {
    /// Storage buffer: corner words that the programs' indices mean.
    pub buffer: &'a [CornerWords],
    /// Region size, d (m).
    pub region_size: f64,
    /// Ground range of each sample (m).
    pub ranges: &'a [f64],
    /// Height that the summer subtracts: the eye's (m).
    pub datum: f64,
}

/// How heights and slopes are worked out.
pub trait Method<S: Real> {
    /// Height and slopes at the samples of `span`; nothing else of `profile` is touched.
    fn trace(
        &mut self,
        generator: &TerrainGenerator<'_>,
        programs: &[SweepProgram; LANES],
        span: Range<usize>,
        profile: &mut Profile<S>,
    );
}

impl TerrainGenerator<'_> {
    /// Runs the programs of a group side by side into `profile`.
    pub fn run<S: Real>(
        &self,
        programs: &[SweepProgram; LANES],
        light: &[SweepLight; LANES],
        profile: &mut Profile<S>,
    ) {
        self.trace_by(&mut Polynomials::default(), programs, profile);
        self.reflect(&GroupLight::new(light), 0..self.ranges.len(), profile);
    }

    /// Height and slopes alone, by a method.
    pub fn trace_by<S: Real>(
        &self,
        method: &mut impl Method<S>,
        programs: &[SweepProgram; LANES],
        profile: &mut Profile<S>,
    ) {
        let samples = self.ranges.len();
        profile.resize(samples);
        method.trace(self, programs, 0..samples, profile);
    }

    /// Reflectivity of `samples` from the slopes along and across (section 7), and from the line of sight if the law asks for
    /// it.
    pub fn reflect<S: Real>(&self, light: &GroupLight<S>, samples: Range<usize>, profile: &mut Profile<S>) {
        let Profile { height, along, across, reflectivity } = profile;
        let ground = [&height[samples.clone()], &along[samples.clone()], &across[samples.clone()]];
        let (ranges, out) = (&self.ranges[samples.clone()], &mut reflectivity[samples]);
        dispatch!(Level::new(), _ => light.reflect(ground, ranges, out));
    }
}
