//! How far the writing came.

/// How far the writing of a log or of files came.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outcome {
    /// Frames that are to be written.
    pub frames: u64,
    /// Frames that are written: fewer than all if told to end.
    pub done: u64,
}
