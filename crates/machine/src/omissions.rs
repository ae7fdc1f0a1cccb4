//! What the elaborated machine leaves out, and what that does to the picture.

use control_plane::{Blocks, MachineStage, beam_has_parts, guest_omissions, mixing_has_parts};
use generator::{Omission, Weight};
use hardware_model::Economy;

/// What a machine of these blocks leaves out.
pub(crate) fn omissions(stage: &MachineStage, blocks: &Blocks) -> Vec<Omission> {
    let mut list = absent_blocks(stage, blocks);
    list.extend(guest_omissions(&stage.landscape, &stage.scenery));
    let parts = &stage.settings.analog;
    let ideal = [
        (parts.terrain_is_ideal(), "terrain-generator", "dynamics of parts"),
        (parts.features_are_ideal(), "feature-generator", "bandwidth and errors of the sub-generators"),
        (
            parts.shadow_lines_are_ideal(),
            "shadow-controller",
            "errors of line generators, hysteresis and offset",
        ),
        (parts.texture_is_ideal(), "texture-generator", "bits and filter"),
        (parts.body_switch_is_ideal(), "polyhedron-generator", "delay and transition of the third switch"),
        (!mixing_has_parts(parts), "mixing-unit", "transitions, delays and bandwidth of the switches"),
        (!beam_has_parts(parts), "display-projection-processor", "dynamics of parts and of the write gun"),
        (parts.memory.is_ideal(), "sweep-memory", "spot, exposure, residue"),
        (parts.wires.is_ideal(), "mixing-unit", "output amplifiers of the main signals"),
    ];
    let absent = |block: &str| match block {
        "feature-generator" => !blocks.features,
        "shadow-controller" => blocks.shadows.is_none(),
        "texture-generator" => !blocks.texture,
        "polyhedron-generator" => !blocks.bodies,
        _ => false,
    };
    let ideal = ideal.into_iter().filter(|(is_ideal, block, _)| *is_ideal && !absent(block));
    list.extend(
        ideal.map(|(_, block, what)| {
            Omission::lossless(block, what, "the model names no figure of its parts")
        }),
    );
    if let Some(texture) = stage.landscape.texture() {
        let what = format!("texture beyond {} m", texture.reach());
        list.push(Omission::lossless("texture-generator", what, "it has faded to nothing there"));
    }
    if blocks.bodies && stage.settings.economy.leaves_out_small_bodies() {
        list.push(Omission {
            block: "polyhedron-generator",
            what: "rocks and culture smaller than a resolution cell of the picture".into(),
            why: "maximal distance of the report, body by body; `bodies_left_out` and `pixels_left_out` of the record say how much, \
                  --lossless draws them".into(),
            weight: Weight::Bounded(255.0),
        });
    }
    if stage.settings.economy == Economy::Swift {
        list.extend(swift(blocks));
    }
    let levels = stage.landscape.bank().levels().len();
    let drawn = if blocks.coarse.is_some() { 2 } else { 1 };
    if levels > drawn {
        list.push(Omission {
            block: "terrain-generator",
            what: format!("{} coarser terrain levels", levels - drawn),
            why: "the machine has a terrain generator for each level that the scenario switches to".into(),
            weight: Weight::NotModelled,
        });
    }
    list
}

/// What a machine leaves out that is told to draw swiftly.
fn swift(blocks: &Blocks) -> Vec<Omission> {
    if !blocks.swift {
        let why = "the model names parts beside those of terrain generators, or laws ask for features apart from the terrain: the \
             whole machine draws";
        return vec![Omission::lossless("machine", "nothing, although it is to draw swiftly", why)];
    }
    let left_out = |block, what: &str, why: &str| Omission {
        block,
        what: what.into(),
        why: why.into(),
        weight: Weight::Bounded(255.0),
    };
    let mut list = vec![left_out(
        "machine",
        "kinks, edges and curves between samples",
        "--swift: signals are known at the samples and straight between them; docs/economy.md says what that does to pictures",
    )];
    if blocks.features {
        list.push(left_out(
            "feature-generator",
            "craters that look less than half a line high",
            "--swift; `craters_left_out` and `pixels_left_out` of the record say how much",
        ));
    }
    list
}

/// Blocks without work.
fn absent_blocks(stage: &MachineStage, blocks: &Blocks) -> Vec<Omission> {
    let rows = [
        (blocks.features, "feature-generator", "sub-generators and VS1", "the ground has no features"),
        (
            blocks.shadows.is_some(),
            "shadow-controller",
            "line generators and VS2",
            "the scenario asks for no shadows",
        ),
        (blocks.texture, "texture-generator", "texture and its adder", "the ground has no texture"),
        (blocks.bodies, "polyhedron-generator", "polyhedra and VS3", "nothing stands on the ground"),
        (
            blocks.coarse.is_some(),
            "terrain-generator",
            "second level and its switch",
            "the ground has one level, or the scenario never switches",
        ),
        (
            !stage.landscape.silhouettes().is_empty(),
            "terrain-generator",
            "profiles of far mountains",
            "the scenario has none",
        ),
        (stage.settings.yoke.is_some(), "display", "turning yoke", "the display shows no roll"),
    ];
    let absent = rows.into_iter().filter(|(present, ..)| !present);
    absent.map(|(_, block, what, why)| Omission::lossless(block, what, why)).collect()
}
