//! Gates of eight sweeps side by side, from crossings of which only ranges are known.

use std::array;

use fearless_simd::prelude::{SimdBase, SimdMask};
use fearless_simd::{Level, Select, Simd, dispatch, u64x8};
use signal::LANES;

use crate::controller::{Gate, add_change};
use crate::crossing::{Bare, Crossing, Place};
use crate::crossings::Met;
use crate::network::{BLOCK, Row, sort_columns};

/// Counted from here, the number of shadows is never negative.
const NONE: u64 = 1 << 32;

/// Crossings of a group of sweeps, a lane each; used again from group to group.
#[derive(Debug, Default)]
pub(crate) struct SideBySide {
    rows: Vec<Row>,
    /// Of each row: which crossings are between light and shadow, a bit each.
    changes: Vec<u8>,
}

/// What is known of each sweep beside its changes.
struct Counts {
    /// Whether it starts in shadow: a bit each.
    dark_at_start: u64,
    /// Crossings up to the reach.
    within: [u64; LANES],
}

impl SideBySide {
    /// Finds the gates of as many sweeps as there are, from number `first` on and up to a ground range of `reach` (m).
    pub(crate) fn find<F>(&mut self, met: &Met<'_, F, Bare>, first: usize, reach: f64, gates: &mut [Gate]) {
        let crossings = self.gather(met, first, gates.len());
        let counts = dispatch!(Level::new(), simd => {
            sort_columns(simd, &mut self.rows);
            self.unite(simd, crossings, reach)
        });
        for (lane, gate) in gates.iter_mut().enumerate() {
            gate.dark_at_start = counts.dark_at_start >> lane & 1 == 1;
            gate.swings.clear();
            self.tell(lane, &mut gate.toggles);
            gate.united = counts.within[lane] as u32 - gate.toggles.len() as u32;
        }
    }

    /// Brings the crossings of `sweeps` sweeps into their columns, filled up with what lies beyond all; returns how many each has.
    fn gather<F>(&mut self, met: &Met<'_, F, Bare>, first: usize, sweeps: usize) -> [u64; LANES] {
        let count = |lane| if lane < sweeps { met.of(first + lane).map(<[_]>::len).sum() } else { 0 };
        let counts: [usize; LANES] = array::from_fn(count);
        let most = counts.into_iter().fold(0, usize::max);
        self.rows.clear();
        self.rows.resize(most.next_multiple_of(BLOCK), Row([Bare::MAX; LANES]));
        for lane in 0..sweeps {
            let mut rows = self.rows.as_mut_slice();
            for crossings in met.of(first + lane) {
                let (filled, others) = rows.split_at_mut(crossings.len());
                filled.iter_mut().zip(crossings).for_each(|(row, &crossing)| row.0[lane] = crossing);
                rows = others;
            }
        }
        counts.map(|count| count as u64)
    }

    /// The I/O processor's editing: of the sorted crossings up to `reach` (m) finds those between light and shadow.
    #[inline(always)]
    fn unite<V: Simd>(&mut self, simd: V, crossings: [u64; LANES], reach: f64) -> Counts {
        let splat = |word| u64x8::splat(simd, word);
        let (none, one, last) = (splat(NONE), splat(1), splat(Bare::new(reach, true, Place::default())));
        let mut ends = splat(0);
        for row in &self.rows {
            ends += u64x8::load_array_ref(simd, &row.0) & one;
        }
        // Outlines are closed, so beyond the last crossing there is no shadow. What the columns are filled up with counts as ends.
        let filled = splat(self.rows.len() as u64) - u64x8::load_array(simd, crossings);
        let mut depth = none + ends + ends - splat(self.rows.len() as u64) - filled;
        let mut is_dark = depth.simd_gt(none);
        let (dark_at_start, mut within) = (is_dark.to_bitmask(), splat(0));
        self.changes.resize(self.rows.len(), 0);
        for (row, changes) in self.rows.iter().zip(&mut self.changes) {
            let crossing = u64x8::load_array_ref(simd, &row.0);
            let (before, ends) = (is_dark, crossing & one);
            depth = depth + one - ends - ends;
            is_dark = depth.simd_gt(none);
            let is_within = crossing.simd_le(last);
            within += is_within.select(one, splat(0));
            *changes = ((before ^ is_dark) & is_within).to_bitmask() as u8;
        }
        Counts { dark_at_start, within: within.to_array() }
    }

    /// Ranges at which the gate of a lane changes.
    fn tell(&self, lane: usize, toggles: &mut Vec<f64>) {
        const WORD: usize = u64::BITS as usize;
        toggles.clear();
        for (rows, changes) in self.rows.chunks(WORD).zip(self.changes.chunks(WORD)) {
            // Which are changes cannot be guessed: a word of them is asked for the next one.
            let bit = |(n, row): (usize, &u8)| u64::from(row >> lane & 1) << n;
            let mut left = changes.iter().enumerate().map(bit).fold(0, |all, bit| all | bit);
            while left != 0 {
                let range = rows[left.trailing_zeros() as usize].0[lane].range();
                left &= left - 1;
                add_change(toggles, range, |range| range);
            }
        }
    }
}
