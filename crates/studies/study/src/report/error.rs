//! Error against run time, as text, document, tables and plots.

use std::path::Path;

use serde_json::{Value, json};

use super::folder::{ReportError, write};
use super::ladder_plots::write_plots;
use crate::advice::Advice;
use crate::fronts::Front;
use crate::ladder::{EXACT, LadderOutcome, OrderOutcome};
use crate::reference::SelfError;
use crate::{csv, table};

/// How near a measured order must come to theory.
const WITHIN: f64 = 0.2;

/// What came of a study of errors.
pub struct ErrorReport {
    /// Commit of the program.
    pub commit: String,
    /// Title of the scenario.
    pub title: String,
    /// Frames that were looked at.
    pub frames: Vec<u64>,
    /// Number of threads that drew.
    pub threads: usize,
    /// How far `exact` is from itself with its limits halved.
    pub exact: SelfError,
    /// Ladders, each with its rungs.
    pub ladders: Vec<LadderOutcome>,
    /// Cheapest setting for each wanted error.
    pub advice: Vec<Advice>,
    /// Settings that nothing beats, by each of two errors.
    pub fronts: Vec<Front>,
    /// What the build leaves out, where it was asked for.
    pub not_built: Option<&'static str>,
}

impl ErrorReport {
    /// Leaves `error.json`, `error.csv`, `error.md` and plots in `folder`.
    ///
    /// # Errors
    /// If the folder cannot be made, or a file not be written.
    pub fn leave(&self, folder: &Path) -> Result<(), ReportError> {
        write(folder, "error", &self.json(), &csv(&self.ladders), &self.page())?;
        write_plots(folder, &self.facts(), &self.ladders)
    }

    /// A document of schema `lunoid.study-error/1`.
    pub fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-error/1",
            "commit": self.commit,
            "title": self.title,
            "frames": self.frames,
            "threads": self.threads,
            "exact": self.exact,
            "ladders": self.ladders,
            "advice": self.advice,
            "fronts": self.fronts,
            "not_built": self.not_built,
        })
    }

    fn facts(&self) -> String {
        let commit = &self.commit;
        format!(
            "{}, {}, {} threads, commit {commit}",
            self.title,
            text::named_frames(&self.frames),
            self.threads
        )
    }

    /// Returns the outcome as tables for people.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n{}\n", self.facts(), self.exact.sentence());
        for ladder in &self.ladders {
            text += &format!(
                "\n{}: {}{}\n{}",
                ladder.name,
                ladder.what,
                against(ladder),
                text::table(&table(ladder))
            );
            ladder.orders.iter().for_each(|order| text += &format!("  {}\n", order_words(order)));
        }
        text += "\n";
        self.advice.iter().for_each(|advice| text += &format!("{}\n", advice.sentence()));
        self.fronts.iter().for_each(|front| text += &format!("{}\n", front.sentence()));
        self.not_built.iter().for_each(|what| text += &format!("{what}\n"));
        text
    }

    /// The same as a page of Markdown.
    fn page(&self) -> String {
        let mut text = format!("{}. {}\n", self.facts(), self.exact.sentence());
        for ladder in &self.ladders {
            let (name, what, against) = (ladder.name, ladder.what, against(ladder));
            text += &format!("\n### {what}{against}\n\n![{name} against time]({name}.svg)\n\n");
            text += &text::markdown(&table(ladder));
            ladder.orders.iter().for_each(|order| text += &format!("\n{}\n", order_words(order)));
        }
        text += "\n";
        self.advice.iter().for_each(|advice| text += &format!("- {}\n", advice.sentence()));
        self.fronts.iter().for_each(|front| text += &format!("- {}\n", front.sentence()));
        self.not_built.iter().for_each(|what| text += &format!("- {what}\n"));
        text
    }
}

/// What the errors of a ladder are against, if that is not `exact`.
fn against(ladder: &LadderOutcome) -> String {
    if ladder.against == EXACT { String::new() } else { format!(", against {}", ladder.against) }
}

fn order_words(order: &OrderOutcome) -> String {
    let expected = &order.expected;
    let theory = format!("theory says {} ({})", expected.order, expected.why);
    match order.measured {
        Some(found) => format!(
            "{}: order {:.2} over {} rungs, {theory}: {}",
            expected.error,
            found.slope,
            found.rungs,
            if order.agrees(WITHIN) { "agrees" } else { "differs" }
        ),
        None => format!("{}: no straight part; {theory}", expected.error),
    }
}
