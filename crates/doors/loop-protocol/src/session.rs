//! A session: an opened drive with its loop, and the answer to each request.

use std::sync::Arc;

use diagnostics::{Problem, nearest};
use drive::{Drive, DriveError, Fault, Loop};
use serde_json::{Value, json};

use crate::keys::{Keys, NAME};
use crate::log::Log;
use crate::requests::REQUESTS;
use crate::{Home, Message, Opening, Plane, RequestRow, WireError};

/// Name of the protocol.
pub const PROTOCOL: &str = "lunoid.loop/1";

/// Whoever answers requests: one drive, one loop.
pub struct Session<H> {
    pub(crate) home: H,
    pub(crate) held: Option<Held>,
}

/// The drive that is opened, with its loop.
pub(crate) struct Held {
    pub drive: Arc<Drive>,
    pub driven: Loop,
    /// What was asked for, with the settings that were made since.
    pub opening: Opening,
    pub log: Log,
}

impl Held {
    /// `drive` as `opening` asked for it; nothing driven yet.
    pub fn new(drive: Arc<Drive>, opening: Opening) -> Self {
        Self { driven: Loop::new(Arc::clone(&drive)), drive, opening, log: Log::default() }
    }
}

/// Answer to a request.
pub(crate) struct Reply {
    pub ok: Value,
    pub planes: Vec<Plane>,
}

impl From<Value> for Reply {
    fn from(ok: Value) -> Self {
        Self { ok, planes: Vec::new() }
    }
}

impl<H: Home> Session<H> {
    /// A session with nothing opened.
    pub fn new(home: H) -> Self {
        Self { home, held: None }
    }

    /// A session with `drive` opened, as an [`Opening`] without any wish opens it.
    pub fn with(home: H, drive: Arc<Drive>) -> Self {
        Self { home, held: Some(Held::new(drive, Opening::default())) }
    }

    /// Answers a request. The same requests have the same answers, to the byte.
    pub fn answer(&mut self, request: &Message) -> Message {
        let id = request.id();
        match self.reply(request) {
            Ok(Reply { ok, planes }) => Message::new(json!({ "id": id, "ok": ok })).with(planes),
            Err(error) => refusal(id, error.faults()),
        }
    }

    /// Answers the request that `bytes` are.
    pub fn answer_bytes(&mut self, bytes: &[u8]) -> Vec<u8> {
        match Message::decode(bytes) {
            Ok(request) => self.answer(&request).encode(),
            Err(error) => unreadable(&error).encode(),
        }
    }

    fn reply(&mut self, request: &Message) -> Result<Reply, DriveError> {
        let row = asked(request)?;
        let keys = Keys::of(request, row);
        match row.name {
            "hello" => self.hello(keys),
            "open" => self.open(keys, request),
            "frame" => self.frame(keys),
            "look" => self.look(keys),
            "step" => self.step(keys),
            "ahead" => self.ahead(keys),
            "set" => self.set(keys),
            "state" => self.state(keys),
            "restore" => self.restore(keys, request),
            "record" => self.record(keys),
            "probe" => self.probe(keys),
            "explain" => self.explain(keys),
            "events" => self.events(keys),
            "trigger" => self.trigger(keys),
            "effect" => self.effect(keys),
            "timing" => self.timing(keys),
            "omissions" => self.omissions(keys),
            "signals" => self.signals(keys),
            "blocks" => self.blocks(keys),
            "parameters" => self.parameters(keys),
            "faults" => self.faults(keys),
            _ => self.planes(keys),
        }
    }

    /// The drive that is opened, or why there is none.
    pub(crate) fn held(&mut self) -> Result<&mut Held, DriveError> {
        let problem = || {
            let problem = Problem::of_file(NAME, "nothing is opened").expected("a request `open` before");
            DriveError::from(problem)
        };
        self.held.as_mut().ok_or_else(problem)
    }
}

/// The row of a request.
fn asked(request: &Message) -> Result<&'static RequestRow, DriveError> {
    let word = request.header.get("do").and_then(Value::as_str);
    if let Some(row) = word.and_then(RequestRow::find) {
        return Ok(row);
    }
    let names = REQUESTS.map(|row| row.name);
    let problem = match word {
        Some(word) => Problem::of_file(NAME, format!("no request `{word}`")).found(word),
        None => Problem::of_file(NAME, "a request without a word under `do`"),
    };
    let problem = problem.key("do").expected(format!("one of {}", names.join(", ")));
    let meant = word.and_then(|word| nearest(word, &names));
    Err(match meant {
        Some(meant) => problem.help(format!("did you mean `{meant}`?")).into(),
        None => problem.into(),
    })
}

/// The answer to bytes that are no message, or a faulty one.
pub fn unreadable(error: &WireError) -> Message {
    match error {
        WireError::Faulty { id, problems } => refusal(id.clone(), problems.records()),
        WireError::Problems(list) => refusal(Value::Null, list.records()),
        WireError::Io(error) => {
            refusal(Value::Null, vec![Problem::of_file("message", error.to_string()).record()])
        }
    }
}

/// The answer that nothing was done.
pub fn refusal(id: Value, faults: Vec<Fault>) -> Message {
    let problem = |fault: Fault| {
        let Fault { file, line, column, key, title, found, expected, help } = fault;
        json!({ "file": file, "line": line, "column": column, "key": key, "title": title, "found": found,
                "expected": expected, "help": help })
    };
    let problems: Vec<Value> = faults.into_iter().map(problem).collect();
    Message::new(json!({ "id": id, "error": { "problems": problems } }))
}
