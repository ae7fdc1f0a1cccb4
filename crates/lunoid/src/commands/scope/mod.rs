//! One sweep, or one row of a grid, as a page of the scope: PNG or SVG, as the file is named.

mod args;
mod page;

use std::path::Path;

use generator::Scan;
use plots::{Drawing, scope_picture, scope_svg};
use scenario::Display;
use signal::{Waveform, Wire};

use crate::Failure;

pub use args::ScopeArgs;
pub use page::runs_along;

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
    SHADED.into_iter().chain([scan.place]).chain(scan.ahead).collect()
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

/// Writes the page of one sweep.
pub fn write_picture(path: &Path, recorded: &Recorded<'_>, args: &ScopeArgs) -> Result<(), Failure> {
    draw(recorded, args)?.write(path).map_err(Failure::output)
}

/// The text of an SVG file of one sweep, light or dark as its reader prefers.
pub fn light_or_dark_svg(recorded: &Recorded<'_>) -> Result<String, Failure> {
    let page = page::Page::new(recorded)?;
    let look = ScopeArgs::default().look(recorded.title, page.facts(), page.line())?;
    scope_svg(&page.scope()?, &look).map_err(Failure::usage)
}

/// Draws the page of one sweep.
pub fn draw(recorded: &Recorded<'_>, args: &ScopeArgs) -> Result<Drawing, Failure> {
    let page = page::Page::new(recorded)?;
    let look = args.look(recorded.title, page.facts(), page.line())?;
    let scope = page.scope()?;
    args.expect_places(&scope.clock)?;
    scope_picture(&scope, &look).map_err(Failure::usage)
}

/// Corners to the east of each level of a bank.
pub fn columns_of(bank: &landscape::Bank) -> Vec<usize> {
    bank.levels().iter().map(|level| level.corners()[1]).collect()
}
