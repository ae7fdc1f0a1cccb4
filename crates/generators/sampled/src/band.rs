//! Sub-areas put together, band by band, so that no more than a band of them is held.

use generator::Label;
use raster::{Screen, SubArea};

use crate::picture::Picture;
use crate::tile::Tile;

/// Rows of pixels that have not all their sampling points yet.
pub struct Band {
    width: usize,
    height: usize,
    /// How many pixels a sub-area reaches beyond its own: 0 or 1.
    reach: usize,
    /// The first row.
    first: usize,
    /// The row after the last sub-area that was added.
    end: usize,
    /// Colours and weights, row by row.
    sums: Vec<([f64; 3], f64)>,
    surfaces: Vec<(f32, Label)>,
}

impl Band {
    /// The first band of a screen; `reach` is how many pixels the filter reaches beyond one.
    pub fn new(screen: &Screen, reach: usize) -> Self {
        let [width, height] = screen.size().map(|pixels| pixels as usize);
        Self { width, height, reach, first: 0, end: 0, sums: Vec::new(), surfaces: Vec::new() }
    }

    /// Adds a sub-area; they come in their order.
    pub fn add(&mut self, tile: &Tile, area: &SubArea) {
        let (columns, rows) = (area.columns(), area.rows());
        self.end = rows.end as usize;
        self.grow();
        for (k, (q, label)) in tile.surfaces.iter().enumerate() {
            let [row, column] = [k / columns.len(), k % columns.len()];
            let row = rows.start as usize + row - self.first;
            self.surfaces[row * self.width + columns.start as usize + column] = (*q as f32, *label);
        }
        let across = columns.len() + 2 * self.reach;
        for (k, (colour, weight)) in tile.colours.iter().enumerate() {
            let x = (columns.start as usize + k % across).wrapping_sub(self.reach);
            let y = (rows.start as usize + k / across).wrapping_sub(self.reach);
            if x < self.width && y < self.height {
                let (sum, weights) = &mut self.sums[(y - self.first) * self.width + x];
                *sum = [sum[0] + colour[0], sum[1] + colour[1], sum[2] + colour[2]];
                *weights += weight;
            }
        }
    }

    /// Hands over the rows that no later sub-area reaches.
    pub fn hand_over(&mut self, picture: &mut Picture) {
        let end = if self.end == self.height { self.height } else { self.end - self.reach };
        let pixels = (end - self.first) * self.width;
        // Beyond the border of the screen there are no sampling points: the others weigh more.
        let mean = |(sum, weight): ([f64; 3], f64)| sum.map(|channel| (channel / weight) as f32);
        picture.colours.extend(self.sums.drain(..pixels).map(mean));
        picture.surfaces.extend(self.surfaces.drain(..pixels));
        self.first = end;
    }

    /// Makes room for all that the last sub-area reaches.
    fn grow(&mut self) {
        let rows = (self.end + self.reach).min(self.height) - self.first;
        let pixels = rows * self.width;
        if self.sums.len() < pixels {
            self.sums.resize(pixels, ([0.0; 3], 0.0));
            self.surfaces.resize(pixels, (0.0, Label::Sky));
        }
    }
}
