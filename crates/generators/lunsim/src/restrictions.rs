//! What the program could not do, in the report's words: errors, until the run lifts them.

use generator::{FrameError, Omission, PrepareError, Stage, Weight};
use landscape::Photometry;
use quantities::degrees;
use scenario::{FieldOfView, Pose};

use crate::{NAME, Parameters};

/// Largest grid: the plotting positions of the recorder.
const LARGEST_GRID: u32 = crate::projection::POSITIONS as u32;

/// An angle nearer than this (rad) to where it has to be is there: paths are written in degrees.
const TOLERANCE: f64 = 1e-9;

/// Advice at the end of the message: how to lift the restrictions.
const REMEDY: &str =
    "change the scenario, or lift what the program could not do with --set lunsim.restrictions=false";

/// Whether the program could do `stage`.
///
/// # Errors
/// All that it could not do, each with the report's reason.
pub(crate) fn check_stage(stage: &Stage, run: &Parameters) -> Result<(), PrepareError> {
    let broken: Vec<String> = of_program(stage, run.grid).chain(not_modelled(stage).map(told)).collect();
    match broken.is_empty() || !run.restrictions {
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
            "a line of sight at heading {:.3} deg ([path]: the observer stands on one of the four cardinal points)",
            degrees(heading)
        ));
    }
    let upper = pitch + libm::atan(field.tan_half_height);
    if upper > TOLERANCE {
        broken.push(format!(
            "an upper edge of the picture {:.3} deg above the horizontal ([path]: its highest line of \
                 sight is level)",
            degrees(upper)
        ));
    }
    match broken.is_empty() {
        true => Ok(()),
        false => {
            let reason = format!("{NAME} cannot do {}: {REMEDY}", broken.join("; "));
            Err(FrameError::Refused { frame, reason })
        }
    }
}

/// What is left out once restrictions are lifted: there is no law for it.
pub(crate) fn omissions(stage: &Stage) -> Vec<Omission> {
    let omission = |lack: Lack| Omission {
        block: NAME,
        what: lack.what.into(),
        why: lack.why.into(),
        weight: Weight::NotModelled,
    };
    not_modelled(stage).map(omission).collect()
}

/// Restrictions beyond which there is a law all the same.
fn of_program(stage: &Stage, grid: u32) -> impl Iterator<Item = String> {
    let level = stage.landscape.level();
    let first = level.words()[0][0];
    let is_smooth =
        level.words().iter().all(|words| words[0] == first && words[1..].iter().all(|w| *w == 0.0));
    let is_lambert = *stage.landscape.photometry() == Photometry::Lambert;
    let sun = stage.scenery.suns().iter().find(|(_, sun)| !is_cardinal(sun.azimuth));
    [
        (grid > LARGEST_GRID)
            .then(|| format!("a grid of {grid} points ([lunsim]: at most {LARGEST_GRID}, the recorder's positions)")),
        (!is_smooth).then(|| "ground of any relief ([landscape]: its surface is smooth but for craters)".to_owned()),
        (!is_lambert).then(|| "another law of reflection ([photometry]: its surface is perfectly diffuse: Lambert)".to_owned()),
        sun.map(|(time, sun)| {
            format!(
                "a sun at azimuth {:.3} deg from {time} s on ([sun]: sun calculations run along rows and columns, so it \
                 stands on one of the four cardinal points)",
                degrees(sun.azimuth)
            )
        }),
    ]
    .into_iter()
    .flatten()
}

/// Something that no law is given for.
struct Lack {
    what: &'static str,
    /// Where a scenario asks for it.
    place: &'static str,
    /// Reason that the report gives.
    why: &'static str,
}

fn not_modelled(stage: &Stage) -> impl Iterator<Item = Lack> {
    const CRATERS: &str = "its features are craters of three types";
    const ALBEDO: &str = "its surface returns the same share of light everywhere";
    const SMOOTH: &str = "its surface is smooth but for craters";
    let Stage { landscape, scenery, view } = stage;
    let has_bodies = !scenery.standing().is_empty() || !scenery.all_guests().is_empty();
    [
        (has_bodies, "rocks and man-made things", "[rocks], [[object]]", CRATERS),
        (
            !scenery.all_effects().is_empty(),
            "lights, sheets and discs of the sky",
            "[[light]], [[sheet]], [stars]",
            CRATERS,
        ),
        (!scenery.patches(f64::INFINITY).is_empty(), "vehicle tracks", "[tracks]", CRATERS),
        (scenery.vehicle().is_some(), "the vehicle's own shadow", "[vehicle]", CRATERS),
        (landscape.albedo_map().is_some(), "a map of albedo", "[landscape] albedo_map", ALBEDO),
        (landscape.texture().is_some(), "texture", "[texture]", SMOOTH),
        (
            !landscape.silhouettes().is_empty(),
            "far silhouettes",
            "[[silhouette]]",
            "its picture ends at the horizontal",
        ),
        (view.levels.is_some(), "a second level of ground", "[levels]", SMOOTH),
        (view.yoke.is_some(), "roll", "[roll]", "its observer has an azimuth and an elevation angle"),
    ]
    .into_iter()
    .filter_map(|(is_there, what, place, why)| is_there.then_some(Lack { what, place, why }))
}

fn told(Lack { what, place, why }: Lack) -> String {
    format!("{what} ({place}: {why})")
}

fn is_cardinal(azimuth: f64) -> bool {
    let quarters = azimuth / std::f64::consts::FRAC_PI_2;
    (quarters - quarters.round()).abs() <= TOLERANCE
}
