//! Lines that runs cover in part, mixed by the share that they cover.

use fearless_simd::prelude::Select;
use fearless_simd::{Level, Simd, SimdBase, dispatch, f32x16};

use crate::Run;

/// Lines side by side: most runs are shorter.
const TOGETHER: usize = 16;

/// What covers each line; nothing between two rows.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cover {
    shares: Vec<f32>,
    /// Sum of share times value, line by line.
    sums: Vec<f32>,
}

impl Cover {
    /// Mixes runs, disjoint and from the top, into a row of lines.
    pub fn mix(&mut self, runs: &[Run], row: &mut [f32], shown: impl Fn(&Run) -> Run) {
        // Whoever looks at the last line looks at some more.
        let room = row.len() + TOGETHER;
        if self.shares.len() < room {
            self.shares.resize(room, 0.0);
            self.sums.resize(room, 0.0);
        }
        dispatch!(Level::new(), simd => {
            runs.iter().for_each(|run| self.add(simd, &shown(run), row.len()));
            self.take(simd, runs, row);
        });
    }

    /// Adds a run: how many lines it covers cannot be guessed, but nearly always they are looked at together.
    #[inline(always)]
    fn add<V: Simd>(&mut self, simd: V, run: &Run, lines: usize) {
        let end = run.bottom.min(lines as f32);
        let mut first = run.top.max(0.0) as usize;
        while (first as f32) < end {
            let line = f32x16::splat(simd, first as f32) + f32x16::from_fn(simd, |n| n as f32);
            let [top, bottom] = [run.top, end].map(|end| f32x16::splat(simd, end));
            let cover = (bottom.min(line + 1.0) - top.max(line)).max(0.0);
            add(simd, &mut self.shares[first..first + TOGETHER], cover);
            let sums = &mut self.sums[first..first + TOGETHER];
            match run.ramp {
                0.0 => add(simd, sums, cover * run.reflectivity),
                // The mean over what is covered of a line: that in its middle.
                ramp => {
                    let middle = (bottom.min(line + 1.0) + top.max(line)) * 0.5;
                    add(simd, sums, cover * ((middle.min(bottom) - top) * ramp + run.reflectivity));
                }
            }
            first += TOGETHER;
        }
    }

    /// Mixes what was added into a row, and forgets it.
    #[inline(always)]
    fn take<V: Simd>(&mut self, simd: V, runs: &[Run], row: &mut [f32]) {
        let (Some(first), Some(last)) = (runs.first(), runs.last()) else { return };
        let mut at = first.top.max(0.0) as usize;
        while at < row.len() && (at as f32) < last.bottom {
            let place = at..at + TOGETHER;
            let [cover, sum] =
                [&self.shares, &self.sums].map(|all| f32x16::from_slice(simd, &all[place.clone()]));
            self.shares[place.clone()].fill(0.0);
            self.sums[place].fill(0.0);
            let lines = &mut row[at..];
            let mixed =
                |before: f32x16<V>| cover.simd_gt(0.0).select(before * (-cover + 1.0).max(0.0) + sum, before);
            match lines.first_chunk_mut::<TOGETHER>() {
                Some(lines) => *lines = mixed(f32x16::load_array(simd, *lines)).to_array(),
                None => {
                    let before = std::array::from_fn(|n| lines.get(n).copied().unwrap_or_default());
                    let mixed = mixed(f32x16::load_array(simd, before)).to_array();
                    lines.copy_from_slice(&mixed[..lines.len()]);
                }
            }
            at += TOGETHER;
        }
    }
}

#[inline(always)]
fn add<V: Simd>(simd: V, to: &mut [f32], value: f32x16<V>) {
    (f32x16::from_slice(simd, to) + value).store_slice(to);
}

#[cfg(test)]
mod tests {
    use super::Cover;
    use crate::Run;
    use proptest::prelude::{prop_assert_eq, proptest};

    proptest! {
        /// To the bit: runs that touch, share lines, are longer than what is looked at together and reach beyond the picture.
        #[test]
        fn lines_side_by_side_are_what_each_is_alone(
            top in -40.0..20.0f32,
            steps in proptest::collection::vec((0..3u8, 0.0..30.0f32, 0.0..1.0f32), 0..12),
            ramp in proptest::sample::select(vec![0.0f32, 0.01, -0.02]),
            lines in 0..90usize,
        ) {
            let mut at = top;
            let mut runs = Vec::new();
            for (kind, height, reflectivity) in steps {
                let height = [0.0, 0.1 * height, height][kind as usize];
                runs.push(Run { top: at, bottom: at + height, reflectivity, ramp });
                at += if reflectivity < 0.5 { height } else { 1.5 * height };
            }
            let mut cover = Cover::default();
            // What a row leaves behind would show in the next.
            for before in [0.25f32, 0.75] {
                let mut row = vec![before; lines];
                cover.mix(&runs, &mut row, |run| *run);
                for (number, mixed) in row.into_iter().enumerate() {
                    let (top, bottom) = (number as f32, number as f32 + 1.0);
                    let (mut share, mut sum) = (0.0f32, 0.0f32);
                    for run in &runs {
                        let part = (run.bottom.min(bottom) - run.top.max(top)).max(0.0);
                        share += part;
                        let middle = (run.bottom.min(bottom) + run.top.max(top)) * 0.5;
                        sum += part * ((middle - run.top) * run.ramp + run.reflectivity);
                    }
                    let expected = if share > 0.0 { before * (1.0 - share).max(0.0) + sum } else { before };
                    prop_assert_eq!(mixed, expected, "line {}", number);
                }
            }
        }
    }
}
