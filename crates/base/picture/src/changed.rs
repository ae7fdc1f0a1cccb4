//! The pixels in which two pictures differ, and a picture of them.

use crate::error::PictureError;
use crate::pixels::{ColourPicture, GreyPicture, Picture};
use crate::transfer::Encoder;

/// A changed pixel that is brighter in the second picture: orange.
const BRIGHTER: [u32; 3] = [255, 150, 0];
/// A changed pixel that is darker in the second picture: blue, which every eye tells from orange.
const DARKER: [u32; 3] = [0, 140, 255];
/// Share of its brightness that an unchanged pixel keeps, in hundredths: changed ones stand out.
const DIMMED: u32 = 40;
/// Least and further share of its colour that a changed pixel has, in hundredths: one of no grey level is seen too.
const SHOWN: [u32; 2] = [55, 45];

/// One pixel that is not the same in two pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChangedPixel {
    /// Column, from 0 at the left.
    pub column: usize,
    /// Line, from 0 at the top.
    pub line: usize,
    /// Linear intensity in the second picture less that in the first: not 0.
    pub by: f32,
    /// The same in levels of the encoder: 0 where nobody sees it.
    pub levels: i32,
}

/// The pixels in which two pictures of one size differ, line by line.
#[derive(Debug, Clone, PartialEq)]
pub struct ChangedPixels {
    first: GreyPicture,
    pixels: Vec<ChangedPixel>,
}

impl ChangedPixels {
    /// Compares two planes of linear intensity, `columns` x `lines`; levels are those of `encoder`.
    ///
    /// # Errors
    /// [`PictureError::Size`], [`PictureError::NotFinite`], as [`Encoder::encode`].
    pub fn between(
        encoder: &Encoder,
        [first, second]: [&[f32]; 2],
        [columns, lines]: [usize; 2],
    ) -> Result<Self, PictureError> {
        let codes = [encoder.encode(first, columns, lines)?, encoder.encode(second, columns, lines)?];
        let changed = (0..first.len()).filter(|&at| first[at] != second[at]).map(|at| {
            let [before, after] = codes.each_ref().map(|picture| i32::from(picture.codes()[at]));
            let (column, line) = (at % columns, at / columns);
            ChangedPixel { column, line, by: second[at] - first[at], levels: after - before }
        });
        let pixels = changed.collect();
        let [first, _] = codes;
        Ok(Self { first, pixels })
    }

    /// The changed pixels, line by line from the top.
    pub fn pixels(&self) -> &[ChangedPixel] {
        &self.pixels
    }

    /// How many of them differ by a level of the encoder or more.
    pub fn seen(&self) -> usize {
        self.pixels.iter().filter(|pixel| pixel.levels != 0).count()
    }

    /// Columns with a changed pixel, from the left.
    pub fn columns(&self) -> Vec<usize> {
        each_once(self.pixels.iter().map(|pixel| pixel.column).collect())
    }

    /// Lines with a changed pixel, from the top.
    pub fn lines(&self) -> Vec<usize> {
        each_once(self.pixels.iter().map(|pixel| pixel.line).collect())
    }

    /// The pixel that changed most, by levels and then by intensity; none if no pixel changed.
    pub fn largest(&self) -> Option<ChangedPixel> {
        let size = |pixel: &ChangedPixel| (pixel.levels.unsigned_abs(), pixel.by.abs());
        let larger = |a: ChangedPixel, b: ChangedPixel| if size(&b) > size(&a) { b } else { a };
        self.pixels.iter().copied().reduce(larger)
    }

    /// The first picture in dim grey, and on it the changed pixels: orange where the second is brighter, blue where it is
    /// darker, the more the change the brighter the colour. 8 bits.
    pub fn picture(&self) -> ColourPicture {
        let dark = self.first.to_eight_bits();
        let dim = |code: &u16| [(u32::from(*code) * DIMMED / 100) as u16; 3];
        let mut codes: Vec<u16> = dark.codes().iter().flat_map(dim).collect();
        let white = i64::from(self.first.depth().white());
        for ChangedPixel { column, line, by, levels } in &self.pixels {
            let colour = if *by > 0.0 { BRIGHTER } else { DARKER };
            let [least, more] = SHOWN;
            let share = least + (i64::from(levels.abs()) * i64::from(more) / white) as u32;
            let at = 3 * (line * dark.columns() + column);
            codes[at..at + 3].copy_from_slice(&colour.map(|code| (code * share / 100) as u16));
        }
        Picture::from_parts(dark.columns(), dark.lines(), dark.depth(), codes)
    }
}

fn each_once(mut all: Vec<usize>) -> Vec<usize> {
    all.sort_unstable();
    all.dedup();
    all
}

#[cfg(test)]
mod tests {
    use super::{ChangedPixel, ChangedPixels};
    use crate::{Depth, Encoder, Transfer};

    fn encoder() -> Encoder {
        Encoder::new(Transfer::new(1.0, 1.0).unwrap(), Depth::Eight)
    }

    /// Of six pixels one is brighter by 51 levels, one darker by less than a level.
    #[test]
    fn what_differs_is_found_and_coloured() {
        let first = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];
        let mut second = first;
        second[1] = 0.4;
        second[5] = 0.9999;
        let changed = ChangedPixels::between(&encoder(), [&first, &second], [3, 2]).unwrap();
        let pixel = |column, line, by, levels| ChangedPixel { column, line, by, levels };
        let expected = [pixel(1, 0, 0.2, 51), pixel(2, 1, 0.9999 - 1.0, 0)];
        assert_eq!(changed.pixels(), expected);
        assert_eq!((changed.seen(), changed.columns(), changed.lines()), (1, vec![1, 2], vec![0, 1]));
        assert_eq!(changed.largest(), Some(expected[0]));
        let picture = changed.picture();
        let [brighter, darker] = [picture.pixel(1, 0), picture.pixel(2, 1)];
        assert!(brighter[0] > brighter[2] && darker[2] > darker[0], "{brighter:?}, {darker:?}");
        assert_eq!(picture.pixel(0, 1), [(153 * 40 / 100) as u16; 3], "unchanged pixels are dim");
    }

    #[test]
    fn equal_pictures_have_none() {
        let plane = [0.1, 0.2];
        let changed = ChangedPixels::between(&encoder(), [&plane, &plane], [2, 1]).unwrap();
        assert_eq!((changed.pixels(), changed.largest()), (&[][..], None));
        assert!(ChangedPixels::between(&encoder(), [&plane, &plane[..1]], [2, 1]).is_err());
    }
}
