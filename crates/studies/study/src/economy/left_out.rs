//! What is left out, level by level: of the mission, of a frame, of a sweep, of a sample.

use control_plane::MachineStage;
use generator::{FrameCounts, Session, Weight};
use serde::Serialize;

use super::waste::{Part, WasteCounts};

/// How often it is decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// Once a mission, at elaboration.
    Mission,
    /// Once for every frame.
    Frame,
    /// Once for every sweep.
    Sweep,
    /// Once for every sample.
    Sample,
}

impl Level {
    /// Returns the name of the level for tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mission => "mission",
            Self::Frame => "frame",
            Self::Sweep => "sweep",
            Self::Sample => "sample",
        }
    }
}

/// Something that is not done.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LeftOut {
    /// Where it is decided.
    pub level: Level,
    /// Block, by crate name.
    pub block: &'static str,
    /// What is not done.
    pub what: String,
    /// Why it need not be done.
    pub why: String,
    /// How much of it is not done, of how much; `None` where it is all or nothing.
    pub count: Option<[u64; 2]>,
    /// What it does to the picture.
    pub weight: String,
}

/// What `session` leaves out of the frames that have `counts`.
pub fn left_out(
    stage: &MachineStage,
    session: &dyn Session,
    counts: &FrameCounts,
    waste: &WasteCounts,
) -> Vec<LeftOut> {
    let mut all: Vec<LeftOut> = session
        .omissions()
        .into_iter()
        .map(|omission| LeftOut {
            level: Level::Mission,
            block: omission.block,
            what: omission.what,
            why: omission.why,
            count: None,
            weight: match omission.weight {
                Weight::Lossless => LOSSLESS.to_owned(),
                Weight::NotModelled => "not modelled".to_owned(),
                Weight::Bounded(levels) => format!("at most {levels} of 255 in a pixel"),
            },
        })
        .collect();
    all.extend(counted(stage, counts, waste));
    all
}

const LOSSLESS: &str = "lossless";

fn counted(stage: &MachineStage, counts: &FrameCounts, waste: &WasteCounts) -> Vec<LeftOut> {
    let sweeps = u64::from(stage.settings.raster.sweeps);
    let frames = counts["sweeps"] / sweeps;
    let level = stage.landscape.level().corners();
    let regions = frames * ((level[0] - 1) * (level[1] - 1)) as u64;
    let standing = frames * stage.scenery.standing().len() as u64;
    let craters = counts["sweeps"] * stage.landscape.features().craters().len() as u64;
    let not = |done: u64, all: u64| Part { some: all.saturating_sub(done), all };
    let too_small = Part { some: counts["bodies_left_out"], all: standing };
    let row = |level, block, what: &str, why: &str, Part { some, all }| LeftOut {
        level,
        block,
        what: what.to_owned(),
        why: why.to_owned(),
        count: Some([some, all]),
        weight: LOSSLESS.to_owned(),
    };
    let bodies = row(
        Level::Frame,
        "polyhedron-generator",
        "bodies smaller than a resolution cell",
        "the maximal distance of the report, body by body",
        too_small,
    );
    let bodies = LeftOut {
        weight: format!("at most {} pixels of full scale in all frames", counts["pixels_left_out"]),
        ..bodies
    };
    let rows = vec![
        row(
            Level::Frame,
            "data-bank",
            "regions of the finest level",
            "not in the sector of the sweeps",
            not(counts["regions"], regions),
        ),
        bodies,
        row(
            Level::Frame,
            "polyhedron-generator",
            "bodies out of sight",
            "outside the picture, or hidden by the law",
            not(counts["bodies"] + counts["bodies_left_out"], standing),
        ),
        row(
            Level::Sweep,
            "feature-generator",
            "craters that a sweep does not load",
            "it does not cross them",
            not(counts["features"], craters),
        ),
        row(
            Level::Sweep,
            "polyhedron-generator",
            "bodies that a sweep does not meet",
            "it passes beside them",
            not(counts["spans"], counts["bodies"] * sweeps),
        ),
        row(
            Level::Sample,
            "feature-generator",
            "samples without a crater",
            "sub-generators run from edge to edge",
            waste.without_crater,
        ),
        row(
            Level::Sample,
            "texture-generator",
            "samples without texture",
            "it has faded to nothing",
            waste.without_texture,
        ),
        row(
            Level::Sample,
            "terrain-generator",
            "samples of one level where all lanes take the other",
            "the switch of each sweep",
            waste.one_level,
        ),
    ];
    rows.into_iter().filter(|row| row.count.is_some_and(|[_, all]| all > 0)).collect()
}
