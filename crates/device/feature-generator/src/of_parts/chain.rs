//! A group of sweeps through the sub-generators of parts.

use features::{Crater, Features};
use hardware_model::{AnalogParts, FeatureParts};
use parts::{GateEdge, LagStep, Spread};
use signal::{LANES, Lanes, Real};

use crate::grain::{Footprint, begin, up_to};
use crate::of_parts::footprint::{self, Rim};
use crate::of_parts::sub_generator::Chain;
use crate::steps::{Step, collect};
use crate::sub_generator::{SubGenerator, Zone};
use crate::{FeatureLoad, FeatureProfile, FeatureProgram, Kink};

/// Sub-generators of a type that differ from one another where there may be any number.
pub const MOST: u32 = 64;

/// A chain below this share of a crater's height is at rest.
const AT_REST: f64 = 1e-9;

/// The generator, its parts drawn once from the seed of the model.
#[derive(Debug, Clone)]
pub struct PartsFeatures {
    /// Length of a sample (s).
    h: f64,
    /// Of each crater type.
    chains: [Vec<Chain>; 3],
    /// Whether footprints are found by comparators that mind how they are met.
    has_comparators: bool,
}

/// Buffers of a group, used again; and where its craters are lit.
#[derive(Debug, Clone, Default)]
pub struct ChainScratch<S> {
    /// 1 where a chain is at work: inside its footprint, and behind it until it is at rest.
    pub lit: Vec<Lanes<S>>,
    /// Changes of the presence line, ascending, which is 0 as a sweep begins; of a generator with comparators
    /// ([`PartsFeatures::has_comparators`]) alone.
    pub gates: [Vec<GateEdge>; LANES],
    rims: Vec<Rim>,
    at_work: Vec<AtWork>,
    steps: Vec<Step>,
    /// Of each kink of the lane: its load and the zone that it leads to.
    marks: Vec<(u32, Zone)>,
}

impl PartsFeatures {
    /// For samples that are `h` seconds apart; `seed` is the model's.
    pub fn new(h: f64, features: &FeatureParts, parts: &AnalogParts, seed: u64) -> Self {
        let (spread, count) = (Spread::new(seed), features.sub_generators.unwrap_or(MOST).clamp(1, MOST));
        let chain = |kind: usize| move |index: u32| Chain::new(h, parts, &spread, kind, u64::from(index));
        let has_comparators = parts.comparator.offset > 0.0 || parts.comparator.overdrive > 0.0;
        let chains = std::array::from_fn(|kind| (0..count).map(chain(kind)).collect());
        Self { h, chains, has_comparators }
    }

    #[cfg(test)]
    pub(crate) fn of(h: f64, chain: Chain) -> Self {
        let has_comparators = chain.threshold != 0.0;
        Self { h, chains: std::array::from_fn(|_| vec![chain]), has_comparators }
    }

    /// Whether its presence line is that of comparators that mind how a footprint is met: [`ChainScratch::gates`].
    pub fn has_comparators(&self) -> bool {
        self.has_comparators
    }

    /// Runs the programs of a group side by side into `profile`, along `directions` (cosine, sine of azimuth) over samples
    /// at `ranges` (m, ascending); `features` are those from which the programs were written. The profile's presence is
    /// that of the comparators, the places of its kinks are those of the footprints as the sub-generators have them; both
    /// are before any delay.
    pub fn run<S: Real>(
        &self,
        features: &Features,
        ranges: &[f64],
        programs: &[FeatureProgram; LANES],
        directions: &[[f64; 2]; LANES],
        scratch: &mut ChainScratch<S>,
        profile: &mut FeatureProfile<S>,
    ) {
        profile.clear(ranges.len());
        scratch.lit.clear();
        scratch.lit.resize(ranges.len(), Lanes::default());
        for (lane, program) in programs.iter().enumerate() {
            let last = ranges.partition_point(|&range| range <= program.end_range);
            let sweep = Sweep { h: self.h, ranges: &ranges[..last], lane };
            self.load(features, program, directions[lane], scratch);
            sweep.find_kinks(scratch, profile);
            if self.has_comparators {
                footprint::unite(&mut scratch.rims, &mut scratch.gates[lane]);
                sweep.follow(&scratch.gates[lane], profile);
            }
            for load in 0..scratch.at_work.len() {
                sweep.draw(load as u32, scratch, profile);
            }
        }
    }

