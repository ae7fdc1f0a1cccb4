//! Blocks of the machine beside the terrain path: how many parts they have and how they are organised.

use scenario::LevelSwitch;
use serde::Serialize;

/// How features come to the sub-generators (section 10).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Organisation {
    /// A: stored and loaded in groups, region by region, from local memory.
    ByRegion,
    /// B: the digital processing unit works out when and where to load each.
    Scheduled,
}

/// Parts of the feature generator and their organisation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FeatureParts {
    /// How features come to the sub-generators.
    pub organisation: Organisation,
    /// Sub-generators of each crater type; any number if `None`.
    pub sub_generators: Option<u32>,
}

impl Default for FeatureParts {
    /// As many sub-generators as the ground asks for.
    fn default() -> Self {
        Self { organisation: Organisation::Scheduled, sub_generators: None }
    }
}

/// What the processor does about far ground while the vehicle turns (report II.B): the coarse level begins nearer, because a background
/// that rushes past looks blurred. Which rate and which range: our choice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LevelTurn {
    /// Rate of turn from which on it does so (rad/s), to within a billionth of it; infinite where it never does.
    pub rate: f64,
    /// Share of the switch's range, and of its blend, that is left then, 0..=1.
    pub share: f64,
}

impl LevelTurn {
    /// The switch stays where it is, however fast the vehicle turns.
    pub const NEVER: Self = Self { rate: f64::INFINITY, share: 1.0 };

    /// The switch while the heading turns at `rate` (rad/s, either way).
    pub fn switch(&self, switch: LevelSwitch, rate: f64) -> LevelSwitch {
        if rate.abs() < self.rate * (1.0 - ROUNDING) {
            return switch;
        }
        LevelSwitch { range: self.share * switch.range, blend: self.share * switch.blend }
    }
}

/// Rounding of a rate of turn, as a share: one that stays the same from frame to frame is on one side of the limit. Chosen.
const ROUNDING: f64 = 1e-9;

/// The shadow controller (section 11.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShadowParts {
    /// Segments in line generators, compared with the sweep.
    Digital {
        /// Line generators; any number if `None`.
        line_generators: Option<u32>,
    },
    /// Boundaries written into a scan converter and read along the sweep.
    ScanConverter {
        /// Displacement of the reading, north and east, as a share of the map's side.
        offset: [f64; 2],
        /// Error of the reading's scale, as a share.
        gain: f64,
    },
}

impl Default for ShadowParts {
    /// As many line generators as the ground asks for.
    fn default() -> Self {
        Self::Digital { line_generators: None }
    }
}

/// What opens a video switch (section 14).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gate {
    /// A presence line of its own.
    Presence,
    /// The video that is switched: dark parts of it do not open the switch.
    SelfKeyed,
}

/// Parts of the mixing unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MixingParts {
    /// What opens VS1 and VS3.
    pub gate: Gate,
    /// Level above which a self-keyed gate opens, in reflectivity.
    pub threshold: f64,
}

impl Default for MixingParts {
    /// Returns gates with a presence line, and threshold 0.
    fn default() -> Self {
        Self { gate: Gate::Presence, threshold: 0.0 }
    }
}

/// What may be left out of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Economy {
    /// What the scene's counts say: whole as `Bounded`, or at so many `Instants` that the picture is no worse for it.
    #[default]
    Normal,
    /// Whatever cannot be seen, with a stated bound.
    Bounded,
    /// The same, and whatever takes long to tell and little room to show: signals at so many instants a step of the
    /// accumulators (1 and more) alone, straight between them, and no crater that looks smaller than a part of a line.
    Instants(u32),
    /// Only what leaves every bit as it is.
    Lossless,
    /// The same, but one thing that has no work runs: what it costs is what leaving it out saves.
    LosslessBut(Forced),
    /// Nothing: every block runs, whether it has work or not.
    Everything,
}

/// What runs without work if it is told to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Forced {
    /// Feature generator and VS1.
    Features,
    /// VS2 and the adder, with no gate and no texture to them.
    Switches,
    /// The mixing unit, as two wires and a clip.
    Mixing,
    /// Occlusion around breaks, in groups of sweeps that have none.
    Breaks,
    /// Polyhedron generator and VS3.
    Bodies,
}

impl Forced {
    /// All blocks and steps that can be forced.
    pub const ALL: [Self; 5] = [Self::Features, Self::Switches, Self::Mixing, Self::Breaks, Self::Bodies];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Features => "feature generator and VS1",
            Self::Switches => "VS2 and the adder",
            Self::Mixing => "mixing unit",
            Self::Breaks => "occlusion around breaks",
            Self::Bodies => "polyhedron generator and VS3",
        }
    }
}

impl Economy {
    /// By what timing goes. The processor does not transform bodies that are too small to be seen, whatever is drawn of them.
    #[must_use]
    pub fn of_timing(self) -> Self {
        if self.leaves_out_small_bodies() { self } else { Self::Bounded }
    }

    /// Whether bodies that look smaller than a resolution cell are left out.
    pub fn leaves_out_small_bodies(self) -> bool {
        matches!(self, Self::Normal | Self::Bounded | Self::Instants(_))
    }

    /// Whether `what` runs without work.
    pub fn forces(self, what: Forced) -> bool {
        self == Self::Everything || self == Self::LosslessBut(what)
    }
}
