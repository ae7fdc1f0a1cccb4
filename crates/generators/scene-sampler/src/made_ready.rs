//! What all generators that draw with this crate say of a stage.

use features::kept_share;
use generator::{Omission, PrepareError, Stage, Weight};
use landscape::Landscape;
use raster::Screen;

use crate::tile::SIDE;

/// The raster of a stage in sub-areas, for the generator of a name.
///
/// # Errors
/// If it is too large.
pub fn screen(stage: &Stage, generator: &'static str) -> Result<Screen, PrepareError> {
    let size = [stage.view.columns, stage.view.lines];
    Screen::new(size, SIDE as u32).map_err(|error| PrepareError::Unsupported {
        generator,
        what: error.to_string(),
        remedy: "ask for a smaller raster".into(),
    })
}

/// What is on a stage and in no picture of faces, for the block of a name.
pub fn omissions(stage: &Stage, block: &'static str) -> Vec<Omission> {
    let Stage { landscape, scenery, view } = stage;
    let lacks = [
        (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks"),
        (landscape.texture().is_some(), "texture"),
        (!landscape.silhouettes().is_empty(), "far silhouettes"),
        (view.shadows.is_some(), "remote shadow"),
    ];
    let omission = |what: &str| Omission {
        block,
        what: what.into(),
        why: "it draws faces, sheets and lights".into(),
        weight: Weight::NotModelled,
    };
    lacks.into_iter().filter(|(is_there, _)| *is_there).map(|(_, what)| omission(what)).collect()
}

/// The craters that posts `spacing` (m) apart, the closest of the ground, lose or flatten; `None` if there are none. `remedy` names the key
/// that brings posts closer.
pub fn small_craters(
    landscape: &Landscape,
    spacing: f64,
    block: &'static str,
    remedy: &str,
) -> Option<Omission> {
    let features = landscape.features();
    let count = features.craters().len() as u32;
    let shares = (0..count).map(|index| kept_share(features.crater(index).outer() / spacing));
    let [gone, flatter] = shares.fold([0, 0], |[gone, flatter], share| match share {
        ..=0.0 => [gone + 1, flatter],
        ..1.0 => [gone, flatter + 1],
        _ => [gone, flatter],
    });
    (gone + flatter > 0).then(|| Omission {
        block,
        what: format!("{gone} of {count} craters, and a part of {flatter} more"),
        why: format!("posts {spacing:.3} m apart cannot show them; {remedy}"),
        weight: Weight::NotModelled,
    })
}
