//! A pixel of a frame: how it came about.

use exact::Columns;
use explain::{Inquiry, InquiryError, Late, corner_place, facts};
use generator::Fact;
use machine::ControlPlane;
use quantities::SweepTime;
use scenario::Pose;
use serde_json::Value;
use sweep_program::Colour;

use crate::{Drive, DriveError};

/// An explanation of one pixel.
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
        let late = told.late.iter().rev().find(|late| late.in_force);
        let late = late.map(|late| self.late_word((frame, &pose), told.place.sweep, late)).transpose()?;
        let cause = late.or(told.because.first().cloned()).unwrap_or_default();
        Ok(Explained { cause, text: told.text(), because: told.because, document })
    }

    fn explain_guest(&self, frame: u64, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        let pose = self.seen_from(frame)?;
        let generator = &*self.opened.generator;
        let told = || facts(generator, &*self.session, &self.stage.view, (frame, &pose), pixel);
        let told = self.pool.install(told).map_err(|error| self.no_pixel(&error))?;
        let because: Vec<String> =
            told.iter().map(|Fact { what, value }| format!("{what}: {value}")).collect();
        let document =
            serde_json::json!({ "frame": frame, "time_s": pose.time, "pixel": pixel, "facts": told });
        let cause = because.first().cloned().unwrap_or_default();
        Ok(Explained { cause, text: because.join("\n") + "\n", because, document })
    }

    fn no_pixel(&self, error: &InquiryError) -> DriveError {
        DriveError::of(self.file(), error)
    }

    /// A late word of sweep `sweep`, with the corner that its register asks for when it is due.
    fn late_word(&self, (frame, pose): (u64, &Pose), sweep: u32, late: &Late) -> Result<String, DriveError> {
        let control = self.control.get_or_init(|| ControlPlane::new(self.machine.clone()));
        let sweeps = control.sweeps(frame, pose).map_err(|error| DriveError::of(self.file(), &error))?;
        let states = sweeps.registers(sweep, SweepTime(late.due));
        let mut levels = states.iter().zip(self.stage.landscape.bank().levels());
        // The fine level comes first.
        let state = if late.level == "fine" { levels.next() } else { levels.next_back() };
        let colour = Colour::ALL.iter().position(|colour| colour.name() == late.colour);
        let corner = state.zip(colour).map_or_else(String::new, |((state, level), colour)| {
            let [x, y] = corner_place(level, state.colours[colour][0].wanted);
            format!(", corner {x}, {y}")
        });
        let period_ns = 1e9 / self.machine.settings.timebase.sample_rate().hertz();
        let by = late.came.map(|came| format!("{:.0} ns", (came - late.due) * period_ns));
        Ok(format!("late word: tg.{}{corner}, {}", late.colour, by.unwrap_or_else(|| "never came".into())))
    }
}
