//! Highest posts of square blocks, level over level.

/// For each level l the highest post of every block of 2^l x 2^l cells, borders included. A void counts as infinite.
#[derive(Debug, Clone)]
pub struct Pyramid {
    levels: Vec<Blocks>,
}

#[derive(Debug, Clone)]
struct Blocks {
    size: [usize; 2],
    highest: Vec<f64>,
}

impl Pyramid {
    /// The pyramid of rows x columns of heights (m), up to one block.
    pub fn new([rows, columns]: [usize; 2], heights: &[f64]) -> Self {
        let of_post = |row: usize, column: usize| {
            let height = heights[row * columns + column];
            if height.is_nan() { f64::INFINITY } else { height }
        };
        let mut levels = vec![Blocks::new([rows - 1, columns - 1], |row, column| {
            let north = of_post(row, column).max(of_post(row, column + 1));
            north.max(of_post(row + 1, column)).max(of_post(row + 1, column + 1))
        })];
        while levels[levels.len() - 1].highest.len() > 1 {
            levels.push(levels[levels.len() - 1].coarser());
        }
        Self { levels }
    }

    /// Number of levels, the cells included.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Highest post (m) of a block.
    pub fn highest(&self, level: usize, [row, column]: [usize; 2]) -> f64 {
        let blocks = &self.levels[level];
        blocks.highest[row * blocks.size[1] + column]
    }
}

impl Blocks {
    fn new(size: [usize; 2], highest: impl Fn(usize, usize) -> f64) -> Self {
        let places = (0..size[0] * size[1]).map(|at| (at / size[1], at % size[1]));
        Self { size, highest: places.map(|(row, column)| highest(row, column)).collect() }
    }

    /// The level above: two blocks by two, fewer at the southern and eastern border.
    fn coarser(&self) -> Self {
        let [rows, columns] = self.size;
        let of_four = |row: usize, column: usize| {
            let lines = 2 * row..rows.min(2 * row + 2);
            let of_line =
                |line: usize| &self.highest[line * columns..][2 * column..columns.min(2 * column + 2)];
            lines.flat_map(of_line).copied().fold(f64::NEG_INFINITY, f64::max)
        };
        Self::new([rows.div_ceil(2), columns.div_ceil(2)], of_four)
    }
}
