//! How long the program of the thesis takes: work that `panel-program` counts, times what a piece takes on its computer.

mod hardware;
mod inputs;
mod job;
mod tasks;
mod thesis;

pub use hardware::Hardware;
pub(crate) use hardware::SHIPPED;
pub(crate) use job::Job;
pub use tasks::tasks;
pub use thesis::REPORTED;
