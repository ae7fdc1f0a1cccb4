//! Text as outlines of the font Hack, so that letters and curves have the same edges everywhere.

use ab_glyph::{Font, FontRef, OutlineCurve, Point};
use tiny_skia::{Path, PathBuilder};

/// A text size in pixels an em.
pub(crate) type Size = f32;

/// Width of `text` (pixels).
pub(crate) fn width(text: &str, size: Size) -> f32 {
    let font = font();
    text.chars().map(|c| font.h_advance_unscaled(font.glyph_id(c))).sum::<f32>() * scale(&font, size)
}

/// The outline of `text`, its base line from (0, 0) to the right; `None` if nothing of it is inked.
pub(crate) fn outline(text: &str, size: Size) -> Option<Path> {
    let font = font();
    let scale = scale(&font, size);
    let mut path = PathBuilder::new();
    let mut left = 0.0;
    for glyph in text.chars().map(|c| font.glyph_id(c)) {
        let place = |point: Point| (left + point.x * scale, -point.y * scale);
        if let Some(outline) = font.outline(glyph) {
            add_curves(&outline.curves, place, &mut path);
        }
        left += font.h_advance_unscaled(glyph) * scale;
    }
    path.finish()
}

/// The outline of one sign in units of the font, as the data of an SVG path; empty if it has no ink.
pub(crate) fn sign(sign: char) -> String {
    let font = font();
    let Some(outline) = font.outline(font.glyph_id(sign)) else { return String::new() };
    let (mut path, mut last) = (String::new(), None);
    for curve in &outline.curves {
        let (from, to) = ends(curve);
        if last != Some(from) {
            let close = if last.is_some() { "Z" } else { "" };
            path += &format!("{close}M{}", at(from));
        }
        last = Some(to);
        path += &match *curve {
            OutlineCurve::Line(..) => format!("L{}", at(to)),
            OutlineCurve::Quad(_, control, _) => format!("Q{} {}", at(control), at(to)),
            OutlineCurve::Cubic(_, a, b, _) => format!("C{} {} {}", at(a), at(b), at(to)),
        };
    }
    path + "Z"
}

/// The outlines of the font lie on whole units, or on halves of them.
fn at(point: Point) -> String {
    format!("{} {}", point.x, point.y)
}

/// From one sign to the next, in units of the font.
pub(crate) fn advance(sign: char) -> f32 {
    let font = font();
    font.h_advance_unscaled(font.glyph_id(sign))
}

/// Pixels a unit of the font.
pub(crate) fn em(size: Size) -> f32 {
    scale(&font(), size)
}

fn add_curves(curves: &[OutlineCurve], place: impl Fn(Point) -> (f32, f32), path: &mut PathBuilder) {
    let mut last = None;
    for curve in curves {
        let (from, to) = ends(curve);
        if last != Some(from) {
            path.close();
            let (x, y) = place(from);
            path.move_to(x, y);
        }
        last = Some(to);
        let (x, y) = place(to);
        match *curve {
            OutlineCurve::Line(..) => path.line_to(x, y),
            OutlineCurve::Quad(_, control, _) => {
                let (cx, cy) = place(control);
                path.quad_to(cx, cy, x, y);
            }
            OutlineCurve::Cubic(_, a, b, _) => {
                let ((ax, ay), (bx, by)) = (place(a), place(b));
                path.cubic_to(ax, ay, bx, by, x, y);
            }
        }
    }
    path.close();
}

fn ends(curve: &OutlineCurve) -> (Point, Point) {
    match *curve {
        OutlineCurve::Line(from, to)
        | OutlineCurve::Quad(from, _, to)
        | OutlineCurve::Cubic(from, _, _, to) => (from, to),
    }
}

fn font() -> FontRef<'static> {
    FontRef::try_from_slice(epaint_default_fonts::HACK_REGULAR).expect("the built-in font is whole")
}

fn scale(font: &FontRef<'_>, size: Size) -> f32 {
    size / font.units_per_em().expect("the built-in font names its em")
}

#[cfg(test)]
mod tests {
    use super::{outline, width};

    #[test]
    fn every_sign_we_write_has_a_shape() {
        for sign in "0Aµ°−±×²→≤".chars() {
            assert!(outline(&sign.to_string(), 12.0).is_some(), "{sign}");
        }
        assert!(outline(" ", 12.0).is_none());
    }

    #[test]
    fn width_goes_with_size() {
        assert!((width("metre", 24.0) - 2.0 * width("metre", 12.0)).abs() < 1e-4);
    }
}
