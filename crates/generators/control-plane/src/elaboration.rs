//! What a stage makes of the machine: one list of its blocks, from which everything else is read (section 24; economy).
//!
//! Whether a block is there, and whether it is made of parts, is asked here and nowhere else. A block that is not there does
//! not exist; a block whose parts are all ideal is its algebra. The list is read when the machine is elaborated, never for a
//! sample.

use generator::Omission;
use hardware_model::Forced;
use landscape::Photometry;

use crate::instants::instants;
use crate::stage::MachineStage;

/// A block of the machine, or a part of one that a stage may need or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// Terrain generator of the finest level.
    Terrain,
    /// Feature generator and VS1.
    Features,
    /// Shadow controller and VS2.
    Shadows,
    /// Texture generator and the adder.
    Texture,
    /// Polyhedron generator and VS3.
    Bodies,
    /// Second terrain generator and its switch.
    SecondLevel,
    /// Profiles of far mountains.
    Silhouettes,
    /// The yoke that turns the picture.
    Yoke,
    /// Mixing unit; two wires where it has nothing to switch, add or clip.
    Mixing,
    /// Projection processor and write gun, which are joined by the beam's gate.
    Beam,
    /// Storage tubes of the sweep memory.
    Memory,
    /// Video amplifier and picture tube of the display.
    PictureTube,
    /// Output amplifiers of the main signals.
    Amplifiers,
}

/// What a record says of a block that is not there, or whose parts are ideal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Missing {
    /// Name of the block's crate.
    block: &'static str,
    what: &'static str,
    why: &'static str,
}

/// A row of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Row {
    block: Block,
    is_there: bool,
    /// What a record says if it is not there; nothing of what is wires then.
    absence: Option<Missing>,
    has_parts: bool,
    /// What a record says if it is there without parts; nothing of what never has any.
    ideal: Option<Missing>,
}

/// The machine that a stage asks for, as a list of blocks in the order of the record.
#[derive(Debug, Clone, PartialEq)]
pub struct Elaboration {
    rows: [Row; 13],
    instants: Option<u32>,
}

/// Why parts of a block are ideal.
const NO_FIGURE: &str = "the model names no figure of its parts";

impl Elaboration {
    /// The machine for `stage`: what it needs, or all for which there is a source if nothing may be left out.
    pub fn new(stage: &MachineStage) -> Self {
        let rows = [
            terrain(stage),
            features(stage),
            shadows(stage),
            texture(stage),
            bodies(stage),
            second_level(stage),
            silhouettes(stage),
            yoke(stage),
            mixing(stage),
            beam(stage),
            memory(stage),
            picture_tube(stage),
            amplifiers(stage),
        ];
        let remembers = |row: &Row| matches!(row.block, Block::Terrain | Block::Amplifiers) && row.has_parts;
        Self { rows, instants: instants(stage, rows.iter().any(remembers)) }
    }

    fn row(&self, block: Block) -> &Row {
        self.rows.iter().find(|row| row.block == block).expect("every block has a row")
    }

    /// Whether a block is there.
    pub fn has(&self, block: Block) -> bool {
        self.row(block).is_there
    }

    /// Whether the model names parts of a block.
    pub fn has_parts(&self, block: Block) -> bool {
        self.row(block).has_parts
    }

    /// Instants a step of the accumulators, if groups are drawn straight between instants: the economy says so, parts beside those
    /// of the terrain generators are ideal, and the laws are such that features and terrain can be lit as one surface.
    pub fn instants(&self) -> Option<u32> {
        self.instants
    }

    /// Blocks that are not there, then blocks that are there without their parts, in the order of the list.
    pub fn omissions(&self) -> Vec<Omission> {
        let told = |missing: Missing| Omission::lossless(missing.block, missing.what, missing.why);
        let absent = self.rows.iter().filter(|row| !row.is_there).filter_map(|row| row.absence);
        let is_wires = |row: &&Row| row.is_there || row.absence.is_none();
        let ideal =
            self.rows.iter().filter(is_wires).filter(|row| !row.has_parts).filter_map(|row| row.ideal);
        absent.chain(ideal).map(told).collect()
    }
}

impl Row {
    /// A block that is always there, or wires.
    fn always(block: Block, name: &'static str, parts: &'static str, has_parts: bool) -> Self {
        let ideal = Some(Missing { block: name, what: parts, why: NO_FIGURE });
        Self { block, is_there: true, absence: None, has_parts, ideal }
    }

