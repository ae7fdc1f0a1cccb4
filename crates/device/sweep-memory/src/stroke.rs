//! One straight motion of the write beam, and what it leaves in the lines.

use signal::Number;

/// The beam over a stretch between two samples: line positions (`to` is above, that is, smaller) and intensities. One stroke, or
/// those of eight sweeps side by side, or of two steps of eight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stroke<T = f32> {
    pub from: T,
    pub to: T,
    pub start: T,
    pub end: T,
}

impl<T: Number> Stroke<T> {
    /// Along a straight step with the intensities `before` and `end` at its ends. The profile is in sight from the part `entry` of the
    /// step on.
    #[inline(always)]
    pub fn in_sight(from: T, to: T, before: T, end: T, entry: T) -> Self {
        Self { from, to, start: before + entry * (end - before), end }
    }

    /// Intensity at a line position within the stroke.
    #[inline(always)]
    pub fn at(&self, line: T) -> T {
        self.start + (self.from - line) / (self.from - self.to) * (self.end - self.start)
    }
}

/// The integral over a part of a stroke that is `height` lines high, from its intensity `below` to the one `above`.
#[inline(always)]
pub(crate) fn integral<T: Number>(below: T, above: T, height: T) -> T {
    below.like(0.5) * (below + above) * height
}

impl Stroke {
    /// The part of the stroke whose intensity is above black: the beam is cut off where local shadow begins,
    /// between two samples.
    #[inline(always)]
    pub fn lit(self) -> Option<Self> {
        let Self { from, to, start, end } = self;
        if start >= 0.0 && end >= 0.0 {
            return Some(self);
        }
        if start <= 0.0 && end <= 0.0 {
            return None;
        }
        let black = (from + start / (end - start) * (from - to)).clamp(to, from);
        let lit = if start < 0.0 {
            Self { from: black, start: 0.0, ..self }
        } else {
            Self { to: black, end: 0.0, ..self }
        };
        (lit.to < lit.from).then_some(lit)
    }
}

/// The stroke's integral over each of `lines` lines that it touches, from the lowest up.
#[inline]
pub(crate) fn line_mean(stroke: Stroke, lines: usize, mut add: impl FnMut(usize, f32)) {
    let (bottom, top) = (stroke.from.min(lines as f32), stroke.to.max(0.0));
    if bottom <= top {
        return;
    }
    let last = top as usize;
    if bottom <= (last + 1) as f32 && bottom == stroke.from && top == stroke.to {
        // Nearly all strokes of far ground stay within one line.
        return add(last, integral(stroke.start, stroke.end, bottom - top));
    }
    let (mut lower, mut below) = (bottom, stroke.at(bottom));
    let mut index = (bottom.ceil() as usize).min(lines);
    while index > last {
        index -= 1;
        let upper = top.max(index as f32);
        let above = stroke.at(upper);
        add(index, integral(below, above, lower - upper));
        (lower, below) = (upper, above);
    }
}

/// The intensity in each of `lines` lines whose centre the stroke passes, from the highest down.
#[inline]
pub(crate) fn centre(stroke: Stroke, lines: usize, mut set: impl FnMut(usize, f32)) {
    let first = (stroke.to - 0.5).ceil().max(0.0) as usize;
    for index in first..lines {
        let centre = index as f32 + 0.5;
        if centre >= stroke.from {
            break;
        }
        set(index, stroke.at(centre));
    }
}
