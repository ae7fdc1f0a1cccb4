//! Steps of the write beam with breaks in them or beside them.
//!
//! A bend divides the position of the beam into smooth pieces, any break divides its intensity. Between two samples
//! a piece is drawn along the parabola through three places that it has; no curve reaches across a break.

use std::ops::Range;

use signal::{Breaks, LANES, Real};

use crate::Beam;
use crate::curve::{Curve, MOST_BEND, STRAIGHT, Stretch, chords};
use crate::stroke::Stroke;
use crate::write::at;

/// Breaks of a group: lane by lane, ascending, all arrays of a lane equally long.
#[derive(Debug, Clone, Copy)]
pub struct BeamBreaks<'a, S> {
    /// Where they are, and the intensities on both sides.
    pub breaks: &'a Breaks<S>,
    /// Which of them bend the profile; the others lie on the curve that the beam draws anyway.
    pub bends: &'a [Vec<bool>; LANES],
    /// Line position of the profile there; of those that bend it.
    pub position: &'a [Vec<S>; LANES],
    /// Line position of the highest elevation so far, just after it; of those that bend it.
    pub line: &'a [Vec<S>; LANES],
}

/// How far each lane of a group has come along its breaks.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cursors<'a, S> {
    broken: BeamBreaks<'a, S>,
    /// Breaks of steps that no step ahead touches.
    passed: [usize; LANES],
}

impl<'a, S: Real> Cursors<'a, S> {
    pub fn new(broken: BeamBreaks<'a, S>) -> Self {
        Self { broken, passed: [0; LANES] }
    }

    /// The first step from `sample` on that has a break of any lane in it or beside it.
    pub fn next_disturbed(&self, sample: usize) -> usize {
        let lanes = self.broken.breaks.iter().zip(&self.passed);
        let next = |(breaks, &passed): (&Vec<signal::Break<S>>, _)| {
            let ahead = breaks[passed..].iter().find(|place| place.sample + 1 >= sample)?;
            Some(sample.max(ahead.sample - 1))
        };
        lanes.filter_map(next).min().unwrap_or(usize::MAX)
    }

    /// Leaves behind what no step from that to `sample` on touches in a lane.
    pub fn pass(&mut self, sample: usize, lane: usize) {
        self.passed[lane] = self.ahead(lane, self.passed[lane], sample - 1);
    }

    /// The first break of a lane from `from` on that lies in step `until` or beyond.
    fn ahead(&self, lane: usize, from: usize, until: usize) -> usize {
        from + self.broken.breaks[lane][from..].iter().take_while(|place| place.sample < until).count()
    }

    /// The step to `sample` in a lane, which has been [passed](Self::pass), if a break lies in it or beside it.
    pub fn around(&self, sample: usize, lane: usize) -> Option<BrokenStep<'a, S>> {
        let before = self.passed[lane];
        let begin = self.ahead(lane, before, sample);
        let end = self.ahead(lane, begin, sample + 1);
        let beyond = self.ahead(lane, end, sample + 2);
        (before < beyond).then_some(BrokenStep {
            broken: self.broken,
            sample,
            lane,
            before: before..begin,
            own: begin..end,
            beyond: end..beyond,
        })
    }
}

/// One step of one lane, and which breaks lie in the step before, in it, and in the step beyond.
pub(crate) struct BrokenStep<'a, S> {
    broken: BeamBreaks<'a, S>,
    sample: usize,
    lane: usize,
    before: Range<usize>,
    own: Range<usize>,
    beyond: Range<usize>,
}

impl<S: Real> BrokenStep<'_, S> {
    /// Its strokes, piece by piece between bends: of each piece what rises above the held line.
    pub fn strokes(&self, beam: &Beam<'_, S>, draw: &mut impl FnMut(Stroke)) {
        let line = |sample| at(beam.line, sample, self.lane);
        let (position, light) = self.samples(beam);
        let (mut begin, mut first, mut from) = (None, self.own.start, line(self.sample - 1));
        loop {
            let end = (first..self.own.end).find(|&index| self.broken.bends[self.lane][index]);
            let to = end.map_or_else(|| line(self.sample), |bend| value(self.broken.line, self.lane, bend));
            if to < from {
                let curve =
                    position.between(begin.map(|bend| self.bend(bend)), end.map(|bend| self.bend(bend)));
                let piece = Piece { step: self, position: curve, light: &light };
                piece.strokes([begin, end], first..end.unwrap_or(self.own.end), [from, to], draw);
            }
            let Some(bend) = end else { return };
            (begin, first, from) = (end, bend + 1, to);
        }
    }

    /// Position and intensity at the samples around, as far as no break hides them from the step.
    fn samples(&self, beam: &Beam<'_, S>) -> (Samples, Samples) {
        let around = |signal| {
            let value = |sample: Option<usize>| Some(at(signal, sample?, self.lane));
            let beyond = Some(self.sample + 1).filter(|&sample| sample < beam.line.len());
            let [begin, end] = [self.sample - 1, self.sample].map(|sample| at(signal, sample, self.lane));
            Samples { near: value(self.sample.checked_sub(2)), begin, end, far: value(beyond) }
        };
        let (mut position, mut light) = (around(beam.position), around(beam.intensity));
        let bends = &self.broken.bends[self.lane];
        let smooth = |steps: &Range<usize>| !bends[steps.clone()].contains(&true);
        let [near, far] = position.belong();
        position.keep(near && smooth(&self.before), far && smooth(&self.beyond));
        light.keep(near && self.before.is_empty(), far && self.beyond.is_empty());
        (position, light)
    }

    fn share(&self, index: usize) -> f32 {
        self.broken.breaks[self.lane][index].share.to_f64() as f32
    }

    /// Share and position of a bend.
    fn bend(&self, index: usize) -> (f32, f32) {
        (self.share(index), value(self.broken.position, self.lane, index))
    }

    /// Share of a break, and the intensities on both sides.
    fn light(&self, index: usize) -> (f32, [f32; 2]) {
        let place = &self.broken.breaks[self.lane][index];
        (self.share(index), [place.before, place.after].map(|value| value.to_f64() as f32))
    }
}

