//! One crater along all sweeps of a group: its law is asked for eight lanes at a time.

use fearless_simd::prelude::{ExtractToken, Select, SimdBase, SimdFrom, SimdMask};
use fearless_simd::{Simd, f64x8};
use features::Crater;
use signal::{Comparable, LANES, Lanes, Number, Real, eight};

use crate::Surface;
use crate::chord::half_chord;
use crate::passing::Passing;
use crate::sub_generator::{Parabola, around, hollow, ring};

/// What craters are laid on.
pub(crate) struct TerrainBelow<'a, 's, S, P> {
    /// Ground range of each sample, ascending (m).
    pub ranges: &'a [f64],
    /// Where a range (m) is on the sweep clock, sample k at k.
    pub place: P,
    /// Samples of the profile of each sweep.
    pub samples: [usize; LANES],
    pub surface: Surface<'s, S>,
    /// 1 wherever a crater adds anything, if anybody asks.
    pub present: Option<&'s mut [Lanes<S>]>,
}

/// Part of a crater along the sweeps, from its leading to its far end: offsets from where each passes the centre (m).
#[derive(Clone, Copy)]
struct Zone<L: Simd> {
    begin: f64x8<L>,
    end: f64x8<L>,
}

impl<L: Simd> Zone<L> {
    #[inline(always)]
    fn ends(self) -> [[f64; LANES]; 2] {
        [self.begin.to_array(), self.end.to_array()]
    }
}

/// Where the sweeps pass a crater: range of the centre (m), and the centre to the left (m).
#[derive(Clone, Copy)]
struct Centre<L: Simd, S: Real> {
    middle: f64x8<L>,
    left: S::Vector<L>,
}

/// A crater as it lies across the samples.
#[derive(Clone, Copy, Default)]
pub(crate) struct Lie {
    /// Of rim, hollow and rim, from where to where in each sweep: offsets from where it passes the centre (m).
    zones: [[[f64; LANES]; 2]; 3],
    /// First sample about which a step lies partly in the zone in any sweep, and the first that is beyond.
    samples: [[usize; 2]; 3],
}

impl<S: Real, P: Fn(f64) -> f64> TerrainBelow<'_, '_, S, P> {
    /// Finds where a crater lies.
    #[inline(always)]
    pub fn find<L: Simd>(&self, simd: L, crater: &Crater, passing: &Passing) -> Lie {
        let (middle, side) = (eight(simd, &passing.middle), eight(simd, &passing.side));
        let [near_ring, inside, far_ring] = zones(crater, side, eight(simd, &passing.from) - middle);
        Lie {
            zones: [near_ring.ends(), inside.ends(), far_ring.ends()],
            samples: [
                self.samples_in(simd, near_ring, middle),
                self.samples_in(simd, inside, middle),
                self.samples_in(simd, far_ring, middle),
            ],
        }
    }

    /// Adds a crater where it lies.
    #[inline(always)]
    pub fn lay<L: Simd>(&mut self, simd: L, crater: &Crater, passing: &Passing, lie: &Lie) {
        let (middle, side) = (eight(simd, &passing.middle), eight(simd, &passing.side));
        let centre = Centre { middle, left: S::narrow(-side) };
        let (rim, bowl) = (ring(crater).cast(), hollow(crater).cast());
        self.lay_zone(simd, &rim, Parabola::ring, lie, 0, centre);
        if crater.floor() > 0.0 {
            self.lay_zone(simd, &bowl, Parabola::floor_and_wall, lie, 1, centre);
        } else {
            self.lay_zone(simd, &bowl, Parabola::bowl, lie, 1, centre);
        }
        self.lay_zone(simd, &rim, Parabola::ring, lie, 2, centre);
    }

