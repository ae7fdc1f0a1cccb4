//! Cutting a span where the ground hides it.

use crate::layers::Part;
use crate::{Hold, Span};

/// Lines by which a span must clear all that is held in its reach before nobody looks closer: far more than rounding.
const ROOM: f32 = 0.25;

/// How much of what stands on a sweep the ground leaves in sight, as far as what is held about it tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sight {
    Whole,
    Hidden,
    /// Nobody knows without looking closer.
    Part,
}

impl Sight {
    /// Of what reaches from one line position to another, where the least and the greatest that is held are these.
    #[inline(always)]
    pub fn of([top, bottom]: [f32; 2], [low, high]: [f32; 2]) -> Self {
        if low > bottom + ROOM {
            Self::Whole
        } else if high >= top - ROOM {
            Self::Part
        } else {
            Self::Hidden
        }
    }
}

/// All of some spans, the first of which has this number; but for those without any height.
#[inline(always)]
pub(crate) fn whole((first, spans): (usize, &[Span])) -> impl Iterator<Item = Part> {
    let numbered = (first as u32..).zip(spans).filter(|(_, span)| span.top < span.bottom);
    numbered.map(|(span, &Span { top, bottom, .. })| Part { top, bottom, span })
}

/// Appends the parts of some spans, one below another, that no nearer ground reaches above; `held` are the least and the greatest
/// line position that is held where they are.
// The few stacks that need it call it: inlined, it grows the work on a group, and what else is inlined there (2 % of a nominal drive).
#[inline(never)]
pub(crate) fn above_ground<L: Fn(usize) -> f32>(
    (first, spans): (usize, &[Span]),
    hold: &Hold<L>,
    held: [f32; 2],
    parts: &mut Vec<Part>,
) {
    for (number, span) in (first as u32..).zip(spans) {
        let part = Part { top: span.top, bottom: span.bottom, span: number };
        match Sight::of([span.top, span.bottom], held) {
            Sight::Whole => parts.push(part),
            Sight::Part => cut((number, span), hold, parts),
            Sight::Hidden => {}
        }
    }
}

/// Looks closely at a span.
///
/// Where the span passes the range of a sample, the hold bends; between two such places its clearance over the
/// ground is nearly linear, and one step of false position finds its zero.
#[inline(always)]
fn cut<L: Fn(usize) -> f32>((number, span): (u32, &Span), hold: &Hold<L>, parts: &mut Vec<Part>) {
    let beyond = [hold.near.not_nearer(span.near[0]), hold.near.not_nearer(span.near[1])];
    let clear = [
        hold.between(beyond[0], span.near[0]) - span.top,
        hold.between(beyond[1], span.near[1]) - span.bottom,
    ];
    let between = beyond[0].min(beyond[1])..beyond[0].max(beyond[1]);
    let seen_from = (clear[0] >= 0.0).then_some(0.0);
    let mut cutter = Cutter { number, span, hold, seen_from, last: (0.0, clear[0]) };
    let count = between.len();
    for step in 0..count {
        let sample = if beyond[0] < beyond[1] { between.start + step } else { between.end - 1 - step };
        let share = share_at(span, hold.near.samples()[sample]);
        cutter.advance(share, (hold.lines)(sample) - span.line_at(share), parts);
    }
    cutter.advance(1.0, clear[1], parts);
    if let Some(from) = cutter.seen_from {
        parts.extend(cutter.part(from, 1.0));
    }
}

struct Cutter<'a, L> {
    number: u32,
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

    #[inline(always)]
    fn advance(&mut self, share: f32, clearance: f32, parts: &mut Vec<Part>) {
        match (self.seen_from, clearance >= 0.0) {
            (Some(from), false) => {
                let to = self.zero(share, clearance);
                parts.extend(self.part(from, to));
                self.seen_from = None;
            }
            (None, true) => self.seen_from = Some(self.zero(share, clearance)),
            _ => {}
        }
        self.last = (share, clearance);
    }

    /// The part of the span between two shares of the way, if it has any height.
    fn part(&self, from: f32, to: f32) -> Option<Part> {
        let [top, bottom] = [from, to].map(|share| self.span.line_at(share));
        (top < bottom).then_some(Part { top, bottom, span: self.number })
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

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use super::{Sight, above_ground, cut, whole};
    use crate::stack::Stack;
    use crate::{Hold, NearTable, Overlay, Span, SpanTable};
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
            ranges in [1.0..40.0f32, 1.0..40.0, 1.0..40.0],
            tilts in [0.9..1.1f32, 0.9..1.1],
            top in 0.0..190.0f32,
            height in 0.1..60.0f32,
        ) {
            let hold = Hold { near: &table, lines: |sample: usize| held[sample] };
            // Two spans that follow one another are asked at once.
            let [middle, bottom] = [top + height, top + 1.5 * height];
            let stack = [span([top, middle], [ranges[0], ranges[1]], tilts), span([middle, bottom], [ranges[1], ranges[2]], tilts)];
            let mut found = Stack::at(0);
            stack.iter().for_each(|span| found.add(span));
            let held = hold.extremes(found.near);
            let (mut quickly, mut closely) = (Vec::new(), Vec::new());
            match Sight::of(found.ends, held) {
                Sight::Whole => quickly.extend(whole((0, &stack))),
                Sight::Part => above_ground((0, &stack), &hold, held, &mut quickly),
                Sight::Hidden => {}
            }
            stack.iter().zip(0..).for_each(|(span, number)| cut((number, span), &hold, &mut closely));
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
            let (mut overlay, standing) = (Overlay::default(), SpanTable::of_sweep(&[span]));
            let shown = overlay.compose(standing.sweep(0), BodyVisibility::Depth, Some(&hold));
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
