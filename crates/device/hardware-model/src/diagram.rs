//! The block diagram of a model, with the number of parts in each block (report III.C, figures; section 6.1).

use std::fmt;

use crate::{CrossingServer, FoldDetect, HardwareModel, ShadowParts};

/// Tables of a model's file by the block that they describe. A table that several blocks share stands at each of them.
pub const BLOCK_TABLES: [(&str, &[&str]); 12] = [
    (
        "data-bank",
        &["drum", "channel", "feature_bank", "shadow_bank", "polyhedron_bank", "io_processor", "buffer"],
    ),
    ("dpu", &["dpu", "cpu", "level_turn", "loader"]),
    ("sweep-generator", &["raster", "range", "sweep"]),
    ("terrain-generator", TERRAIN),
    ("feature-generator", &["feature_generator"]),
    ("shadow-controller", &["shadow_controller", "comparator"]),
    ("texture-generator", &["texture_generator"]),
    ("polyhedron-generator", &["polyhedron_generator"]),
    ("mixing-unit", &["mixing_unit", "video_switch", "summer"]),
    ("display-projection-processor", &["dpp", "sample_hold", "comparator"]),
    ("sweep-memory", &["sweep_memory", "roll"]),
    ("picture-tube", &["video", "picture_tube"]),
];

const TERRAIN: &[&str] = &[
    "analog",
    "amplifier",
    "function_generator",
    "multiplier",
    "multiplying_dac",
    "summer",
    "level_blend",
    "reflectivity",
    "spread",
    "wires",
];

/// Corners of a region and words of each: one product for each of them.
const PRODUCTS: u32 = 36;
/// Height, slope to the north, slope to the east: the products are made for each.
const ARRAYS: u32 = 3;
/// Types of craters, each with sub-generators of its own.
const CRATER_TYPES: u32 = 3;

/// Parts of a machine with one terrain generator; ground of two levels has a second one, with a range switch. Numbers
/// that are `None` are as many as there is work for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PartCounts {
    /// Ramps: accumulator, D/A converter and smoother each.
    pub ramps: u32,
    /// Comparators at the limit stops of the ramps; the accumulators find the folds where there are none.
    pub limit_stops: u32,
    /// Polarity flip-flops, one an axis.
    pub polarity_flip_flops: u32,
    /// Inverters that they switch.
    pub inverters: u32,
    /// Generators of g0, g1, g2, fed X, 1 - X, Y and 1 - Y.
    pub function_generators: u32,
    /// Generators of their derivatives.
    pub derivative_generators: u32,
    /// Analog multipliers of the height.
    pub height_multipliers: u32,
    /// Analog multipliers of height and both slopes, if nothing is shared.
    pub multipliers: u32,
    /// D/A multipliers of the height.
    pub height_multiplying_dacs: u32,
    /// D/A multipliers of height and both slopes.
    pub multiplying_dacs: u32,
    /// Registers of words: hold, X-first, Y-first, and the diagonal one where there is one.
    pub registers: u32,
    /// Amplifiers of the three sums.
    pub summing_amplifiers: u32,
    /// Number of pointers made of hardware.
    pub wired_pointers: u32,
    /// Banks of the storage buffer for terrain.
    pub buffer_banks: u32,
    /// Drums of each level.
    pub drums: u32,
    /// Crater sub-generators of all types.
    pub sub_generators: Option<u32>,
    /// Line generators of the shadow controller; none where a tube holds the boundaries.
    pub line_generators: Option<u32>,
    /// Number of video switches.
    pub video_switches: u32,
    /// Comparators of the projection processor.
    pub occlusion_comparators: u32,
    /// Sample-and-holds of the projection processor.
    pub sample_holds: u32,
    /// Tubes of the sweep memory.
    pub tubes: u32,
}

impl PartCounts {
    /// Counts the parts of `model`.
    pub fn of(model: &HardwareModel) -> Self {
        let is_wired = model.loader.served_by == CrossingServer::WiredPointers;
        let registers = if model.loader.diagonal_register { 4 } else { 3 };
        Self {
            ramps: 2,
            limit_stops: if model.analog.sweep.fold_detect == FoldDetect::Comparator { 4 } else { 0 },
            polarity_flip_flops: 2,
            inverters: 4,
            function_generators: 12,
            derivative_generators: 12,
            height_multipliers: PRODUCTS,
            multipliers: ARRAYS * PRODUCTS,
            height_multiplying_dacs: PRODUCTS,
            multiplying_dacs: ARRAYS * PRODUCTS,
            registers: registers * PRODUCTS,
            summing_amplifiers: ARRAYS * model.analog.summer_inputs.map_or(1, tree),
            wired_pointers: if is_wired { 4 } else { 0 },
            buffer_banks: if is_wired { 4 } else { 1 },
            drums: model.data_banks.drum.map_or(0, |drum| drum.count),
            sub_generators: model.feature_generator.sub_generators.map(|each| CRATER_TYPES * each),
            line_generators: match model.shadow_controller {
                ShadowParts::Digital { line_generators } => line_generators,
                ShadowParts::ScanConverter { .. } => Some(0),
            },
            video_switches: 3,
            occlusion_comparators: 1,
            sample_holds: 1,
            tubes: model.analog.memory.tubes,
        }
    }

