//! The third video switch: spans of one sweep over its lines (section 14).

use std::ops::Range;

use fearless_simd::{Level, dispatch};
use scenario::{BodyVisibility, PixelRule};
use signal::{Signal, Unit};

use crate::cover::Cover;
use crate::cut::{self, Sight};
use crate::layers::{Choice, Layers, Part};
use crate::stack::Stack;
use crate::{Hold, Sweep};

/// Signals of the block.
pub const SIGNALS: &[Signal] = &[
    Signal::display("pg.present", Unit::Gate, "1 where a polyhedron is seen: gate of VS3", "fig. 29"),
    Signal::display("pg.reflectivity", Unit::Reflectivity, "reflectivity of the polyhedron seen", "fig. 29"),
];

/// A part of a line position axis over which one face is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// Upper end: line position from the top of the picture.
    pub top: f32,
    /// Lower end: line position from the top of the picture.
    pub bottom: f32,
    /// Reflectivity of the face at the upper end.
    pub reflectivity: f32,
    /// How it changes from line to line downwards (1/line): 0 on a face whose light is flat.
    pub ramp: f32,
}

impl Run {
    /// Reflectivity at a line position of the run.
    #[inline(always)]
    pub(crate) fn reflectivity_on(&self, line: f32) -> f32 {
        self.reflectivity + self.ramp * (line - self.top)
    }

    /// The same of real parts, whose ramp stands still before the run and behind it.
    pub(crate) fn reflectivity_at(&self, line: f64) -> f64 {
        let [top, bottom] = [self.top, self.bottom].map(f64::from);
        f64::from(self.reflectivity) + f64::from(self.ramp) * (line.clamp(top, bottom) - top)
    }

    /// The part of it whose reflectivity exceeds a threshold, if there is any: a ramp passes it once at most.
    fn above(self, threshold: f32) -> Option<Self> {
        let ends = [self.reflectivity, self.reflectivity_on(self.bottom)];
        let passes = || (self.top + (threshold - ends[0]) / self.ramp).clamp(self.top, self.bottom);
        match ends.map(|end| end > threshold) {
            [true, true] => Some(self),
            [true, false] if self.ramp != 0.0 => Some(Self { bottom: passes(), ..self }),
            [false, true] if self.ramp != 0.0 => {
                let top = passes();
                Some(Self { top, reflectivity: self.reflectivity_on(top), ..self })
            }
            _ => None,
        }
    }
}

/// The switch of one sweep and its buffers; one a worker.
#[derive(Debug, Clone, Default)]
pub struct Overlay {
    /// Least and greatest line position that is held where each stack is.
    held: Vec<[f32; 2]>,
    /// What is seen of the spans, stack by stack.
    parts: Vec<Part>,
    /// What is seen of each stack.
    seen: Vec<Range<usize>>,
    layers: Layers,
    runs: Vec<Run>,
    cover: Cover,
}

impl Overlay {
    /// Lays what stands on a `sweep` over its `row` of lines, `row[k]` being the line from position k to k + 1.
    ///
    /// `AsReported`: bodies are seen as a whole, the nearer foot point on top. `Depth`: what lies below the
    /// `hold` of the ground in front of it is cut away, and the nearest shows; without a hold nothing is cut.
    pub fn overlay<L: Fn(usize) -> f32>(
        &mut self,
        sweep: Sweep<'_>,
        visibility: BodyVisibility,
        hold: Option<&Hold<L>>,
        rule: PixelRule,
        row: &mut [f32],
    ) {
        self.compose(sweep, visibility, hold);
        self.write(rule, row);
    }

    /// What is seen of what stands on a sweep: disjoint runs, from the top.
    pub fn compose<L: Fn(usize) -> f32>(
        &mut self,
        sweep: Sweep<'_>,
        visibility: BodyVisibility,
        hold: Option<&Hold<L>>,
    ) -> &[Run] {
        // Compiled at the width of the vectors, comparisons and sums of single numbers have better instructions too.
        dispatch!(Level::new(), _simd => self.compose_here(sweep, visibility, hold));
        &self.runs
    }

