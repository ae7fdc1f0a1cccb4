//! A signal of one sweep between its samples: straight lines, but for places of their own where it jumps or bends.

use crate::Delay;

/// Where a signal jumps or bends between two samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// When (steps).
    pub at: f64,
    /// Value just before.
    pub before: f64,
    /// Value just after.
    pub after: f64,
}

/// Value of a signal just before and just after `time` (steps): `sample` gives it at the samples 0 to `last`, `jumps` are
/// ascending. Before the first sample and behind the last it stands.
pub fn broken_at(sample: impl Fn(usize) -> f64, last: usize, jumps: &[Jump], time: f64) -> [f64; 2] {
    if time <= 0.0 {
        return [sample(0); 2];
    }
    let end = step_of(time).min(last);
    if time > last as f64 || end == 0 {
        return [sample(last); 2];
    }
    let begin = (end - 1) as f64;
    let first = jumps.partition_point(|jump| jump.at < time);
    let behind = first + jumps[first..].partition_point(|jump| jump.at <= time);
    let line = |from: Option<&Jump>, to: Option<&Jump>| {
        let (start, value) = from.map_or((begin, sample(end - 1)), |jump| (jump.at, jump.after));
        let (stop, target) = to.map_or((end as f64, sample(end)), |jump| (jump.at, jump.before));
        if stop > start { value + (target - value) * ((time - start) / (stop - start)) } else { target }
    };
    let passed = jumps[..first].last().filter(|jump| jump.at >= begin);
    if first == behind {
        return [line(passed, jumps.get(behind).filter(|jump| jump.at <= end as f64)); 2];
    }
    [jumps[first].before, jumps[behind - 1].after]
}

/// Jumps of a signal as time goes on: those that [`broken_at`] needs, without a search.
#[derive(Debug, Clone)]
pub struct NearJumps<'a> {
    /// From the first that has not been passed.
    ahead: &'a [Jump],
}

impl<'a> NearJumps<'a> {
    /// Of ascending jumps.
    pub fn new(jumps: &'a [Jump]) -> Self {
        Self { ahead: jumps }
    }

    /// Those of the step in which `time` (steps) lies; not earlier than the step before it was asked for.
    #[inline]
    pub fn at(&mut self, time: f64) -> &'a [Jump] {
        let end = step_of(time.max(0.0)) as f64;
        while self.ahead.first().is_some_and(|jump| jump.at < end - 1.0) {
            self.ahead = &self.ahead[1..];
        }
        let count = self.ahead.iter().take_while(|jump| jump.at <= end).count();
        &self.ahead[..count]
    }
}

/// The sample at which the step ends in which `time` lies, 0 or later.
pub(crate) fn step_of(time: f64) -> usize {
    let whole = time as usize;
    whole + usize::from(time > whole as f64)
}

impl Delay {
    /// The signal of one sweep behind this delay: `sample` before it, `jumps` before it and then behind it, `put` takes each
    /// sample behind it. Before the sweep the signal stood as it begins.
    pub fn pass_broken(
        &self,
        sample: impl Fn(usize) -> f64,
        samples: usize,
        jumps: &mut Vec<Jump>,
        mut put: impl FnMut(usize, f64),
    ) {
        let Some(last) = samples.checked_sub(1) else { return };
        let late = self.whole as f64 + self.share;
        let mut near = NearJumps::new(jumps);
        for index in 0..samples {
            let time = index as f64 - late;
            let [_, after] = broken_at(&sample, last, near.at(time), time);
            put(index, after);
        }
        jumps.iter_mut().for_each(|jump| jump.at += late);
        jumps.retain(|jump| jump.at < last as f64);
    }
}

#[cfg(test)]
mod tests {
    use super::{Jump, NearJumps, broken_at};
    use crate::Delay;

    const SAMPLES: [f64; 5] = [0.0, 1.0, 2.0, 7.0, 8.0];
    const JUMPS: [Jump; 2] =
        [Jump { at: 2.25, before: 2.5, after: 6.0 }, Jump { at: 2.5, before: 6.5, after: 6.5 }];

    fn at(time: f64) -> [f64; 2] {
        broken_at(|k| SAMPLES[k], 4, &JUMPS, time)
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
            assert_eq!(broken_at(|k| SAMPLES[k], 4, near.at(time), time), at(time), "{time}");
        }
    }

    #[test]
    fn a_delay_moves_samples_and_jumps_alike() {
        for late in [0.0, 0.25, 0.5, 1.0, 1.375] {
            let (mut jumps, mut out) = (JUMPS.to_vec(), [0.0; 5]);
            Delay::new(1.0, late).pass_broken(|k| SAMPLES[k], 5, &mut jumps, |k, value| out[k] = value);
            for k in 0..40 {
                let time = late + f64::from(k) * 0.1 + 0.03;
                let [value, _] = broken_at(|k| out[k], 4, &jumps, time);
                // Bends of a delayed signal lie between samples too: only jumps are kept as such.
                let near = [1.0, 2.0, 3.0].iter().any(|bend| (time - late - bend).abs() < 1.0);
                assert!(time > 4.0 || near || (value - at(time - late)[0]).abs() < 1e-12, "{late} {time}");
            }
            let moved = |k: usize| jumps[k].at == JUMPS[k].at + late;
            assert!(jumps.len() == 2 && moved(0) && moved(1));
            assert_eq!(out[4], at(4.0 - late)[1]);
        }
    }
}
