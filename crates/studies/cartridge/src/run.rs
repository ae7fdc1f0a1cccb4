//! Running a cartridge: right on everything that an answer holds for, and wrong under every overlay that must show.

use crate::engine::Engine;
use crate::file::{Cartridge, CartridgeError, Expect};
use crate::outcome::{Answer, Outcome, OverlayOutcome};
use crate::reading::Reading;
use crate::scene::Case;

impl Cartridge {
    /// Runs it, by the threads of the current rayon pool.
    ///
    /// # Errors
    /// A scene that cannot be drawn, or a reading that finds nothing to read.
    pub fn run(&self) -> Result<Outcome, CartridgeError> {
        let refuse = |message: String| CartridgeError { place: self.name.clone(), message };
        let mut answers = Vec::new();
        for engine in self.engines() {
            answers.extend(self.answers(&self.cases, engine).map_err(refuse)?);
        }
        let mut overlays = Vec::new();
        for (overlay, cases) in &self.must_fail {
            for &engine in &overlay.engines {
                let refuse =
                    |message| refuse(format!("under the overlay \"{}\": {message}", overlay.because));
                let answers = self.answers(cases, engine).map_err(refuse)?;
                let noticed = answers.into_iter().filter(|answer| !answer.passed);
                let by: Vec<String> = noticed.map(|answer| answer.reading).collect();
                let because = overlay.because.clone();
                overlays.push(OverlayOutcome { engine, because, caught: !by.is_empty(), by });
            }
        }
        let right = answers.iter().all(|answer| answer.passed);
        let passed = right && overlays.iter().all(|overlay| overlay.caught);
        Ok(Outcome {
            passed,
            name: self.name.clone(),
            title: self.title.clone(),
            runs: self.cases.len(),
            answers,
            overlays,
        })
    }

    /// Every answer that holds for `engine`, if `run` is run in place of what is meant: the worst of all runs.
    fn answers(&self, run: &[Case], engine: Engine) -> Result<Vec<Answer>, String> {
        let expect: Vec<&Expect> =
            self.expect.iter().filter(|expect| expect.engines.contains(&engine)).collect();
        let readings: Vec<&Reading> = expect.iter().map(|expect| &expect.read).collect();
        let mut worst: Vec<Option<Answer>> = vec![None; expect.len()];
        for (meant, run) in self.cases.iter().zip(run) {
            let in_run = |message: String| format!("{}, {}: {message}", engine.word(), run.what());
            let seen = run.run(engine, &readings).map_err(in_run)?;
            for (expect, worst) in expect.iter().zip(&mut worst) {
                let deviation = expect.read.deviation(meant, &seen).map_err(in_run)?;
                if worst.as_ref().is_none_or(|worst| deviation.off > worst.worst_error) {
                    *worst = Some(Answer::new(engine, expect, deviation, &meant.what()));
                }
            }
        }
        Ok(worst.into_iter().flatten().collect())
    }
}
