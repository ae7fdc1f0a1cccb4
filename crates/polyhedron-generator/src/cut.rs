//! Cutting a span where the ground hides it.

use crate::overlay::Piece;
use crate::{Hold, Span};

/// Lines by which a span must clear all that is held in its reach before nobody looks closer: far more than rounding.
const ROOM: f32 = 0.25;

/// Appends the parts of `span` that no nearer ground reaches above. Most spans are seen or hidden as a whole, and the few samples
/// around them tell that.
#[inline(always)]
pub(crate) fn above_ground<L: Fn(usize) -> f32>(
    span: &Span,
    hold: &Hold<L>,
    [low, high]: [f32; 2],
    pieces: &mut Vec<Piece>,
) {
    if low > span.bottom + ROOM {
        pieces.push(part(span, 0.0, 1.0));
    } else if high >= span.top - ROOM {
        cut(span, hold, pieces);
    }
}

/// The same, looked at closely.
///
/// Where the span passes the range of a sample, the hold bends; between two such places its clearance over the
/// ground is nearly linear, and one step of false position finds its zero.
// The few that need it call it: inlined, it grows the work on a group, and what else is inlined there (2 % of a nominal drive).
#[inline(never)]
fn cut<L: Fn(usize) -> f32>(span: &Span, hold: &Hold<L>, pieces: &mut Vec<Piece>) {
    let [top, bottom] = span.near;
    let between = hold.near.not_nearer(top.max(bottom))..hold.near.not_nearer(top.min(bottom));
    let mut cutter = Cutter { span, hold, seen_from: None, last: (0.0, f32::INFINITY) };
    cutter.last = (0.0, cutter.clearance(0.0));
    cutter.seen_from = (cutter.last.1 >= 0.0).then_some(0.0);
    let count = between.len();
    for step in 0..count {
        let sample = if top > bottom { between.start + step } else { between.end - 1 - step };
        let share = share_at(span, hold.near.samples()[sample]);
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
}

impl<L: Fn(usize) -> f32> Cutter<'_, L> {
    /// Lines by which a place of the span lies above what the ground has reached.
    fn clearance(&self, share: f32) -> f32 {
        self.hold.at(self.span.near_at(share)) - self.span.line_at(share)
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
    fn zero(&self, share: f32, clearance: f32) -> f32 {
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

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use super::{above_ground, cut};
    use crate::{Hold, NearTable, Overlay, Span};
    use proptest::collection::vec;
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, proptest};
    use scenario::BodyVisibility;

    /// Samples, and the line position that is held at each: so many lines less from one to the next.
    fn ground(samples: Range<usize>, fall: Range<f32>) -> impl Strategy<Value = (NearTable, Vec<f32>)> {
        vec((0.05..1.5f32, fall), samples).prop_map(|steps| {
            let (mut range, mut line) = (2.0, 180.0);
            let sample = |(step, fall)| {
                range += step;
                line -= fall;
                (1.0 / range, line)
            };
            let (near, held): (Vec<f32>, Vec<f32>) = steps.into_iter().map(sample).unzip();
            (NearTable::new(near), held)
        })
    }

    fn span([top, bottom]: [f32; 2], ranges: [f32; 2], tilts: [f32; 2]) -> Span {
        let near = ranges.map(|range| 1.0 / range);
        Span { top, bottom, near, depth: [near[0] * tilts[0], near[1] * tilts[1]], ..Span::default() }
    }

    proptest! {
        /// Ground that rises and falls, before, within and behind the samples.
        #[test]
        fn what_is_seen_or_hidden_as_a_whole_is_cut_as_if_it_were_looked_at_closely(
            (table, held) in ground(0..40, -4.0..8.0),
            ranges in [1.0..40.0f32, 1.0..40.0],
            tilts in [0.9..1.1f32, 0.9..1.1],
            top in 0.0..190.0f32,
            height in 0.1..60.0f32,
        ) {
            let hold = Hold { near: &table, lines: |sample: usize| held[sample] };
            let span = span([top, top + height], ranges, tilts);
            let (mut quickly, mut closely) = (Vec::new(), Vec::new());
            above_ground(&span, &hold, hold.extremes(span.near), &mut quickly);
            cut(&span, &hold, &mut closely);
            prop_assert_eq!(quickly, closely);
        }

        #[test]
        fn a_span_shows_exactly_where_no_nearer_ground_reaches_above_it(
            (table, held) in ground(1..40, 0.0..8.0),
            ranges in [3.0..30.0f32, 3.0..30.0],
            lines in [20.0..60.0f32, 60.0..190.0],
        ) {
            let hold = Hold { near: &table, lines: |sample: usize| held[sample] };
            let span = span(lines, ranges, [1.0; 2]);
            let mut overlay = Overlay::default();
            let shown = overlay.compose(&[span], BodyVisibility::Depth, Some(&hold));
            for number in 0..=500 {
                let share = number as f32 / 500.0;
                let place = span.line_at(share);
                let clearance = hold.at(span.near_at(share)) - place;
                let seen = shown.iter().any(|run| run.top <= place && place <= run.bottom);
                // Between two samples the zero is found by false position; a tenth of a line is its allowance.
                prop_assert!(clearance.abs() < 0.1 || seen == (clearance > 0.0), "share {share}: {clearance}, {seen}");
            }
        }
    }
}
