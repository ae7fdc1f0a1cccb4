//! Hull, deck and superstructure of a ship as faces.

use glam::DVec3;

use super::pieces::Pieces;
use super::{Block, Level, Ship};
use crate::error::FaceError;
use crate::face::Shading;
use crate::mesh::Mesh;

/// Intervals between stations from stern to bow (chosen).
pub(super) const INTERVALS: usize = 20;
/// Number of the level at the waterline.
const WATER: usize = 2;
/// Linear grey of the hull (chosen).
pub(super) const HULL: [f64; 3] = [0.22, 0.23, 0.25];
/// Linear grey of the deck (chosen).
const DECK: [f64; 3] = [0.10, 0.10, 0.11];
/// Linear grey of the superstructure (chosen).
const BLOCK: [f64; 3] = [0.32, 0.33, 0.35];
/// Linear white of markings (chosen).
const PAINT: [f64; 3] = [0.80, 0.80, 0.78];

/// Down to where a hull is modelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Depth {
    /// Hull above the water only.
    Waterline,
    /// Whole hull, closed at the keel.
    Keel,
}

impl Level {
    /// Half breadth as a part of half the beam, at part `u` of the length from stern (0) to bow (1).
    fn part(&self, u: f64) -> f64 {
        let rounded = |s: f64| {
            let s = s.min(1.0);
            s * (2.0 - s)
        };
        let aft = self.transom + (1.0 - self.transom) * rounded(u / self.run);
        self.breadth * aft.min(rounded((1.0 - u) / self.entrance))
    }
}

impl Ship {
    /// The starboard edge of a level at station `station` from the stern (forward, starboard, up; m).
    pub(super) fn edge(&self, level: &Level, station: usize) -> DVec3 {
        let u = station as f64 / INTERVALS as f64;
        let along = -self.length / 2.0 + u * (self.length - level.cut_back);
        DVec3::new(along, level.part(u) * self.beam / 2.0, level.up)
    }

    /// Edge of the waterline at a station.
    pub(super) fn waterline(&self, station: usize) -> DVec3 {
        self.edge(&self.levels[WATER], station)
    }

    /// Faces of the whole ship above the waterline, the list `list`.
    ///
    /// # Errors
    /// If the ship's figures give no faces.
    pub fn above_water(&self, list: &str) -> Result<Mesh, FaceError> {
        self.pieces(Depth::Waterline).mesh(list)
    }

    /// Faces of the whole ship down to the keel, the list `list`.
    ///
    /// # Errors
    /// If the ship's figures give no faces.
    pub fn to_the_keel(&self, list: &str) -> Result<Mesh, FaceError> {
        self.pieces(Depth::Keel).mesh(list)
    }

    /// Faces from the top downwards: of faces in one plane the earlier wins.
    pub(super) fn pieces(&self, depth: Depth) -> Pieces {
        let mut pieces = Pieces::default();
        self.blocks.iter().for_each(|block| raise(block, &mut pieces));
        self.deck(&mut pieces);
        let lowest = match depth {
            Depth::Waterline => WATER,
            Depth::Keel => 0,
        };
        self.sides(&self.levels[lowest..], &mut pieces);
        self.transom(&self.levels[lowest..], &mut pieces);
        if depth == Depth::Keel {
            self.plate(&self.levels[0], -DVec3::Z, HULL, &mut pieces);
        }
        pieces
    }

    /// Markings, then the deck.
    fn deck(&self, pieces: &mut Pieces) {
        let top = &self.levels[4];
        for marking in self.markings {
            let [aft, fore] = marking.along;
            let [port, starboard] = marking.across;
            let corners = [[aft, port], [aft, starboard], [fore, starboard], [fore, port]];
            pieces.flat(&corners.map(|[x, y]| DVec3::new(x, y, top.up)), DVec3::Z, PAINT);
        }
        self.plate(top, DVec3::Z, DECK, pieces);
    }

    /// A level as flat faces from side to side.
    fn plate(&self, level: &Level, outwards: DVec3, colour: [f64; 3], pieces: &mut Pieces) {
        for station in 0..INTERVALS {
            let [aft, fore] = [station, station + 1].map(|station| self.edge(level, station));
            let mut outline = vec![mirrored(aft), aft, fore];
            if fore.y > 0.0 {
                outline.push(mirrored(fore));
            }
            pieces.flat(&outline, outwards, colour);
        }
    }

    /// Both sides of the hull between levels, cut in triangles with shared vertices.
    fn sides(&self, levels: &[Level], pieces: &mut Pieces) {
        for side in [DVec3::Y, -DVec3::Y] {
            let mut numbers = Vec::with_capacity(levels.len() * (INTERVALS + 1));
            for level in levels {
                for station in 0..=INTERVALS {
                    let edge = self.edge(level, station);
                    numbers.push(pieces.vertex(if side.y > 0.0 { edge } else { mirrored(edge) }));
                }
            }
            let number = |level: usize, station: usize| numbers[level * (INTERVALS + 1) + station];
            for level in 0..levels.len() - 1 {
                for station in 0..INTERVALS {
                    let [a, b] = [number(level, station), number(level, station + 1)];
                    let [d, c] = [number(level + 1, station), number(level + 1, station + 1)];
                    pieces.join(vec![a, b, c], side, (HULL, Shading::Smooth));
                    pieces.join(vec![a, c, d], side, (HULL, Shading::Smooth));
                }
            }
        }
    }

    /// The stern between levels.
    fn transom(&self, levels: &[Level], pieces: &mut Pieces) {
        for pair in levels.windows(2) {
            let [low, high] = [&pair[0], &pair[1]].map(|level| self.edge(level, 0));
            pieces.flat(&[mirrored(low), low, high, mirrored(high)], -DVec3::X, HULL);
        }
    }
}

/// The same place on the port side.
pub(super) fn mirrored(place: DVec3) -> DVec3 {
    DVec3::new(place.x, -place.y, place.z)
}

/// Four sides and the top of a block.
fn raise(block: &Block, pieces: &mut Pieces) {
    let middle = [block.along, block.across].map(|[low, high]| (low + high) / 2.0);
    let corner = |k: usize, top: bool| {
        let [x, y] = [block.along[usize::from(k == 1 || k == 2)], block.across[usize::from(k >= 2)]];
        let part = if top { block.taper } else { 1.0 };
        let [x, y] = [middle[0] + (x - middle[0]) * part, middle[1] + (y - middle[1]) * part];
        DVec3::new(x, y, block.up[usize::from(top)])
    };
    pieces.flat(&[0, 1, 2, 3].map(|k| corner(k, true)), DVec3::Z, BLOCK);
    for k in 0..4 {
        let next = (k + 1) % 4;
        let outline = [corner(k, false), corner(next, false), corner(next, true), corner(k, true)];
        let outwards = [-DVec3::Y, DVec3::X, DVec3::Y, -DVec3::X][k];
        pieces.flat(&outline, outwards, BLOCK);
    }
}
