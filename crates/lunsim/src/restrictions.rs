//! What the program could not do, in the report's words: errors, until the run lifts them.

use generator::{FrameError, Omission, PrepareError, Stage, Weight};
use landscape::Photometry;
use quantities::degrees;
use scenario::{FieldOfView, Pose};

use crate::NAME;

/// Largest grid: the plotting positions of the recorder.
const LARGEST_GRID: u32 = crate::projection::POSITIONS as u32;

/// An angle nearer than this (rad) to where it has to be is there: paths are written in degrees.
const TOLERANCE: f64 = 1e-9;

/// What lifts them.
const REMEDY: &str =
    "change the scenario, or lift what the program could not do with --set lunsim.restrictions=false";

/// Whether the program could do `stage`.
///
/// # Errors
/// All that it could not do, each with the report's reason.
pub(crate) fn check_stage(stage: &Stage) -> Result<(), PrepareError> {
    let broken: Vec<String> = of_program(stage).chain(not_modelled(stage).map(told)).collect();
    match broken.is_empty() || !stage.settings.lunsim.restrictions {
        true => Ok(()),
        false => Err(PrepareError::Unsupported {
            generator: NAME,
            what: broken.join("; "),
            remedy: REMEDY.to_owned(),
        }),
    }
}

/// Whether the program could look as `pose` does.
///
/// # Errors
/// All that it could not do, each with the report's reason.
pub(crate) fn check_pose(frame: u64, pose: &Pose, field: FieldOfView) -> Result<(), FrameError> {
    let mut broken = Vec::new();
    let (heading, pitch) = (pose.attitude.heading, pose.attitude.pitch);
    if !is_cardinal(heading) {
        broken.push(format!(
            "a line of sight at heading {:.3} deg (the observer stands on one of the four cardinal points)",
            degrees(heading)
        ));
    }
    let upper = pitch + libm::atan(field.tan_half_height);
    if upper > TOLERANCE {
        broken.push(format!(
            "an upper edge of the picture {:.3} deg above the horizontal (its highest line of sight is level)",
            degrees(upper)
        ));
    }
    match broken.is_empty() {
        true => Ok(()),
        false => {
            let reason = format!("{NAME} cannot do {}: {REMEDY}", broken.join("; "));
            Err(FrameError::Unsupported { frame, reason })
        }
    }
}

/// What is left out once restrictions are lifted: there is no law for it.
pub(crate) fn omissions(stage: &Stage) -> Vec<Omission> {
    let omission = |(what, why): (&str, &str)| Omission {
        block: NAME,
        what: what.into(),
        why: why.into(),
        weight: Weight::NotModelled,
    };
    not_modelled(stage).map(omission).collect()
}

/// Restrictions beyond which there is a law all the same.
fn of_program(stage: &Stage) -> impl Iterator<Item = String> {
    let grid = stage.settings.lunsim.grid;
    let level = stage.landscape.level();
    let first = level.words()[0][0];
    let is_smooth =
        level.words().iter().all(|words| words[0] == first && words[1..].iter().all(|w| *w == 0.0));
    let is_lambert = *stage.landscape.photometry() == Photometry::Lambert;
    let sun = stage.scenery.suns().iter().find(|(_, sun)| !is_cardinal(sun.azimuth));
    [
        (grid > LARGEST_GRID)
            .then(|| format!("a grid of {grid} points (at most {LARGEST_GRID}, the recorder's positions)")),
        (!is_smooth).then(|| "ground of any relief (its surface is smooth but for craters)".to_owned()),
        (!is_lambert).then(|| "another law of reflection (its surface is perfectly diffuse: Lambert)".to_owned()),
        sun.map(|(time, sun)| {
            format!(
                "a sun at azimuth {:.3} deg from {time} s on (sun calculations run along rows and columns, so it \
                 stands on one of the four cardinal points)",
                degrees(sun.azimuth)
            )
        }),
    ]
    .into_iter()
    .flatten()
}

/// What no law is given for, with the reason.
fn not_modelled(stage: &Stage) -> impl Iterator<Item = (&'static str, &'static str)> {
    const CRATERS: &str = "its features are craters of three types";
    const SMOOTH: &str = "its surface is smooth but for craters";
    let Stage { landscape, scenery, settings } = stage;
    [
        (!scenery.standing().is_empty(), "rocks and man-made things", CRATERS),
        (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks", CRATERS),
        (scenery.vehicle().is_some(), "the vehicle's own shadow", CRATERS),
        (landscape.texture().is_some(), "texture", SMOOTH),
        (!landscape.silhouettes().is_empty(), "far silhouettes", "its picture ends at the horizontal"),
        (settings.levels.is_some(), "a second level of ground", SMOOTH),
        (settings.yoke.is_some(), "roll", "its observer has an azimuth and an elevation angle"),
    ]
    .into_iter()
    .filter_map(|(is_there, what, why)| is_there.then_some((what, why)))
}

fn told((what, why): (&str, &str)) -> String {
    format!("{what} ({why})")
}

fn is_cardinal(azimuth: f64) -> bool {
    let quarters = azimuth / std::f64::consts::FRAC_PI_2;
    (quarters - quarters.round()).abs() <= TOLERANCE
}
