//! Holes of a grid: voids joined by rows and columns, with the known posts around them.

/// All holes of a grid, by their first post.
pub(super) struct Holes {
    /// Voids of the first hole, then of the second and so on.
    posts: Vec<usize>,
    /// Their rims, in the same way.
    rims: Vec<usize>,
    ends: Vec<End>,
}

/// Where a hole ends in the lists.
struct End {
    posts: usize,
    rim: usize,
    is_enclosed: bool,
}

/// Voids that hang together.
#[derive(Clone, Copy)]
pub(super) struct Hole<'a> {
    /// Its voids in ascending order: row by row.
    pub posts: &'a [usize],
    /// Known posts beside its voids, in ascending order.
    pub rim: &'a [usize],
    /// Whether no void of the hole lies at the edge of the grid.
    pub is_enclosed: bool,
}

/// The posts above, left, right and below a post, as far as the grid goes.
pub(super) fn neighbours([rows, columns]: [usize; 2], post: usize) -> impl Iterator<Item = usize> {
    let (row, column) = (post / columns, post % columns);
    [
        (row > 0).then(|| post - columns),
        (column > 0).then(|| post - 1),
        (column + 1 < columns).then(|| post + 1),
        (row + 1 < rows).then(|| post + columns),
    ]
    .into_iter()
    .flatten()
}

impl Holes {
    /// The holes of `heights`, NaN for a void.
    pub fn find(shape: [usize; 2], heights: &[f64]) -> Self {
        let mut seen = vec![false; heights.len()];
        let mut holes = Self { posts: Vec::new(), rims: Vec::new(), ends: Vec::new() };
        for (first, height) in heights.iter().enumerate() {
            if height.is_nan() && !seen[first] {
                holes.add(shape, heights, first, &mut seen);
            }
        }
        holes
    }

    fn add(&mut self, shape: [usize; 2], heights: &[f64], first: usize, seen: &mut [bool]) {
        let (begin, rim) = (self.posts.len(), self.rims.len());
        let (mut next, mut is_enclosed) = (begin, true);
        self.posts.push(first);
        seen[first] = true;
        while let Some(&post) = self.posts.get(next) {
            next += 1;
            let mut beside_it = 0;
            for beside in neighbours(shape, post) {
                beside_it += 1;
                if !heights[beside].is_nan() {
                    self.rims.push(beside);
                } else if !seen[beside] {
                    seen[beside] = true;
                    self.posts.push(beside);
                }
            }
            is_enclosed &= beside_it == 4;
        }
        self.posts[begin..].sort_unstable();
        self.rims[rim..].sort_unstable();
        let mut last = rim;
        for at in rim..self.rims.len() {
            if self.rims[at] != self.rims[last] {
                last += 1;
                self.rims[last] = self.rims[at];
            }
        }
        self.rims.truncate(self.rims.len().min(last + 1));
        self.ends.push(End { posts: self.posts.len(), rim: self.rims.len(), is_enclosed });
    }

    /// Each hole, by its first post.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Hole<'_>> {
        (0..self.ends.len()).map(|number| {
            let before =
                |end: fn(&End) -> usize| number.checked_sub(1).map_or(0, |last| end(&self.ends[last]));
            let end = &self.ends[number];
            Hole {
                posts: &self.posts[before(|end| end.posts)..end.posts],
                rim: &self.rims[before(|end| end.rim)..end.rim],
                is_enclosed: end.is_enclosed,
            }
        })
    }
}