    /// What craters add to the gain of texture, as [`FeatureGenerator::grain`](crate::FeatureGenerator::grain): by the footprints that
    /// the sub-generators make of them.
    pub fn grain<S: Real>(
        &self,
        features: &Features,
        ranges: &[f64],
        programs: &[FeatureProgram; LANES],
        directions: &[[f64; 2]; LANES],
        added: impl Fn(u32) -> f64,
        grain: &mut Vec<Lanes<S>>,
    ) {
        begin(ranges, grain);
        for (lane, program) in programs.iter().enumerate() {
            let ranges = up_to(ranges, program.end_range);
            for load in &program.loads {
                let crater = features.crater(load.crater);
                let chain = self.chain(crater.type_number(), load);
                let (made, load) = chain.distorted(&crater, load, directions[lane]);
                Footprint::of(&made, &load).add(added(crater.type_number()), ranges, lane, grain);
            }
        }
    }

    fn load<S: Real>(
        &self,
        features: &Features,
        program: &FeatureProgram,
        direction: [f64; 2],
        scratch: &mut ChainScratch<S>,
    ) {
        scratch.at_work.clear();
        scratch.steps.clear();
        scratch.rims.clear();
        for (number, load) in (0..).zip(&program.loads) {
            let crater = &features.crater(load.crater);
            let chain = self.chain(crater.type_number(), load);
            let (crater, load) = chain.distorted(crater, load, direction);
            collect(&crater, &load, number, &mut scratch.steps);
            footprint::collect(&crater, &load, chain.threshold, &mut scratch.rims);
            scratch.at_work.push(AtWork::new(&crater, &load, chain));
        }
        scratch.steps.sort_unstable();
    }

    fn chain(&self, kind: u32, load: &FeatureLoad) -> &Chain {
        let chains = &self.chains[kind as usize - 1];
        &chains[load.sub_generator as usize % chains.len()]
    }
}

/// A sub-generator with a crater in it.
#[derive(Debug, Clone)]
struct AtWork {
    law: SubGenerator,
    chain: Chain,
    /// Outputs below which it is at rest.
    rest: [f64; 3],
    /// The first sample behind its first circle, with the number of the kink there; none if that is beyond the sweep.
    begin: Option<(usize, usize)>,
    /// What it is in at the first sample.
    zone: Zone,
    /// Range of its last circle (m).
    last: f64,
}

impl AtWork {
    fn new(crater: &Crater, load: &FeatureLoad, chain: &Chain) -> Self {
        let height = AT_REST * (crater.depth() + crater.rim());
        let slope = height / crater.foot();
        Self {
            law: SubGenerator::new(crater, load),
            chain: *chain,
            rest: [height, slope, slope],
            begin: None,
            zone: Zone::Outside,
            last: f64::INFINITY,
        }
    }
}

/// One lane of the group.
struct Sweep<'a> {
    h: f64,
    /// Of the samples of the profile.
    ranges: &'a [f64],
    lane: usize,
}

/// A sub-generator on its way along a sweep.
struct Walk {
    chain: Chain,
    zone: Zone,
    /// How far into the step, with input and output there.
    share: f64,
    u: [f64; 3],
    y: [f64; 3],
}

