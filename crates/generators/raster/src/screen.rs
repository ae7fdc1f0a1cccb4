//! The screen and its sub-areas.

use std::ops::Range;

/// Most pixels of a raster's side. Chosen, so that edge functions fit their integers with room.
pub const LARGEST_RASTER: u32 = 8192;

/// Most pixels of a sub-area's side. Chosen: the pixels of a sub-area are then the bits of one word.
pub const LARGEST_SIDE: u32 = 8;

/// A raster that is cut into square sub-areas. Those at the right and lower border may be narrower.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Screen {
    size: [u32; 2],
    side: u32,
    counts: [u32; 2],
}

/// A size that no screen has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum ScreenError {
    /// Width or height (pixels) is out of range.
    #[error("raster of {0} x {1} pixels: expected sides of 1 to {LARGEST_RASTER}")]
    Size(u32, u32),
    /// The side of a sub-area (pixels) is out of range.
    #[error("sub-areas of {0} x {0} pixels: expected sides of 1 to {LARGEST_SIDE}")]
    Side(u32),
}

impl Screen {
    /// A screen of `size` (width, height; pixels, 1 to 8192) in sub-areas of `side` pixels (1 to 8).
    ///
    /// # Errors If size or side is out of range.
    pub fn new(size: [u32; 2], side: u32) -> Result<Self, ScreenError> {
        let [width, height] = size;
        if size.iter().any(|pixels| !(1..=LARGEST_RASTER).contains(pixels)) {
            return Err(ScreenError::Size(width, height));
        }
        if !(1..=LARGEST_SIDE).contains(&side) {
            return Err(ScreenError::Side(side));
        }
        Ok(Self { size, side, counts: size.map(|pixels| pixels.div_ceil(side)) })
    }

    /// Width and height (pixels), each 1 to 8192.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Side of a sub-area (pixels), 1 to 8.
    pub fn side(&self) -> u32 {
        self.side
    }

    /// Columns and rows of sub-areas.
    pub fn counts(&self) -> [u32; 2] {
        self.counts
    }

    /// Number of all sub-areas.
    pub fn sub_areas(&self) -> usize {
        (self.counts[0] * self.counts[1]) as usize
    }

    /// The sub-area of a number below [`Screen::sub_areas`], counted row by row from the top left.
    pub fn sub_area(&self, number: usize) -> SubArea {
        let [columns, _] = self.counts;
        let place = [number as u32 % columns, number as u32 / columns];
        let origin = place.map(|count| count * self.side);
        SubArea { origin, size: [0, 1].map(|axis| self.side.min(self.size[axis] - origin[axis])) }
    }
}

/// A rectangle of at most 8 x 8 pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubArea {
    pub(crate) origin: [u32; 2],
    pub(crate) size: [u32; 2],
}

impl SubArea {
    /// Its columns of pixels on the screen.
    pub fn columns(&self) -> Range<u32> {
        self.range(0)
    }

    /// Its rows of pixels on the screen.
    pub fn rows(&self) -> Range<u32> {
        self.range(1)
    }

    fn range(&self, axis: usize) -> Range<u32> {
        self.origin[axis]..self.origin[axis] + self.size[axis]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sub_areas_tile_the_raster() {
        let screen = Screen::new([21, 10], 8).unwrap();
        let mut seen = [[0; 21]; 10];
        for area in (0..screen.sub_areas()).map(|number| screen.sub_area(number)) {
            for y in area.rows() {
                area.columns().for_each(|x| seen[y as usize][x as usize] += 1);
            }
        }
        assert!(seen.iter().flatten().all(|&times| times == 1), "{seen:?}");
        assert_eq!(Screen::new([1000, 1000], 8).unwrap().sub_areas(), 15625);
    }

    #[test]
    fn sizes_out_of_range_are_refused() {
        for size in [[0, 5], [5, 0], [8193, 5], [5, u32::MAX]] {
            assert_eq!(Screen::new(size, 8), Err(ScreenError::Size(size[0], size[1])));
        }
        for side in [0, 9] {
            assert_eq!(Screen::new([5, 5], side), Err(ScreenError::Side(side)));
        }
        assert!(Screen::new([8192, 8192], 1).is_ok());
    }
}