    /// The parts of a block of the diagram, in words; none of a block that has no counts.
    pub fn of_block(&self, block: &str) -> Vec<String> {
        match block {
            "data-bank" => vec![
                format!("{} of each level", plural(self.drums, "drum")),
                format!("storage buffer: {}", plural(self.buffer_banks, "bank")),
            ],
            "dpu" => vec![self.pointers()],
            "sweep-generator" => vec![self.sweep_parts()],
            "terrain-generator" => vec![self.basis(), self.products(), self.words_and_sums()],
            "feature-generator" => vec![number(self.sub_generators, "sub-generator")],
            "shadow-controller" => vec![number(self.line_generators, "line generator")],
            "mixing-unit" => vec![plural(self.video_switches, "video switch")],
            "display-projection-processor" => vec![self.occlusion()],
            "sweep-memory" => vec![plural(self.tubes, "tube")],
            _ => Vec::new(),
        }
    }

    /// Names with their numbers; `None` where there are as many as there is work for.
    pub fn rows(&self) -> [(&'static str, Option<u32>); 21] {
        [
            ("ramps", Some(self.ramps)),
            ("limit_stops", Some(self.limit_stops)),
            ("polarity_flip_flops", Some(self.polarity_flip_flops)),
            ("inverters", Some(self.inverters)),
            ("function_generators", Some(self.function_generators)),
            ("derivative_generators", Some(self.derivative_generators)),
            ("height_multipliers", Some(self.height_multipliers)),
            ("multipliers", Some(self.multipliers)),
            ("height_multiplying_dacs", Some(self.height_multiplying_dacs)),
            ("multiplying_dacs", Some(self.multiplying_dacs)),
            ("registers", Some(self.registers)),
            ("summing_amplifiers", Some(self.summing_amplifiers)),
            ("wired_pointers", Some(self.wired_pointers)),
            ("buffer_banks", Some(self.buffer_banks)),
            ("drums", Some(self.drums)),
            ("sub_generators", self.sub_generators),
            ("line_generators", self.line_generators),
            ("video_switches", Some(self.video_switches)),
            ("occlusion_comparators", Some(self.occlusion_comparators)),
            ("sample_holds", Some(self.sample_holds)),
            ("tubes", Some(self.tubes)),
        ]
    }
}

/// Amplifiers of a tree that sums all products, with so many inputs each.
fn tree(inputs: u32) -> u32 {
    let (mut signals, mut amplifiers) = (PRODUCTS, 0);
    while signals > 1 {
        signals = signals.div_ceil(inputs);
        amplifiers += signals;
    }
    amplifiers
}

impl fmt::Display for PartCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (block, parts) in self.blocks() {
            writeln!(f, "{}", format!("{block:<39}{parts}").trim_end())?;
        }
        Ok(())
    }
}

impl PartCounts {
    /// Lines of the diagram: blocks with the way of the signals, and their parts.
    fn blocks(&self) -> [(&'static str, String); 23] {
        let wires = |line| (line, String::new());
        [
            ("data banks", format!("{} of each level", plural(self.drums, "drum"))),
            wires("  ▼ records"),
            ("storage buffer", plural(self.buffer_banks, "bank")),
            wires("  ▼ words"),
            ("digital processing unit", self.pointers()),
            ("  ├──▶ sweep generator", self.sweep_parts()),
            wires("  │      ▼ folded X, Y"),
            ("  ├──▶ terrain generator", self.basis()),
            ("  │      │", self.products()),
            ("  │      │", self.words_and_sums()),
            ("  ├──▶ feature generator", number(self.sub_generators, "sub-generator")),
            ("  ├──▶ shadow controller", number(self.line_generators, "line generator")),
            ("  ├──▶ texture generator", String::new()),
            wires("  │      ▼ height, reflectivity"),
            ("  │    mixing unit", plural(self.video_switches, "video switch")),
            wires("  │      ▼ one profile"),
            ("  │    display projection processor", self.occlusion()),
            wires("  │      ▼ video, deflection"),
            wires("  └──▶ polyhedron generator"),
            wires("         ▼"),
            ("       sweep memory", plural(self.tubes, "tube")),
            wires("         ▼ video"),
            ("       display", "video amplifier, picture tube".into()),
        ]
    }

    fn pointers(&self) -> String {
        match self.wired_pointers {
            0 => "pointers in a program, one request after another".into(),
            pointers => plural(pointers, "wired pointer"),
        }
    }

    fn sweep_parts(&self) -> String {
        let ramps = format!("{} of accumulator, D/A converter, smoother", plural(self.ramps, "ramp"));
        match self.limit_stops {
            0 => ramps,
            stops => format!("{ramps}; {} at the stops", plural(stops, "comparator")),
        }
    }

    fn basis(&self) -> String {
        let (functions, derivatives) = (self.function_generators, self.derivative_generators);
        format!("{functions} function generators of g0, g1, g2, {derivatives} of their derivatives")
    }

    fn products(&self) -> String {
        let (analog, converters) = (self.multipliers, self.multiplying_dacs);
        let (height, of_height) = (self.height_multipliers, self.height_multiplying_dacs);
        format!(
            "{analog} analog multipliers ({height} for the height), {converters} D/A multipliers ({of_height})"
        )
    }

    fn words_and_sums(&self) -> String {
        let Self { registers, summing_amplifiers, inverters, polarity_flip_flops, .. } = self;
        format!(
            "{registers} registers, {summing_amplifiers} summing amplifiers, {inverters} inverters on \
             {polarity_flip_flops} polarity flip-flops"
        )
    }

    fn occlusion(&self) -> String {
        let comparators = plural(self.occlusion_comparators, "comparator");
        format!("{comparators}, {}", plural(self.sample_holds, "sample-and-hold"))
    }
}

fn plural(count: u32, name: &str) -> String {
    match (count, name.ends_with("ch")) {
        (1, _) => format!("1 {name}"),
        (_, true) => format!("{count} {name}es"),
        _ => format!("{count} {name}s"),
    }
}

fn number(count: Option<u32>, name: &str) -> String {
    count.map_or_else(|| format!("any number of {name}s"), |count| plural(count, name))
}
