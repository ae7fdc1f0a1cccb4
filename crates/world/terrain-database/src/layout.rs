//! Size of a terrain as the document stores it.

/// Bytes of a vertex of the document: x, y and z as single numbers.
const VERTEX: u64 = 12;
/// Versions of outer and corner faces: the neighbour is as fine, coarser or finer.
const VERSIONS: u64 = 3;

/// Bytes of so many tiles of order n in the layout of the document: vertices of the inner face of every level, and of outer and corner
/// faces in three versions each.
pub fn documented_bytes(order: u32, tiles: u64) -> u64 {
    (0..=order).map(|level| tiles * VERTEX * vertices(1 << (order - level))).sum()
}

/// Vertices of a level of `cells` cells a side. A face has the vertices of its own cells: the inner face those within the outermost
/// cells, an outer face two rows, a corner four.
fn vertices(cells: u64) -> u64 {
    let inner = cells.saturating_sub(1);
    let outer = if cells > 2 { 2 * inner } else { 0 };
    let face = if cells > 2 { inner * inner } else { 0 };
    face + 4 * VERSIONS * (outer + 4)
}
