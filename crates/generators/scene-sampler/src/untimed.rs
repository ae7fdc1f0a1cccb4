//! A frame of a generator whose lists and beam take no time.

use generator::{FrameError, Planes};
use light_points::BeamBudget;
use raster::{Lists, Screen};
use scenario::View;

use crate::filled::Filled;
use crate::parameters::Parameters;
use crate::picture::{Picture, draw, fill};
use crate::scene::Scene;

/// A beam that takes no time.
const BEAM: BeamBudget = BeamBudget { jump_ns: 0, dwell_ns: 0 };

/// Draws a scene with its beam, and fills the planes that are wanted.
///
/// # Errors If a light is no number.
pub fn draw_untimed(
    scene: &Scene,
    screen: &Screen,
    run: &Parameters,
    (view, frame): (&View, u64),
    planes: &mut Planes,
) -> Result<Picture, FrameError> {
    let mut picture = draw(scene, &lists(scene, screen), screen, run, BEAM, view, frame, false)?;
    picture.beam.draw(&scene.lights.points, run, screen, &mut picture.colours);
    fill(&picture, scene, planes);
    Ok(picture)
}

/// Uses a pixel of a scene with the stacks of its sampling points.
///
/// # Errors If a light is no number.
pub fn with_pixel<T>(
    scene: &Scene,
    screen: &Screen,
    run: &Parameters,
    (frame, pixel): (u64, [usize; 2]),
    use_it: impl FnOnce(&Filled<'_>) -> T,
) -> Result<T, FrameError> {
    let lists = lists(scene, screen);
    let filled = Filled::new(scene, &lists, screen, run, pixel);
    let filled = filled.map_err(|error| FrameError::Refused { frame, reason: error.to_string() })?;
    Ok(use_it(&filled))
}

fn lists(scene: &Scene, screen: &Screen) -> Lists {
    let mut lists = Lists::default();
    lists.fill(screen, &scene.faces.triangles);
    lists
}
