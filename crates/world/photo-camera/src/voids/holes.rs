//! Holes of a grid: voids joined by rows and columns, with the known posts around them.

/// Voids that hang together.
pub(super) struct Hole {
    /// Its voids in ascending order: row by row.
    pub posts: Vec<usize>,
    /// Known posts beside its voids, in ascending order.
    pub rim: Vec<usize>,
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

/// All holes of a grid, by their first post.
pub(super) fn find(shape: [usize; 2], heights: &[f64]) -> Vec<Hole> {
    let mut seen = vec![false; heights.len()];
    let mut holes = Vec::new();
    for first in 0..heights.len() {
        if heights[first].is_nan() && !seen[first] {
            holes.push(around(shape, heights, first, &mut seen));
        }
    }
    holes
}

fn around(shape: [usize; 2], heights: &[f64], first: usize, seen: &mut [bool]) -> Hole {
    let (mut posts, mut rim, mut is_enclosed) = (vec![first], Vec::new(), true);
    seen[first] = true;
    let mut next = 0;
    while let Some(&post) = posts.get(next) {
        next += 1;
        is_enclosed &= neighbours(shape, post).count() == 4;
        for beside in neighbours(shape, post) {
            if !heights[beside].is_nan() {
                rim.push(beside);
            } else if !seen[beside] {
                seen[beside] = true;
                posts.push(beside);
            }
        }
    }
    posts.sort_unstable();
    rim.sort_unstable();
    rim.dedup();
    Hole { posts, rim, is_enclosed }
}
