//! The requests `state`, `restore` and `record`.

use std::sync::Arc;

use diagnostics::Problem;
use drive::{DriveError, EyePose, Loop, SavedFile};
use limits::Limit;
use serde_json::{Value, json};

use crate::keys::{Keys, NAME};
use crate::log::{Log, Stretch};
use crate::session::{Held, Reply};
use crate::{Home, Message, Opening, Plane, Session};

/// Schema of a state.
const SCHEMA: &str = "lunoid.loop.state/1";

/// Plane of a state.
const STATE: &str = "state";

/// File of the hashes and settings beside a recorded scenario.
const RECORD: &str = "record.json";

impl<H: Home> Session<H> {
    pub(crate) fn state(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let frames = keys.whole("frames");
        keys.finish()?;
        let held = self.held()?;
        let frames = expect_driven(held, frames)?;
        let state = state_json(held, frames).to_string().into_bytes();
        let ok = json!({ "frames": frames });
        Ok(Reply { ok, planes: vec![Plane::of_file(STATE, state)] })
    }

    pub(crate) fn restore(&mut self, keys: Keys, request: &Message) -> Result<Reply, DriveError> {
        keys.finish()?;
        let State { opening, poses, log } = State::of(request).ok_or_else(|| no_state(request))?;
        let drive = Arc::new(self.home.open(&opening)?);
        let driven = Loop::after(Arc::clone(&drive), &poses)?;
        Ok(self.hold(Held { drive, driven, opening, log }))
    }

    pub(crate) fn record(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let read = |value: &Value| value.as_str().filter(|name| is_name(name)).map(str::to_owned);
        let name = keys.optional("name", "a name of letters, digits, `-` and `_`", read);
        keys.finish()?;
        let held = self.held.as_ref().ok_or_else(|| {
            DriveError::from(Problem::of_file(NAME, "nothing is opened").expected("a request `open` before"))
        })?;
        let record = format!("{:#}\n", held.log.record());
        let record = SavedFile { name: RECORD.into(), bytes: record.into_bytes() };
        let name = name.unwrap_or_else(|| "drive".into());
        let kept = self.home.keep(&held.driven, &name, std::slice::from_ref(&record))?;
        let frames = held.driven.frames();
        if let Some(folder) = kept {
            return Ok(json!({ "frames": frames, "folder": folder }).into());
        }
        let files = held.driven.saved()?.into_iter().chain([record]);
        let planes: Vec<Plane> = files.map(|file| Plane::of_file(file.name, file.bytes)).collect();
        expect_room(&planes)?;
        let names: Vec<&str> = planes.iter().map(Plane::name).collect();
        let ok = json!({ "frames": frames, "files": names });
        Ok(Reply { ok, planes })
    }
}

/// Whether a folder may have this name.
fn is_name(name: &str) -> bool {
    let is_in_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '-' || letter == '_';
    !name.is_empty() && name.len() <= 64 && name.chars().all(is_in_name)
}

fn expect_room(planes: &[Plane]) -> Result<(), DriveError> {
    let bytes = planes.iter().map(|plane| plane.bytes().len() as u64).sum();
    if Limit::PlaneBytes.allows(bytes) {
        return Ok(());
    }
    let problem =
        Problem::of_file(NAME, "the files are too long for a message").found(format!("{bytes} bytes"));
    let problem = problem.expected(format!("at most {} bytes", Limit::PlaneBytes.value()));
    Err(problem.help(Limit::PlaneBytes.to_string()).into())
}

/// Everything with which a loop goes on.
struct State {
    opening: Opening,
    poses: Vec<EyePose>,
    log: Log,
}

impl State {
    /// The state of a request; `None` if it has none.
    fn of(request: &Message) -> Option<Self> {
        let [plane] = &request.planes[..] else { return None };
        let bytes = Some(plane.values::<u8>()?).filter(|_| plane.name() == STATE)?;
        let state: Value = serde_json::from_slice(&bytes).ok()?;
        let of = |key: &str| state.get(key)?.as_array();
        let text = |value: &Value| value.as_str().map(str::to_owned);
        let hashes: Vec<String> = of("pixels_blake3")?.iter().map(text).collect::<Option<_>>()?;
        let poses: Vec<EyePose> = of("poses")?.iter().map(pose).collect::<Option<_>>()?;
        let stretches: Vec<Stretch> = of("stretches")?.iter().map(stretch).collect::<Option<_>>()?;
        let is_whole = state.get("schema")? == SCHEMA && hashes.len() == poses.len();
        let begins = stretches.first().map_or(poses.len() as u64, |stretch| stretch.from) == 0;
        let ascends = stretches.windows(2).all(|pair| pair[0].from < pair[1].from);
        let ends = stretches.last().is_none_or(|last| last.from < poses.len() as u64);
        let opening = Opening::of_json(state.get("opening")?)?;
        (is_whole && begins && ascends && ends).then_some(Self {
            opening,
            poses,
            log: Log { hashes, stretches },
        })
    }
}

/// The number of frames that a state is asked to have; all that were driven if none is asked for.
fn expect_driven(held: &Held, frames: Option<u64>) -> Result<usize, DriveError> {
    let driven = held.driven.frames();
    let frames = frames.unwrap_or(driven);
    if frames <= driven {
        return Ok(frames as usize);
    }
    let problem = Problem::of_file(NAME, "the loop has driven fewer frames").key("frames");
    Err(problem.found(frames.to_string()).expected(format!("at most {driven}")).into())
}

/// The state after the first `frames` frames, with the settings of now.
fn state_json(held: &Held, frames: usize) -> Value {
    let pose = |pose: &EyePose| {
        let EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg } = *pose;
        json!([time_s, x, y, z, heading_deg, pitch_deg, roll_deg, yoke_deg])
    };
    let stretch = |stretch: &Stretch| json!({ "from": stretch.from, "opening": stretch.opening.json(), "options": stretch.options });
    let stretches = held.log.stretches.iter().filter(|stretch| stretch.from < frames as u64);
    json!({
        "schema": SCHEMA,
        "opening": held.opening.json(),
        "poses": held.driven.poses()[..frames].iter().map(pose).collect::<Vec<_>>(),
        "pixels_blake3": held.log.hashes[..frames],
        "stretches": stretches.map(stretch).collect::<Vec<_>>(),
    })
}

fn pose(value: &Value) -> Option<EyePose> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    let [time_s, x, y, z, heading_deg, pitch_deg, roll_deg, yoke_deg] = numbers[..] else { return None };
    Some(EyePose { time_s, eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, yoke_deg })
}

fn stretch(value: &Value) -> Option<Stretch> {
    let options = value.get("options")?.as_array()?.iter();
    Some(Stretch {
        from: value.get("from")?.as_u64()?,
        opening: Opening::of_json(value.get("opening")?)?,
        options: options.map(|word| word.as_str().map(str::to_owned)).collect::<Option<_>>()?,
    })
}

fn no_state(request: &Message) -> DriveError {
    let names: Vec<&str> = request.planes.iter().map(Plane::name).collect();
    let found = if names.is_empty() { "no plane".into() } else { format!("planes {}", names.join(", ")) };
    let problem = Problem::of_file(NAME, "the request has no state that `state` has handed out");
    let problem = problem.found(found).expected("one plane `state`, unchanged");
    problem.into()
}
