//! The program of the thesis in place of the scene sampler.

mod explained;
mod keys;
mod posts;
mod session;

pub use keys::ProgramKeys;
pub use posts::{Block, PostTable};
pub(crate) use session::{PLANES, ProgramSession};
