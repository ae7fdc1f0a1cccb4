//! Missions into frames: a run of a scenario through a generator, in a folder that can be resumed.
//!
//! [`RunFolder::claim`] takes a folder for one run; [`run`] draws a [`Job`] into it:
//!
//! ```text
//! frames/frame-000000.png   grey, 8 or 16 bits; text chunks with frame, time and pose
//! run.json                  what was drawn from what, with which settings, and a hash of every frame's pixels
//! performance.json          wall times, threads, rates: all that differs between equal runs
//! poses.csv  camera.json    where the eye was, and from pixel to ray
//! contact-sheet.png  animation.png
//! index.html  page.json  scopes/    the page of the run: crate `report` writes it, the folder knows its names
//! truth/                    what each pixel shows: [`write_truth`]
//! exr/                      the frames as OpenEXR: crate `robot-log` writes them, the folder knows their names
//! ```
//!
//! A frame is a function of its pose. Some threads *carry* one frame each from pose to disk, one frame more than
//! the pool has threads, so that encoding and writing of one frame overlap the drawing of others, and memory does
//! not grow with the number of frames. The bytes do not depend on the number of threads.
//!
//! A file is a run's if a record or a journal lists it, or if it says so itself. No other file is removed or replaced.
//!
//! [`JoinedRun`] is a run whose frames other folders have: crate `merge` joins them.
//!
//! Every finished frame is written to a [`Journal`]; the same job again verifies what stands there and draws the rest.

mod camera;
mod check;
mod costs;
mod draw;
mod drawable;
mod error;
mod film;
mod fingerprint;
mod folder;
mod held;
mod job;
mod joined;
mod journal;
mod listed;
mod names;
mod performance;
mod phases;
mod picture_png;
mod record;
mod run;
mod truth;
mod truth_files;
mod world;
mod written;

pub use camera::Pinhole;
pub use costs::frame_costs;
pub use error::ReplayError;
pub use film::{write_apng, write_y4m};
pub use fingerprint::{Fingerprint, differences};
pub use folder::RunFolder;
pub use held::{HeldRun, RUN_RECORD};
pub use job::{Control, Job, Pictures, Progress};
pub use joined::{JoinedRun, expect_run_of, read_listed, unfinished_frames};
pub use journal::{Entry, Found, JOURNAL, Journal, RunSpan, read as read_journal};
pub use names::{
    ANIMATION, CAMERA, CONTACT_SHEET, EXR, PAGE, PAGE_DATA, POSES, SCOPE_KIND, SCOPES, SHADOWS, TRUTH,
    exr_name, is_run_file, picture_name, scope_name,
};
pub use performance::{Performance, peak_memory};
pub use phases::{Phase, Phases};
pub use picture_png::picture_png;
pub use run::{Outcome, run};
pub use truth::{JoinedTruth, TRUTH_ERROR, TruthItem, TruthItems, TruthOutcome, held_truth, write_truth};
