//! A signal that is straight between its samples, but for places at which it jumps or bends.

/// A place at which a signal jumps or bends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// Its instant (steps from the first sample).
    pub at: f64,
    /// Value just before it.
    pub before: f64,
    /// Value just after it.
    pub after: f64,
}

/// A signal of a sweep.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Broken {
    /// Values at the samples.
    pub samples: Vec<f64>,
    /// Places between them, ascending.
    pub jumps: Vec<Jump>,
}

impl Broken {
    /// Value just before and just after `time` (steps); before the first sample and behind the last it stands.
    pub fn at(&self, time: f64) -> [f64; 2] {
        let end = time.max(0.0).ceil() as usize;
        let (Some(&first), Some(&last)) = (self.samples.first(), self.samples.last()) else {
            return [0.0; 2];
        };
        if end == 0 {
            return [first; 2];
        }
        let Some(&target) = self.samples.get(end) else { return [last; 2] };
        let step = (end - 1) as f64;
        let of_step = || self.jumps.iter().filter(|jump| jump.at >= step && jump.at <= end as f64);
        let mut here = of_step().filter(|jump| jump.at == time);
        if let Some(jump) = here.next() {
            return [jump.before, here.next_back().unwrap_or(jump).after];
        }
        let from = of_step().rfind(|jump| jump.at < time);
        let to = of_step().find(|jump| jump.at > time);
        let (start, value) = from.map_or((step, self.samples[end - 1]), |jump| (jump.at, jump.after));
        let (stop, target) = to.map_or((end as f64, target), |jump| (jump.at, jump.before));
        [value + (target - value) * ((time - start) / (stop - start)); 2]
    }

    /// The same signal `late` steps later; before the sweep it stood as it begins.
    pub fn delayed(&self, late: f64) -> Self {
        let samples = (0..self.samples.len()).map(|sample| self.at(sample as f64 - late)[1]).collect();
        let jumps = self.jumps.iter().map(|jump| Jump { at: jump.at + late, ..*jump });
        Self { samples, jumps: jumps.collect() }
    }
}