    /// A block that is there if it has work.
    fn with_work(block: Block, is_there: bool, [name, what, why]: [&'static str; 3]) -> Self {
        let absence = Some(Missing { block: name, what, why });
        Self { block, is_there, absence, has_parts: false, ideal: None }
    }

    /// The same block, which may be made of parts.
    fn of_parts(self, what: &'static str, has_parts: bool) -> Self {
        let ideal = self.absence.map(|absence| Missing { what, why: NO_FIGURE, ..absence });
        Self { has_parts, ideal, ..self }
    }
}

fn forces(stage: &MachineStage, what: Forced) -> bool {
    stage.settings.economy.forces(what)
}

fn terrain(stage: &MachineStage) -> Row {
    let has_parts = !stage.settings.analog.terrain_is_ideal();
    Row::always(Block::Terrain, "terrain-generator", "dynamics of parts", has_parts)
}

fn features(stage: &MachineStage) -> Row {
    let is_there = forces(stage, Forced::Features) || !stage.landscape.features().is_empty();
    let names = ["feature-generator", "sub-generators and VS1", "the ground has no features"];
    Row::with_work(Block::Features, is_there, names)
        .of_parts("bandwidth and errors of the sub-generators", !stage.settings.analog.features_are_ideal())
}

fn shadows(stage: &MachineStage) -> Row {
    let names = ["shadow-controller", "line generators and VS2", "the scenario asks for no shadows"];
    let has_parts = !stage.settings.analog.shadow_lines_are_ideal();
    Row::with_work(Block::Shadows, stage.settings.shadows.is_some(), names)
        .of_parts("errors of line generators, hysteresis and offset", has_parts)
}

fn texture(stage: &MachineStage) -> Row {
    let names = ["texture-generator", "texture and its adder", "the ground has no texture"];
    Row::with_work(Block::Texture, stage.landscape.texture().is_some(), names)
        .of_parts("bits and filter", !stage.settings.analog.texture_is_ideal())
}

fn bodies(stage: &MachineStage) -> Row {
    let is_there = forces(stage, Forced::Bodies) || !stage.scenery.standing().is_empty();
    let names = ["polyhedron-generator", "polyhedra and VS3", "nothing stands on the ground"];
    let has_parts = !stage.settings.analog.body_switch_is_ideal();
    Row::with_work(Block::Bodies, is_there, names)
        .of_parts("delay and transition of the third switch", has_parts)
}

fn second_level(stage: &MachineStage) -> Row {
    let is_there = stage.settings.levels.is_some() && stage.landscape.bank().levels().len() > 1;
    let why = "the ground has one level, or the scenario never switches";
    Row::with_work(Block::SecondLevel, is_there, ["terrain-generator", "second level and its switch", why])
}

fn silhouettes(stage: &MachineStage) -> Row {
    let is_there = !stage.landscape.silhouettes().is_empty();
    let names = ["terrain-generator", "profiles of far mountains", "the scenario has none"];
    Row::with_work(Block::Silhouettes, is_there, names)
}

fn yoke(stage: &MachineStage) -> Row {
    let names = ["display", "turning yoke", "the display shows no roll"];
    Row::with_work(Block::Yoke, stage.settings.yoke.is_some(), names)
}

/// The mixing unit has work if it has anything to switch, add or clip. Its gates wait for their comparators.
fn mixing(stage: &MachineStage) -> Row {
    let parts = &stage.settings.analog;
    let has_parts = !parts.switching_is_ideal();
    let runs_idle = [Forced::Mixing, Forced::Features, Forced::Switches, Forced::Breaks];
    let has_sources = [features(stage), shadows(stage), texture(stage)].iter().any(|row| row.is_there);
    // Lambert's light never exceeds full scale; other laws need the clip.
    let clips = *stage.landscape.photometry() != Photometry::Lambert;
    let drives = parts.wires.drives("mu.height") || parts.wires.drives("mu.reflectivity");
    let is_idle = runs_idle.into_iter().any(|what| forces(stage, what));
    let row = Row::always(
        Block::Mixing,
        "mixing-unit",
        "transitions, delays and bandwidth of the switches",
        has_parts,
    );
    Row { is_there: is_idle || has_sources || clips || has_parts || drives, ..row }
}

fn beam(stage: &MachineStage) -> Row {
    let what = "dynamics of parts and of the write gun";
    Row::always(Block::Beam, "display-projection-processor", what, !stage.settings.analog.beam_is_ideal())
}

fn memory(stage: &MachineStage) -> Row {
    let has_parts = !stage.settings.analog.memory.keeps_pictures();
    Row::always(Block::Memory, "sweep-memory", "spot, exposure, residue", has_parts)
}

fn picture_tube(stage: &MachineStage) -> Row {
    let has_parts = !stage.settings.analog.display_is_ideal();
    Row::always(
        Block::PictureTube,
        "picture-tube",
        "law of the tube, noise, phosphor, spot, interlace",
        has_parts,
    )
}

fn amplifiers(stage: &MachineStage) -> Row {
    let has_parts = !stage.settings.analog.wires.is_ideal();
    Row::always(Block::Amplifiers, "mixing-unit", "output amplifiers of the main signals", has_parts)
}
