//! What the elaborated machine leaves out, and what that does to the picture.

use control_plane::{Block, Elaboration, MachineStage, guest_omissions};
use generator::{Omission, Weight, face_lists_beside, photographs_beside};

/// What the machine of `list` leaves out of `stage`.
pub(crate) fn omissions(stage: &MachineStage, list: &Elaboration) -> Vec<Omission> {
    let mut omissions = list.omissions();
    omissions.extend(guest_omissions(&stage.landscape, &stage.scenery, stage.settings.laws.body_shading));
    omissions.extend(photographs_beside(&stage.landscape, "terrain-generator"));
    omissions.extend(face_lists_beside(&stage.scenery, "polyhedron-generator"));
    if let Some(texture) = stage.landscape.texture() {
        let what = format!("texture beyond {} m", texture.reach());
        omissions.push(Omission::lossless("texture-generator", what, "it has faded to nothing there"));
    }
    if list.has(Block::Bodies) && stage.settings.economy.leaves_out_small_bodies() {
        omissions.push(Omission {
            block: "polyhedron-generator",
            what: "rocks and culture smaller than a resolution cell of the picture".into(),
            why: "maximal distance of the report, body by body; `bodies_left_out` and `pixels_left_out` of the record say how much, \
                  --lossless draws them".into(),
            weight: Weight::Bounded(255.0),
        });
    }
    if let Some(instants) = list.instants() {
        omissions.extend(between(list, instants));
    }
    let levels = stage.landscape.bank().levels().len();
    let drawn = if list.has(Block::SecondLevel) { 2 } else { 1 };
    if levels > drawn {
        omissions.push(Omission {
            block: "terrain-generator",
            what: format!("{} coarser terrain levels", levels - drawn),
            why: "the machine has a terrain generator for each level that the scenario switches to".into(),
            weight: Weight::NotModelled,
        });
    }
    omissions
}

/// What a picture lacks that is drawn straight between so many `instants` a step.
fn between(list: &Elaboration, instants: u32) -> Vec<Omission> {
    let left_out = |block, what: &str, why: &str| Omission {
        block,
        what: what.into(),
        why: why.into(),
        weight: Weight::Bounded(255.0),
    };
    let mut omissions = vec![left_out(
        "machine",
        "kinks, edges and curves between the instants of a picture",
        &format!(
            "signals are evaluated at {instants} instants a step of the accumulators and straight between them; docs/economy.md says \
             what that does to pictures, and --quality fine draws each edge at its own instant"
        ),
    )];
    if list.has(Block::Features) {
        omissions.push(left_out(
            "feature-generator",
            "craters that look less than half a line high",
            "`craters_left_out` and `pixels_left_out` of the record say how much",
        ));
    }
    omissions
}
