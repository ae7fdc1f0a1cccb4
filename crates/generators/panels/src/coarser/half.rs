//! Triangles that are halved: one half of a square of posts.

/// Row and column of a post. It may lie beyond the last row or column: the square is larger than the ground.
pub type Post = [u32; 2];

/// A triangle of posts with a right angle, counter-clockwise seen from above.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Half {
    /// Ends of the longest side.
    pub ends: [Post; 2],
    /// The post at the right angle.
    pub corner: Post,
}

impl Half {
    /// Both halves of a square of `side` cells, parted from its south-western to its north-eastern corner.
    pub fn of_square(side: u32) -> [Self; 2] {
        let [first, last] = [[0, 0], [side, side]];
        [Self { ends: [last, first], corner: [0, side] }, Self { ends: [first, last], corner: [side, 0] }]
    }

    /// The post in the middle of the longest side; none in half a cell.
    pub fn middle(&self) -> Option<Post> {
        let [a, b] = self.ends;
        let sum = [a[0] + b[0], a[1] + b[1]];
        (sum[0] % 2 == 0 && sum[1] % 2 == 0).then(|| sum.map(|at| at / 2))
    }

    /// Its two halves, which meet along the way from its corner to `middle`.
    pub fn halves(&self, middle: Post) -> [Self; 2] {
        let [a, b] = self.ends;
        [Self { ends: [self.corner, a], corner: middle }, Self { ends: [b, self.corner], corner: middle }]
    }

    /// Its corners, counter-clockwise seen from above.
    pub fn corners(&self) -> [Post; 3] {
        [self.ends[0], self.ends[1], self.corner]
    }

    /// First and last row of its corners (axis 0), or first and last column (axis 1).
    fn reach(&self, axis: usize) -> [u32; 2] {
        let [a, b, c] = self.corners().map(|post| post[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// Whether no part of it lies over ground whose last post is `last`.
    pub fn is_beside(&self, last: Post) -> bool {
        (0..2).any(|axis| self.reach(axis)[0] >= last[axis])
    }

    /// Whether it may lie partly over that ground.
    pub fn is_over_border(&self, last: Post) -> bool {
        !self.is_beside(last) && (0..2).any(|axis| self.reach(axis)[1] > last[axis])
    }
}

/// Whether the halves of a square part its cell (by its south-western post) from there to its north-eastern post.
pub fn parts_from_south_west([row, column]: Post) -> bool {
    (row + column) % 2 == 0
}
