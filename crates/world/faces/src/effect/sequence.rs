//! Sequences of a list: faces that follow one another in the file take turns.

use diagnostics::{Problem, Reader, nearest};

use crate::error::FaceError;
use crate::sequence::{Drive, Mode, Sequence};

/// Faces of a sequence by number in the file: `members` times `each` of them from `first`.
#[derive(Debug)]
pub(super) struct Turns {
    first: usize,
    members: usize,
    each: usize,
    frames: u64,
    start: i64,
    mode: Mode,
}

impl Turns {
    /// The sequence, by numbers of the mesh; a face that was left out shows nothing in its turn.
    pub fn of_faces(self, kept: &[Option<usize>]) -> Result<Sequence<Vec<usize>>, FaceError> {
        // Asked before a list of so many is made.
        let there = kept.len().saturating_sub(self.first) / self.each;
        if there < self.members {
            return Err(FaceError::MissingMember { missing: there, members: self.members });
        }
        let faces = kept[self.first..].chunks(self.each);
        let members = faces.take(self.members).map(|faces| Some(faces.iter().copied().flatten().collect()));
        Sequence::new(members.collect(), self.frames, self.start, self.mode)
    }
}

/// The sequences of a list.
pub(super) fn sequences(table: &Reader, signals: &[&str]) -> Option<Vec<Turns>> {
    let tables = table.tables("sequence");
    let read: Vec<Option<Turns>> = tables.iter().map(|table| sequence(table, signals)).collect();
    read.into_iter().collect()
}

/// Largest number of members, and of faces of one: no list has more.
const MOST: usize = 1 << 28;

fn sequence(table: &Reader, signals: &[&str]) -> Option<Turns> {
    let first = table.usize("first").at_most(MOST).default(0);
    let members = table.usize("members").between(1, MOST).required();
    let each = table.usize("each").between(1, MOST).default(1);
    let start = table.i64("start").default(0);
    let words = [("cycle", 0), ("once", 1), ("ping-pong", 2), ("driven", 3)];
    let Some(word) = table.one_of("mode", &words).default(0) else {
        ["frames", "signal", "low", "step"].iter().for_each(|key| table.know(key));
        return None;
    };
    let (frames, mode) = match word {
        0 => (frames(table), Some(Mode::Cycle)),
        1 => (frames(table), Some(Mode::Once)),
        2 => (frames(table), Some(Mode::PingPong)),
        _ => (Some(1), drive(table, signals).map(Mode::Driven)),
    };
    let turns =
        Turns { first: first?, members: members?, each: each?, frames: frames?, start: start?, mode: mode? };
    Some(turns)
}

fn frames(table: &Reader) -> Option<u64> {
    table.u64("frames").at_least(1).required()
}

fn drive(table: &Reader, signals: &[&str]) -> Option<Drive> {
    let signal = table.string("signal").required();
    let low = table.f64("low").required();
    let step = table.f64("step").must("not 0", |step| *step != 0.0).required();
    let signal = signal?;
    if !signals.contains(&signal.as_str()) {
        let title = format!("there is no signal `{signal}`");
        let problem = table.problem("signal", title).found(&signal);
        let problem = problem.expected(format!("one of {}", signals.join(", ")));
        let help = nearest(&signal, signals).map(|signal| format!("did you mean `{signal}`?"));
        table.report(Problem { help, ..problem });
        return None;
    }
    Some(Drive { signal, low: low?, step: step? })
}
