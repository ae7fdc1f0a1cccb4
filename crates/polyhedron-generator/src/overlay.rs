//! The third video switch: spans of one sweep over its lines (section 14).

use fearless_simd::{Level, dispatch};
use scenario::{BodyVisibility, PixelRule};
use signal::{Signal, Unit};

use crate::cover::Cover;
use crate::{Hold, Span, cut};

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
    /// Lower end.
    pub bottom: f32,
    /// Reflectivity of the face.
    pub reflectivity: f32,
}

/// A part of a span that the ground does not hide, as the choice between faces needs it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    top: f32,
    bottom: f32,
    /// Inverse depth at the top, and its growth a line.
    depth: f32,
    slope: f32,
    reflectivity: f32,
    /// Range of the foot point, and the object: what decides as reported.
    foot: (f32, u32),
}

impl Piece {
    #[inline(always)]
    pub fn new(span: &Span) -> Self {
        let Span { top, bottom, depth: [depth, below], reflectivity, .. } = *span;
        let foot = (span.foot_range, span.object);
        Self { top, bottom, depth, slope: (below - depth) / (bottom - top), reflectivity, foot }
    }

    #[inline(always)]
    fn depth(&self, line: f32) -> f32 {
        self.depth + self.slope * (line - self.top)
    }
}

/// The switch of one sweep and its buffers; one a worker.
#[derive(Debug, Clone, Default)]
pub struct Overlay {
    /// Least and greatest line position that is held where each span is.
    held: Vec<[f32; 2]>,
    pieces: Vec<Piece>,
    /// Pieces from the top: see [`from_top`].
    order: Vec<u64>,
    active: Vec<usize>,
    runs: Vec<Run>,
    cover: Cover,
}

impl Overlay {
    /// Lays the `spans` of a sweep over its `row` of lines, `row[k]` being the line from position k to k + 1.
    ///
    /// `AsReported`: bodies are seen as a whole, the nearer foot point on top. `Depth`: what lies below the
    /// `hold` of the ground in front of it is cut away, and the nearest shows; without a hold nothing is cut.
    pub fn overlay<L: Fn(usize) -> f32>(
        &mut self,
        spans: &[Span],
        visibility: BodyVisibility,
        hold: Option<&Hold<L>>,
        rule: PixelRule,
        row: &mut [f32],
    ) {
        self.compose(spans, visibility, hold);
        self.write(rule, row);
    }

    /// What is seen of the spans of a sweep: disjoint runs, from the top.
    pub fn compose<L: Fn(usize) -> f32>(
        &mut self,
        spans: &[Span],
        visibility: BodyVisibility,
        hold: Option<&Hold<L>>,
    ) -> &[Run] {
        // Compiled at the width of the vectors, comparisons and sums of single numbers have better instructions too.
        dispatch!(Level::new(), _simd => self.compose_here(spans, visibility, hold));
        &self.runs
    }

    #[inline(always)]
    fn compose_here<L: Fn(usize) -> f32>(
        &mut self,
        spans: &[Span],
        visibility: BodyVisibility,
        hold: Option<&Hold<L>>,
    ) {
        self.pieces.clear();
        self.runs.clear();
        match (visibility, hold) {
            (BodyVisibility::Depth, Some(hold)) => {
                // Looked up for all before anything is decided: what is decided cannot be guessed.
                self.held.clear();
                for span in spans {
                    self.held.push(hold.extremes(span.near));
                }
                for (span, held) in spans.iter().zip(&self.held) {
                    cut::above_ground(span, hold, *held, &mut self.pieces);
                }
            }
            _ => self.pieces.extend(spans.iter().map(Piece::new)),
        }
        self.order.clear();
        self.order.extend(self.pieces.iter().enumerate().map(|(number, piece)| from_top(piece, number)));
        self.order.sort_unstable();
        self.sweep_down(visibility);
    }

    /// Drops the runs whose own video does not exceed `threshold`: they do not open a self-keyed switch (section 14).
    pub fn key(&mut self, threshold: f32) {
        self.runs.retain(|run| run.reflectivity > threshold);
    }

    /// The runs of the last composition.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// Lays the runs of the last composition over a row.
    pub fn write(&mut self, rule: PixelRule, row: &mut [f32]) {
        self.lay(rule, row, |run| run.reflectivity);
    }

    /// The gate: the share of each line over which a polyhedron is seen, added to a row of zeros.
    pub fn present(&mut self, rule: PixelRule, row: &mut [f32]) {
        self.lay(rule, row, |_| 1.0);
    }

