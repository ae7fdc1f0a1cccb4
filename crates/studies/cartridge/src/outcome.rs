//! What came of a cartridge.

use serde::Serialize;

use crate::engine::Engine;
use crate::file::Expect;
use crate::reading::Deviation;

/// What came of a cartridge: its answers, and its overlays.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outcome {
    /// Name of its folder.
    pub name: String,
    /// What the cartridge shows, for people.
    pub title: String,
    /// Whether every answer is right and every overlay is caught.
    pub passed: bool,
    /// Runs of the scene on each engine: models by headings by grounds.
    pub runs: usize,
    /// Each answer on each engine that it holds for.
    pub answers: Vec<Answer>,
    /// Each overlay on each engine on which it must show.
    pub overlays: Vec<OverlayOutcome>,
}

/// One answer on one engine, over all runs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// Engine that ran the scene.
    pub engine: Engine,
    /// Name of the reading.
    pub reading: String,
    /// Where it is farthest off: what and in which run.
    pub place: String,
    /// Value found there; null in JSON if it is no number.
    pub found: f64,
    /// Value that was expected there.
    pub expected: f64,
    /// How far off, in the unit of the tolerance; null in JSON where nothing could be compared.
    pub worst_error: f64,
    /// How far off it may be.
    pub tolerance: f64,
    /// Error over tolerance: 1 uses all of it. 0 where both are 0.
    pub tolerance_used: f64,
    /// Why it may be off so far.
    pub because: String,
    /// Where the expected value comes from.
    pub derivation: String,
    /// Whether it is right.
    pub passed: bool,
}

/// One overlay on one engine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OverlayOutcome {
    /// Engine that ran the changed scene.
    pub engine: Engine,
    /// What the overlay changes.
    pub because: String,
    /// Whether an answer noticed.
    pub caught: bool,
    /// The answers that did.
    pub by: Vec<String>,
}

/// What a page needs to know of many cartridges.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Number of cartridges that ran.
    pub cartridges: usize,
    /// Those that passed: every answer right, every overlay caught.
    pub passed: usize,
    /// Answers, each engine by itself.
    pub answers: usize,
    /// Largest share of a tolerance that an answer used; null in JSON if one is infinitely far off.
    pub worst_tolerance_used: f64,
    /// Its cartridge, reading and engine.
    pub worst: String,
    /// Overlays, each engine by itself.
    pub overlays: usize,
    /// Those that an answer noticed.
    pub overlays_caught: usize,
}

impl Answer {
    pub(crate) fn new(engine: Engine, expect: &Expect, deviation: Deviation, run: &str) -> Self {
        let Deviation { what, found, expected, off } = deviation;
        let tolerance = expect.tolerance;
        Self {
            engine,
            reading: expect.read.label(),
            place: format!("{what}, {run}"),
            found,
            expected,
            worst_error: off,
            tolerance,
            tolerance_used: if off == 0.0 { 0.0 } else { off / tolerance },
            because: expect.because.clone(),
            derivation: expect.derivation.clone(),
            passed: off <= tolerance,
        }
    }
}

impl Outcome {
    /// What is wrong, a line each; nothing if it passed.
    pub fn faults(&self) -> Vec<String> {
        let wrong = self.answers.iter().filter(|answer| !answer.passed).map(|answer| {
            let Answer { engine, reading, place, found, expected, worst_error, tolerance, .. } = answer;
            format!(
                "{}, {reading} on {}: {place}: found {found}, expected {expected}, off by {worst_error:e}, allowed \
                 {tolerance:e}",
                self.name,
                engine.word(),
            )
        });
        let missed = self.overlays.iter().filter(|overlay| !overlay.caught);
        let missed = missed.map(|overlay| {
            format!("{} does not notice on {}: {}", self.name, overlay.engine.word(), overlay.because)
        });
        wrong.chain(missed).collect()
    }
}

impl Summary {
    /// Returns the summary of some outcomes.
    pub fn of(outcomes: &[Outcome]) -> Self {
        let answers = || outcomes.iter().flat_map(|one| one.answers.iter().map(move |answer| (one, answer)));
        let overlays = || outcomes.iter().flat_map(|one| &one.overlays);
        let worst = answers().max_by(|a, b| a.1.tolerance_used.total_cmp(&b.1.tolerance_used));
        Self {
            cartridges: outcomes.len(),
            passed: outcomes.iter().filter(|outcome| outcome.passed).count(),
            answers: answers().count(),
            worst_tolerance_used: worst.map_or(0.0, |(_, answer)| answer.tolerance_used),
            worst: worst.map_or(String::new(), |(outcome, answer)| {
                format!("{}, {} on {}", outcome.name, answer.reading, answer.engine.word())
            }),
            overlays: overlays().count(),
            overlays_caught: overlays().filter(|overlay| overlay.caught).count(),
        }
    }
}
