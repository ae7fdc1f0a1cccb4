//! Some sweeps of a frame drawn without a look at any signal.

use std::ops::Range;

use signal::{Real, Waveform};
use signal_plane::{Look, Recorded};

/// Looks at no signal, and has these sweeps drawn.
pub(crate) struct Again<'a>(pub &'a Range<u32>);

impl Look for Again<'_> {
    fn wants_any_of(&self, sweeps: Range<u32>) -> bool {
        sweeps.start < self.0.end && self.0.start < sweeps.end
    }

    fn look<S: Real>(&self, _: &Recorded<'_, S>, _: usize, _: u32, _: &mut Vec<Waveform>) {}
}
