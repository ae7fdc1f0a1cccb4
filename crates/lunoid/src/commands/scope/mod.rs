//! One sweep, or one row of LUNSIM's grid, as a page of the scope: PNG or SVG, as the file is named.

mod args;
mod page;

use std::path::Path;

use hardware_model::Settings;
use plots::{Drawing, scope_picture, scope_svg};
use signal::{Waveform, Wire};

use crate::Failure;

pub use args::ScopeArgs;
pub use page::runs_along;

/// Signals that a page needs beside those that it shows: its axes, what it shades, its crossings and the picture column; of
/// each generator those that it has.
pub const NEEDS: [&str; 10] = [
    "sweep.range",
    "sweep.fold.x",
    "sweep.fold.y",
    "sweep.coarse.fold.x",
    "sweep.coarse.fold.y",
    "dpp.blank",
    "dpp.y",
    "sm.write",
    "lunsim.across",
    "lunsim.along",
];

/// What was recorded of one sweep.
#[derive(Debug, Clone, Copy)]
pub struct Recorded<'a> {
    /// What was drawn, and by what machine.
    pub title: &'a str,
    /// Signals of the sweep, [`NEEDS`] among them.
    pub waveforms: &'a [Waveform],
    /// Wires of the machine, for voltages.
    pub wires: &'a [Wire],
    /// Names of the signals to be shown.
    pub wanted: &'a [&'a str],
    /// Clocks and display of the run.
    pub settings: &'a Settings,
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
