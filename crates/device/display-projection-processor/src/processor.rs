//! Elevation, occlusion and deflection of a group of sweeps.

use std::ops::{Add, Div, Mul, Sub};

use fearless_simd::prelude::{SimdBase, SimdMask};
use fearless_simd::{Level, Simd, dispatch};
use scenario::{Curvature, Occlusion};
use signal::{Break, Breaks, LANES, Lanes, Number, Real, Signal, Unit};

use crate::occlusion::{BEYOND, Circuit, Derivative, Memory, PeakHold, occlude};
use crate::{BrokenProfile, Deflection};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::ground("dpp.elevation", Unit::Tangent, "tangent of the elevation of the profile", "fig. 30"),
    Signal::ground(
        "dpp.derivative",
        Unit::TangentRate,
        "change of the elevation: below 0 it falls; where occlusion is by derivative",
        "fig. 30",
    ),
    Signal::ground("dpp.blank", Unit::Gate, "1 while the profile is hidden by nearer ground", "fig. 30"),
    Signal::ground(
        "dpp.hold",
        Unit::Tangent,
        "highest elevation so far: what the sample-and-hold keeps",
        "fig. 30",
    ),
    Signal::ground("dpp.y", Unit::Line, "line position of the write beam, from the top", "fig. 30"),
];

/// What the block is set to for a run: tables over the sweep.
#[derive(Debug, Clone)]
pub struct Processor<S> {
    occlusion: Occlusion,
    curvature: Curvature,
    ranges: Vec<f64>,
    inverse_range: Vec<S>,
    drop: Vec<S>,
    /// Vectors of the computer.
    pub(crate) vectors: Level,
}

/// Outputs of a group: one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub struct Projected<S> {
    /// Tangent of the elevation.
    pub elevation: Vec<Lanes<S>>,
    /// Highest tangent so far, tops between samples included.
    pub hold: Vec<Lanes<S>>,
    /// Part of the step from the sample before, 0..=1, at which the profile comes back into sight, for the last time
    /// if it does so more than once; 0 if it was in sight.
    pub entry: Vec<Lanes<S>>,
    /// Line position of the elevation itself, in sight or not, from the top of the picture.
    pub position: Vec<Lanes<S>>,
    /// Line position of the held elevation: never grows.
    pub line: Vec<Lanes<S>>,
    /// The same at the breaks.
    pub breaks: ProjectedBreaks<S>,
}

/// Outputs at the breaks: lane by lane, one value a break, in their order.
#[derive(Debug, Clone, Default)]
pub struct ProjectedBreaks<S> {
    /// Tangent of the elevation.
    pub elevation: [Vec<S>; LANES],
    /// Highest tangent so far, just after it.
    pub hold: [Vec<S>; LANES],
    /// Line position of the elevation.
    pub position: [Vec<S>; LANES],
    /// Line position of the held elevation.
    pub line: [Vec<S>; LANES],
}

/// Takes what a walk finds. No closure: those that the compiler does not inline lose the vectors of their caller.
pub(crate) trait Take<L: Simd, S: Real> {
    /// Takes the next sample of the walk.
    fn take(&mut self, sample: usize, place: Place<L, S>);
}

/// One sample on its way through the processor, in all lanes: see [`Projected`].
#[derive(Clone, Copy)]
pub(crate) struct Place<L: Simd, S: Real> {
    pub elevation: S::Vector<L>,
    pub hold: S::Vector<L>,
    pub entry: S::Vector<L>,
    pub line: S::Vector<L>,
}

impl<S: Real> Processor<S> {
    /// A processor for samples at `ranges` (m, ascending, above 0).
    pub fn new(occlusion: Occlusion, curvature: Curvature, ranges: &[f64]) -> Self {
        Self {
            occlusion,
            curvature,
            ranges: ranges.to_vec(),
            inverse_range: ranges.iter().map(|&range| S::from_f64(1.0 / range)).collect(),
            drop: ranges.iter().map(|&range| S::from_f64(curvature.drop(range))).collect(),
            vectors: Level::new(),
        }
    }

