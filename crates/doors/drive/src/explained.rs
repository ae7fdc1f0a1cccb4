//! A pixel of a frame: how it came about.

use explain::{Inquiry, InquiryError, Late, corner_place, facts};
use generator::Fact;
use quantities::SweepTime;
use serde_json::Value;
use sweep_program::Colour;

use crate::{Drive, DriveError, Viewpoint};

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
    /// Explains pixel `pixel` of frame `frame` of the path.
    ///
    /// # Errors
    /// If there is no such frame, or as [`Viewpoint::explain`].
    pub fn explain(&self, frame: u64, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        self.at(frame)?.explain(pixel)
    }
}

impl Viewpoint<'_> {
    /// Explains pixel `pixel` (column and line, from 0 at the top left).
    ///
    /// # Errors
    /// If there is no such pixel, or the frame cannot be drawn.
    pub fn explain(&self, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        match self.drive.opened.is_machine() {
            true => self.explain_machine(pixel),
            false => self.explain_guest(pixel),
        }
    }

    fn explain_machine(&self, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let inquiry = Inquiry::new(&bench.machine, &*bench.session, bench.control(), Some(bench.exact()));
        let told = drive.pool.install(|| inquiry.explain(*frame, pose, pixel));
        let told = told.map_err(|error| self.no_pixel(&error))?;
        let document = serde_json::to_value(&told).map_err(|error| DriveError::of(drive.file(), &error))?;
        let late = told.late.iter().rev().find(|late| late.in_force);
        let late = late.map(|late| self.late_word(told.place.sweep, late)).transpose()?;
        let cause = late.or(told.because.first().cloned()).unwrap_or_default();
        Ok(Explained { cause, text: told.text(), because: told.because, document })
    }

    fn explain_guest(&self, pixel: [usize; 2]) -> Result<Explained, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let generator = &*drive.opened.generator;
        let told = || facts(generator, &*bench.session, &bench.stage.view, (*frame, pose), pixel);
        let told = drive.pool.install(told).map_err(|error| self.no_pixel(&error))?;
        let because: Vec<String> =
            told.iter().map(|Fact { what, value }| format!("{what}: {value}")).collect();
        let document =
            serde_json::json!({ "frame": frame, "time_s": pose.time, "pixel": pixel, "facts": told });
        let cause = because.first().cloned().unwrap_or_default();
        Ok(Explained { cause, text: because.join("\n") + "\n", because, document })
    }

    fn no_pixel(&self, error: &InquiryError) -> DriveError {
        DriveError::of(self.drive.file(), error)
    }

    /// A late word of sweep `sweep`, with the corner that its register asks for when it is due.
    fn late_word(&self, sweep: u32, late: &Late) -> Result<String, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let sweeps = bench.control().sweeps(*frame, pose);
        let sweeps = sweeps.map_err(|error| DriveError::of(drive.file(), &error))?;
        let states = sweeps.registers(sweep, SweepTime(late.due));
        let mut levels = states.iter().zip(bench.stage.landscape.bank().levels());
        // The fine level comes first.
        let state = if late.level == "fine" { levels.next() } else { levels.next_back() };
        let colour = Colour::ALL.iter().position(|colour| colour.name() == late.colour);
        let corner = state.zip(colour).map_or_else(String::new, |((state, level), colour)| {
            let [x, y] = corner_place(level, state.colours[colour][0].wanted);
            format!(", corner {x}, {y}")
        });
        let period_ns = 1e9 / bench.machine.settings.timebase.sample_rate().hertz();
        let by = late.came.map(|came| format!("{:.0} ns", (came - late.due) * period_ns));
        Ok(format!("late word: tg.{}{corner}, {}", late.colour, by.unwrap_or_else(|| "never came".into())))
    }
}
