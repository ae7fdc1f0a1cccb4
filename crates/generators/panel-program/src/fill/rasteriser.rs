//! Squares of 8 x 8 pixels by edge functions.

use raster::{Coverage, Pattern, Point, Sampling, Screen, Triangle};

use super::{FillWork, PixelBox};

/// Side of a square (pixels).
const SIDE: usize = raster::LARGEST_SIDE as usize;

#[derive(Debug, Clone)]
pub(super) struct Rasteriser {
    /// None for a screen that the crate `raster` refuses; it then finds no pixel.
    screen: Option<Screen>,
    sampling: Sampling,
    coverage: Coverage,
}

impl Rasteriser {
    pub fn new(size: [usize; 2]) -> Self {
        let size = size.map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        let screen = Screen::new(size, SIDE as u32).ok();
        Self { screen, sampling: Sampling::new(Pattern::One), coverage: Coverage::default() }
    }

    pub fn fill(
        &mut self,
        corners: [Point; 3],
        pixels: &PixelBox,
        work: &mut FillWork,
        mut each: impl FnMut(usize, usize),
    ) {
        let (Some(triangle), Some(screen)) = (Triangle::new(corners), &self.screen) else { return };
        let across = screen.counts()[0] as usize;
        let squares =
            |axis: usize| pixels.low[axis] as usize / SIDE..(pixels.high[axis] as usize).div_ceil(SIDE);
        for row in squares(1) {
            for column in squares(0) {
                let area = screen.sub_area(row * across + column);
                self.coverage.find(&triangle, &area, &self.sampling);
                work.scanned += 1;
                for (pixel, _) in self.coverage.pixels() {
                    work.found += 1;
                    each(column * SIDE + pixel % SIDE, row * SIDE + pixel / SIDE);
                }
            }
        }
    }
}
