//! Heights of one feature on its own posts, bilinear between them.

/// Share of a side over which a feature fades to 0 at its border (chosen).
const FADE: f64 = 0.1;

/// A box of ground: south-west and north-east corner, each north, east (m).
pub type Area = [[f64; 2]; 2];

/// Posts over an area, its corners included, with a height each. Outside the area heights are 0.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightGrid {
    posts: Posts,
    /// Row by row from the south, each from the west.
    heights: Vec<f64>,
}

/// Posts over an area, evenly spaced, its corners included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Posts {
    /// Area between the outermost posts (m).
    pub area: Area,
    /// Rows and columns of posts, at least 2 each.
    pub count: [usize; 2],
}

impl Posts {
    /// Posts over an area, as near to `spacing` (m) apart as they fit.
    pub fn new(area: Area, spacing: f64) -> Self {
        let cells = |axis: usize| ((area[1][axis] - area[0][axis]) / spacing).round().max(1.0) as usize;
        Self { area, count: [0, 1].map(|axis| cells(axis) + 1) }
    }

    /// Distance between rows and between columns (m).
    pub fn step(&self) -> [f64; 2] {
        [0, 1].map(|axis| (self.area[1][axis] - self.area[0][axis]) / (self.count[axis] - 1) as f64)
    }

    /// Place of a post: north, east (m).
    pub fn place(&self, post: [usize; 2]) -> [f64; 2] {
        let step = self.step();
        [0, 1].map(|axis| self.area[0][axis] + post[axis] as f64 * step[axis])
    }

    /// The post nearest to a place; places outside go to the border.
    pub fn nearest(&self, place: [f64; 2]) -> [usize; 2] {
        let step = self.step();
        [0, 1].map(|axis| {
            let post = ((place[axis] - self.area[0][axis]) / step[axis]).round().max(0.0);
            (post as usize).min(self.count[axis] - 1)
        })
    }

    /// All posts, row by row.
    pub fn all(&self) -> impl Iterator<Item = [usize; 2]> {
        let [rows, columns] = self.count;
        (0..rows).flat_map(move |row| (0..columns).map(move |column| [row, column]))
    }

    /// Factor that fades a feature to 0 at the border: `t^2 (3 - 2 t)` over a tenth of each side.
    pub fn fade(&self, place: [f64; 2]) -> f64 {
        let share = |axis: usize| {
            let [low, high] = [self.area[0][axis], self.area[1][axis]];
            let inside = (place[axis] - low).min(high - place[axis]);
            let t = (inside / (FADE * (high - low))).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        };
        share(0) * share(1)
    }
}

impl HeightGrid {
    /// Heights by a law of the post's row and column.
    pub fn new(posts: Posts, height: impl Fn([usize; 2]) -> f64) -> Self {
        Self { posts, heights: posts.all().map(height).collect() }
    }

    /// Posts of the grid.
    pub fn posts(&self) -> &Posts {
        &self.posts
    }

    /// Height of a post (m).
    pub fn post(&self, [row, column]: [usize; 2]) -> f64 {
        self.heights[row * self.posts.count[1] + column]
    }

    /// Height (m) at a place, bilinear between four posts; 0 outside the area.
    pub fn height(&self, place: [f64; 2]) -> f64 {
        let (area, step) = (self.posts.area, self.posts.step());
        if !(0..2).all(|axis| (area[0][axis]..=area[1][axis]).contains(&place[axis])) {
            return 0.0;
        }
        let cell = |axis: usize| {
            let along = (place[axis] - area[0][axis]) / step[axis];
            let post = (along.floor() as usize).min(self.posts.count[axis] - 2);
            (post, along - post as f64)
        };
        let ((row, v), (column, u)) = (cell(0), cell(1));
        let [south, north] =
            [row, row + 1].map(|row| [self.post([row, column]), self.post([row, column + 1])]);
        bilinear([south, north], [v, u])
    }

    /// Mean of the posts (m).
    pub fn mean(&self) -> f64 {
        self.heights.iter().sum::<f64>() / self.heights.len() as f64
    }
}

/// Between four heights `[[near, right], [far, far right]]`, at shares of the way to the far row and to the right column.
pub fn bilinear([near, far]: [[f64; 2]; 2], [v, u]: [f64; 2]) -> f64 {
    let across = |row: [f64; 2]| row[0] + u * (row[1] - row[0]);
    across(near) + v * (across(far) - across(near))
}
