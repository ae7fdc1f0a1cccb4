//! Buffers of one worker; they live as long as the session.

use std::array;

use display_projection_processor::{Driven, PreviewSight, Projected, Scratch};
use feature_generator::{ChainScratch, FeatureProfile, FeatureProgram, Passings};
use light_point_generator::LightSwitch;
use mixing_unit::{Mixed, SwitchScratch};
use parts::GateEdge;
use polyhedron_generator::{BodyFade, Overlay};
use signal::{LANES, Lanes, Real, Stretches};
use sweep_memory::{FarStroke, GunWork};
use sweep_program::SweepProgram;
use terrain_generator::{ArrayState, Overlap, Polynomials, Profile};

use crate::feature_light::Lit;
use crate::lane_gate::LaneGate;
use crate::output_amplifiers::AmplifierScratch;

/// Programs and signals of a group of sweeps, in the order in which they arise.
#[derive(Debug, Clone)]
pub struct Workspace<S> {
    /// Programs of the terrain generator; of its fine level, if there are two.
    pub programs: [SweepProgram; LANES],
    /// Programs of the coarse level.
    pub coarse: [SweepProgram; LANES],
    /// Craters that the group can meet.
    pub craters: Vec<u32>,
    /// Programs of the feature generator.
    pub features: [FeatureProgram; LANES],
    /// Craters that the group draws, where the machine draws a preview or craters change the texture.
    pub passings: Passings,
    /// Wires of the terrain generators made of parts, the fine level's first.
    pub arrays: [ArrayState<S>; 2],
    /// Buffers of the terrain generators made of ideal parts, the fine level's first.
    pub polynomials: [Polynomials<S>; 2],
    /// Height and slopes of the terrain, sample by sample.
    pub profile: Profile<S>,
    /// Both levels where they blend.
    pub overlap: Overlap<S>,
    /// Largest difference of the levels at the switch (m).
    pub step: f64,
    /// Height and slopes that features add, sample by sample.
    pub feature_profile: FeatureProfile<S>,
    /// Sub-generators of parts, and where their craters are lit.
    pub chains: ChainScratch<S>,
    /// Features in the light.
    pub lit: Lit<S>,
    /// Changes of a gate along a sweep, as they are found.
    pub edges: Vec<GateEdge>,
    /// Gates of remote shadow.
    pub shadow: [LaneGate<S>; LANES],
    /// Stretches in remote shadow, where the machine draws a preview.
    pub dark: Stretches,
    /// Presence of features, by comparators of parts.
    pub presence: [LaneGate<S>; LANES],
    /// What craters add to the gain of texture, as far as texture goes; empty where they add nothing.
    pub grain: Vec<Lanes<S>>,
    /// Texture of the foreground.
    pub texture: Vec<Lanes<S>>,
    /// Fades of the switches of parts.
    pub fades: SwitchScratch<S>,
    /// Projection processor of parts.
    pub chain: Scratch<S>,
    /// Signals that the projection processor of parts sends on.
    pub driven: Driven<S>,
    /// Write gun of parts.
    pub gun: GunWork,
    /// Output amplifiers of the main signals.
    pub amplifiers: AmplifierScratch<S>,
    /// Composite profiles; not used where terrain is alone.
    pub mixed: Mixed<S>,
    /// Profiles after projection, with occlusion and deflection.
    pub projected: Projected<S>,
    /// What is seen of them, where the machine draws a preview.
    pub sight: PreviewSight<S>,
    /// Mountains behind the last sample.
    pub far: [Vec<FarStroke>; LANES],
    /// Lines of the ideal write beam while they are written.
    pub lines: Vec<Lanes<f32>>,
    /// Buffers of the third video switch (VS3).
    pub third: ThirdSwitch,
}

/// Buffers of the third video switch (VS3).
#[derive(Debug, Clone, Default)]
pub struct ThirdSwitch {
    /// Polyhedra of the sweep that was composed last.
    pub overlay: Overlay,
    /// Fade of polyhedra by a switch of parts.
    pub body_fade: BodyFade,
    /// Light points, and what sweeps see of the calligraphic ones.
    pub lights: LightSwitch,
}

impl<S: Real> Default for Workspace<S> {
    fn default() -> Self {
        Self {
            programs: array::from_fn(|_| SweepProgram::idle()),
            coarse: array::from_fn(|_| SweepProgram::idle()),
            craters: Vec::new(),
            features: Default::default(),
            passings: Passings::default(),
            arrays: Default::default(),
            polynomials: Default::default(),
            profile: Profile::default(),
            overlap: Overlap::default(),
            step: 0.0,
            feature_profile: FeatureProfile::default(),
            chains: ChainScratch::default(),
            lit: Lit::default(),
            edges: Vec::new(),
            shadow: Default::default(),
            dark: Default::default(),
            presence: Default::default(),
            grain: Vec::new(),
            texture: Vec::new(),
            fades: SwitchScratch::default(),
            chain: Scratch::default(),
            driven: Driven::default(),
            gun: GunWork::default(),
            amplifiers: AmplifierScratch::default(),
            mixed: Mixed::default(),
            projected: Projected::default(),
            sight: PreviewSight::default(),
            far: Default::default(),
            lines: Vec::new(),
            third: ThirdSwitch::default(),
        }
    }
}
