//! The page of a run: one self-contained HTML file.
//!
//! ```text
//! run.json ──────────────┐
//! poses.csv ─────────────┤
//! frames/*.png ─▶ strip ─┼─▶ write_page ─▶ index.html
//! page.json ─────────────┤
//! scopes/*.svg ──────────┘
//! ```
//!
//! **Law.** The page is a function of the folder: the same files give the same bytes, however often and by whomever it
//! is written. It holds no clock, so it says nothing of `performance.json`.
//! **What it shows.** Frames with pose and time, a contact sheet, the machine with what was left out of it, timing of the
//! digital side, waveforms of recorded sweeps, error, and the record.
//! **What is needed beside it.** Nothing: frames and plots are part of it, byte for byte. A run whose frames take more than
//! `FILM_BYTES` has every n-th of them in its page, and the others beside it; where those are gone the nearest frame
//! stands in, and the page says so.
//! **No network.** Style, script and data are in the file, and its content security policy forbids the rest.
//! **Served.** [`waiting_page`] shows a run while it is drawn, and [`live_page`] is the page with sweeps that are computed on a click. A program serves both
//! (`lunoid replay --live`); neither is written into the folder.
//! **page.json** ([`Beside`]) keeps what the record does not have: the words of the command line, where a pixel lies among
//! the sweeps, a [summary](TimingSummary) of timing, the list of plots and their [values](SweepWaves). Without it the page has fewer sections.
//! **Side by side.** [`write_side_by_side`] makes one page of the runs of several machines: frames in columns, errors against one
//! of them, and what their drawing took, which it reads from `performance.json`: it alone has a clock.
//! **Levels of detail.** [`DescentPage`] shows a descent in several ways side by side, with their curves.
//! **Our choices.** The page is no output of `run.json`, whose hashes it shows: it can be written again from the folder.
//! **Not modelled.** Anything that would need the machine again.

mod beside;
mod cells;
mod check_plot;
mod data;
mod descent;
mod diagram;
mod error;
mod film;
mod live;
mod machine_section;
mod masthead;
mod page;
mod record_section;
mod run;
mod scope_section;
mod side_by_side;
mod sight;
mod strip;
mod timing_section;
mod timing_summary;
mod viewer;
mod waves;

pub use beside::{BESIDE, Beside, ScopePlot};
pub use descent::{DescentPage, DescentPicture, DescentPlace, DescentShot, DescentWay, place_pixels};
pub use error::ReportError;
pub use live::{LIVE_FILES, LIVE_FIRST, waiting_page};
pub use page::{live_page, write_page};
pub use side_by_side::{FrameError, SIDE_BY_SIDE, SideBySide, write_side_by_side};
pub use sight::{Sight, SightLine};
pub use timing_summary::{DeadlineLine, TimingSummary, UnitLine};
pub use waves::{SweepWaves, Wave};
