//! What the pictures are drawn on: paper that remembers every stroke.

use crate::Drawing;
use crate::colour::{Colour, LIGHT, Palette};
use crate::lettering::{self, Size};
use crate::mark::{Letters, Mark};

pub(crate) use crate::mark::Area;

/// No stroke goes farther from the paper than this (pixels), whatever the values are.
const FARTHEST: f32 = 30_000.0;

/// Where a text stands relative to its point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Anchor {
    Left,
    Middle,
    Right,
}

impl Anchor {
    fn shift(self, width: f32) -> f32 {
        match self {
            Self::Left => 0.0,
            Self::Middle => -width / 2.0,
            Self::Right => -width,
        }
    }
}

/// Paper of a fixed size.
pub(crate) struct Canvas {
    columns: u32,
    lines: u32,
    palette: &'static Palette,
    title: String,
    marks: Vec<Mark>,
}

impl Canvas {
    /// Blank white paper; a side of 0 becomes 1.
    pub fn new(columns: u32, lines: u32) -> Self {
        Self::of(&LIGHT, columns, lines)
    }

    /// Blank paper for the colours of `palette`.
    pub fn of(palette: &'static Palette, columns: u32, lines: u32) -> Self {
        let (columns, lines) = (columns.max(1), lines.max(1));
        Self { columns, lines, palette, title: String::new(), marks: Vec::new() }
    }

    /// The colours that this paper is for.
    pub fn palette(&self) -> &'static Palette {
        self.palette
    }

    /// Names the drawing, for whoever does not see it.
    pub fn name(&mut self, title: &str) {
        title.clone_into(&mut self.title);
    }

    /// Keeps curves within `area` until [`unclip`](Self::unclip).
    pub fn clip(&mut self, area: Area) {
        self.marks.push(Mark::Clip(Some(area)));
    }

    /// Lets curves go anywhere.
    pub fn unclip(&mut self) {
        self.marks.push(Mark::Clip(None));
    }

    /// Fills `area`; one without width or height is not there.
    pub fn fill(&mut self, area: Area, colour: Colour) {
        let Area { left, top, width, height } = area;
        if [left, top, width, height].iter().all(|side| side.is_finite()) && width > 0.0 && height > 0.0 {
            self.marks.push(Mark::Fill(area, colour));
        }
    }

    /// The border of `area`, a pixel wide, inside it.
    pub fn border(&mut self, area: Area, colour: Colour) {
        let Area { left, top, width, height } = area;
        self.fill(Area { height: 1.0, ..area }, colour);
        self.fill(Area { top: top + height - 1.0, height: 1.0, ..area }, colour);
        self.fill(Area { width: 1.0, ..area }, colour);
        self.fill(Area { left: left + width - 1.0, width: 1.0, ..area }, colour);
    }

    /// Joined lines through `points` (pixels).
    pub fn line(&mut self, points: &[(f32, f32)], width: f32, colour: Colour) {
        self.stroke(points, width, None, colour);
    }

    /// Joined lines of dashes, `[ink, gap]` pixels long.
    pub fn dashed(&mut self, points: &[(f32, f32)], width: f32, dash: [f32; 2], colour: Colour) {
        self.stroke(points, width, Some(dash), colour);
    }

    /// Joined lines, of dashes if there are any.
    pub fn stroke(&mut self, points: &[(f32, f32)], width: f32, dash: Option<[f32; 2]>, colour: Colour) {
        let points = near(points);
        if points.len() > 1 {
            self.marks.push(Mark::Line { points, width, dash, colour });
        }
    }

    /// A closed polygon, filled.
    pub fn polygon(&mut self, points: &[(f32, f32)], colour: Colour) {
        let points = near(points);
        if points.len() > 2 {
            self.marks.push(Mark::Polygon(points, colour));
        }
    }

    /// Text with its base line at `at`.
    pub fn text(&mut self, text: &str, at: (f32, f32), anchor: Anchor, size: Size, colour: Colour) {
        let left = at.0 + anchor.shift(lettering::width(text, size));
        self.letters(text, (left, at.1), false, size, colour);
    }

    /// Text that runs upwards, centred on `at`.
    pub fn text_upwards(&mut self, text: &str, at: (f32, f32), size: Size, colour: Colour) {
        let below = at.1 + lettering::width(text, size) / 2.0;
        self.letters(text, (at.0, below), true, size, colour);
    }

    fn letters(&mut self, text: &str, at: (f32, f32), upwards: bool, size: Size, colour: Colour) {
        if !text.trim().is_empty() {
            self.marks.push(Mark::Letters(Letters { text: text.to_owned(), at, upwards, size, colour }));
        }
    }

    /// Sets the pixels of `area`, whose corners lie on whole pixels, to `colour_of(column, line)`.
    pub fn image(&mut self, area: Area, colour_of: impl Fn(u32, u32) -> Colour) {
        let (columns, lines) = (area.width as u32, area.height as u32);
        let line = |line| (0..columns).map(move |column| (column, line));
        let colours = (0..lines).flat_map(line).map(|(column, line)| colour_of(column, line)).collect();
        self.marks.push(Mark::Image(area, colours));
    }

    /// Returns the finished picture of all marks.
    pub fn finish(self) -> Drawing {
        Drawing::new([self.columns, self.lines], self.palette.paper, self.title, self.marks)
    }
}

fn near(points: &[(f32, f32)]) -> Vec<(f32, f32)> {
    let finite = points.iter().filter(|(x, y)| x.is_finite() && y.is_finite());
    finite.map(|(x, y)| (x.clamp(-FARTHEST, FARTHEST), y.clamp(-FARTHEST, FARTHEST))).collect()
}
