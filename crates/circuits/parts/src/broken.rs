//! A signal of one sweep between its samples: straight lines, but for places of their own where it jumps or bends.

use fearless_simd::{Level, dispatch};
use signal::{LANES, Lanes, Real};

use crate::Delay;

/// Where a signal jumps or bends between two samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// Instant of the jump or bend (steps).
    pub at: f64,
    /// Value of the signal just before it.
    pub before: f64,
    /// Value of the signal just after it.
    pub after: f64,
}

/// Value at `time` (steps) of a signal without jumps: `sample` gives it at the samples 0 to `last`. Before the first sample and
/// behind the last it stands.
#[inline]
pub fn straight_at(sample: impl Fn(usize) -> f64, last: usize, time: f64) -> f64 {
    let end = step_of(time.max(0.0));
    if end == 0 {
        return sample(0);
    }
    if end > last {
        return sample(last);
    }
    let from = sample(end - 1);
    from + (sample(end) - from) * (time - (end - 1) as f64)
}

/// A signal with jumps as time goes on.
#[derive(Debug, Clone)]
pub struct NearJumps<'a> {
    jumps: &'a [Jump],
    /// Jumps that have been passed.
    passed: usize,
}

impl<'a> NearJumps<'a> {
    /// Of ascending jumps, from the start of the sweep.
    pub fn new(jumps: &'a [Jump]) -> Self {
        Self { jumps, passed: 0 }
    }

    /// Value of the signal just before and just after `time` (steps), not earlier than it was asked for before; `sample` and
    /// `last` as those of [`straight_at`].
    #[inline]
    pub fn at(&mut self, sample: impl Fn(usize) -> f64, last: usize, time: f64) -> [f64; 2] {
        while self.jumps.get(self.passed).is_some_and(|jump| jump.at < time) {
            self.passed += 1;
        }
        let (end, (passed, ahead)) = (step_of(time.max(0.0)), self.jumps.split_at(self.passed));
        if end == 0 || end > last {
            return [straight_at(sample, last, time); 2];
        }
        let here = ahead.iter().take_while(|jump| jump.at <= time).count();
        if here > 0 {
            return [ahead[0].before, ahead[here - 1].after];
        }
        let from = passed.last().filter(|jump| jump.at >= (end - 1) as f64);
        let to = ahead.first().filter(|jump| jump.at <= end as f64);
        let (start, value) = from.map_or(((end - 1) as f64, sample(end - 1)), |jump| (jump.at, jump.after));
        let (stop, target) = to.map_or((end as f64, sample(end)), |jump| (jump.at, jump.before));
        [if stop > start { value + (target - value) * ((time - start) / (stop - start)) } else { target }; 2]
    }
}

/// More than an instant of a sweep is rounded by (steps).
const ROUNDING: f64 = 1e-9;

/// The sample at which the step ends in which `time` lies, 0 or later.
pub(crate) fn step_of(time: f64) -> usize {
    let whole = time as usize;
    whole + usize::from(time > whole as f64)
}

impl Delay {
    /// The signals of a group behind this delay, with their jumps; `before` gets what they were before it. Before the
    /// sweep they stood as it begins.
    pub fn pass_broken<S: Real>(
        &self,
        signal: &mut [Lanes<S>],
        jumps: &mut [Vec<Jump>; LANES],
        before: &mut Vec<Lanes<S>>,
    ) {
        let Some(last) = signal.len().checked_sub(1) else { return };
        before.clear();
        before.extend_from_slice(signal);
        let late = self.whole as f64 + self.share;
        dispatch!(Level::new(), _ => straight(late, before, signal));
        for (lane, jumps) in jumps.iter_mut().enumerate() {
            let value = |sample: usize| before[sample][lane].to_f64();
            let (mut near, mut next) = (NearJumps::new(jumps), 0);
            for jump in &*jumps {
                // The samples that are taken from within a step that holds the jump, ends at it or begins there.
                let [begin, end] = [jump.at.ceil() - 1.0, jump.at.floor() + 1.0].map(|step| step + late);
                let first = (begin - ROUNDING).max(0.0).ceil() as usize;
                let beyond = (end + ROUNDING) as usize + 1;
                for index in first.max(next)..beyond.min(signal.len()) {
                    let time = index as f64 - late;
                    let [_, after] = near.at(value, last, time);
                    signal[index][lane] = S::from_f64(after);
                    next = index + 1;
                }
            }
            jumps.iter_mut().for_each(|jump| jump.at += late);
            jumps.retain(|jump| jump.at < last as f64);
        }
    }
}

/// Signals of a group `late` steps later, as if they did not jump: what [`straight_at`] has.
#[inline(always)]
fn straight<S: Real>(late: f64, before: &[Lanes<S>], signal: &mut [Lanes<S>]) {
    for (index, signal) in signal.iter_mut().enumerate() {
        let time = index as f64 - late;
        let end = step_of(time.max(0.0));
        if end == 0 {
            *signal = before[0];
            continue;
        }
        let (from, to, share) = (&before[end - 1], &before[end], time - (end - 1) as f64);
        for lane in 0..LANES {
            let [from, to] = [from.0[lane].to_f64(), to.0[lane].to_f64()];
            signal.0[lane] = S::from_f64(from + (to - from) * share);
        }
    }
}

