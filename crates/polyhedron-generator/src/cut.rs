//! Cutting a span where the ground hides it.

use crate::overlay::Piece;
use crate::{Hold, Span};

/// Appends the parts of `span` that no nearer ground reaches above.
///
/// Where the span passes the range of a sample, the hold bends; between two such places its clearance over the
/// ground is nearly linear, and one step of false position finds its zero.
pub(crate) fn above_ground<L: Fn(usize) -> f32>(span: &Span, hold: &Hold<L>, pieces: &mut Vec<Piece>) {
    let [top, bottom] = span.near;
    let begin = hold.sample(top.max(bottom));
    let between = begin..hold.sample_from(begin, top.min(bottom));
    let mut cutter = Cutter { span, hold, seen_from: None, last: (0.0, f32::INFINITY), beyond: begin };
    cutter.last = (0.0, cutter.clearance(0.0));
    cutter.seen_from = (cutter.last.1 >= 0.0).then_some(0.0);
    let count = between.len();
    for step in 0..count {
        let sample = if top > bottom { between.start + step } else { between.end - 1 - step };
        let share = share_at(span, hold.near[sample]);
        cutter.advance(share, (hold.lines)(sample) - span.line_at(share), pieces);
    }
    let clearance = cutter.clearance(1.0);
    cutter.advance(1.0, clearance, pieces);
    if let Some(from) = cutter.seen_from {
        pieces.push(part(span, from, 1.0));
    }
}

struct Cutter<'a, L> {
    span: &'a Span,
    hold: &'a Hold<'a, L>,
    /// Where the part in sight began.
    seen_from: Option<f32>,
    /// Share and clearance of the place before.
    last: (f32, f32),
    /// First sample not nearer than the place last asked for.
    beyond: usize,
}

impl<L: Fn(usize) -> f32> Cutter<'_, L> {
    /// Lines by which a place of the span lies above what the ground has reached.
    fn clearance(&mut self, share: f32) -> f32 {
        let near = self.span.near_at(share);
        self.beyond = self.hold.sample_from(self.beyond, near);
        self.hold.before(self.beyond, near) - self.span.line_at(share)
    }

    fn advance(&mut self, share: f32, clearance: f32, pieces: &mut Vec<Piece>) {
        match (self.seen_from, clearance >= 0.0) {
            (Some(from), false) => {
                let to = self.zero(share, clearance);
                pieces.push(part(self.span, from, to));
                self.seen_from = None;
            }
            (None, true) => self.seen_from = Some(self.zero(share, clearance)),
            _ => {}
        }
        self.last = (share, clearance);
    }

    /// Where the clearance is 0 between the last place and this.
    fn zero(&mut self, share: f32, clearance: f32) -> f32 {
        let (from, to) = (self.last, (share, clearance));
        // No ground is drawn before the first sample: the change lies at the sample itself.
        if from.1.is_infinite() || to.1.is_infinite() {
            return if from.1.is_infinite() { to.0 } else { from.0 };
        }
        let guess = false_position(from, to);
        let middle = (guess, self.clearance(guess));
        if (middle.1 >= 0.0) == (from.1 >= 0.0) {
            false_position(middle, to)
        } else {
            false_position(from, middle)
        }
    }
}

fn false_position(from: (f32, f32), to: (f32, f32)) -> f32 {
    let share = from.1 / (from.1 - to.1);
    from.0 + (to.0 - from.0) * share.clamp(0.0, 1.0)
}

/// Where the span is at an inverse range: `depth = near stretch` with both sides linear.
fn share_at(span: &Span, near: f32) -> f32 {
    let stretch = [0, 1].map(|end| span.depth[end] / span.near[end]);
    let [top, bottom] = [0, 1].map(|end| span.depth[end] - near * stretch[end]);
    (top / (top - bottom)).clamp(0.0, 1.0)
}

fn part(span: &Span, from: f32, to: f32) -> Piece {
    Piece::new(&Span {
        top: span.line_at(from),
        bottom: span.line_at(to),
        near: [span.near_at(from), span.near_at(to)],
        depth: [span.depth_at(from), span.depth_at(to)],
        ..*span
    })
}
