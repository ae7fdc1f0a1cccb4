//! Sub-areas put together, band by band, so that no more than a band of them is held.

use generator::Label;
use raster::{Screen, SubArea};

use crate::tile::Tile;

/// Rows of pixels that have not all their sampling points yet.
pub struct Band {
    width: usize,
    height: usize,
    /// How many pixels a sub-area reaches beyond its own: 0 or 1.
    reach: usize,
    /// Row of pixels at which it begins.
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
        let first = columns.start as usize;
        for (row, surfaces) in (rows.start as usize..).zip(tile.surfaces.chunks(columns.len())) {
            let place = (row - self.first) * self.width + first;
            for (kept, (q, label)) in self.surfaces[place..].iter_mut().zip(surfaces) {
                *kept = (*q as f32, *label);
            }
        }
        let across = columns.len() + 2 * self.reach;
        // What reaches beyond the border of the screen is left out: the first place that lies on it, and how many do.
        let skipped = self.reach.saturating_sub(first);
        let left = (first + skipped).saturating_sub(self.reach);
        for (row, colours) in (rows.start as usize..).zip(tile.colours.chunks(across)) {
            let y = row.wrapping_sub(self.reach);
            if y >= self.height {
                continue;
            }
            let place = (y - self.first) * self.width;
            let sums = &mut self.sums[place + left..place + self.width];
            for ((sum, weights), (colour, weight)) in sums.iter_mut().zip(&colours[skipped..]) {
                *sum = [sum[0] + colour[0], sum[1] + colour[1], sum[2] + colour[2]];
                *weights += weight;
            }
        }
    }

    /// Hands over the rows that no later sub-area reaches: their colours and nearest surfaces, row by row.
    pub fn hand_over(&mut self, colours: &mut Vec<[f32; 3]>, surfaces: &mut Vec<(f32, Label)>) {
        let end = if self.end == self.height { self.height } else { self.end - self.reach };
        let pixels = (end - self.first) * self.width;
        // Beyond the border of the screen there are no sampling points: the others weigh more.
        let mean = |([red, green, blue], weight): ([f64; 3], f64)| {
            [(red / weight) as f32, (green / weight) as f32, (blue / weight) as f32]
        };
        colours.extend(self.sums.drain(..pixels).map(mean));
        surfaces.extend(self.surfaces.drain(..pixels));
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A tile of a sub-area whose pixels, and those that it reaches, have values of their own.
    fn tile(area: &SubArea, reach: usize) -> Tile {
        let (columns, rows) = (area.columns(), area.rows());
        let value = |k: usize| f64::from(columns.start * 7 + rows.start * 3) + (k * k % 11) as f64;
        let reached = (columns.len() + 2 * reach) * (rows.len() + 2 * reach);
        let colour = |k: usize| ([value(k), 2.0 * value(k), 1.0], 0.5 + (k % 3) as f64);
        let surface = |k: usize| (value(k), if k.is_multiple_of(2) { Label::Terrain } else { Label::Rock });
        Tile {
            colours: (0..reached).map(colour).collect(),
            surfaces: (0..columns.len() * rows.len()).map(surface).collect(),
            ..Tile::default()
        }
    }

    /// Colour of a pixel from all sub-areas at once.
    fn colour(screen: &Screen, reach: usize, [x, y]: [usize; 2]) -> [f32; 3] {
        let (mut sum, mut weights) = ([0.0; 3], 0.0);
        for number in 0..screen.sub_areas() {
            let area = screen.sub_area(number);
            let [column, row] = [(x, area.columns()), (y, area.rows())].map(|(at, range)| {
                ((at + reach).wrapping_sub(range.start as usize), range.len() + 2 * reach)
            });
            if column.0 < column.1 && row.0 < row.1 {
                let (colour, weight) = tile(&area, reach).colours[row.0 * column.1 + column.0];
                sum = [0, 1, 2].map(|channel| sum[channel] + colour[channel]);
                weights += weight;
            }
        }
        sum.map(|channel| (channel / weights) as f32)
    }

    #[test]
    fn bands_of_any_height_make_the_picture_of_all_sub_areas() {
        let screen = Screen::new([19, 45], 8).unwrap();
        let [columns, rows] = screen.counts().map(|count| count as usize);
        for reach in [0, 1] {
            for band_rows in [1, 2, rows] {
                let (mut band, mut colours, mut surfaces) =
                    (Band::new(&screen, reach), Vec::new(), Vec::new());
                for number in 0..screen.sub_areas() {
                    let area = screen.sub_area(number);
                    band.add(&tile(&area, reach), &area);
                    if (number + 1).is_multiple_of(band_rows * columns) {
                        band.hand_over(&mut colours, &mut surfaces);
                    }
                }
                let places = (0..45).flat_map(|y| (0..19).map(move |x| [x, y]));
                let expected: Vec<[f32; 3]> = places.map(|place| colour(&screen, reach, place)).collect();
                assert_eq!(colours, expected, "reach {reach}, {band_rows} rows");
                // The second pixel of the sub-area at 8, 8.
                assert_eq!(surfaces[8 * 19 + 9], ((8 * 7 + 8 * 3 + 1) as f32, Label::Rock));
                assert_eq!(surfaces.len(), 19 * 45);
            }
        }
    }
}
