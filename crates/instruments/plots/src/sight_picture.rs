//! What an observer sees of an area.

use crate::axis::{Ruler, extremes};
use crate::bank_picture::check_panel;
use crate::canvas::{Anchor, Area, Canvas};
use crate::colour::{Colour, HATCH, INK, LATE, PAPER, SOFT, VOID, lit, of_height};
use crate::frame::{BAR, BAR_ROOM, BELOW, Frame, Header, LEFT, SMALL, colour_bar, map_frame, map_size};
use crate::{Drawing, PlotError};

/// Colour of ground that is seen.
const SEEN: Colour = [246, 214, 120];
/// Colour of ground that is hidden.
const HIDDEN: Colour = [84, 98, 128];
/// Half the mark of the observer (pixels).
const MARK: f32 = 7.0;

/// What is drawn of each cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SightLayer<'a> {
    /// Whether a target is seen; `None` where it is unknown.
    Seen(&'a [Option<bool>]),
    /// Least height (m) at which a target is seen; NaN where it is unknown.
    LeastHeight(&'a [f64]),
}

/// Cells on a regular grid, rows from north to south, with the heights of their ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SightMap<'a> {
    /// Numbers of rows and columns.
    pub size: [usize; 2],
    /// Place of the north-western cell: north, east (m).
    pub corner: [f64; 2],
    /// Distance from cell to cell (m).
    pub spacing: f64,
    /// Height (m) of the ground of each cell, row by row; NaN where there is none.
    pub heights: &'a [f64],
    /// What is drawn of each cell, row by row.
    pub layer: SightLayer<'a>,
    /// Place of the observer: north, east (m).
    pub observer: [f64; 2],
}

/// How a map of sight is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SightLook {
    /// Title, which says what was looked at.
    pub title: String,
    /// Lines below the title.
    pub facts: Vec<String>,
    /// The longer side of the map, 120 to 8000 pixels.
    pub longest: u32,
}

/// The map of what an observer sees: colours of the cells on ground that is shaded from the north-west, north up.
///
/// # Errors
/// If the map is too small or too large, a list has another number of cells than the grid, or a place is no number.
pub fn sight_picture(map: &SightMap<'_>, look: &SightLook) -> Result<Drawing, PlotError> {
    check_panel(look.longest)?;
    map.check()?;
    let extent = map.extent();
    let [south, west, north, east] = extent;
    let (width, height) = map_size([north - south, east - west], look.longest);
    let paper = (LEFT + width + BAR_ROOM).max(560.0);
    let header = Header::new(&look.title, &look.facts, paper - LEFT - 16.0);
    let area = Area { left: LEFT, top: header.height(), width, height };
    let mut canvas = Canvas::new(paper as u32, (area.bottom() + BELOW) as u32);
    header.draw(&mut canvas, LEFT);
    let ruler = map.ruler();
    canvas.image(area, |column, line| map.colour([column, line], area, &ruler));
    let (frame, unit) = map_frame(area, extent);
    draw_observer(&mut canvas, &frame, map.observer, extent);
    frame.axes(&mut canvas, Some(&format!("east ({unit})")), &format!("north ({unit})"));
    match map.layer {
        SightLayer::Seen(_) => draw_legend(&mut canvas, area),
        SightLayer::LeastHeight(_) => colour_bar(&mut canvas, area, ruler, "least height (m)", of_height),
    }
    Ok(canvas.finish())
}