impl Sweep<'_> {
    /// Presence at the samples, and kinks where a sub-generator changes its zone between two, whose values come later; where
    /// each is at work.
    fn find_kinks<S: Real>(&self, scratch: &mut ChainScratch<S>, profile: &mut FeatureProfile<S>) {
        scratch.marks.clear();
        let (mut inside, mut sample) = (0_i32, 0);
        for step in &scratch.steps {
            let next = sample + step.sample(&self.ranges[sample..]);
            self.be_present(inside, sample..next, profile);
            sample = next;
            let own = &mut scratch.at_work[step.load() as usize];
            own.last = step.range();
            if sample >= self.ranges.len() {
                continue;
            }
            own.begin.get_or_insert((sample, profile.kinks[self.lane].len()));
            let before = inside > 0;
            let [from, to] = step.zones();
            inside += i32::from(from == Zone::Outside) - i32::from(to == Zone::Outside);
            if sample > 0 {
                let [near, far] = [self.ranges[sample - 1], self.ranges[sample]];
                scratch.marks.push((step.load(), to));
                profile.kinks[self.lane].push(Kink {
                    sample,
                    share: S::from_f64((step.range() - near) / (far - near)),
                    range: step.range(),
                    height: S::ZERO,
                    before: [S::ZERO; 2],
                    after: [S::ZERO; 2],
                    present: [before, inside > 0],
                });
            } else {
                own.zone = to;
            }
        }
        self.be_present(inside, sample..self.ranges.len(), profile);
    }

    /// Presence at the samples, anew, from its changes.
    fn follow<S: Real>(&self, edges: &[GateEdge], profile: &mut FeatureProfile<S>) {
        profile.present.iter_mut().for_each(|sample| sample[self.lane] = S::ZERO);
        let after = |edge: &GateEdge| self.ranges.partition_point(|&range| range < edge.range);
        for pair in edges.chunks_exact(2) {
            self.be_present(1, after(&pair[0])..after(&pair[1]), profile);
        }
    }

    fn be_present<S: Real>(
        &self,
        inside: i32,
        samples: std::ops::Range<usize>,
        profile: &mut FeatureProfile<S>,
    ) {
        if inside > 0 {
            profile.present[samples].iter_mut().for_each(|sample| sample[self.lane] = S::ONE);
        }
    }

    /// Adds what one sub-generator puts out to samples and kinks.
    fn draw<S: Real>(&self, load: u32, scratch: &mut ChainScratch<S>, profile: &mut FeatureProfile<S>) {
        let ChainScratch { at_work, marks, lit, .. } = scratch;
        let AtWork { law, chain, rest, begin, zone, last } = &at_work[load as usize];
        let &Some((first, mut next)) = begin else { return };
        let mut walk = Walk { chain: *chain, zone: *zone, share: 0.0, u: [0.0; 3], y: [0.0; 3] };
        let kinks = &mut profile.kinks[self.lane];
        for sample in first..self.ranges.len() {
            let range = self.ranges[sample];
            if sample == 0 {
                walk.settle(law.at(walk.zone, range));
            } else {
                walk.share = 0.0;
                while let Some(kink) = kinks.get_mut(next).filter(|kink| kink.sample == sample) {
                    walk.cross(law, self.h, kink, (marks[next], load));
                    next += 1;
                }
                walk.end(law.at(walk.zone, range), self.h);
            }
            let outputs = [&mut profile.height, &mut profile.along, &mut profile.across];
            for (signal, value) in outputs.into_iter().zip(walk.y) {
                signal[sample][self.lane] += S::from_f64(walk.chain.gain * value);
            }
            lit[sample][self.lane] = S::ONE;
            if range > *last && walk.is_at_rest(rest) {
                break;
            }
        }
    }
}

impl Walk {
    fn settle(&mut self, u: [f64; 3]) {
        (self.u, self.y) = (u, u);
    }

    /// Over a kink of any load; only its own changes the zone.
    fn cross<S: Real>(
        &mut self,
        law: &SubGenerator,
        h: f64,
        kink: &mut Kink<S>,
        ((load, zone), own): ((u32, Zone), u32),
    ) {
        self.advance(h, kink.share.to_f64(), law.at(self.zone, kink.range));
        let before = self.y;
        if load == own {
            self.zone = zone;
            self.u = law.at(zone, kink.range);
        }
        let after = if self.chain.tau == 0.0 { self.u } else { before };
        let value = |value: f64| S::from_f64(self.chain.gain * value);
        kink.height += value(before[0]);
        for (sum, values) in [(&mut kink.before, before), (&mut kink.after, after)] {
            sum[0] += value(values[1]);
            sum[1] += value(values[2]);
        }
    }

    /// To the end of the step, where the law has `u`.
    fn end(&mut self, u: [f64; 3], h: f64) {
        if self.share == 0.0 {
            for ((y, before), now) in self.y.iter_mut().zip(self.u).zip(u) {
                *y = self.chain.lag.step(*y, before, now);
            }
            self.u = u;
        } else {
            self.advance(h, 1.0, u);
        }
    }

    fn advance(&mut self, h: f64, share: f64, u: [f64; 3]) {
        let lag = LagStep::part(h * (share - self.share).max(0.0), self.chain.tau);
        for ((y, before), now) in self.y.iter_mut().zip(self.u).zip(u) {
            *y = lag.step(*y, before, now);
        }
        (self.share, self.u) = (share, u);
    }

    fn is_at_rest(&self, rest: &[f64; 3]) -> bool {
        self.zone == Zone::Outside && self.y.iter().zip(rest).all(|(y, rest)| y.abs() <= *rest)
    }
}
