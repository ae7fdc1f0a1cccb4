//! What is seen from a pose, and why a pose is not taken.

use std::collections::BTreeMap;
use std::sync::Arc;

use drive::{Codes, Drive, DriveError, EyePose, Loop, Seen, Truth, Unplaced, Viewpoint};
use generator::Label;
use replay::{TruthItem, TruthItems};
use scenario::PoseFault;

/// What is seen from a pose.
pub(crate) struct Looked {
    /// Picture, as the machine shows it.
    pub seen: Seen,
    /// Planes that are asked for, and the range.
    pub truth: Truth,
    /// North and east (m) of the ground that each pixel shows.
    pub places: Vec<Option<[f64; 2]>>,
    /// Azimuth and elevation of the sun (degrees).
    pub sun_deg: [f64; 2],
}

impl Looked {
    /// Draws what `view` sees, with the planes `asked` of truth.
    pub fn from(view: &Viewpoint, asked: Option<&TruthItems>) -> Result<Self, DriveError> {
        let seen = view.draw()?;
        let asked = asked.map_or_else(String::new, |items| format!("{items},"));
        let truth = view.truth(&(asked + TruthItem::Range.name()))?;
        let places = view.places(ranges(&truth));
        Ok(Self { seen, truth, places, sun_deg: view.sun_deg() })
    }
}

/// What `ask` says of frame `frame` from `pose`. Of a machine with memory it is the first frame of a drive: nothing was shown before.
pub(crate) fn at_pose<T>(
    drive: &Arc<Drive>,
    frame: u64,
    pose: &EyePose,
    ask: impl FnOnce(&Viewpoint) -> Result<T, DriveError>,
) -> Result<T, DriveError> {
    match drive.remembers_frames() {
        true => ask(&Loop::after(Arc::clone(drive), &[*pose])?.viewpoint()?),
        false => ask(&drive.from_pose(frame, pose)?),
    }
}

/// Range of each pixel (m), line by line.
pub(crate) fn ranges(truth: &Truth) -> &[f32] {
    let range = TruthItem::Range.name();
    match truth.planes.iter().find(|plane| plane.name == range).map(|plane| &plane.values) {
        Some(Codes::Numbers(numbers)) => numbers,
        _ => &[],
    }
}

/// Pixels of each label that the picture shows, where the plane is there.
pub(crate) fn labels(truth: &Truth) -> Option<BTreeMap<String, u64>> {
    let plane = truth.planes.iter().find(|plane| plane.name == TruthItem::Label.name())?;
    let Codes::Codes(codes) = &plane.values else { return None };
    let mut counts = BTreeMap::new();
    for code in codes {
        let word = Label::of_code(*code).map_or("unknown", Label::name);
        *counts.entry(word.to_owned()).or_default() += 1;
    }
    Some(counts)
}

/// Why a pose was not taken: a word for the count, and a sentence.
pub(crate) type Refusal = (&'static str, String);

pub(crate) fn reason(why: &Unplaced) -> Refusal {
    match why {
        Unplaced::Pose(PoseFault::Outside { .. }) => ("outside", "the vehicle is outside the ground".into()),
        Unplaced::Pose(PoseFault::NoData { .. }) => {
            ("no-data", "the survey has no data under a wheel".into())
        }
        Unplaced::Pose(PoseFault::EyeUnderGround { eye, ground }) => {
            ("under-ground", format!("the eye is at {eye} m and the ground at {ground} m"))
        }
        Unplaced::Pose(PoseFault::NotDriven) => ("not-driven", "no row of this time was driven".into()),
        Unplaced::Pose(PoseFault::Tilt { what, .. }) => ("tilt", format!("a {what} that no vehicle has")),
        Unplaced::Steep { found_deg, most_deg } => {
            ("steep", format!("ground of {found_deg:.1} degrees, the vehicle climbs {most_deg:.1}"))
        }
        Unplaced::Number(error) => ("number", error.to_string()),
    }
}
