//! What a finished run gets for its page, so that any program can make a run with its page.
//!
//! [`Making`] is a page in the making: it records the sweeps of each [`Request`], sums up timing, notes where a pixel lies
//! among the sweeps, and has `report` write the page. [`gather`] takes over the recorded sweeps of other folders.

mod error;
mod gathering;
mod making;
mod recording;
mod request;
mod sight;

pub use error::{PageError, RequestError};
pub use gathering::gather;
pub use making::Making;
pub use request::{Request, check};
