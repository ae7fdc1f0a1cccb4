//! Spans that follow one another down a sweep: what is asked of one of them is asked of all at once.

use std::ops::Range;

use crate::Span;
use crate::order::{greater, lesser};

/// Spans of one object on one sweep without gaps, from the top: its body, as long as no ground is in front.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Stack {
    /// Which of all spans.
    pub spans: Range<usize>,
    /// Upper and lower end.
    pub ends: [f32; 2],
    /// Least and greatest inverse range (1/m).
    pub near: [f32; 2],
}

impl Stack {
    /// One that is to begin with span `number`.
    pub fn at(number: usize) -> Self {
        let nothing = [f32::INFINITY, 0.0];
        Self { spans: number..number, ends: nothing, near: nothing }
    }

    /// Adds the next span.
    #[inline(always)]
    pub fn add(&mut self, &Span { top, bottom, near: [above, below], .. }: &Span) {
        self.spans.end += 1;
        self.ends = [lesser(self.ends[0], top), bottom];
        let [low, high] = self.near;
        self.near = [lesser(low, lesser(above, below)), greater(high, greater(above, below))];
    }
}
