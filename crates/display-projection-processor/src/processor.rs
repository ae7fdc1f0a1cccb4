//! Elevation, occlusion and deflection of a group of sweeps.

use fearless_simd::{Level, dispatch};
use landscape::parabolic_drop;
use scenario::{Curvature, Occlusion};
use signal::{Break, Breaks, LANES, Lanes, Real, Signal, Unit};

use crate::occlusion::{Memory, all, beyond, derivative, occlude, peak_hold};
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
pub(crate) trait Take<S> {
    /// The next sample.
    fn take(&mut self, sample: usize, place: Place<S>);
}

/// One sample on its way through the processor, lane by lane: see [`Projected`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place<S> {
    pub elevation: Lanes<S>,
    pub hold: Lanes<S>,
    pub entry: Lanes<S>,
    pub line: Lanes<S>,
}

impl<S: Real> Processor<S> {
    /// A processor for samples at `ranges` (m, ascending, above 0).
    pub fn new(occlusion: Occlusion, curvature: Curvature, ranges: &[f64]) -> Self {
        Self {
            occlusion,
            curvature,
            ranges: ranges.to_vec(),
            inverse_range: ranges.iter().map(|&range| S::from_f64(1.0 / range)).collect(),
            drop: ranges.iter().map(|&range| S::from_f64(drop_at(curvature, range))).collect(),
            vectors: Level::new(),
        }
    }

    /// Projects the profiles of a group; `height` is above the eye (m), `deflection` in lines.
    pub fn run(&self, height: &[Lanes<S>], deflection: &[Deflection; LANES], out: &mut Projected<S>) {
        out.breaks.clear();
        dispatch!(self.vectors, _ => self.run_smooth(height, deflection, out));
    }

    #[inline(always)]
    fn run_smooth(&self, height: &[Lanes<S>], deflection: &[Deflection; LANES], out: &mut Projected<S>) {
        out.resize(height.len());
        self.walk(height, deflection, &mut All { by: DeflectionLanes::new(deflection), out });
    }

    /// Hands each sample of profiles without bends to `taker`.
    #[inline(always)]
    pub(crate) fn walk(
        &self,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        taker: &mut impl Take<S>,
    ) {
        match self.occlusion {
            Occlusion::PeakHold => self.walk_by(peak_hold, height, deflection, taker),
            Occlusion::Derivative => self.walk_by(derivative, height, deflection, taker),
        }
    }

    /// By one circuit. In one pass: a loop without a memory from sample to sample would
    /// be turned into vectors along the samples, and they lie apart.
    #[inline(always)]
    fn walk_by(
        &self,
        circuit: impl Fn(S, S, S) -> S,
        height: &[Lanes<S>],
        deflection: &[Deflection; LANES],
        taker: &mut impl Take<S>,
    ) {
        let samples = height.len();
        if samples == 0 {
            return;
        }
        let by = DeflectionLanes::new(deflection);
        let (drop, inverse) = (&self.drop[..samples], &self.inverse_range[..samples]);
        let tangent =
            |sample: usize| (height[sample] - Lanes::splat(drop[sample])) * Lanes::splat(inverse[sample]);
        let mut now = tangent(0);
        let mut memory = Memory::new(now);
        let (mut held, mut held_at) = (now, by.at(now));
        for sample in 0..samples {
            let after = if sample + 1 < samples { tangent(sample + 1) } else { beyond() };
            let entry = memory.step(now, after, &circuit);
            let hold = memory.hold();
            // Half of all samples are hidden in all lanes: what is held stands.
            if !all(|lane| hold[lane] == held[lane]) {
                (held, held_at) = (hold, by.at(hold));
            }
            taker.take(sample, Place { elevation: now, hold, entry, line: held_at });
            now = after;
        }
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
        match self.occlusion {
            Occlusion::PeakHold => occlude(out, broken, peak_hold),
            Occlusion::Derivative => occlude(out, broken, derivative),
        }
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
        S::from_f64((place.height.to_f64() - drop_at(self.curvature, range)) / range)
    }
}

fn drop_at(curvature: Curvature, range: f64) -> f64 {
    match curvature {
        Curvature::None => 0.0,
        Curvature::Parabolic => parabolic_drop(range),
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
struct All<'a, S> {
    by: DeflectionLanes<S>,
    out: &'a mut Projected<S>,
}

impl<S: Real> Take<S> for All<'_, S> {
    #[inline(always)]
    fn take(&mut self, sample: usize, place: Place<S>) {
        let Projected { elevation, hold, entry, position, line, .. } = self.out;
        (elevation[sample], hold[sample]) = (place.elevation, place.hold);
        (entry[sample], line[sample]) = (place.entry, place.line);
        position[sample] = self.by.at(place.elevation);
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

/// The deflections of a group side by side.
struct DeflectionLanes<S> {
    a: Lanes<S>,
    b: Lanes<S>,
    c: Lanes<S>,
    e: Lanes<S>,
}

impl<S: Real> DeflectionLanes<S> {
    #[inline(always)]
    fn new(deflection: &[Deflection; LANES]) -> Self {
        let lanes =
            |part: fn(&Deflection) -> f64| Lanes::from_fn(|lane| S::from_f64(part(&deflection[lane])));
        Self { a: lanes(|d| d.a), b: lanes(|d| d.b), c: lanes(|d| d.c), e: lanes(|d| d.e) }
    }
    #[inline(always)]
    fn at(&self, tangent: Lanes<S>) -> Lanes<S> {
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
            lines.clear();
            lines.extend(tangents.iter().map(|&tangent| (a - b * tangent) / (c + e * tangent)));
        }
    }
}

#[cfg(test)]
mod tests;
