//! The state of a loop as a sealed document: everything with which the loop goes on, and what it is of.

use diagnostics::Problem;
use drive::{DriveError, EyePose};
use run_record::{differences, is_as_sealed, sealed};
use serde_json::{Value, json};

use crate::keys::NAME;
use crate::log::{Log, Stretch};
use crate::session::Held;
use crate::{Message, Opening, Plane};

/// Schema of a state.
const SCHEMA: &str = "lunoid.loop.state/2";

/// Plane of a state.
pub(crate) const STATE: &str = "state";

/// Everything with which a loop goes on.
pub(crate) struct State {
    /// The settings of the frames to come.
    pub opening: Opening,
    /// Poses that were driven, one a frame.
    pub poses: Vec<EyePose>,
    /// Hashes and settings of these frames.
    pub log: Log,
    /// [`Drive::identity`](drive::Drive::identity) of the drive whose state it is.
    of: Value,
}

impl State {
    /// The bytes of the state of `held` after its first `frames` frames, with the settings of now. `of` is the identity of its drive.
    pub fn bytes(held: &Held, frames: usize, of: &Value) -> Vec<u8> {
        let stretches = held.log.stretches.iter().filter(|stretch| stretch.from < frames as u64);
        let state = json!({
            "schema": SCHEMA,
            "of": of,
            "opening": held.opening.json(),
            "poses": held.driven.poses()[..frames].iter().map(pose_json).collect::<Vec<_>>(),
            "pixels_blake3": held.log.hashes[..frames],
            "stretches": stretches.map(stretch_json).collect::<Vec<_>>(),
        });
        sealed(&state.to_string()).into_bytes()
    }

    /// The state that a request brings.
    ///
    /// # Errors
    /// If the request has no state, or one that was changed since it was handed out.
    pub fn of(request: &Message) -> Result<Self, DriveError> {
        let text = text_of(request)?;
        let state: Value = serde_json::from_str(&text).unwrap_or_default();
        if let Some(other) = state["schema"].as_str().filter(|schema| *schema != SCHEMA) {
            let problem = fault("the state has another schema").found(format!("{other:?}"));
            return Err(problem.expected(format!("{SCHEMA:?}")).help(DRIVE_AGAIN).into());
        }
        if !is_as_sealed(&text) {
            let problem = fault("the state was changed since it was handed out");
            let problem = problem.found("bytes that the seal at their end does not fit");
            return Err(problem.expected("the bytes of the plane `state`, unchanged").into());
        }
        Self::read(&state).ok_or_else(|| {
            let problem = fault("the state does not hold together").found("keys that no state has");
            problem.expected("a state that `state` has handed out").into()
        })
    }

    /// Sees that the state is of the drive whose identity is `own`.
    ///
    /// # Errors
    /// If a file, a setting or the program is another one; the error names what differs.
    pub fn expect_of(&self, own: &Value) -> Result<(), DriveError> {
        let Some(differs) = differences(&self.of, own) else { return Ok(()) };
        let problem = fault("the state is of another scenario, model or program").found(differs);
        let [title, drawn_by] = ["title", "drawn_by"].map(|key| own[key].as_str().unwrap_or_default());
        let [name, version] = ["name", "version"].map(|key| own["program"][key].as_str().unwrap_or_default());
        let expected = format!(
            "a state of {title:?}, drawn by {drawn_by}, {name} {version}, with the files and settings of now"
        );
        Err(problem.expected(expected).help(DRIVE_AGAIN).into())
    }

    fn read(state: &Value) -> Option<Self> {
        let of = |key: &str| state.get(key)?.as_array();
        let hash = |value: &Value| value.as_str().map(str::to_owned);
        let hashes: Vec<String> = of("pixels_blake3")?.iter().map(hash).collect::<Option<_>>()?;
        let poses: Vec<EyePose> = of("poses")?.iter().map(pose).collect::<Option<_>>()?;
        let stretches: Vec<Stretch> = of("stretches")?.iter().map(stretch).collect::<Option<_>>()?;
        let begins = stretches.first().map_or(poses.len() as u64, |stretch| stretch.from) == 0;
        let ascends = stretches.windows(2).all(|pair| pair[0].from < pair[1].from);
        let ends = stretches.last().is_none_or(|last| last.from < poses.len() as u64);
        let opening = Opening::of_json(state.get("opening")?)?;
        (hashes.len() == poses.len() && begins && ascends && ends).then_some(Self {
            opening,
            poses,
            log: Log { hashes, stretches },
            of: state.get("of")?.clone(),
        })
    }
}

/// What to do with a state that is not of here.
const DRIVE_AGAIN: &str = "take the state up where it is of, or drive its poses again here";

fn fault(title: &str) -> Problem {
    Problem::of_file(NAME, title).key("planes")
}

/// The text of the plane of a request that has nothing else.
fn text_of(request: &Message) -> Result<String, DriveError> {
    let bytes = match &request.planes[..] {
        [plane] if plane.name() == STATE => plane.values::<u8>(),
        _ => None,
    };
    let Some(bytes) = bytes else {
        let names: Vec<&str> = request.planes.iter().map(Plane::name).collect();
        let found = if names.is_empty() { "no plane".into() } else { format!("planes {}", names.join(", ")) };
        let problem = fault("the request has no state").found(found);
        return Err(problem.expected("one plane `state` of `u8`, as `state` has handed it out").into());
    };
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn pose_json(pose: &EyePose) -> Value {
    let EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg } = *pose;
    json!([time_s, x, y, z, heading_deg, pitch_deg, roll_deg, yoke_deg])
}

fn pose(value: &Value) -> Option<EyePose> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    let [time_s, x, y, z, heading_deg, pitch_deg, roll_deg, yoke_deg] = numbers[..] else { return None };
    Some(EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg })
}

fn stretch_json(stretch: &Stretch) -> Value {
    json!({ "from": stretch.from, "opening": stretch.opening.json(), "options": stretch.options })
}

fn stretch(value: &Value) -> Option<Stretch> {
    let options = value.get("options")?.as_array()?.iter();
    Some(Stretch {
        from: value.get("from")?.as_u64()?,
        opening: Opening::of_json(value.get("opening")?)?,
        options: options.map(|word| word.as_str().map(str::to_owned)).collect::<Option<_>>()?,
    })
}
