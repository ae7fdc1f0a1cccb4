//! Height and slopes sweep by sweep, before they stand side by side.

use std::ops::Range;

use fearless_simd::prelude::{SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use signal::{LANES, Lanes, Real, turn_square};

use crate::Profile;

/// Samples that are evaluated at once at most.
pub(crate) const WIDE: usize = 2 * LANES;

/// Height above the eye (m), slopes along and across of each sweep of a group, sample after sample.
///
/// Behind the last sample of a sweep there is room for those that vectors work out beyond it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sweeps<S> {
    signals: [Vec<S>; 3],
    /// Room of one sweep.
    room: usize,
}

impl<S: Real> Sweeps<S> {
    /// Room for sweeps of `samples` samples.
    pub(crate) fn resize(&mut self, samples: usize) {
        self.room = samples + WIDE;
        self.signals.iter_mut().for_each(|signal| signal.resize(LANES * self.room, S::ZERO));
    }

    /// The signals of one sweep.
    #[inline(always)]
    pub(crate) fn of_sweep(&mut self, lane: usize) -> [&mut [S]; 3] {
        let room = lane * self.room..(lane + 1) * self.room;
        self.signals.each_mut().map(|signal| &mut signal[room.clone()])
    }

    /// Puts one sample of a sweep.
    #[inline(always)]
    pub(crate) fn put(&mut self, lane: usize, sample: usize, values: [S; 3]) {
        let place = lane * self.room + sample;
        for (signal, value) in self.signals.iter_mut().zip(values) {
            signal[place] = value;
        }
    }

    /// Puts the samples of `span` side by side; nothing else of `profile` is touched.
    pub(crate) fn put_side_by_side(&self, vectors: Level, span: Range<usize>, profile: &mut Profile<S>) {
        let Profile { height, along, across, .. } = profile;
        for (sweeps, signal) in self.signals.iter().zip([height, along, across]) {
            dispatch!(vectors, simd => put_squares(simd, sweeps, self.room, span.start, &mut signal[span.clone()]));
        }
    }
}

/// Rows of samples, `room` apart, into groups of lanes from sample `first` on: squares of eight by eight.
#[inline(always)]
fn put_squares<S: Real, L: Simd>(simd: L, sweeps: &[S], room: usize, first: usize, out: &mut [Lanes<S>]) {
    let whole = out.len() - out.len() % LANES;
    let (squares, rest) = out.split_at_mut(whole);
    for (square, out) in squares.chunks_exact_mut(LANES).enumerate() {
        put_square(simd, sweeps, room, first + LANES * square, out);
    }
    put_square(simd, sweeps, room, first + whole, rest);
}

/// The first of eight samples, as many as `out` has.
#[inline(always)]
fn put_square<S: Real, L: Simd>(simd: L, sweeps: &[S], room: usize, sample: usize, out: &mut [Lanes<S>]) {
    let mut rows = [S::Vector::<L>::simd_from(simd, S::ZERO); LANES];
    for (lane, row) in rows.iter_mut().enumerate() {
        let at = lane * room + sample;
        *row = S::Vector::from_slice(simd, &sweeps[at..at + LANES]);
    }
    turn_square(&mut rows);
    for (out, row) in out.iter_mut().zip(rows) {
        row.store_slice(&mut out.0);
    }
}
