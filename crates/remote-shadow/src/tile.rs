//! One tile of the shadow map.

use crate::Segment;
use crate::caster::Upstream;
use crate::ground::LitGround;
use crate::profile::{Interval, Walk};
use crate::strip::{Piece, Side, edge, join};

/// Strips of a tile: it has one profile more, and as many spacings along each.
pub(crate) const STRIPS: i64 = 64;

/// Place of a tile: spacing `lattice 2^level`, indices across and away from the sun in units of tiles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    pub(crate) level: u32,
    pub(crate) at: [i64; 2],
}

impl Place {
    /// First lattice point (p, q) and the number of lattice points along a side.
    pub(crate) fn lattice(self) -> ([i64; 2], i64) {
        let side = STRIPS << self.level;
        (self.at.map(|index| index * side), side)
    }

    /// The four tiles of the next finer level on the same ground.
    pub(crate) fn quarters(self) -> [Self; 4] {
        std::array::from_fn(|k| Self {
            level: self.level - 1,
            at: [2 * self.at[0] + k as i64 / 2, 2 * self.at[1] + k as i64 % 2],
        })
    }
}

/// Boundaries of remote shadow over one square of ground. They are closed: where shadow goes on beyond the square,
/// the square's own edge is among them, so that windings add up to 0 along any line.
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    /// Distance between the profiles (m): across the sun's azimuth boundaries are good to about this.
    pub spacing: f64,
    /// Boundary segments, shadow to the right of each.
    pub segments: Vec<Segment>,
}

impl Tile {
    /// The shadow over `place`.
    pub(crate) fn compute(lit: LitGround<'_>, place: Place) -> Self {
        let spacing = lit.lattice * (1i64 << place.level) as f64;
        let ([p, q], side) = place.lattice();
        let step = side / STRIPS;
        let across: Vec<f64> = (0..=STRIPS).map(|n| (p + n * step) as f64 * lit.lattice).collect();
        let start = q as f64 * lit.lattice;
        let mut hint = None;
        let dark: Vec<Vec<Interval>> = across
            .iter()
            .map(|&p| {
                let caster = Upstream::new(lit, p, q).highest(hint);
                hint = caster.map(|(_, k)| k);
                let top = caster.map_or(f64::NEG_INFINITY, |(top, _)| top);
                Walk::intervals(lit, p, start, spacing, STRIPS as usize, top)
            })
            .collect();
        let pieces = outline(&across, &dark);
        let ground = |point| lit.axes.to_ground(point);
        let segments = pieces.iter().map(|&[a, b]| Segment { from: ground(a), to: ground(b) }).collect();
        Self { spacing, segments }
    }
}

fn outline(across: &[f64], dark: &[Vec<Interval>]) -> Vec<Piece> {
    let side = |n: usize| Side { p: across[n], dark: &dark[n] };
    let mut pieces = Vec::new();
    for n in 1..across.len() {
        join(side(n - 1), side(n), &mut pieces);
    }
    edge(side(0), false, &mut pieces);
    edge(side(across.len() - 1), true, &mut pieces);
    pieces
}