    /// Projects the profiles of a group; `height` is above the eye (m), `deflection` in lines.
    pub fn run(&self, height: &[Lanes<S>], deflection: &[Deflection; LANES], out: &mut Projected<S>) {
        out.breaks.clear();
        dispatch!(self.vectors, simd => self.run_smooth(simd, height, deflection, out));
    }

    #[inline(always)]
    fn run_smooth<L: Simd>(
        &self,
        simd: L,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        out: &mut Projected<S>,
    ) {
        out.resize(height.len());
        let by = DeflectionLanes::<Lanes<S>>::new(deflection).in_vectors(simd);
        self.walk(simd, height, deflection, &mut All::<L, S> { by, out });
    }

    /// Hands each sample of profiles without bends to `taker`.
    #[inline(always)]
    pub(crate) fn walk<L: Simd>(
        &self,
        simd: L,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        taker: &mut impl Take<L, S>,
    ) {
        match self.occlusion {
            Occlusion::PeakHold => self.walk_by::<L, PeakHold>(simd, height, deflection, taker),
            Occlusion::Derivative => self.walk_by::<L, Derivative>(simd, height, deflection, taker),
        }
    }

    /// By one circuit, in one pass.
    #[inline(always)]
    fn walk_by<L: Simd, C: Circuit>(
        &self,
        simd: L,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        taker: &mut impl Take<L, S>,
    ) {
        let samples = height.len();
        if samples == 0 {
            return;
        }
        let by = DeflectionLanes::<Lanes<S>>::new(deflection).in_vectors(simd);
        let mut now = self.tangent(simd, height, 0);
        let mut running = Memory::new(now);
        let (mut held, mut held_at) = (now, by.at(now));
        for sample in 0..samples {
            let after =
                if sample + 1 < samples { self.tangent(simd, height, sample + 1) } else { now.like(BEYOND) };
            let entry = running.step::<C>(now, after);
            let hold = running.hold;
            // Half of all samples are hidden in all lanes: what is held stands.
            if !hold.simd_eq(held).all_true() {
                (held, held_at) = (hold, by.at(hold));
            }
            taker.take(sample, Place { elevation: now, hold, entry, line: held_at });
            now = after;
        }
    }

    /// Tangent of the elevation of a sample.
    #[inline(always)]
    fn tangent<L: Simd>(&self, simd: L, height: &[Lanes<S>], sample: usize) -> S::Vector<L> {
        let height = S::Vector::<L>::from_slice(simd, &height[sample].0);
        (height - self.drop[sample]) * self.inverse_range[sample]
    }

    /// The same for profiles that bend between samples. Breaks that do not bend the profile are projected, and the
    /// circuits do not see them.
    pub fn run_broken(
        &self,
        height: &[Lanes<S>],
        broken: BrokenProfile<'_, S>,
        deflection: &[Deflection; LANES],
        out: &mut Projected<S>,
    ) {
        self.elevate(height, out);
        self.elevate_breaks(broken.breaks, &mut out.breaks);
        dispatch!(self.vectors, simd => match self.occlusion {
            Occlusion::PeakHold => occlude::<_, S, PeakHold>(simd, out, broken),
            Occlusion::Derivative => occlude::<_, S, Derivative>(simd, out, broken),
        });
        deflect(deflection, out);
        deflect_breaks(deflection, &mut out.breaks);
    }

    fn elevate(&self, height: &[Lanes<S>], out: &mut Projected<S>) {
        out.resize(height.len());
        self.tangents(height, &mut out.elevation);
    }

    /// Tangent of the elevation of each sample.
    pub(crate) fn tangents(&self, height: &[Lanes<S>], elevation: &mut [Lanes<S>]) {
        let tables = self.drop.iter().zip(&self.inverse_range);
        for ((elevation, &height), (&drop, &inverse)) in elevation.iter_mut().zip(height).zip(tables) {
            *elevation = (height - Lanes::splat(drop)) * Lanes::splat(inverse);
        }
    }

    fn elevate_breaks(&self, breaks: &Breaks<S>, out: &mut ProjectedBreaks<S>) {
        for ((elevation, hold), breaks) in out.elevation.iter_mut().zip(&mut out.hold).zip(breaks) {
            elevation.clear();
            elevation.extend(breaks.iter().map(|place| self.elevation_of(place)));
            hold.resize(breaks.len(), S::ZERO);
        }
    }