    /// Adds what lies in a zone: heights to the samples in it, slopes to each sample by as much of the step about it as lies in
    /// the zone.
    #[inline(always)]
    fn lay_zone<L: Simd>(
        &mut self,
        simd: L,
        parabola: &Parabola<S>,
        law: impl Fn(&Parabola<S::Vector<L>>, S::Vector<L>) -> [S::Vector<L>; 2],
        lie: &Lie,
        zone: usize,
        Centre { middle, left }: Centre<L, S>,
    ) {
        let [first, beyond] = lie.samples[zone];
        if first >= beyond {
            return;
        }
        let all = |value: S| S::Vector::<L>::simd_from(simd, value);
        let Parabola { vertex, rise, at, scale } = *parabola;
        let parabola = Parabola { vertex: all(vertex), rise: all(rise), at: all(at), scale: all(scale) };
        let [begin, end] = &lie.zones[zone];
        let [begin, end] = [S::narrow(eight(simd, begin)), S::narrow(eight(simd, end))];
        let counts = self.samples.map(|samples| S::from_f64(samples as f64));
        let (counts, zero) = (S::Vector::<L>::from_slice(simd, &counts), all(S::ZERO));
        let mut before = self.steps_a_metre(first);
        for sample in first..beyond {
            let behind = self.steps_a_metre(sample + 1);
            // The difference is taken in f64: far away a range has no millimetres left in f32.
            let offset = S::narrow::<L>(eight(simd, &[self.ranges[sample]; LANES]) - middle);
            let steps = [before, behind].map(|steps| all(S::from_f64(steps)));
            let share = in_step::<L, S>(end - offset, steps) - in_step::<L, S>(begin - offset, steps);
            let is_laid = share.simd_gt(zero) & all(S::from_f64(sample as f64)).simd_lt(counts);
            if is_laid.any_true() {
                // Beyond its zone a law says nothing: it may be steep there, or have no value.
                let nearest = end.at_most(offset.at_least(begin));
                let [height, rise_along, rise_across] =
                    around(nearest, left, |square| law(&parabola, square));
                let is_inside = is_laid & offset.simd_ge(begin) & offset.simd_lt(end);
                let Surface { height: heights, along, across } = &mut self.surface;
                add::<L, S>(&mut heights[sample], is_inside.select(height, zero));
                add::<L, S>(&mut along[sample], is_laid.select(share * rise_along, zero));
                add::<L, S>(&mut across[sample], is_laid.select(share * rise_across, zero));
                if let Some(present) = &mut self.present {
                    let present = &mut present[sample];
                    let before = S::Vector::<L>::from_slice(simd, &present.0);
                    is_laid.select(all(S::ONE), before).store_slice(&mut present.0);
                }
            }
            before = behind;
        }
    }

    /// First sample about which a step lies partly in the zone in any sweep, and the first that is beyond; none between them if
    /// no sweep meets it.
    #[inline(always)]
    fn samples_in<L: Simd>(&self, simd: L, Zone { begin, end }: Zone<L>, middle: f64x8<L>) -> [usize; 2] {
        let is_met = begin.simd_lt(end);
        let bound = |value| f64x8::simd_from(simd, value);
        let near = is_met.select(begin + middle, bound(f64::INFINITY)).reduce_min();
        let far = is_met.select(end + middle, bound(f64::NEG_INFINITY)).reduce_max();
        if near >= far {
            return [0; 2];
        }
        let count = self.samples.into_iter().max().unwrap_or_default();
        let [first, last] = [(near, 0.5 - SLACK), (far, 0.5 + SLACK)]
            .map(|(range, half)| ((self.place)(range) + half).max(0.0) as usize);
        [first, count.min(last + 1)]
    }

    /// Steps a metre in the step that ends at `sample`. Before the first sample and beyond the last nothing is about a
    /// sample: there all that is not the sample itself is more than half a step away.
    #[inline(always)]
    fn steps_a_metre(&self, sample: usize) -> f64 {
        match self.ranges.get(sample) {
            Some(range) if sample > 0 => 1.0 / (range - self.ranges[sample - 1]),
            _ => FAR_AWAY,
        }
    }
}

/// Part of a step by which rounding may put the end of a zone nearer or farther: whether a sample has a share is each lane's own
/// matter, and no neighbour's.
const SLACK: f64 = 0.0625;

/// Steps a metre where there are none: times a millimetre still more than any sweep has.
const FAR_AWAY: f64 = 1e9;

/// What the sweeps meet of a crater that is drawn from an offset on: rim, hollow, rim. Where they meet no hollow, the first is
/// all.
#[inline(always)]
fn zones<L: Simd>(crater: &Crater, side: f64x8<L>, from: f64x8<L>) -> [Zone<L>; 3] {
    let zero = side.like(0.0);
    let [outer, foot] = [half_chord(crater.outer(), side), half_chord(crater.foot(), side)];
    let is_met = foot.simd_gt(zero);
    let begin = is_met.select(-foot, outer).at_least(from);
    let end = is_met.select(foot, outer).at_least(from);
    let [leading, far] = [(-outer).at_least(from), outer.at_least(from)];
    [Zone { begin: leading, end: begin }, Zone { begin, end }, Zone { begin: end, end: far }]
}

#[inline(always)]
fn add<L: Simd, S: Real>(sums: &mut Lanes<S>, values: S::Vector<L>) {
    (S::Vector::<L>::from_slice(values.token(), &sums.0) + values).store_slice(&mut sums.0);
}

/// Where a place `way` behind a sample (m) lies on the sweep clock, in steps from the sample and no farther than half a step;
/// `steps` a metre before and behind it.
#[inline(always)]
fn in_step<L: Simd, S: Real>(way: S::Vector<L>, [before, behind]: [S::Vector<L>; 2]) -> S::Vector<L> {
    let [zero, half] = [0.0, 0.5].map(|value| way.like(value));
    let place = way * way.simd_lt(zero).select(before, behind);
    half.at_most(place.at_least(-half))
}
