//! Spans that follow one another down a sweep: what is asked of one of them is asked of all at once.

use std::ops::Range;

use crate::Span;
use crate::order::{greater, lesser};

/// Spans of one object on one sweep without gaps, from the top: its body, as long as no ground is in front.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stack {
    /// Which spans of the sweep.
    pub spans: Range<usize>,
    /// Upper and lower end.
    pub ends: [f32; 2],
    /// Least and greatest inverse range (1/m).
    pub near: [f32; 2],
}

impl Stack {
    /// Those of the spans of a sweep, in their order.
    #[inline(always)]
    pub fn all(spans: &[Span]) -> impl Iterator<Item = Self> {
        let mut begin = 0;
        spans.chunk_by(Span::goes_on).map(move |stack| {
            let spans = begin..begin + stack.len();
            begin = spans.end;
            let widen = |[low, high]: [f32; 2], near: f32| [lesser(low, near), greater(high, near)];
            let near = stack.iter().flat_map(|span| span.near).fold([f32::INFINITY, 0.0], widen);
            Self { spans, ends: [stack[0].top, stack[stack.len() - 1].bottom], near }
        })
    }
}
