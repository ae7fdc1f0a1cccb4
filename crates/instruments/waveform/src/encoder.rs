//! What every format does with sweeps.

use std::io;

use crate::SweepTraces;

/// A format, whatever it is written to.
pub(crate) trait Encoder {
    /// Writes a sweep.
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()>;
    /// Ends the file.
    fn finish(self: Box<Self>) -> io::Result<()>;
}
