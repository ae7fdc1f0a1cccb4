//! What the vertices on a side of a tile do.

use crate::{State, Terrain, Tile, TileState};

/// Who decides how far the vertices on an edge have morphed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edges {
    /// The edge: both sides draw the same line.
    Shared,
    /// Each tile for itself, as reported: the sides differ, and the ground cracks.
    PerTile,
}

/// A side of a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Least x of a tile.
    Left,
    /// Greatest x of a tile.
    Right,
    /// Least y of a tile.
    Bottom,
    /// Greatest y of a tile.
    Top,
}

impl Side {
    /// All sides of a tile.
    pub const ALL: [Self; 4] = [Self::Left, Self::Right, Self::Bottom, Self::Top];

    /// The tile beyond the side; `None` at a border of the terrain.
    pub fn beyond(self, terrain: &Terrain, Tile { column, row }: Tile) -> Option<Tile> {
        let [columns, rows] = terrain.counts();
        match self {
            Self::Left => column.checked_sub(1).map(|column| Tile { column, row }),
            Self::Right => (column + 1 < columns).then_some(Tile { column: column + 1, row }),
            Self::Bottom => row.checked_sub(1).map(|row| Tile { column, row }),
            Self::Top => (row + 1 < rows).then_some(Tile { column, row: row + 1 }),
        }
    }

    /// Whether vertex i, j of a tile of so many cells lies on the side.
    pub fn holds(self, [i, j]: [usize; 2], cells: usize) -> bool {
        match self {
            Self::Left => i == 0,
            Self::Right => i == cells,
            Self::Bottom => j == 0,
            Self::Top => j == cells,
        }
    }
}

/// Fraction of the vertices on a side of a tile of state `own`, 0 to 1.
pub fn fraction(edges: Edges, own: TileState, other: Option<TileState>) -> f64 {
    match (edges, other) {
        (Edges::PerTile, _) | (_, None) => own.fraction,
        (Edges::Shared, Some(other)) if other.level == own.level => shared(own.fraction, other.fraction),
        // The line is that of the coarser tile: the finer one has wholly become it, and the coarser one does not move.
        (Edges::Shared, Some(other)) => f64::from(u8::from(other.level > own.level)),
    }
}

/// Fraction of an edge between tiles of one level with fractions a and b: 1 where either is 1, 0 where either is 0, and the same from both sides. Where
/// one is 1 and the other 0 there is none: zones longer than the distance of tiles keep that from happening, and 0 is taken.
fn shared(a: f64, b: f64) -> f64 {
    let both = a * b;
    let neither = (1.0 - a) * (1.0 - b);
    if both + neither == 0.0 { 0.0 } else { both / (both + neither) }
}

/// State of the tile beyond a side.
pub fn beyond(terrain: &Terrain, state: &State, tile: Tile, side: Side) -> Option<TileState> {
    side.beyond(terrain, tile).map(|other| state.tile(terrain.number(other)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn check_values_of_the_edge_rule() {
        let values = [
            (0.5, 0.5, 0.5),
            (0.25, 0.75, 0.5),
            (0.3, 0.6, 0.391304347826),
            (1.0, 0.2, 1.0),
            (0.0, 0.7, 0.0),
        ];
        for (a, b, expected) in values {
            assert!((shared(a, b) - expected).abs() < 1e-12, "{a} {b}");
            assert_eq!(shared(a, b), shared(b, a));
        }
    }

    #[test]
    fn the_coarser_side_rules() {
        let of = |level: usize| TileState { level, fraction: 0.3 };
        assert_eq!(fraction(Edges::Shared, of(0), Some(of(1))), 1.0);
        assert_eq!(fraction(Edges::Shared, of(1), Some(of(0))), 0.0);
        assert_eq!(fraction(Edges::PerTile, of(1), Some(of(0))), 0.3);
        assert_eq!(fraction(Edges::Shared, of(1), None), 0.3);
    }
}
