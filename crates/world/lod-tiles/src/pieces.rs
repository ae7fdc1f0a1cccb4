//! What a tile takes to draw, counted without making its mesh.

use crate::edges::{beyond, fraction};
use crate::{Side, Stitch, Surface, Tile};

/// The version of a tile's faces along a side, by the level of the neighbour there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Version {
    /// The neighbour has the same level, or there is none.
    Same,
    /// The neighbour is coarser.
    Coarser,
    /// The neighbour is finer.
    Finer,
}

/// Vertices and triangles of a tile as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TilePieces {
    /// Triangles of cells that touch no side.
    pub inner: u64,
    /// Triangles of the cells on the sides.
    pub border: u64,
    /// Vertices that are where their level has them.
    pub still: u64,
    /// Vertices that have moved on their way to the next level, those of finer neighbours with them.
    pub morphing: u64,
}

impl Surface<'_> {
    /// Versions of the sides of a tile, in the order of [`Side::ALL`].
    pub fn versions(&self, tile: Tile) -> [Version; 4] {
        let own = self.tile_state(tile).level;
        Side::ALL.map(|side| match beyond(self.terrain, self.state, tile, side) {
            Some(other) if other.level > own => Version::Coarser,
            Some(other) if other.level < own => Version::Finer,
            Some(_) | None => Version::Same,
        })
    }

    /// Vertices and triangles of a tile, as [`mesh`](Self::mesh) makes them.
    pub fn pieces(&self, tile: Tile) -> TilePieces {
        let own = self.tile_state(tile);
        let cells = self.terrain.cells(own.level) as u64;
        let versions = self.versions(tile);
        let sides = |version: Version| versions.iter().filter(|found| **found == version).count() as u64;
        // A vertex of a finer neighbour parts a triangle in two; one that is left out makes two into one.
        let (added, lost) = match self.stitch {
            Stitch::CoarseSide => (cells * sides(Version::Finer), 0),
            Stitch::FineSide => (0, cells / 2 * sides(Version::Coarser)),
            Stitch::None => (0, 0),
        };
        let inner = 2 * cells.saturating_sub(2).pow(2);
        let morphing = self.own_morphing(tile, cells) + added;
        let vertices = (cells + 1).pow(2) + added;
        TilePieces {
            inner,
            border: 2 * cells.pow(2) + added - lost - inner,
            still: vertices - morphing,
            morphing,
        }
    }

    /// Vertices of a tile's own level that have moved: those that the next level lacks, within the tile and on each side, where there is a fraction.
    fn own_morphing(&self, tile: Tile, cells: u64) -> u64 {
        let own = self.tile_state(tile);
        if own.level + 1 >= self.levels || cells < 2 {
            return 0;
        }
        let lacking = |vertices: u64, kept: u64| vertices.pow(2) - kept.pow(2);
        let within = if own.fraction > 0.0 { lacking(cells - 1, cells / 2 - 1) } else { 0 };
        let moves =
            |side: &Side| fraction(self.edges, own, beyond(self.terrain, self.state, tile, *side)) > 0.0;
        within + cells / 2 * Side::ALL.iter().filter(|side| moves(side)).count() as u64
    }

    /// How many edges between two tiles are drawn as two different lines, whatever the ground.
    pub fn cracked_edges(&self) -> u64 {
        let edges = self.terrain.tiles().flat_map(|tile| [(tile, Side::Right), (tile, Side::Top)]);
        edges.filter(|(tile, side)| self.is_cracked(*tile, *side)).count() as u64
    }

    fn is_cracked(&self, tile: Tile, side: Side) -> bool {
        let own = self.tile_state(tile);
        let Some(other) = beyond(self.terrain, self.state, tile, side) else { return false };
        let [a, b] = [(own, other), (other, own)].map(|(own, other)| fraction(self.edges, own, Some(other)));
        match own.level.abs_diff(other.level) {
            0 => a != b && own.level + 1 < self.levels,
            // The finer side has the coarser one's line only where it has wholly become it, and where that one has not moved.
            1 => {
                let [finer, coarser] = if own.level < other.level { [a, b] } else { [b, a] };
                let is_moved = coarser != 0.0 && own.level.max(other.level) + 1 < self.levels;
                finer != 1.0 && self.stitch != Stitch::FineSide || is_moved
            }
            _ => true,
        }
    }
}