#[cfg(test)]
mod tests {
    use signal::{LANES, Lanes};

    use super::{Jump, NearJumps};
    use crate::Delay;

    const SAMPLES: [f64; 5] = [0.0, 1.0, 2.0, 7.0, 8.0];
    const JUMPS: [Jump; 2] =
        [Jump { at: 2.25, before: 2.5, after: 6.0 }, Jump { at: 2.5, before: 6.5, after: 6.5 }];

    fn at(time: f64) -> [f64; 2] {
        NearJumps::new(&JUMPS).at(|k| SAMPLES[k], 4, time)
    }

    #[test]
    fn straight_between_samples_and_jumps() {
        assert_eq!([at(-1.0), at(0.0), at(0.5), at(1.0)], [[0.0; 2], [0.0; 2], [0.5; 2], [1.0; 2]]);
        assert_eq!([at(2.125), at(2.25), at(2.375)], [[2.25; 2], [2.5, 6.0], [6.25; 2]]);
        assert_eq!([at(2.5), at(2.75), at(3.0)], [[6.5; 2], [6.75; 2], [7.0; 2]]);
        assert_eq!([at(3.5), at(4.0), at(9.0)], [[7.5; 2], [8.0; 2], [8.0; 2]]);
    }

    #[test]
    fn jumps_that_are_near_are_all_that_counts() {
        let mut near = NearJumps::new(&JUMPS);
        for k in -10..60 {
            let time = f64::from(k) * 0.125;
            assert_eq!(near.at(|k| SAMPLES[k], 4, time), at(time), "{time}");
        }
    }

    #[test]
    fn a_delay_moves_samples_and_jumps_alike() {
        for late in [0.0, 0.25, 0.5, 1.0, 1.375] {
            let (mut jumps, mut out) = ([(); LANES].map(|_| JUMPS.to_vec()), SAMPLES.map(Lanes::splat));
            Delay::new(1.0, late).pass_broken(&mut out, &mut jumps, &mut Vec::new());
            let (jumps, out) = (&jumps[3], out.map(|out| out[3]));
            for k in 0..40 {
                let time = late + f64::from(k) * 0.1 + 0.03;
                let [value, _] = NearJumps::new(jumps).at(|k| out[k], 4, time);
                // Bends of a delayed signal lie between samples too: only jumps are kept as such.
                let near = [1.0, 2.0, 3.0].iter().any(|bend| (time - late - bend).abs() < 1.0);
                assert!(time > 4.0 || near || (value - at(time - late)[0]).abs() < 1e-12, "{late} {time}");
            }
            let moved = |k: usize| jumps[k].at == JUMPS[k].at + late;
            assert!(jumps.len() == 2 && moved(0) && moved(1));
            assert_eq!(out[4], at(4.0 - late)[1]);
        }
    }

    /// A group whose lanes jump here and there has at each sample what a search among all of a lane's jumps finds.
    #[test]
    fn a_delayed_group_is_its_lanes() {
        let drawn = |words: &[u64]| quantities::unit_interval(6, words);
        for round in 0..60 {
            let samples = 1 + (drawn(&[round]) * 40.0) as usize;
            let delay = Delay::new(1.0, 4.0 * drawn(&[round, 1]).max(0.1) - 0.4);
            let mut jumps = [(); LANES].map(|_| Vec::new());
            for (lane, jumps) in jumps.iter_mut().enumerate() {
                let place = |k: u64| {
                    let at = 40.0 * drawn(&[round, 2, lane as u64, k]);
                    if k.is_multiple_of(3) { at.round() } else { at }
                };
                let mut places: Vec<f64> = (0..2 * lane as u64).map(place).collect();
                places.sort_by(f64::total_cmp);
                let values = |k: usize| [3, 4].map(|side| drawn(&[round, side, lane as u64, k as u64]));
                jumps.extend(places.iter().enumerate().map(|(k, &at)| {
                    let [before, after] = values(k);
                    Jump { at, before, after }
                }));
            }
            let before: Vec<Lanes<f64>> = (0..samples as u64)
                .map(|sample| Lanes::from_fn(|lane| drawn(&[round, 5, lane as u64, sample])))
                .collect();
            let (mut out, mut moved) = (before.clone(), jumps.clone());
            delay.pass_broken(&mut out, &mut moved, &mut Vec::new());
            let late = delay.whole as f64 + delay.share;
            for (sample, out) in out.iter().enumerate() {
                for lane in 0..LANES {
                    let value = |k: usize| before[k][lane];
                    let [_, right] =
                        NearJumps::new(&jumps[lane]).at(value, samples - 1, sample as f64 - late);
                    assert_eq!(out[lane], right, "round {round}, lane {lane}, sample {sample}");
                }
            }
        }
    }
}
