//! The lattice of a tile in the sun's axes, on which all corners of its shadow lie.

use crate::axes::SunAxes;
use crate::strip::TIP_PLACES;
use crate::tile::{Place, STRIPS};

/// Places over a spacing away from the sun: 12 halvings of it, 12 more of a part that they left, and the middle of two.
const ALONG: f64 = (1 << 25) as f64;

/// A place of the lattice, counted from the middle of the tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Corner {
    /// Away from the sun.
    pub(crate) along: i32,
    /// Steps across the direction of the sun.
    pub(crate) across: i16,
}

/// Corners of a tile, one after the other. There are hundreds of thousands: six bytes each.
#[derive(Debug, Clone, PartialEq)]
pub struct TileCorners {
    lattice: GroundLattice,
    along: Box<[i32]>,
    across: Box<[i16]>,
}

/// The lattice of one tile.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lattice {
    /// Middle of the tile: p, q (m).
    middle: [f64; 2],
    /// From place to place: p, q (m).
    steps: [f64; 2],
}

/// The same on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GroundLattice {
    /// Middle of the tile: north, east (m).
    middle: [f64; 2],
    /// From place to place across and away from the sun: north, east (m).
    steps: [[f64; 2]; 2],
}

impl Lattice {
    /// That of the tile at `place`; profiles of the finest tiles are `finest` (m) apart.
    pub(crate) fn new(finest: f64, place: Place) -> Self {
        let (first, side) = place.lattice();
        let spacing = finest * (side / STRIPS) as f64;
        Self {
            middle: first.map(|first| (first + side / 2) as f64 * finest),
            steps: [spacing / f64::from(TIP_PLACES), spacing / ALONG],
        }
    }

    /// The place nearest to (p, q) (m) of the tile.
    pub(crate) fn nearest(&self, [p, q]: [f64; 2]) -> Corner {
        let [across, along] =
            [(p, 0), (q, 1)].map(|(at, axis)| ((at - self.middle[axis]) / self.steps[axis]).round());
        Corner { along: along as i32, across: across as i16 }
    }

    /// As it lies under a sun.
    pub(crate) fn on_ground(&self, axes: SunAxes) -> GroundLattice {
        let [across, along] = self.steps;
        GroundLattice {
            middle: axes.to_ground(self.middle),
            steps: [axes.to_ground([across, 0.0]), axes.to_ground([0.0, along])],
        }
    }
}

impl GroundLattice {
    /// North or east (m) of a place.
    #[inline(always)]
    fn place(&self, axis: usize, Corner { along, across }: Corner) -> f64 {
        let [a, b] = self.steps;
        self.middle[axis] + (f64::from(across) * a[axis] + f64::from(along) * b[axis])
    }
}

impl TileCorners {
    pub(crate) fn new(lattice: GroundLattice, corners: &[Corner]) -> Self {
        let (along, across) =
            corners.iter().map(|corner| (corner.along, corner.across)).unzip::<_, _, Vec<_>, Vec<_>>();
        Self { lattice, along: along.into(), across: across.into() }
    }

    /// Returns the number of corners.
    #[inline]
    pub fn len(&self) -> usize {
        self.along.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// As the lattice has them.
    pub(crate) fn iter(&self) -> impl Iterator<Item = Corner> {
        self.along.iter().zip(&self.across).map(|(&along, &across)| Corner { along, across })
    }

    /// North and east (m) of corner `number`.
    #[inline]
    pub fn get(&self, number: usize) -> [f64; 2] {
        let corner = Corner { along: self.along[number], across: self.across[number] };
        [0, 1].map(|axis| self.lattice.place(axis, corner))
    }

    /// Returns several corners from `first` on; see [`Corners::some`](crate::Corners::some).
    #[inline(always)]
    pub(crate) fn some<const COUNT: usize>(&self, first: usize) -> [[f64; COUNT]; 2] {
        let (along, across): ([i32; COUNT], [i16; COUNT]) =
            (some_of(&self.along, first), some_of(&self.across, first));
        let mut places = [[0.0; COUNT]; 2];
        // Loops have the vectors of their caller.
        for axis in 0..2 {
            for n in 0..COUNT {
                places[axis][n] = self.lattice.place(axis, Corner { along: along[n], across: across[n] });
            }
        }
        places
    }
}

/// Those from number `first` on; the last one stands in for those that are not there.
#[inline(always)]
pub(crate) fn some_of<P: Copy, const COUNT: usize>(all: &[P], first: usize) -> [P; COUNT] {
    match all[first..].first_chunk() {
        Some(some) => *some,
        None => std::array::from_fn(|n| all[(first + n).min(all.len() - 1)]),
    }
}

#[cfg(test)]
mod tests {
    use super::{Lattice, TileCorners};
    use crate::axes::SunAxes;
    use crate::strip::{TIP, TIP_PLACES};
    use crate::tile::{Place, STRIPS};
    use landscape::Sun;
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, proptest};

    fn place() -> impl Strategy<Value = Place> {
        (0..12u32, [-4000..4000i64, -4000..4000i64]).prop_map(|(level, at)| Place { level, at })
    }

    proptest! {
        /// Profiles and tips between them; starts and ends halved twice over, and their middles: to the rounding of a length.
        #[test]
        fn corners_of_a_tile_lie_on_its_lattice(
            place in place(),
            (profile, tip) in (0..=STRIPS, -1..=1i8),
            (spot, part) in (0..STRIPS, 0..=1u32 << 25),
            azimuth in -4.0..4.0f64,
            finest in 1e-3..2.0f64,
        ) {
            let lattice = Lattice::new(finest, place);
            let ([p, q], side) = place.lattice();
            let spacing = finest * (side / STRIPS) as f64;
            let p = p as f64 * finest + (profile as f64 + f64::from(tip) * TIP) * spacing;
            let q = q as f64 * finest + (spot as f64 + f64::from(part) / f64::from(1u32 << 25)) * spacing;
            let corner = lattice.nearest([p, q]);
            let across = i64::from(TIP_PLACES) * (profile - STRIPS / 2) + 4 * i64::from(tip);
            prop_assert_eq!(corner.across, across as i16);
            let axes = SunAxes::new(&Sun { azimuth, elevation: 0.1 });
            let found = TileCorners::new(lattice.on_ground(axes), &[corner]).get(0);
            let right = axes.to_ground([p, q]);
            let rounding = 8.0 * f64::EPSILON * (p.abs() + q.abs() + side as f64 * finest);
            prop_assert!((0..2).all(|axis| (found[axis] - right[axis]).abs() <= rounding), "{:?} {:?}", found, right);
        }
    }
}
