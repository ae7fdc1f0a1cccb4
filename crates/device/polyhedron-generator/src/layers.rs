//! What lies over what on a sweep.

use scenario::BodyVisibility;

use crate::Span;
use crate::order::{greater, lesser};

/// A part of a span: what the ground leaves in sight of it, or what shows of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Part {
    pub top: f32,
    pub bottom: f32,
    /// Which of the spans of all sweeps.
    pub span: u32,
}

/// What shows of stacks laid over and under one another; buffers are kept from sweep to sweep.
#[derive(Debug, Clone, Default)]
pub(crate) struct Layers {
    /// Disjoint, from the top.
    shown: Vec<Part>,
    /// What has been there where a stack is being laid.
    there: Vec<Part>,
}

impl Layers {
    /// Forgets the sweep before.
    pub fn clear(&mut self) {
        self.shown.clear();
    }

    /// What shows, disjoint and from the top.
    pub fn shown(&self) -> &[Part] {
        &self.shown
    }

    /// Lays a stack: parts of some height, disjoint and from the top.
    #[inline(always)]
    pub fn lay(&mut self, stack: &[Part], choice: &Choice<'_>) {
        let Some(first) = stack.first() else { return };
        let reaches = |part: &&Part| part.bottom > first.top;
        let above = self.shown.len() - self.shown.iter().rev().take_while(reaches).count();
        if above == self.shown.len() {
            self.shown.extend_from_slice(stack);
            return;
        }
        self.there.clear();
        self.there.extend_from_slice(&self.shown[above..]);
        self.shown.truncate(above);
        choice.merge([&self.there, stack], &mut self.shown);
    }
}

/// Chooses between spans of a sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Choice<'a> {
    pub spans: &'a [Span],
    pub visibility: BodyVisibility,
}

impl Choice<'_> {
    /// Merges two lists of disjoint parts from the top: where two lie over one another the one on top is kept.
    #[inline(always)]
    fn merge(&self, [there, stack]: [&[Part]; 2], shown: &mut Vec<Part>) {
        let [mut there, mut stack] = [there.iter(), stack.iter()];
        let [mut first, mut second] = [there.next().copied(), stack.next().copied()];
        while let (Some(a), Some(b)) = (&mut first, &mut second) {
            let (top, bottom) = (greater(a.top, b.top), lesser(a.bottom, b.bottom));
            if a.bottom <= top {
                add(*a, shown);
                first = there.next().copied();
            } else if b.bottom <= top {
                add(*b, shown);
                second = stack.next().copied();
            } else {
                // Not by `map`, which is not inlined here.
                let (above, below) = (self.covers(*b, *a, top), self.covers(*b, *a, bottom));
                let [over, under] = if above { [b, a] } else { [a, b] };
                add(Part { bottom: top, ..*under }, shown);
                if above == below {
                    under.top = bottom;
                } else {
                    let line = self.crossing([*over, *under], [top, bottom]);
                    add(Part { bottom: line, ..*over }, shown);
                    (over.top, under.top) = (bottom, line);
                }
            }
        }
        first.into_iter().chain(second).for_each(|part| add(part, shown));
        shown.extend(there);
        shown.extend(stack);
    }

    /// Whether a part lies over another at a line position. Depths are linear: what does so at both ends of a stretch does so
    /// between them, else the two cross.
    #[inline(always)]
    fn covers(&self, part: Part, other: Part, line: f32) -> bool {
        let (first, second) = (&self.spans[part.span as usize], &self.spans[other.span as usize]);
        let foot = |span: &Span| (span.foot_range, span.object);
        if self.visibility == BodyVisibility::AsReported && foot(first) != foot(second) {
            return foot(first) < foot(second);
        }
        first.depth_on(line) > second.depth_on(line)
    }

    /// Where two parts cross between two line positions.
    fn crossing(&self, parts: [Part; 2], [top, bottom]: [f32; 2]) -> f32 {
        let [first, second] = parts.map(|part| &self.spans[part.span as usize]);
        let [above, below] = [top, bottom].map(|line| first.depth_on(line) - second.depth_on(line));
        (top + (bottom - top) * (above / (above - below))).clamp(top, bottom)
    }
}

/// Adds a part, if it has any height.
#[inline(always)]
fn add(part: Part, shown: &mut Vec<Part>) {
    // Without a branch: whether anything is left cannot be guessed.
    let count = shown.len() + usize::from(part.top < part.bottom);
    shown.push(part);
    shown.truncate(count);
}