    /// Between two ends the same pieces are there: finds which shows.
    #[inline(always)]
    fn sweep_down(&mut self, visibility: BodyVisibility) {
        let Self { pieces, order, active, runs, .. } = self;
        active.clear();
        let mut waiting = order.iter().map(|&key| key as u32 as usize).peekable();
        while let Some(first) = waiting.next() {
            let mut top = pieces[first].top;
            active.push(first);
            // From here down to where nothing is.
            loop {
                while let Some(begun) = waiting.next_if(|&piece| pieces[piece].top <= top) {
                    active.push(begun);
                }
                active.retain(|&piece| pieces[piece].bottom > top);
                if active.is_empty() {
                    break;
                }
                let begins = waiting.peek().map_or(f32::INFINITY, |&piece| pieces[piece].top);
                let bottom = active.iter().fold(begins, |end, &piece| end.min(pieces[piece].bottom));
                let stretch = Stretch { pieces, active, visibility };
                stretch.resolve(top, bottom, Stretch::DEEPEST, runs);
                top = bottom;
            }
        }
    }

    #[inline(always)]
    fn lay(&mut self, rule: PixelRule, row: &mut [f32], value: impl Fn(&Run) -> f32) {
        match rule {
            PixelRule::Centre => {
                for run in &self.runs {
                    let [first, end] = [run.top, run.bottom].map(|end| line_from(end - 0.5, row.len()));
                    row[first..end.max(first)].fill(value(run));
                }
            }
            PixelRule::LineMean => self.cover.mix(&self.runs, row, value),
        }
    }
}

/// A number that ascends with the top of a piece and names it: numbers are sorted without asking, pieces are not.
#[inline(always)]
fn from_top(piece: &Piece, number: usize) -> u64 {
    let bits = piece.top.to_bits();
    // Bits ascend as numbers do above 0, and the other way round below.
    let ascending = if piece.top.is_sign_negative() { !bits } else { bits | 1 << 31 };
    u64::from(ascending) << 32 | number as u64
}

/// First of some lines that begins at or below a line position; their number if none does.
#[inline(always)]
fn line_from(position: f32, lines: usize) -> usize {
    // The library's `ceil` is called where it is no instruction.
    let above = (position.max(0.0) as usize).min(lines);
    (above + usize::from((above as f32) < position)).min(lines)
}

/// Pieces that lie over one another from one line position to another.
struct Stretch<'a> {
    pieces: &'a [Piece],
    active: &'a [usize],
    visibility: BodyVisibility,
}

impl Stretch<'_> {
    /// Halvings at crossings of pieces: more than bodies that stand apart can have.
    const DEEPEST: u32 = 8;

    /// Depths are linear, so a piece that shows at both ends shows between them; else the two that show cross.
    fn resolve(&self, top: f32, bottom: f32, deepest: u32, runs: &mut Vec<Run>) {
        let ends = [self.shown(top), self.shown(bottom)];
        let crossing =
            if ends[0] == ends[1] || deepest == 0 { None } else { self.crossing(ends, top, bottom) };
        match crossing {
            Some(line) => {
                self.resolve(top, line, deepest - 1, runs);
                self.resolve(line, bottom, deepest - 1, runs);
            }
            None => {
                let shown = if ends[0] == ends[1] { ends[0] } else { self.shown(0.5 * (top + bottom)) };
                runs.push(Run { top, bottom, reflectivity: self.pieces[shown].reflectivity });
            }
        }
    }

    /// The piece that shows at a line position.
    #[inline(always)]
    fn shown(&self, line: f32) -> usize {
        let on_top = |&a: &usize, &b: &usize| if self.covers(b, a, line) { b } else { a };
        let first = self.active[0];
        self.active[1..].iter().fold(first, |shown, other| on_top(&shown, other))
    }

    /// Whether piece `a` lies over piece `b`.
    #[inline(always)]
    fn covers(&self, a: usize, b: usize, line: f32) -> bool {
        let (first, second) = (&self.pieces[a], &self.pieces[b]);
        if self.visibility == BodyVisibility::AsReported && first.foot != second.foot {
            return first.foot < second.foot;
        }
        first.depth(line) > second.depth(line)
    }

    fn crossing(&self, pieces: [usize; 2], top: f32, bottom: f32) -> Option<f32> {
        let [first, second] = pieces.map(|piece| &self.pieces[piece]);
        let [above, below] = [top, bottom].map(|line| first.depth(line) - second.depth(line));
        let line = top + (bottom - top) * (above / (above - below));
        (line > top && line < bottom).then_some(line)
    }
}
