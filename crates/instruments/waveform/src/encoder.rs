//! What every format does with sweeps.

use std::io;

use crate::SweepTraces;

/// A format, whatever it is written to.
pub(crate) trait Encoder {
    /// Writes one sweep to the file.
    fn sweep(&mut self, traces: &SweepTraces<'_>) -> io::Result<()>;
    /// Writes what ends the file.
    fn finish(self: Box<Self>) -> io::Result<()>;
}
