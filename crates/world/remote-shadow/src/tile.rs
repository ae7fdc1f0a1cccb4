//! One tile of the shadow map.

use crate::Outlines;
use crate::caster::{Best, Upstream};
use crate::chains::Chains;
use crate::ground::LitGround;
use crate::lattice::{Corner, Lattice};
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
    /// Boundaries, shadow to the right of each segment.
    pub outlines: Outlines,
}

impl Tile {
    /// Places of all profiles of a tile at which the ground is looked at first.
    pub const PLACES: u64 = (STRIPS as u64 + 1) * (STRIPS as u64 + 1);

    /// The shadow over `place`, after which `casters` are those of its edge towards the sun.
    pub(crate) fn compute(lit: LitGround<'_>, place: Place, casters: &mut Casters) -> Self {
        let spacing = lit.lattice * (1i64 << place.level) as f64;
        let ([p, q], side) = place.lattice();
        let step = side / STRIPS;
        let across: Vec<f64> = (0..=STRIPS).map(|n| (p + n * step) as f64 * lit.lattice).collect();
        let start = q as f64 * lit.lattice;
        let tops = casters.advance(lit, &across, q);
        let profiles = across.iter().zip(tops);
        let dark: Vec<Vec<Interval>> =
            profiles.map(|(&p, top)| Walk::intervals(lit, p, start, spacing, STRIPS as usize, top)).collect();
        let pieces = outline(&across, &dark, [start, start + STRIPS as f64 * spacing]);
        let lattice = Lattice::new(lit.lattice, place);
        let pieces: Vec<[Corner; 2]> =
            pieces.iter().map(|piece| piece.map(|end| lattice.nearest(end))).collect();
        let chains = Chains::joined(&pieces, |corner| corner);
        Self { spacing, outlines: Outlines::of_tile(lattice.on_ground(lit.axes), &chains) }
    }
}

/// The highest casters of a column of tiles, which lie one behind the other away from the sun: a tile searches only what lies behind the
/// edge of the one before.
#[derive(Debug, Default)]
pub(crate) struct Casters {
    /// Lattice point of the edge, and the highest up to it on each profile; nothing before the first tile.
    known: Option<(i64, Vec<Best>)>,
}

impl Casters {
    /// The largest `G cos e` (m) before the edge at lattice point `q` on each profile of `across` (m); minus infinity without ground.
    fn advance(&mut self, lit: LitGround<'_>, across: &[f64], q: i64) -> Vec<f64> {
        let known = self.known.take();
        let (mut hint, mut highest) = (None, Vec::with_capacity(across.len()));
        let profiles = across.iter().enumerate().map(|(n, &p)| {
            let all = Upstream::new(lit, p, q);
            let upstream = known.as_ref().map_or(all, |(to, bests)| all.behind(*to, bests[n]));
            let best = upstream.best(hint);
            hint = best.point();
            highest.push(best);
            upstream.top(best).unwrap_or(f64::NEG_INFINITY)
        });
        let tops = profiles.collect();
        self.known = Some((q, highest));
        tops
    }
}

fn outline(across: &[f64], dark: &[Vec<Interval>], ends: [f64; 2]) -> Vec<Piece> {
    let side = |n: usize| Side { p: across[n], dark: &dark[n] };
    let mut pieces = Vec::new();
    for n in 1..across.len() {
        join(side(n - 1), side(n), &mut pieces);
    }
    merge_along(ends, &mut pieces);
    edge(side(0), false, &mut pieces);
    edge(side(across.len() - 1), true, &mut pieces);
    pieces
}

/// Makes one piece of those that follow each other along the tile's own edges.
fn merge_along(ends: [f64; 2], pieces: &mut Vec<Piece>) {
    let lies_on = |piece: &Piece, q: f64| piece[0][1] == q && piece[1][1] == q;
    let mut merged: Vec<Piece> = Vec::new();
    for (end, q) in ends.into_iter().enumerate() {
        let first = merged.len();
        for &[from, to] in pieces.iter().filter(|piece| lies_on(piece, q)) {
            // Strips come from left to right; on the edge away from the sun the pieces run the other way.
            match merged[first..].last_mut() {
                Some(last) if end == 0 && last[1] == from => last[1] = to,
                Some(last) if end == 1 && last[0] == to => last[0] = from,
                _ => merged.push([from, to]),
            }
        }
    }
    pieces.retain(|piece| !ends.iter().any(|&q| lies_on(piece, q)));
    pieces.append(&mut merged);
}

#[cfg(test)]
mod tests {
    use super::{Piece, outline};

    fn area(pieces: &[Piece]) -> f64 {
        pieces.iter().map(|[a, b]| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum()
    }

    #[test]
    fn a_dark_tile_has_four_edges() {
        let across = [0.0, 1.0, 2.0, 3.0];
        let pieces = outline(&across, &vec![vec![[5.0, 8.0]]; 4], [5.0, 8.0]);
        assert_eq!(pieces.len(), 4);
        assert_eq!(area(&pieces), 9.0);
    }

    #[test]
    fn merging_keeps_the_area() {
        let across = [0.0, 1.0, 2.0, 3.0];
        let dark = [vec![[5.0, 8.0]], vec![[5.0, 6.0], [7.0, 8.0]], vec![[5.0, 8.0]], vec![[5.5, 8.0]]];
        let merged = outline(&across, &dark, [5.0, 8.0]);
        let apart = outline(&across, &dark, [f64::NAN; 2]);
        assert!(merged.len() < apart.len());
        assert!((area(&merged) - area(&apart)).abs() < 1e-12);
    }
}