    /// Range grows in a straight line between two samples, as the sweep generator's does.
    fn elevation_of(&self, place: &Break<S>) -> S {
        let (near, far) = (self.ranges[place.sample - 1], self.ranges[place.sample]);
        let range = near + place.share.to_f64() * (far - near);
        S::from_f64((place.height.to_f64() - self.curvature.drop(range)) / range)
    }
}

impl<S: Real> ProjectedBreaks<S> {
    fn clear(&mut self) {
        for signal in [&mut self.elevation, &mut self.hold, &mut self.position, &mut self.line] {
            signal.iter_mut().for_each(Vec::clear);
        }
    }
}

/// All that the processor says of a group.
struct All<'a, L: Simd, S: Real> {
    by: DeflectionLanes<S::Vector<L>>,
    out: &'a mut Projected<S>,
}

impl<L: Simd, S: Real> Take<L, S> for All<'_, L, S> {
    #[inline(always)]
    fn take(&mut self, sample: usize, place: Place<L, S>) {
        let Projected { elevation, hold, entry, position, line, .. } = self.out;
        place.elevation.store_slice(&mut elevation[sample].0);
        place.hold.store_slice(&mut hold[sample].0);
        place.entry.store_slice(&mut entry[sample].0);
        place.line.store_slice(&mut line[sample].0);
        self.by.at(place.elevation).store_slice(&mut position[sample].0);
    }
}

impl<S: Real> Projected<S> {
    fn resize(&mut self, samples: usize) {
        let Self { elevation, hold, entry, position, line, .. } = self;
        for signal in [elevation, hold, entry, position, line] {
            signal.resize(samples, Lanes::default());
        }
    }
}

fn deflect<S: Real>(deflection: &[Deflection; LANES], out: &mut Projected<S>) {
    deflect_samples(deflection, &out.elevation, &mut out.position);
    deflect_samples(deflection, &out.hold, &mut out.line);
}

/// The deflections of a group side by side, or of one sweep.
struct DeflectionLanes<T> {
    a: T,
    b: T,
    c: T,
    e: T,
}

impl<S: Real> DeflectionLanes<Lanes<S>> {
    #[inline(always)]
    fn new(deflection: &[Deflection; LANES]) -> Self {
        let lanes =
            |part: fn(&Deflection) -> f64| Lanes::from_fn(|lane| S::from_f64(part(&deflection[lane])));
        Self { a: lanes(|d| d.a), b: lanes(|d| d.b), c: lanes(|d| d.c), e: lanes(|d| d.e) }
    }

    #[inline(always)]
    fn in_vectors<L: Simd>(&self, simd: L) -> DeflectionLanes<S::Vector<L>> {
        let [a, b, c, e] =
            [&self.a, &self.b, &self.c, &self.e].map(|lanes| S::Vector::<L>::from_slice(simd, &lanes.0));
        DeflectionLanes { a, b, c, e }
    }
}

impl<T> DeflectionLanes<T>
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    #[inline(always)]
    fn at(&self, tangent: T) -> T {
        (self.a - self.b * tangent) / (self.c + self.e * tangent)
    }
}

/// Line positions of tangents.
pub(crate) fn deflect_samples<S: Real>(
    deflection: &[Deflection; LANES],
    tangents: &[Lanes<S>],
    lines: &mut [Lanes<S>],
) {
    let by = DeflectionLanes::new(deflection);
    for (line, &tangent) in lines.iter_mut().zip(tangents) {
        *line = by.at(tangent);
    }
}

fn deflect_breaks<S: Real>(deflection: &[Deflection; LANES], out: &mut ProjectedBreaks<S>) {
    let ProjectedBreaks { elevation, hold, position, line } = out;
    for (tangents, lines) in [(elevation, position), (hold, line)] {
        for ((tangents, lines), by) in tangents.iter().zip(lines).zip(deflection) {
            let [a, b, c, e] = [by.a, by.b, by.c, by.e].map(S::from_f64);
            let by = DeflectionLanes { a, b, c, e };
            lines.clear();
            lines.extend(tangents.iter().map(|&tangent| by.at(tangent)));
        }
    }
}

#[cfg(test)]
mod tests;
