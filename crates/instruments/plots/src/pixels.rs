//! Draws marks as pixels of a raster.

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, PremultipliedColorU8, Rect, Stroke,
    StrokeDash, Transform,
};

use crate::colour::Colour;
use crate::lettering;
use crate::mark::{Area, Letters, Mark, Surface};

/// A raster on which later marks cover earlier ones.
pub(crate) struct Pixels {
    pixels: Pixmap,
    clip: Option<Mask>,
}

impl Pixels {
    /// Paper of one colour; a side of 0 becomes 1.
    pub fn new(columns: u32, lines: u32, paper: Colour) -> Self {
        let mut pixels = Pixmap::new(columns.max(1), lines.max(1)).expect("sides are positive and bounded");
        pixels.fill(color(paper));
        Self { pixels, clip: None }
    }

    /// Red, green, blue of every pixel.
    pub fn rgb(&self) -> Vec<u8> {
        self.pixels.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect()
    }

    fn clip(&mut self, area: Option<Area>) {
        self.clip = area.map(|area| {
            let mut mask =
                Mask::new(self.pixels.width(), self.pixels.height()).expect("as large as the paper");
            if let Some(rect) = rect(area) {
                let path = PathBuilder::from_rect(rect);
                mask.fill_path(&path, FillRule::Winding, false, Transform::identity());
            }
            mask
        });
    }

    fn fill(&mut self, area: Area, colour: Colour) {
        if let Some(rect) = rect(area) {
            self.pixels.fill_rect(rect, &paint(colour), Transform::identity(), self.clip.as_ref());
        }
    }

    fn line(&mut self, points: &[(f32, f32)], width: f32, dash: Option<[f32; 2]>, colour: Colour) {
        let dash = dash.and_then(|dash| StrokeDash::new(dash.into(), 0.0));
        let (line_cap, line_join) = (LineCap::Butt, LineJoin::Bevel);
        let stroke = Stroke { width, line_cap, line_join, dash, ..Stroke::default() };
        if let Some(path) = joined(points).finish() {
            let clip = self.clip.as_ref();
            self.pixels.stroke_path(&path, &paint(colour), &stroke, Transform::identity(), clip);
        }
    }

    fn polygon(&mut self, points: &[(f32, f32)], colour: Colour) {
        let mut path = joined(points);
        path.close();
        if let Some(path) = path.finish() {
            let (place, clip) = (Transform::identity(), self.clip.as_ref());
            self.pixels.fill_path(&path, &paint(colour), FillRule::Winding, place, clip);
        }
    }

    fn letters(&mut self, letters: &Letters) {
        let (x, y) = letters.at;
        let place = if letters.upwards {
            Transform::from_row(0.0, -1.0, 1.0, 0.0, x, y)
        } else {
            Transform::from_translate(x, y)
        };
        if let Some(path) = lettering::outline(&letters.text, letters.size) {
            self.pixels.fill_path(&path, &paint(letters.colour), FillRule::Winding, place, None);
        }
    }

    fn image(&mut self, area: Area, colours: &[Colour]) {
        let stride = self.pixels.width() as usize;
        let (left, top, columns) = (area.left as usize, area.top as usize, area.width as usize);
        for (line, colours) in colours.chunks(columns.max(1)).enumerate() {
            let place = (top + line) * stride + left;
            for (pixel, &[r, g, b]) in self.pixels.pixels_mut()[place..].iter_mut().zip(colours) {
                let opaque = PremultipliedColorU8::from_rgba(r, g, b, 255);
                *pixel = opaque.expect("opaque colours are premultiplied");
            }
        }
    }
}

impl Surface for Pixels {
    fn take(&mut self, mark: &Mark) {
        match mark {
            Mark::Clip(area) => self.clip(*area),
            Mark::Fill(area, colour) => self.fill(*area, *colour),
            Mark::Line { points, width, dash, colour } => self.line(points, *width, *dash, *colour),
            Mark::Polygon(points, colour) => self.polygon(points, *colour),
            Mark::Letters(letters) => self.letters(letters),
            Mark::Image(area, colours) => self.image(*area, colours),
        }
    }
}

fn joined(points: &[(f32, f32)]) -> PathBuilder {
    let mut path = PathBuilder::new();
    for (index, &(x, y)) in points.iter().enumerate() {
        if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    path
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
