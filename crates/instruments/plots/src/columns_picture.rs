//! Grey pictures of one size below one another, and under them what each column of them is.

use crate::axis::Ruler;
use crate::bar_picture::legend;
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, FAINT, INK, LATE, TRACES};
use crate::frame::{BELOW, Frame, Header, LEFT, TEXT};
use crate::trace_picture::RIGHT;
use crate::{Drawing, PlotError};

/// Room above a picture for its name.
const ABOVE: f32 = 26.0;
/// Height of the strip.
const STRIP: f32 = 26.0;
/// Pictures narrower than this are shown larger, by whole pixels.
const NARROW: u32 = 480;
/// Classes in the order of their colours: late, parts, both, no reason.
const CLASSES: [Colour; 4] = [LATE, TRACES[0], TRACES[3], [250, 190, 0]];

/// Pictures and the classes of their columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns<'a> {
    /// Pixels of a line, in every picture.
    pub width: usize,
    /// Name and codes of each picture, line by line from the top; 0 is black, 255 white.
    pub pictures: Vec<(&'a str, &'a [u8])>,
    /// Names of the classes, at most four.
    pub classes: Vec<&'a str>,
    /// Class of each column; `None` leaves it blank.
    pub class_of: Vec<Option<usize>>,
}

/// Pictures below one another, pixel by pixel, and a strip that gives each column the colour of its class.
///
/// # Errors
/// If there is no picture, sizes do not go together, or a class has no name.
pub fn columns_picture(columns: &Columns<'_>, title: &str, facts: &[String]) -> Result<Drawing, PlotError> {
    check(columns)?;
    let zoom = NARROW.div_ceil(columns.width as u32).max(1);
    let width = (columns.width as u32 * zoom) as f32;
    let height = (columns.pictures[0].1.len() / columns.width) as u32 * zoom;
    let header = Header::new(title, facts, width);
    let pitch = ABOVE + height as f32;
    let strip = header.height() + pitch * columns.pictures.len() as f32 + ABOVE;
    let mut canvas = Canvas::new((LEFT + width + RIGHT) as u32, (strip + STRIP + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    for (index, (name, codes)) in columns.pictures.iter().enumerate() {
        let top = header.height() + pitch * index as f32 + ABOVE;
        canvas.text(name, (LEFT, top - 8.0), Anchor::Left, TEXT, INK);
        let grey = |column: u32, line: u32| {
            [codes[(line / zoom) as usize * columns.width + (column / zoom) as usize]; 3]
        };
        canvas.image(Area { left: LEFT, top, width, height: height as f32 }, grey);
    }
    draw_strip(&mut canvas, columns, Area { left: LEFT, top: strip, width, height: STRIP }, zoom);
    Ok(canvas.finish())
}

fn draw_strip(canvas: &mut Canvas, columns: &Columns<'_>, area: Area, zoom: u32) {
    let entries: Vec<(&str, Colour)> = columns.classes.iter().copied().zip(CLASSES).collect();
    canvas.text("columns", (area.left, area.top - 8.0), Anchor::Left, TEXT, INK);
    legend(canvas, &entries, area);
    let colour =
        |column: u32, _| columns.class_of[(column / zoom) as usize].map_or(FAINT, |class| CLASSES[class]);
    canvas.image(area, colour);
    let x = Ruler::linear([0.0, columns.width as f64]);
    Frame { area, x, y: Ruler::linear([0.0, 1.0]) }.x_axis(canvas, "column");
}

fn check(columns: &Columns<'_>) -> Result<(), PlotError> {
    let (width, pictures) = (columns.width, &columns.pictures);
    let Some((_, first)) = pictures.first().filter(|(_, codes)| !codes.is_empty() && width > 0) else {
        return Err(PlotError::Empty { what: "pictures".into() });
    };
    let count = |what: &str, found, expected| match found == expected {
        true => Ok(()),
        false => Err(PlotError::Count { what: what.into(), found, expected }),
    };
    count("pixels of whole lines", first.len() % width, 0)?;
    pictures.iter().try_for_each(|(name, codes)| count(name, codes.len(), first.len()))?;
    count("classes of columns", columns.class_of.len(), width)?;
    let names = columns.classes.len().min(CLASSES.len());
    match columns.class_of.iter().flatten().find(|class| **class >= names) {
        None => Ok(()),
        Some(class) => count("names of classes", names, class + 1),
    }
}

#[cfg(test)]
mod tests {
    use super::{Columns, columns_picture};

    fn columns(class_of: Vec<Option<usize>>) -> Columns<'static> {
        let pictures = vec![("a", &[0, 128, 255, 7, 8, 9][..]), ("b", &[1; 6][..])];
        Columns { width: 3, pictures, classes: vec!["timing", "parts"], class_of }
    }

    #[test]
    fn every_pixel_is_there_and_every_column_has_its_colour() {
        let drawing = columns_picture(&columns(vec![Some(0), None, Some(1)]), "two", &[]).unwrap();
        // 160 times as large: a pixel is 160 x 160.
        let (stride, rgb) = (drawing.columns() as usize, drawing.rgb());
        let count = |colour: [u8; 3]| rgb.chunks_exact(3).filter(|pixel| *pixel == colour).count();
        assert_eq!((count([128; 3]), count([7; 3])), (160 * 160, 160 * 160));
        assert!(count([1; 3]) == 6 * 160 * 160);
        let strip = drawing.lines() as usize - super::BELOW as usize - 3;
        let at = |column: usize| {
            let place = 3 * (strip * stride + super::LEFT as usize + column);
            [rgb[place], rgb[place + 1], rgb[place + 2]]
        };
        assert_eq!([at(80), at(240), at(400)], [super::CLASSES[0], super::FAINT, super::CLASSES[1]]);
    }

    #[test]
    fn what_does_not_go_together_is_refused() {
        let wrong = |columns: &Columns<'_>| columns_picture(columns, "", &[]).unwrap_err().to_string();
        let good = || columns(vec![None; 3]);
        assert!(wrong(&Columns { class_of: vec![None; 2], ..good() }).contains("2 values, expected 3"));
        assert!(wrong(&columns(vec![None, None, Some(2)])).contains("names of classes"));
        assert!(wrong(&Columns { pictures: vec![], ..good() }).contains("pictures"));
        let short = vec![("a", &[0; 6][..]), ("b", &[0; 3][..])];
        assert!(wrong(&Columns { pictures: short, ..good() }).starts_with("b: 3 values"));
        assert!(wrong(&Columns { pictures: vec![("a", &[0; 5][..])], ..good() }).contains("whole lines"));
    }
}
