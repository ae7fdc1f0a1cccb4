//! Signals of some sweeps, or rows of a grid: which are chosen, a page of one of them, files of waveforms of many.
//!
//! ```text
//! signal table, wires, patterns ─▶ Choice ─┐
//! session, pose ─▶ Look ───────────────────┴─▶ trace ─▶ file of waveforms, some sweeps at a time
//!                    ├─▶ Recorded, ScopeWishes ─▶ draw ─▶ page of one sweep: PNG, SVG
//!                    └─▶ sweep_space ─▶ a signal of the display, a column a sweep: PNG
//!
//! page/*.js ─▶ LIVE ─▶ the same waveforms on the canvas of a page, with cursors, zoom and X-Y
//! ```

mod choice;
mod error;
mod live;
mod page;
mod sweep_space;
mod trace;
mod wishes;
mod xy;

use generator::Scan;
use plots::{Drawing, scope_picture, scope_svg};
use scenario::Display;
use signal::{Waveform, Wire};

pub use choice::{Choice, expect_known};
pub use error::ScopeError;
pub use live::{LIVE, live_script};
pub use page::runs_along;
pub use sweep_space::sweep_space;
pub use trace::{Look, Looking, Order, Tracing, WINDOW, Written, size, trace, write};
pub use wishes::ScopeWishes;

/// Signals that a page of the hybrid machine needs beside those that it shows and its axes: what it shades, its crossings and
/// the picture column.
const SHADED: [&str; 7] = [
    "sweep.fold.x",
    "sweep.fold.y",
    "sweep.coarse.fold.x",
    "sweep.coarse.fold.y",
    "dpp.blank",
    "dpp.y",
    "sm.write",
];

/// Signals that a page needs beside those that it shows; of each generator those that it has.
pub fn needs(scan: &Scan) -> Vec<&'static str> {
    SHADED.into_iter().chain([scan.place]).chain(scan.ahead()).collect()
}

/// What was recorded of one sweep.
#[derive(Debug, Clone, Copy)]
pub struct Recorded<'a> {
    /// What was drawn, and by what machine.
    pub title: &'a str,
    /// Signals of the sweep, those that it [`needs`] among them.
    pub waveforms: &'a [Waveform],
    /// Wires of the machine, for voltages.
    pub wires: &'a [Wire],
    /// Names of the signals to be shown.
    pub wanted: &'a [&'a str],
    /// How the signals run.
    pub scan: Scan,
    /// From reflectivity to grey.
    pub display: Display,
    /// Corners to the east of the fine and of the coarse level: a corner's number is told as its place.
    pub columns: &'a [usize],
}

/// The text of an SVG file of one sweep, light or dark as its reader prefers.
///
/// # Errors
/// If no signal runs along the sweep, or the page cannot be drawn.
pub fn light_or_dark_svg(recorded: &Recorded<'_>) -> Result<String, ScopeError> {
    let page = page::Page::new(recorded)?;
    let look = ScopeWishes::default().look(recorded.title, page.facts(), page.line())?;
    scope_svg(&page.scope(), &look).map_err(ScopeError::Look)
}

/// Draws the page of one sweep, or two signals of it over each other.
///
/// # Errors
/// If no signal runs along the sweep, a place lies beyond it, or the page cannot be drawn as asked.
pub fn draw(recorded: &Recorded<'_>, wishes: &ScopeWishes) -> Result<Drawing, ScopeError> {
    let page = page::Page::new(recorded)?;
    if let Some(pair) = &wishes.xy {
        return xy::draw(recorded, &page, pair, wishes);
    }
    let look = wishes.look(recorded.title, page.facts(), page.line())?;
    let scope = page.scope();
    wishes.expect_places(&scope.clock)?;
    scope_picture(&scope, &look).map_err(ScopeError::Look)
}

/// Corners to the east of each level of a bank.
pub fn columns_of(bank: &landscape::Bank) -> Vec<usize> {
    bank.levels().iter().map(|level| level.corners()[1]).collect()
}
