//! The requests `hello`, `open` and `set`.

use std::sync::Arc;

use diagnostics::Problem;
use drive::{Drive, DriveError, Loop};
use serde_json::{Value, json};

use crate::keys::{Keys, NAME};
use crate::requests::REQUESTS;
use crate::session::{Held, PROTOCOL, Reply};
use crate::{Home, Message, Opening, Session};

impl<H: Home> Session<H> {
    pub(crate) fn hello(&self, keys: Keys) -> Result<Reply, DriveError> {
        keys.finish()?;
        let rows: Vec<Value> = REQUESTS.iter().map(|row| row.json()).collect();
        let version = env!("CARGO_PKG_VERSION");
        let opened = self.held.as_ref().map(facts);
        Ok(json!({ "protocol": PROTOCOL, "version": version, "opened": opened, "do": rows }).into())
    }

    pub(crate) fn open(&mut self, keys: Keys, request: &Message) -> Result<Reply, DriveError> {
        let opening = Opening { scenario: keys.text("scenario"), ..Opening::default() };
        let opening = changed(opening, &keys);
        keys.finish()?;
        self.home.give(&request.planes)?;
        let drive = Arc::new(self.home.open(&opening)?);
        Ok(self.hold(Held::new(drive, opening)))
    }

    pub(crate) fn set(&mut self, keys: Keys) -> Result<Reply, DriveError> {
        let opening = self.held.as_ref().map_or_else(Opening::default, |held| held.opening.clone());
        let opening = changed(opening, &keys);
        keys.finish()?;
        self.held()?;
        let drive = Arc::new(self.home.open(&opening)?);
        let held = self.held()?;
        if held.driven.frames() > 0 {
            expect_one_rate(&held.drive, &drive)?;
        }
        let driven = Loop::after(Arc::clone(&drive), held.driven.poses())?;
        let log = std::mem::take(&mut held.log);
        Ok(self.hold(Held { drive, driven, opening, log }))
    }

    /// Holds what was opened, and tells it.
    pub(crate) fn hold(&mut self, held: Held) -> Reply {
        facts(self.held.insert(held)).into()
    }
}

/// `opening` with the keys that a request has.
fn changed(mut opening: Opening, keys: &Keys) -> Opening {
    opening.machine = keys.changed("machine", opening.machine);
    opening.channel = keys.changed("channel", opening.channel);
    if keys.has("overlays") {
        opening.overlays = keys.texts("overlays");
    }
    for (key, value) in keys.settings("set") {
        match value {
            Some(value) => drop(opening.set.insert(key, value)),
            None => drop(opening.set.remove(&key)),
        }
    }
    opening
}

/// The times of frames that were driven already stay.
fn expect_one_rate(before: &Drive, after: &Drive) -> Result<(), DriveError> {
    let [before, after] = [before, after].map(|drive| drive.raster().update_hz);
    if before == after {
        return Ok(());
    }
    let problem =
        Problem::of_file(NAME, "the update rate changes within a loop").found(format!("{after} Hz"));
    let problem = problem.expected(format!("{before} Hz, as the frames before have it"));
    Err(problem.help("open the scenario anew with this rate").into())
}

/// What is known without drawing.
fn facts(held: &Held) -> Value {
    let (drive, raster) = (&held.drive, held.drive.raster());
    json!({
        "scenario": drive.file(),
        "title": drive.title(),
        "drawn_by": drive.drawn_by(),
        "frames": drive.frames(),
        "columns": raster.columns,
        "lines": raster.lines,
        "sweeps": raster.sweeps,
        "samples": raster.samples,
        "sample_us": raster.sample_us,
        "update_hz": raster.update_hz,
        "remembers_frames": drive.remembers_frames(),
        "remarks": drive.remarks(),
        "set": held.opening.set,
        "driven": held.driven.frames(),
    })
}
