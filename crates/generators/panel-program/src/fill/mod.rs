//! Five ways to find the pixels of a triangle, and what each costs.

mod edge_buffer;
mod edges;
mod fence;
mod rasteriser;
mod seed;
mod span;
pub(crate) mod written;

use raster::Point;

/// A way to find the pixels whose centres lie in a triangle, by the top-left rule. All ways find the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fill {
    /// Buckets of edges, row by row into a buffer that is scanned: the way of the listing.
    EdgeBuffer,
    /// Pixels between each edge and a fence are inverted in a buffer that is scanned.
    Fence,
    /// From one pixel to its neighbours, in a buffer that is scanned.
    Seed,
    /// From edge to edge in each row, without a buffer.
    Span,
    /// Squares of 8 x 8 pixels by edge functions: the way of the crate `raster`.
    Rasteriser,
}

impl Fill {
    /// All ways by their words.
    pub const ALL: [(&str, Self); 5] = [
        ("edge-buffer", Self::EdgeBuffer),
        ("fence", Self::Fence),
        ("seed", Self::Seed),
        ("span", Self::Span),
        ("rasteriser", Self::Rasteriser),
    ];
}

/// What filling cost, counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FillWork {
    /// Buckets and cells of the buffer that were cleared.
    pub cleared: u64,
    /// Cells that were written in the buffer.
    pub marked: u64,
    /// Cells of the buffer, or squares of pixels, that were looked at.
    pub scanned: u64,
    /// Pixels that were held against the edges.
    pub tested: u64,
    /// Pixels that were found.
    pub found: u64,
}

/// Fills triangles on a screen.
#[derive(Debug, Clone)]
pub struct Filler {
    way: Fill,
    size: [usize; 2],
    buffer: Vec<u8>,
    rasteriser: rasteriser::Rasteriser,
    /// Cost of all triangles so far.
    pub work: FillWork,
}

/// Columns and rows of pixels, from the first to before the last.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PixelBox {
    low: [i64; 2],
    high: [i64; 2],
}

impl PixelBox {
    /// The pixels of a screen whose centres may lie in a triangle.
    fn new(corners: [Point; 3], size: [usize; 2]) -> Self {
        let places = corners.map(Point::position);
        let ends = |axis: usize, pick: fn(f64, f64) -> f64| {
            let end = places.iter().map(|place| place[axis]).reduce(pick).unwrap_or(0.0);
            ((end - 0.5).ceil() as i64).clamp(0, size[axis] as i64)
        };
        Self { low: [0, 1].map(|axis| ends(axis, f64::min)), high: [0, 1].map(|axis| ends(axis, f64::max)) }
    }

    fn rows(&self) -> std::ops::Range<i64> {
        self.low[1]..self.high[1]
    }

    fn columns(&self) -> std::ops::Range<i64> {
        self.low[0]..self.high[0]
    }

    /// The part of a row of crossings that lies on the screen.
    fn clamp(&self, column: i64) -> i64 {
        column.clamp(self.low[0], self.high[0])
    }
}

impl Filler {
    /// A filler of `size` (columns, lines) pixels, each side 1 to 8192.
    pub fn new(way: Fill, size: [usize; 2]) -> Self {
        let needs_buffer = matches!(way, Fill::EdgeBuffer | Fill::Fence | Fill::Seed);
        let cells = if needs_buffer { size[0] * size[1] } else { 0 };
        let rasteriser = rasteriser::Rasteriser::new(size);
        Self { way, size, buffer: vec![0; cells], rasteriser, work: FillWork::default() }
    }

    /// Calls `each` once for every pixel (column, line) of a triangle on the screen.
    pub fn fill(&mut self, corners: [Point; 3], mut each: impl FnMut(usize, usize)) {
        let pixels = PixelBox::new(corners, self.size);
        match self.way {
            Fill::Span => span::fill(corners, &pixels, &mut self.work, each),
            Fill::Rasteriser => self.rasteriser.fill(corners, &pixels, &mut self.work, each),
            Fill::EdgeBuffer | Fill::Fence | Fill::Seed => {
                let mut buffer =
                    Buffer { cells: &mut self.buffer, columns: self.size[0], work: &mut self.work };
                buffer.clear(&pixels);
                match self.way {
                    Fill::EdgeBuffer => edge_buffer::mark(corners, &pixels, self.size[1], &mut buffer),
                    Fill::Fence => fence::mark(corners, &pixels, &mut buffer),
                    _ => seed::mark(corners, &pixels, &mut buffer),
                }
                buffer.scan(&pixels, &mut each);
            }
        }
    }
}

/// The buffer of marks under a triangle.
pub(crate) struct Buffer<'a> {
    cells: &'a mut [u8],
    columns: usize,
    work: &'a mut FillWork,
}

impl Buffer<'_> {
    fn index(&self, column: i64, row: i64) -> usize {
        row as usize * self.columns + column as usize
    }

    fn clear(&mut self, pixels: &PixelBox) {
        for row in pixels.rows() {
            let [from, to] = [pixels.low[0], pixels.high[0]].map(|column| self.index(column, row));
            self.cells[from..to].fill(0);
            self.work.cleared += (to - from) as u64;
        }
    }

    fn set(&mut self, column: i64, row: i64) {
        let at = self.index(column, row);
        self.cells[at] = 1;
        self.work.marked += 1;
    }

    fn is_set(&self, column: i64, row: i64) -> bool {
        self.cells[self.index(column, row)] == 1
    }

    /// Inverts the marks of a row from a column to before another.
    fn invert(&mut self, row: i64, columns: std::ops::Range<i64>) {
        for column in columns {
            let at = self.index(column, row);
            self.cells[at] ^= 1;
            self.work.marked += 1;
        }
    }

    fn scan(&mut self, pixels: &PixelBox, each: &mut impl FnMut(usize, usize)) {
        for row in pixels.rows() {
            for column in pixels.columns() {
                self.work.scanned += 1;
                if self.is_set(column, row) {
                    self.work.found += 1;
                    each(column as usize, row as usize);
                }
            }
        }
    }
}
