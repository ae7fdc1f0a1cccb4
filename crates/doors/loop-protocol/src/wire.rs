//! Messages as bytes: read from anybody, bounded before anything is taken up.

use std::io::{self, Read, Write};

use diagnostics::{Problem, ProblemList, Problems};
use limits::Limit;
use serde_json::Value;

use crate::listing::{Listed, listed};
use crate::message::{MAGIC, PREFIX};
use crate::{Message, Plane};

/// What a problem of the bytes of a message names as its file.
const NAME: &str = "message";

/// Bytes that are taken up at most before as many have come.
const FIRST: u64 = 1 << 16;

/// Why no message could be read.
#[derive(Debug)]
pub enum WireError {
    /// The other side cannot be read any more.
    Io(io::Error),
    /// The bytes are no message. What follows them cannot be told apart.
    Problems(ProblemList),
    /// The bytes of a message are all there, and its header is faulty. The next message can be read.
    Faulty {
        /// The `id` of the message; null if it has none.
        id: Value,
        /// Every fault of the header.
        problems: ProblemList,
    },
}

impl From<Problem> for WireError {
    fn from(problem: Problem) -> Self {
        Self::Problems(problem.into())
    }
}

impl std::fmt::Display for WireError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Io(error) => error.fmt(f),
            Self::Problems(list) | Self::Faulty { problems: list, .. } => list.fmt(f),
        }
    }
}

impl std::error::Error for WireError {}

impl Message {
    /// Reads the next message of `from`; `None` where nothing follows.
    ///
    /// # Errors
    /// If reading fails, the bytes are no message, they are longer than the limits `header-bytes` and `plane-bytes` allow, or something is
    /// wrong in them.
    pub fn read(from: &mut impl Read) -> Result<Option<Self>, WireError> {
        let prefix = take(from, PREFIX as u64)?;
        if prefix.is_empty() {
            return Ok(None);
        }
        let [header, planes] = lengths(&prefix)?;
        let text = take(from, header)?;
        expect_whole("header", text.len() as u64, header)?;
        let (mut message, listed) = match opened(&text, planes) {
            Ok(opened) => opened,
            Err((id, problems)) => {
                pass_over(from, planes)?;
                return Err(WireError::Faulty { id, problems });
            }
        };
        for Listed { name, dtype, shape, count } in listed {
            let bytes = take(from, count)?;
            expect_whole(&format!("plane `{name}`"), bytes.len() as u64, count)?;
            message.planes.push(Plane::of_bytes(name, dtype, &shape, bytes));
        }
        Ok(Some(message))
    }

    /// Reads the message that `bytes` are.
    ///
    /// # Errors
    /// As [`read`](Self::read); or if there is none, or something follows it.
    pub fn decode(bytes: &[u8]) -> Result<Self, WireError> {
        let mut rest = bytes;
        let message = Self::read(&mut rest)?;
        let Some(message) = message else { return Err(cut("prefix", 0, PREFIX as u64).into()) };
        if rest.is_empty() {
            return Ok(message);
        }
        let problem = Problem::of_file(NAME, "something follows the message");
        Err(problem.found(format!("{} bytes more", rest.len())).expected("one message").into())
    }

    /// Writes the message to `to`.
    ///
    /// # Errors
    /// If writing fails.
    pub fn write(&self, to: &mut impl Write) -> io::Result<()> {
        to.write_all(&self.head())?;
        self.planes.iter().try_for_each(|plane| to.write_all(plane.bytes()))?;
        to.flush()
    }
}

/// `count` bytes, or as many as come. Memory grows with what comes, not with what is claimed.
fn take(from: &mut impl Read, count: u64) -> Result<Vec<u8>, WireError> {
    let mut bytes = Vec::with_capacity(count.min(FIRST) as usize);
    from.take(count).read_to_end(&mut bytes).map_err(WireError::Io)?;
    Ok(bytes)
}

/// Passes over the planes of a message that is not taken up.
fn pass_over(from: &mut impl Read, planes: u64) -> Result<(), WireError> {
    let passed = io::copy(&mut from.take(planes), &mut io::sink()).map_err(WireError::Io)?;
    expect_whole("planes", passed, planes)
}

/// The message of a header without its planes, and their list; or the `id` of the header and what is wrong with it.
fn opened(text: &[u8], planes: u64) -> Result<(Message, Vec<Listed>), (Value, ProblemList)> {
    let mut message = Message::new(object(text).map_err(|problems| (Value::Null, problems))?);
    match listed(NAME, &mut message.header, planes) {
        Ok(listed) => Ok((message, listed)),
        Err(problems) => Err((message.id(), problems)),
    }
}

fn cut(what: &str, found: u64, whole: u64) -> Problem {
    let problem = Problem::of_file(NAME, format!("the message ends within its {what}"));
    problem.found(format!("{found} bytes")).expected(format!("{whole} bytes"))
}

fn expect_whole(what: &str, found: u64, whole: u64) -> Result<(), WireError> {
    if found == whole { Ok(()) } else { Err(cut(what, found, whole).into()) }
}

/// Bytes of the header and of all planes.
fn lengths(prefix: &[u8]) -> Result<[u64; 2], WireError> {
    let magic = &prefix[..prefix.len().min(MAGIC.len())];
    if magic != &MAGIC[..magic.len()] {
        let problem = Problem::of_file(NAME, "the bytes are no message of lunoid.loop/1");
        let problem = problem.found(format!("`{}`", magic.escape_ascii()));
        return Err(problem.expected(format!("`{}`", MAGIC.escape_ascii())).into());
    }
    expect_whole("prefix", prefix.len() as u64, PREFIX as u64)?;
    let number = |at: usize| {
        let mut bytes = [0; 8];
        bytes.copy_from_slice(&prefix[at..at + 8]);
        u64::from_le_bytes(bytes)
    };
    let lengths = [number(8), number(16)];
    let problems = Problems::new();
    for (what, length, limit) in
        [("header", lengths[0], Limit::HeaderBytes), ("planes", lengths[1], Limit::PlaneBytes)]
    {
        if !limit.allows(length) {
            let problem = Problem::of_file(NAME, format!("the {what} would be too long"));
            let problem = problem.found(format!("{length} bytes"));
            problems
                .push(problem.expected(format!("at most {} bytes", limit.value())).help(limit.to_string()));
        }
    }
    problems.into_result().map_err(WireError::Problems)?;
    Ok(lengths)
}

/// The header as JSON.
fn object(bytes: &[u8]) -> Result<Value, ProblemList> {
    let problem = |title: String| Problem::of_file(NAME, title).expected("one JSON object in UTF-8");
    match text::read_json(bytes) {
        Ok(Value::Object(header)) => Ok(Value::Object(header)),
        Ok(other) => Err(problem("the header is no object".into()).found(kind(&other)).into()),
        Err(error) => Err(problem(format!("the header is no JSON: {error}")).into()),
    }
}

/// What a JSON value is, in words.
pub(crate) fn kind(value: &Value) -> String {
    match value {
        Value::Null => "null".into(),
        Value::Bool(truth) => truth.to_string(),
        Value::Number(number) => number.to_string(),
        Value::String(text) => format!("{text:?}"),
        Value::Array(list) => format!("an array of {}", list.len()),
        Value::Object(_) => "an object".into(),
    }
}
