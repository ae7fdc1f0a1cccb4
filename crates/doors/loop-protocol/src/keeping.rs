//! The requests `state`, `restore` and `record`.

use std::sync::Arc;

use diagnostics::Problem;
use drive::{DriveError, Loop, SavedFile};
use limits::Limit;
use serde_json::{Value, json};

use crate::keys::{Keys, NAME};
use crate::session::{Held, Reply};
use crate::state::{STATE, State};
use crate::{Home, Message, Plane, Session};

/// File of the hashes and settings beside a recorded scenario.
const RECORD: &str = "record.json";

impl<H: Home> Session<H> {
    pub(crate) fn state(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let frames = keys.whole("frames");
        keys.finish()?;
        let program = self.home.program();
        let held = self.held()?;
        let frames = expect_driven(held, frames)?;
        let state = State::bytes(held, frames, &held.drive.identity(&program));
        let ok = json!({ "frames": frames });
        Ok(Reply { ok, planes: vec![Plane::of_file(STATE, state)] })
    }

    pub(crate) fn restore(&mut self, keys: Keys, request: &Message) -> Result<Reply, DriveError> {
        keys.finish()?;
        let state = State::of(request)?;
        let drive = Arc::new(self.home.open(&state.opening)?);
        state.expect_of(&drive.identity(&self.home.program()))?;
        let State { opening, poses, log, .. } = state;
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
        let kept = self.home.keep(&held.driven, name.as_deref(), std::slice::from_ref(&record))?;
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
