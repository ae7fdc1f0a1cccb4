//! Words that were late, and whether they still are.

use control_plane::{FrameSweeps, LateOf, LoadMiss, LoadedPart};
use serde::Serialize;
use sweep_program::{Event, Load, Miss, MissCause, PreloadRegister, SweepProgram, Target, WordMask};

/// Words that missed the stop they were meant for.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Late {
    /// Level of terrain, `fine` or `coarse`.
    pub level: &'static str,
    /// Fold of that level's ramps in the sweep that found them missing, from 0.
    pub crossing: u32,
    /// Name of the colour whose registers missed them.
    pub colour: &'static str,
    /// Which register was stale.
    pub register: &'static str,
    /// When they were due (samples of the sweep).
    pub due: f64,
    /// When the last one came; none if never.
    pub came: Option<f64>,
    /// Words, bit 3p + q.
    pub words: u16,
    /// Why: `access`, `queue` or `held-back`, as in the timing record.
    pub cause: &'static str,
    /// Whether the hold register is still wrong for them at the sample.
    pub in_force: bool,
}

impl Late {
    /// The fold, with its level where that is not the fine one.
    pub(crate) fn place(&self) -> String {
        let level =
            if self.level == LEVELS[0] { String::new() } else { format!(" of the {} level", self.level) };
        format!("crossing {}{level}", self.crossing)
    }
}

/// Words of a crater or of a shadow boundary that were not there when the sweep met it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LateLoad {
    /// Part into which they are loaded, by its number: `sub-generator.2.0`, `line-generator.3`.
    pub part: String,
    /// Ground range at which the sweep meets the crater's edge, or crosses the boundary (m).
    pub range_m: f64,
    /// When they were due (samples of the sweep).
    pub due: f64,
    /// When the last one came; none if never.
    pub came: Option<f64>,
    /// Number of words that it has.
    pub words: u32,
    /// Why: `access` or `queue`, as in the timing record.
    pub cause: &'static str,
}

impl LateLoad {
    pub(crate) fn of(miss: &LoadMiss) -> Self {
        let &LoadMiss { part, range, due, came, words, cause, .. } = miss;
        Self { part: part.to_string(), range_m: range, due, came, words, cause: cause_name(cause) }
    }
}

/// The late load of a shadow boundary in a sweep, by its line generator and the ground range where the sweep crosses it, which the
/// listing rounds to a centimetre (m); none if no load of that generator was late there.
pub fn boundary_at(sweeps: &FrameSweeps<'_>, sweep: u32, line_generator: u32, range: f64) -> Option<LateOf> {
    const ROUNDED: f64 = 0.01;
    let misses = sweeps.load_misses(sweep).into_iter();
    let of_part = misses.filter(|miss| miss.part == LoadedPart::LineGenerator(line_generator));
    let near = of_part
        .map(|miss| ((miss.range.max(0.0) - range).abs(), miss.of))
        .filter(|(away, _)| *away < ROUNDED);
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, of)| of)
}

fn cause_name(cause: MissCause) -> &'static str {
    match cause {
        MissCause::Access => "access",
        MissCause::Queue => "queue",
        MissCause::HeldBack => "held-back",
    }
}

/// Names of the levels of terrain, the finest first.
pub(crate) const LEVELS: [&str; 2] = ["fine", "coarse"];

/// The misses of the program of a level up to the sample `last`, and whether each is in force at `drawn`.
pub fn late(program: &SweepProgram, level: usize, [drawn, last]: [usize; 2]) -> Vec<Late> {
    let missed = program.misses.iter().filter(|miss| miss.time.0 <= last as f64);
    missed.map(|miss| told(miss, level, in_force(program, miss, drawn))).collect()
}

/// The words that fold `crossing` of a level found missing, as they are at the end of the sweep.
pub(crate) fn late_words(program: &SweepProgram, level: usize, crossing: u32) -> Vec<Late> {
    let missed = program.late_words(crossing);
    missed.iter().map(|miss| told(miss, level, in_force(program, miss, usize::MAX))).collect()
}

fn told(miss: &Miss, level: usize, in_force: bool) -> Late {
    Late {
        level: LEVELS[level],
        crossing: miss.crossing,
        colour: miss.colour.name(),
        register: match miss.register {
            PreloadRegister::XFirst => "x-first",
            PreloadRegister::YFirst => "y-first",
        },
        due: miss.time.0,
        came: miss.arrival.map(|time| time.0),
        words: miss.words.0,
        cause: cause_name(miss.cause),
        in_force,
    }
}

/// Whether nothing has put the hold register right up to `sample`: neither the words themselves nor another transfer.
fn in_force(program: &SweepProgram, miss: &Miss, sample: usize) -> bool {
    let mut waiting = miss.words;
    let since = program.events().skip_while(|step| step.time.0 <= miss.time.0);
    for step in since.take_while(|step| step.sample <= sample) {
        match step.kind {
            Event::Fold(fold) if fold.axis.takes(fold.stop, miss.colour) => return false,
            Event::Load(Load { colour, target: Target::Hold, words, .. }) if colour == miss.colour => {
                waiting = waiting.without(words);
            }
            _ => {}
        }
    }
    waiting != WordMask(0)
}