    #[inline(always)]
    fn compose_here<L: Fn(usize) -> f32>(
        &mut self,
        sweep: Sweep<'_>,
        visibility: BodyVisibility,
        hold: Option<&Hold<L>>,
    ) {
        self.find(sweep, if visibility == BodyVisibility::Depth { hold } else { None });
        self.layers.clear();
        let choice = Choice { spans: sweep.all, visibility };
        for seen in &self.seen {
            self.layers.lay(&self.parts[seen.clone()], &choice);
        }
        let run = |&Part { top, bottom, span }: &Part| {
            let span = &sweep.all[span as usize];
            Run { top, bottom, reflectivity: span.reflectivity_on(top), ramp: span.ramp }
        };
        self.runs.clear();
        self.runs.extend(self.layers.shown().iter().map(run));
    }

    /// Finds what is seen of the stacks of a sweep.
    #[inline(always)]
    fn find<L: Fn(usize) -> f32>(&mut self, Sweep { all, stacks }: Sweep<'_>, hold: Option<&Hold<L>>) {
        let Self { held, parts, seen, .. } = self;
        held.clear();
        // Looked up for all before anything is decided: what is decided cannot be guessed.
        for stack in stacks {
            held.push(match hold {
                Some(hold) => hold.extremes(stack.near),
                None => [f32::INFINITY; 2],
            });
        }
        parts.clear();
        seen.clear();
        for (Stack { spans, ends, .. }, held) in stacks.iter().zip(held) {
            let (begin, spans) = (parts.len(), (spans.start, &all[spans.clone()]));
            match (Sight::of(*ends, *held), hold) {
                (Sight::Part, Some(hold)) => cut::above_ground(spans, hold, *held, parts),
                (Sight::Hidden, _) => continue,
                _ => parts.extend(cut::whole(spans)),
            }
            seen.push(begin..parts.len());
        }
    }

    /// Drops what of the runs does not exceed `threshold` by its own video: it does not open a self-keyed switch (section 14).
    pub fn key(&mut self, threshold: f32) {
        self.runs.retain_mut(|run| match run.above(threshold) {
            Some(above) => {
                *run = above;
                run.top < run.bottom
            }
            None => false,
        });
    }

    /// The runs of the last composition.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// Line positions over which what the last composition, of `sweep`, shows lies nearer than an inverse distance along the view
    /// axis (1/m); disjoint, from the top.
    pub fn nearer_than<'a>(&'a self, sweep: Sweep<'a>, depth: f32) -> impl Iterator<Item = [f32; 2]> + 'a {
        self.layers.shown().iter().filter_map(move |&Part { top, bottom, span }| {
            let span = &sweep.all[span as usize];
            let [above, below] = [top, bottom].map(|line| span.depth_on(line) - depth);
            let crossing = || (top + (bottom - top) * (above / (above - below))).clamp(top, bottom);
            match (above > 0.0, below > 0.0) {
                (true, true) => Some([top, bottom]),
                (true, false) => Some([top, crossing()]),
                (false, true) => Some([crossing(), bottom]),
                (false, false) => None,
            }
        })
    }

    /// Lays the runs of the last composition over a row.
    pub fn write(&mut self, rule: PixelRule, row: &mut [f32]) {
        self.lay(rule, row, |run| *run);
    }

    /// The gate: the share of each line over which a polyhedron is seen, added to a row of zeros.
    pub fn present(&mut self, rule: PixelRule, row: &mut [f32]) {
        self.lay(rule, row, |run| Run { reflectivity: 1.0, ramp: 0.0, ..*run });
    }

    #[inline(always)]
    fn lay(&mut self, rule: PixelRule, row: &mut [f32], shown: impl Fn(&Run) -> Run) {
        match rule {
            PixelRule::Centre => {
                for run in self.runs.iter().map(shown) {
                    let [first, end] = [run.top, run.bottom].map(|end| line_from(end - 0.5, row.len()));
                    let lines = &mut row[first..end.max(first)];
                    match run.ramp {
                        0.0 => lines.fill(run.reflectivity),
                        _ => (first..)
                            .zip(lines)
                            .for_each(|(line, value)| *value = run.reflectivity_on(line as f32 + 0.5)),
                    }
                }
            }
            PixelRule::LineMean => self.cover.mix(&self.runs, row, shown),
        }
    }
}

/// First of some lines that begins at or below a line position; their number if none does.
#[inline(always)]
fn line_from(position: f32, lines: usize) -> usize {
    // The library's `ceil` is called where it is no instruction.
    let above = (position.max(0.0) as usize).min(lines);
    (above + usize::from((above as f32) < position)).min(lines)
}