fn value<S: Real>(values: &[Vec<S>; LANES], lane: usize, index: usize) -> f32 {
    values[lane][index].to_f64() as f32
}

/// A quantity at the ends of a step and a sample further, where it is known there.
#[derive(Debug, Clone, Copy)]
struct Samples {
    near: Option<f32>,
    begin: f32,
    end: f32,
    far: Option<f32>,
}

impl Samples {
    /// Which of the outer samples, being positions, belong to the same profile: beyond its end it is far out of sight.
    fn belong(&self) -> [bool; 2] {
        let bend = |a: f32, b: f32, c: f32| (a - 2.0 * b + c).abs() < MOST_BEND;
        [
            self.near.is_some_and(|near| bend(near, self.begin, self.end)),
            self.far.is_some_and(|far| bend(self.begin, self.end, far)),
        ]
    }

    fn keep(&mut self, near: bool, far: bool) {
        self.near = self.near.filter(|_| near);
        self.far = self.far.filter(|_| far);
    }

    /// The part of the step between two breaks, each a share and a value; `None` stands for the end of the step.
    fn between(&self, begin: Option<(f32, f32)>, end: Option<(f32, f32)>) -> Stretch {
        let near = self.near.filter(|_| begin.is_none());
        let far = self.far.filter(|_| end.is_none());
        Stretch::new(begin.unwrap_or((0.0, self.begin)), end.unwrap_or((1.0, self.end)), near, far)
    }
}

/// A part of a step whose position is smooth.
struct Piece<'a, S> {
    step: &'a BrokenStep<'a, S>,
    position: Stretch,
    light: &'a Samples,
}

impl<S: Real> Piece<'_, S> {
    /// Strokes from the held line `from` up to `to`, divided at the breaks `within` that do not bend it. `ends` are
    /// the breaks at its ends; `None` stands for the end of the step.
    fn strokes(
        &self,
        [mut begin, end]: [Option<usize>; 2],
        within: Range<usize>,
        [mut from, to]: [f32; 2],
        draw: &mut impl FnMut(Stroke),
    ) {
        for index in within {
            let held = self.position.at(self.step.share(index)).max(to).min(from);
            self.stretch([begin, Some(index)], [from, held], draw);
            (begin, from) = (Some(index), held);
        }
        self.stretch([begin, end], [from, to], draw);
    }

    /// What rises above the held line between two breaks.
    fn stretch(&self, [begin, end]: [Option<usize>; 2], [from, to]: [f32; 2], draw: &mut impl FnMut(Stroke)) {
        if to >= from {
            return;
        }
        let side = |index: Option<usize>, side: usize| {
            index.map(|index| self.step.light(index)).map(|(share, light)| (share, light[side]))
        };
        let light = self.light.between(side(begin, 1), side(end, 0));
        let [first, last] = light.reach();
        let entry = first + (last - first) * self.entry([first, last], from);
        let straight = Stroke { from, to, start: light.at(entry), end: light.at(last) };
        if self.position.bend() > STRAIGHT.0 || light.bend() > STRAIGHT.1 {
            let chords = chords(&self.position, &light, straight, [entry, last]);
            chords.into_iter().filter(|chord| chord.to < chord.from).for_each(draw);
        } else {
            draw(straight);
        }
    }

    /// Part of a stretch that lies below the held line.
    fn entry(&self, reach: [f32; 2], held: f32) -> f32 {
        let [begin, end] = reach.map(|share| self.position.at(share));
        match (begin > held, end < held) {
            (true, true) => (begin - held) / (begin - end),
            (true, false) => 1.0,
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests;