impl SightMap<'_> {
    fn check(&self) -> Result<(), PlotError> {
        let [rows, columns] = self.size;
        let expected = rows.saturating_mul(columns);
        let cells = match self.layer {
            SightLayer::Seen(cells) => cells.len(),
            SightLayer::LeastHeight(cells) => cells.len(),
        };
        for (what, found) in [("heights", self.heights.len()), ("cells", cells)] {
            if found != expected || expected == 0 {
                return Err(PlotError::Count { what: what.into(), found, expected: expected.max(1) });
            }
        }
        let places = [self.corner[0], self.corner[1], self.observer[0], self.observer[1]];
        let numbers = [("corner or observer", places.iter().all(|place| place.is_finite()), places[0])];
        let spacing = ("spacing", self.spacing.is_finite() && self.spacing > 0.0, self.spacing);
        for (what, is_good, found) in numbers.into_iter().chain([spacing]) {
            if !is_good {
                let expected = "a finite length, above 0 for spacing";
                return Err(PlotError::Value { what: what.into(), found, expected });
            }
        }
        Ok(())
    }

    /// South, west, north, east edge of the outermost cells (m).
    fn extent(&self) -> [f64; 4] {
        let half = 0.5 * self.spacing;
        let [rows, columns] = self.size.map(|count| count as f64);
        let [north, west] = [self.corner[0] + half, self.corner[1] - half];
        [north - rows * self.spacing, west, north, west + columns * self.spacing]
    }

    fn ruler(&self) -> Ruler {
        let heights = match self.layer {
            SightLayer::Seen(_) => None,
            SightLayer::LeastHeight(cells) => extremes(cells.iter().copied().filter(|cell| !cell.is_nan())),
        };
        Ruler::linear([0.0, heights.map_or(1.0, |[_, most]| most.max(1e-3))])
    }

    /// Colour of a pixel: that of the cell at its middle.
    fn colour(&self, [column, line]: [u32; 2], area: Area, ruler: &Ruler) -> Colour {
        let cell = |pixel: u32, pixels: f32, cells: usize| {
            let share = (f64::from(pixel) + 0.5) / f64::from(pixels);
            ((share * cells as f64) as usize).min(cells - 1)
        };
        let [row, across] = [cell(line, area.height, self.size[0]), cell(column, area.width, self.size[1])];
        let at = row * self.size[1] + across;
        let colour = match self.layer {
            SightLayer::Seen(cells) => cells[at].map(|seen| if seen { SEEN } else { HIDDEN }),
            SightLayer::LeastHeight(cells) => {
                Some(cells[at]).filter(|cell| !cell.is_nan()).map(|cell| of_height(ruler.share(cell)))
            }
        };
        match colour {
            Some(colour) => lit(colour, self.light(row, across)),
            None if (column + line) % 7 < 2 => HATCH,
            None => VOID,
        }
    }

    /// Light of a sun in the north-west over a cell: 0.8 on level ground, 1 at most.
    fn light(&self, row: usize, column: usize) -> f64 {
        let height = |row: usize, column: usize| self.heights[row * self.size[1] + column];
        let [above, below] = [row.saturating_sub(1), (row + 1).min(self.size[0] - 1)];
        let [left, right] = [column.saturating_sub(1), (column + 1).min(self.size[1] - 1)];
        let slope = |rise: f64, cells: usize| rise / (cells.max(1) as f64 * self.spacing);
        let north = slope(height(above, column) - height(below, column), below - above);
        let east = slope(height(row, right) - height(row, left), right - left);
        let steepness = (1.0 + north * north + east * east).sqrt();
        let light = 0.8 + 0.6 * (east - north) / steepness;
        if light.is_nan() { 0.8 } else { light.clamp(0.5, 1.0) }
    }
}

/// A cross at the observer, if it stands in the map.
fn draw_observer(canvas: &mut Canvas, frame: &Frame, [x, y]: [f64; 2], [south, west, north, east]: [f64; 4]) {
    let inside = (south..=north).contains(&x) && (west..=east).contains(&y);
    if inside {
        let share = |at: f64, low: f64, high: f64| ((at - low) / (high - low)) as f32;
        let Area { left, top, width, height } = frame.area;
        let at = (left + share(y, west, east) * width, top + (1.0 - share(x, south, north)) * height);
        draw_mark(canvas, at);
    }
}

fn draw_mark(canvas: &mut Canvas, (x, y): (f32, f32)) {
    for (width, colour) in [(5.0, PAPER), (2.5, LATE)] {
        canvas.line(&[(x - MARK, y), (x + MARK, y)], width, colour);
        canvas.line(&[(x, y - MARK), (x, y + MARK)], width, colour);
    }
}

fn draw_legend(canvas: &mut Canvas, beside: Area) {
    let left = beside.right() + 14.0;
    let row = |number: f32| beside.top + number * 24.0;
    for (number, (colour, word)) in
        [(SEEN, "visible"), (HIDDEN, "hidden"), (VOID, "unknown")].into_iter().enumerate()
    {
        let swatch = Area { left, top: row(number as f32), width: BAR, height: BAR };
        canvas.fill(swatch, colour);
        canvas.border(swatch, SOFT);
        canvas.text(word, (left + BAR + 6.0, swatch.top + 12.0), Anchor::Left, SMALL, INK);
    }
    draw_mark(canvas, (left + BAR / 2.0, row(3.0) + BAR / 2.0));
    canvas.text("observer", (left + BAR + 6.0, row(3.0) + 12.0), Anchor::Left, SMALL, INK);
}
