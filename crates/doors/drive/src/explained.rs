//! A pixel of a frame: how it came about.

use explain::{Explanation, Inquiry, InquiryError, Late, facts};
use exact::Columns;
use generator::Fact;
use machine::ControlPlane;
use serde_json::Value;

use crate::{Drive, DriveError};

/// An explanation.
#[derive(Debug, Clone, PartialEq)]
pub struct Explained {
    /// The most telling reason: the late word that the pixel still shows, or the first of the reasons.
    pub cause: String,
    /// All reasons in words, most telling first; facts of a generator beside the hybrid machine.
    pub because: Vec<String>,
    /// What the command prints.
    pub text: String,
    /// The document of `lunoid explain --json`, without its schema.
    pub document: Value,
}

impl Drive {
    /// Explains pixel `pixel` (column and line, from 0 at the top left) of frame `frame` of the path.
    ///
    /// # Errors
    /// If there is no such pixel or frame, or the frame cannot be drawn.
    pub fn explain(&self, frame: u64, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        match self.opened.is_machine() {
            true => self.explain_machine(frame, pixel),
            false => self.explain_guest(frame, pixel),
        }
    }

    fn explain_machine(&self, frame: u64, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        let pose = self.seen_from(frame)?;
        let control = self.control.get_or_init(|| ControlPlane::new(self.machine.clone()));
        let exact = self.exact.get_or_init(|| Columns::new(self.stage.clone()));
        let inquiry = Inquiry::new(&self.machine, &*self.session, control, Some(exact));
        let told = self.pool.install(|| inquiry.explain(frame, &pose, pixel));
        let told = told.map_err(|error| self.no_pixel(&error))?;
        let document = serde_json::to_value(&told).map_err(|error| DriveError::of(self.file(), &error))?;
        let cause = self.late_word(&told).or(told.because.first().cloned()).unwrap_or_default();
        Ok(Explained { cause, text: told.text(), because: told.because, document })
    }

    fn explain_guest(&self, frame: u64, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        let pose = self.seen_from(frame)?;
        let generator = &*self.opened.generator;
        let told = || facts(generator, &*self.session, &self.stage.view, (frame, &pose), pixel);
        let told = self.pool.install(told).map_err(|error| self.no_pixel(&error))?;
        let because: Vec<String> = told.iter().map(|Fact { what, value }| format!("{what}: {value}")).collect();
        let document = serde_json::json!({ "frame": frame, "time_s": pose.time, "pixel": pixel, "facts": told });
        let cause = because.first().cloned().unwrap_or_default();
        Ok(Explained { cause, text: because.join("\n") + "\n", because, document })
    }

    fn no_pixel(&self, error: &InquiryError) -> DriveError {
        DriveError::of(self.file(), error)
    }

    /// The last late word of the nearest sweep that is still in force at the sample, in words.
    fn late_word(&self, told: &Explanation) -> Option<String> {
        let late: &Late = told.late.iter().rev().find(|late| late.in_force)?;
        let colours = told.ground.iter().flat_map(|ground| &ground.colours);
        let mut wanted = colours.filter(|state| state.colour == late.colour).map(|state| state.wanted);
        let corner = wanted.next().map_or_else(String::new, |[x, y]| format!(", corner {x}, {y}"));
        let period_ns = 1e9 / self.machine.settings.timebase.sample_rate().hertz();
        let by = late.came.map_or_else(|| "never came".into(), |came| format!("{:.0} ns", (came - late.due) * period_ns));
        Some(format!("late word: tg.{}{corner}, {by}", late.colour))
    }
}
