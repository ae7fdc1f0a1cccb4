//! A home with a tiny scene, and what its session answers.

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use drive::{Drive, DriveError, EyePose, Program, Wishes};
use loop_protocol::{Home, Message, Opening, Plane, Session};
use serde_json::{Value, json};
use tempfile::TempDir;

/// The scene that the tests of `drive` have.
const SCENARIO: &str = include_str!("../../../drive/tests/scene.toml");

/// Opens one scenario, whatever is asked for.
pub struct Scene {
    folder: Arc<TempDir>,
    base: Wishes,
    version: Option<&'static str>,
}

impl Scene {
    /// The scene drawn by `machine`.
    pub fn by(machine: &str) -> Self {
        let folder = Arc::new(tempfile::tempdir().unwrap());
        let base = Wishes { machine: Some(machine.into()), ..Wishes::default() };
        fs::write(folder.path().join("scene.toml"), SCENARIO).unwrap();
        Self { folder, base, version: None }
    }

    /// The same with other words in the file of the scenario.
    pub fn reworded(self, from: &str, to: &str) -> Self {
        fs::write(self.path(), SCENARIO.replace(from, to)).unwrap();
        self
    }

    /// The same in a program of another version.
    pub fn of_version(self, version: &'static str) -> Self {
        Self { version: Some(version), ..self }
    }

    /// The same with a key that the host sets.
    pub fn setting(mut self, key: &str, value: &str) -> Self {
        self.base.set.push((key.into(), value.into()));
        self
    }

    /// A session that has opened it.
    pub fn session(self) -> Session<Self> {
        let mut session = Session::new(self);
        ok(&mut session, json!({ "do": "open" }));
        session
    }

    /// The same drive without a session.
    pub fn drive(&self) -> Arc<Drive> {
        Arc::new(Drive::open(&self.path(), &self.base, 1).unwrap())
    }

    fn path(&self) -> PathBuf {
        self.folder.path().join("scene.toml")
    }
}

impl Home for Scene {
    fn program(&self) -> Program {
        let [name, commit, result_family] = ["lunoid", "c", "unfused"].map(str::to_owned);
        Program { name, version: self.version.unwrap_or("1.0.0").into(), commit, result_family }
    }

    fn open(&mut self, asked: &Opening) -> Result<Drive, DriveError> {
        Drive::open(&self.path(), &asked.over(&self.base), 1)
    }
}

/// The answer to a request that is given number 7.
pub fn ask(session: &mut Session<Scene>, request: Value) -> Message {
    ask_with(session, request, Vec::new())
}

/// The same with planes.
pub fn ask_with(session: &mut Session<Scene>, mut request: Value, planes: Vec<Plane>) -> Message {
    request["id"] = json!(7);
    let answer = session.answer(&Message::new(request).with(planes));
    assert_eq!(answer.header["id"], 7);
    answer
}

/// What was done; the request must be right.
pub fn ok(session: &mut Session<Scene>, request: Value) -> Value {
    done(&ask(session, request))
}

/// What an answer says was done.
pub fn done(answer: &Message) -> Value {
    assert!(!answer.header.contains_key("error"), "{}", answer.header["error"]);
    answer.header["ok"].clone()
}

/// The problems of a request that must be wrong.
pub fn problems(session: &mut Session<Scene>, request: Value) -> Vec<Value> {
    problems_of(&ask(session, request))
}

/// The problems of an answer.
pub fn problems_of(answer: &Message) -> Vec<Value> {
    assert!(!answer.header.contains_key("ok"), "{}", answer.header["ok"]);
    assert!(answer.planes.is_empty());
    answer.header["error"]["problems"].as_array().unwrap().clone()
}

/// A pose as a request has it.
pub fn pose_json(pose: &EyePose) -> Value {
    let EyePose { eye_m: [x, y, z], heading_deg, pitch_deg, roll_deg, .. } = pose;
    json!({ "x_m": x, "y_m": y, "z_m": z, "heading_deg": heading_deg, "pitch_deg": pitch_deg, "roll_deg": roll_deg })
}
