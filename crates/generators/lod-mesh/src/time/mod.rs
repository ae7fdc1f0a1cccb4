//! How long the viewer of the thesis takes: work that is counted, times what a piece takes on its computer and its graphics board.

mod deadlines;
mod hardware;
mod inputs;
mod job;
mod sizing;
mod store;
mod work;

pub use hardware::{Board, Capture, Hardware, Viewer};
pub(crate) use hardware::{FILE, SHIPPED, TABLES};
pub(crate) use job::Job;
pub(crate) use work::{SECOND, Work, frame_time};
