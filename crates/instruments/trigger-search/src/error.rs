//! Why a mission cannot be searched.

use deadlines::DeadlineError;
use generator::FrameError;
use trigger::ConditionError;

/// Why a mission cannot be searched.
#[derive(Debug, thiserror::Error)]
pub enum SearchError {
    /// The condition does not suit the machine.
    #[error("--on '{}': {}", .0.text, .0.fault)]
    Condition(#[from] ConditionError),
    /// The path cannot be driven.
    #[error(transparent)]
    Poses(#[from] DeadlineError),
    /// A pose cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
}
