//! How much the database of a terrain takes: as the thesis stores it, and as it is kept here.

use lod_tiles::Terrain;

use super::Hardware;

/// Versions of outer faces and corners that the thesis stores: for a neighbour of the same level, a coarser and a finer one.
const VERSIONS: u64 = 3;

/// Bytes of a post here: its height as f64, two slopes as f32.
const KEPT: u64 = 16;

/// Vertices and triangles of all tiles at all levels, with every version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stored {
    /// Posts of the finest level.
    pub posts: u64,
    /// Vertices of all levels and versions.
    pub vertices: u64,
    /// Triangles of the same.
    pub triangles: u64,
}

impl Stored {
    /// What the thesis stores of `terrain` in so many levels. A version is counted whole; what stitching leaves out of it is not taken off (chosen).
    pub fn of(terrain: &Terrain, levels: usize) -> Self {
        let tiles = terrain.tiles().count() as u64;
        let [mut vertices, mut triangles] = [0; 2];
        for level in 0..levels {
            let cells = terrain.cells(level) as u64;
            // Posts that touch no side; two rows of each outer face; four posts of each corner.
            let (inner, outer) = (cells.saturating_sub(1), cells.saturating_sub(2));
            let outer_vertices = if outer > 0 { 4 * 2 * (outer + 1) } else { 0 };
            vertices += inner * inner + VERSIONS * (outer_vertices + 4 * 4);
            triangles += 2 * outer * outer + VERSIONS * (4 * 2 * outer + 4 * 2);
        }
        let posts = terrain.posts();
        Self { posts, vertices: tiles * vertices, triangles: tiles * triangles }
    }

    /// Bytes of it on the board, with a light map of a texel a post.
    pub fn document_bytes(&self, hardware: &Hardware) -> u64 {
        let board = &hardware.board;
        self.vertices * board.vertex_bytes
            + self.triangles * board.triangle_bytes
            + self.posts * board.texel_bytes
    }

    /// Bytes of the posts as they are kept here: levels and versions follow from them.
    pub fn kept_bytes(&self) -> u64 {
        self.posts * KEPT
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tile of four cells a side: two levels of it.
    #[test]
    fn every_level_and_version_is_counted() {
        let places: Vec<f64> = (0..5).map(f64::from).collect();
        let terrain = Terrain::new(2, [places.clone(), places], vec![0.0; 25]).unwrap();
        let stored = Stored::of(&terrain, 2);
        // 3 x 3 posts within, outer faces of 2 x 3 posts; then one post within, corners alone.
        assert_eq!((stored.posts, stored.vertices), (25, (9 + 3 * (24 + 16)) + (1 + 3 * 16)));
        assert_eq!(stored.triangles, (8 + 3 * (16 + 8)) + 3 * 8);
        assert_eq!(stored.kept_bytes(), 400);
    }
}
