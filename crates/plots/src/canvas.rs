//! What the pictures are drawn on.

use crate::Drawing;
use crate::colour::{Colour, PAPER};
use crate::lettering::{self, Size};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, PremultipliedColorU8, Rect, Stroke,
    Transform,
};

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    pub left: f32,
    pub top: f32,
    pub width: f32,
    pub height: f32,
}

impl Area {
    pub fn right(&self) -> f32 {
        self.left + self.width
    }

    pub fn bottom(&self) -> f32 {
        self.top + self.height
    }
}

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
    pixels: Pixmap,
    clip: Option<Mask>,
}

impl Canvas {
    /// Blank paper; a side of 0 becomes 1.
    pub fn new(columns: u32, lines: u32) -> Self {
        let mut pixels = Pixmap::new(columns.max(1), lines.max(1)).expect("sides are positive and bounded");
        pixels.fill(color(PAPER));
        Self { pixels, clip: None }
    }

    /// Keeps curves within `area` until [`unclip`](Self::unclip).
    pub fn clip(&mut self, area: Area) {
        let mut mask = Mask::new(self.pixels.width(), self.pixels.height()).expect("as large as the paper");
        if let Some(rect) = rect(area) {
            mask.fill_path(&PathBuilder::from_rect(rect), FillRule::Winding, false, Transform::identity());
        }
        self.clip = Some(mask);
    }

    /// Lets curves go anywhere.
    pub fn unclip(&mut self) {
        self.clip = None;
    }

    /// Fills `area`.
    pub fn fill(&mut self, area: Area, colour: Colour) {
        if let Some(rect) = rect(area) {
            let clip = self.clip.as_ref();
            self.pixels.fill_rect(rect, &paint(colour), Transform::identity(), clip);
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
        let mut path = PathBuilder::new();
        for (index, &(x, y)) in points.iter().enumerate() {
            if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        let stroke =
            Stroke { width, line_cap: LineCap::Butt, line_join: LineJoin::Bevel, ..Stroke::default() };
        if let Some(path) = path.finish() {
            let clip = self.clip.as_ref();
            self.pixels.stroke_path(&path, &paint(colour), &stroke, Transform::identity(), clip);
        }
    }

    /// Text with its base line at `at`.
    pub fn text(&mut self, text: &str, at: (f32, f32), anchor: Anchor, size: Size, colour: Colour) {
        let left = at.0 + anchor.shift(lettering::width(text, size));
        self.letters(text, size, colour, Transform::from_translate(left, at.1));
    }

    /// Text that runs upwards, centred on `at`.
    pub fn text_upwards(&mut self, text: &str, at: (f32, f32), size: Size, colour: Colour) {
        let below = at.1 + lettering::width(text, size) / 2.0;
        self.letters(text, size, colour, Transform::from_row(0.0, -1.0, 1.0, 0.0, at.0, below));
    }

    fn letters(&mut self, text: &str, size: Size, colour: Colour, place: Transform) {
        if let Some(path) = lettering::outline(text, size) {
            self.pixels.fill_path(&path, &paint(colour), FillRule::Winding, place, None);
        }
    }

    /// Sets the pixels of `area`, whose corners lie on whole pixels, to `colour_of(column, line)`.
    pub fn image(&mut self, area: Area, colour_of: impl Fn(u32, u32) -> Colour) {
        let stride = self.pixels.width() as usize;
        let (left, top) = (area.left as usize, area.top as usize);
        for line in 0..area.height as u32 {
            for column in 0..area.width as u32 {
                let [r, g, b] = colour_of(column, line);
                let place = (top + line as usize) * stride + left + column as usize;
                let opaque = PremultipliedColorU8::from_rgba(r, g, b, 255);
                self.pixels.pixels_mut()[place] = opaque.expect("opaque colours are premultiplied");
            }
        }
    }

    /// The picture.
    pub fn finish(self) -> Drawing {
        let rgb = self.pixels.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect();
        Drawing::new(self.pixels.width(), self.pixels.height(), rgb)
    }
}

fn rect(area: Area) -> Option<Rect> {
    Rect::from_xywh(area.left, area.top, area.width, area.height)
}

fn color([r, g, b]: Colour) -> Color {
    Color::from_rgba8(r, g, b, 255)
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(color(colour));
    paint
}
