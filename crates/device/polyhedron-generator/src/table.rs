//! Spans of a frame, sweep by sweep.

use crate::Span;
use crate::stack::Stack;

/// Spans of a frame, sorted by sweep; within a sweep in the order in which bodies and faces were given.
#[derive(Debug, Clone, Default)]
pub struct SpanTable {
    spans: Vec<Span>,
    stacks: Vec<Stack>,
    /// First stack, and first span, of each sweep.
    starts: Vec<[usize; 2]>,
}

/// What stands on a sweep.
#[derive(Debug, Clone, Copy)]
pub struct Sweep<'a> {
    /// The spans of all sweeps.
    pub(crate) all: &'a [Span],
    pub(crate) stacks: &'a [Stack],
}

impl<'a> Sweep<'a> {
    /// Whether the sweep meets no body.
    pub fn is_empty(&self) -> bool {
        self.stacks.is_empty()
    }

    /// Returns the spans of the sweep.
    pub fn spans(&self) -> &'a [Span] {
        match (self.stacks.first(), self.stacks.last()) {
            (Some(first), Some(last)) => &self.all[first.spans.start..last.spans.end],
            _ => &[],
        }
    }
}

impl SpanTable {
    /// Of the spans of one sweep.
    pub fn of_sweep(spans: &[Span]) -> Self {
        let mut drawing = Drawing::default();
        for spans in spans.chunk_by(Span::goes_on) {
            let mut stack = drawing.begin();
            spans.iter().for_each(|&span| drawing.add(&mut stack, span));
            drawing.end(0, stack);
        }
        let mut table = Self::default();
        table.fill(1, std::iter::once(&drawing));
        table
    }

    /// What stands on a sweep; nothing beyond the last.
    pub fn sweep(&self, sweep: usize) -> Sweep<'_> {
        let stacks = match self.starts.get(sweep..sweep + 2) {
            Some(&[[start, _], [end, _]]) => &self.stacks[start..end],
            _ => &[],
        };
        Sweep { all: &self.spans, stacks }
    }

    /// Number of spans in all sweeps.
    pub fn len(&self) -> usize {
        self.spans.len()
    }

    /// Whether no sweep meets a body.
    pub fn is_empty(&self) -> bool {
        self.spans.is_empty()
    }

    /// Sorts stacks by their sweeps, keeping their order: a counting sort.
    pub(crate) fn fill<'a>(&mut self, sweeps: usize, drawings: impl Iterator<Item = &'a Drawing> + Clone) {
        let found = drawings.flat_map(|Drawing { spans, stacks }| {
            stacks.iter().map(move |(sweep, stack)| (*sweep as usize, stack, &spans[stack.spans.clone()]))
        });
        self.starts.clear();
        self.starts.resize(sweeps + 1, [0; 2]);
        for (sweep, _, spans) in found.clone() {
            let [stack, span] = &mut self.starts[sweep + 1];
            (*stack, *span) = (*stack + 1, *span + spans.len());
        }
        for sweep in 0..sweeps {
            let before = self.starts[sweep];
            (0..2).for_each(|of| self.starts[sweep + 1][of] += before[of]);
        }
        let [stacks, spans] = self.starts[sweeps];
        self.stacks.resize(stacks, Stack::default());
        self.spans.resize(spans, Span::default());
        for (sweep, stack, spans) in found {
            let [number, first] = &mut self.starts[sweep];
            let place = *first..*first + spans.len();
            self.spans[place.clone()].copy_from_slice(spans);
            self.stacks[*number] = Stack { spans: place.clone(), ..stack.clone() };
            (*number, *first) = (*number + 1, place.end);
        }
        // Each start has moved to the next sweep's: move them back.
        self.starts.copy_within(..sweeps, 1);
        self.starts[0] = [0; 2];
    }
}

/// What some bodies leave: stacks with their sweeps, in the order of bodies and faces.
#[derive(Debug, Clone, Default)]
pub(crate) struct Drawing {
    pub spans: Vec<Span>,
    pub stacks: Vec<(u32, Stack)>,
}

impl Drawing {
    /// A stack that is to be drawn next.
    pub fn begin(&self) -> Stack {
        Stack::at(self.spans.len())
    }

    /// Adds a span to a stack.
    #[inline(always)]
    pub fn add(&mut self, stack: &mut Stack, span: Span) {
        stack.add(&span);
        self.spans.push(span);
    }

    /// Keeps a stack on a sweep, if there is anything in it.
    #[inline(always)]
    pub fn end(&mut self, sweep: u32, stack: Stack) {
        if !stack.spans.is_empty() {
            self.stacks.push((sweep, stack));
        }
    }

    /// Gives back the room that it does not need.
    pub fn shrink_to_fit(&mut self) {
        self.spans.shrink_to_fit();
        self.stacks.shrink_to_fit();
    }
}
