//! Closed outlines, corner by corner: each is stored once, however many segments meet there.

use crate::Segment;
use crate::chains::Chains;
use crate::lattice::{Corner, GroundLattice, TileCorners, some_of};

/// Closed outlines of shadow on the ground (11.2), as chains of corners whose last is the first again.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outlines {
    /// Corners of all chains, chain after chain.
    corners: Corners,
    /// Last corner of each chain but the last one, ascending: from there to the next corner there is no segment.
    ends: Box<[u32]>,
}

/// Corners of outlines, the first of each twice.
#[derive(Debug, Clone, PartialEq)]
pub enum Corners {
    /// Anywhere on the ground: north, east (m).
    Anywhere(Box<[[f64; 2]]>),
    /// On the lattice of a tile.
    OfTile(Box<TileCorners>),
}

impl Default for Corners {
    fn default() -> Self {
        Self::Anywhere(Box::default())
    }
}

impl Corners {
    /// Returns the number of corners.
    #[inline]
    pub fn len(&self) -> usize {
        match self {
            Self::Anywhere(corners) => corners.len(),
            Self::OfTile(corners) => corners.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Corner `number` (north, east; m).
    #[inline]
    pub fn get(&self, number: usize) -> [f64; 2] {
        match self {
            Self::Anywhere(corners) => corners[number],
            Self::OfTile(corners) => corners.get(number),
        }
    }

    /// North of those from number `first` on, and east (m); the last one stands in for those that are not there.
    #[inline(always)]
    pub fn some<const COUNT: usize>(&self, first: usize) -> [[f64; COUNT]; 2] {
        match self {
            Self::Anywhere(corners) => {
                let some: [[f64; 2]; COUNT] = some_of(corners, first);
                let mut places = [[0.0; COUNT]; 2];
                // A loop has the vectors of its caller.
                for n in 0..COUNT {
                    [places[0][n], places[1][n]] = some[n];
                }
                places
            }
            Self::OfTile(corners) => corners.some(first),
        }
    }

    /// Goes through the places of all corners: north, east (m).
    pub fn iter(&self) -> impl ExactSizeIterator<Item = [f64; 2]> {
        (0..self.len()).map(|number| self.get(number))
    }
}

impl Outlines {
    /// The closed outline through `corners` (north, east; m) in their order; nothing for fewer than three.
    pub fn closed(corners: &[[f64; 2]]) -> Self {
        Self::of(&[corners])
    }

    /// The same of several.
    pub fn of(outlines: &[impl AsRef<[[f64; 2]]>]) -> Self {
        let mut chains = Chains::default();
        for corners in outlines.iter().map(AsRef::as_ref).filter(|corners| corners.len() >= 3) {
            chains.begin(corners[0]);
            chains.corners.extend_from_slice(&corners[1..]);
            chains.corners.push(corners[0]);
        }
        Self::anywhere(chains)
    }

    /// The outlines that `segments` make in whatever order they come; each end of one is to be the beginning of another.
    pub fn joined(segments: &[Segment]) -> Self {
        let segments: Vec<_> = segments.iter().map(|&Segment { from, to }| [from, to]).collect();
        // The same place for the same bits alone.
        Self::anywhere(Chains::joined(&segments, |corner| corner.map(f64::to_bits)))
    }

    fn anywhere(Chains { corners, ends }: Chains<[f64; 2]>) -> Self {
        Self { corners: Corners::Anywhere(corners.into()), ends: ends.into() }
    }

    /// Those of a tile with a lattice.
    pub(crate) fn of_tile(lattice: GroundLattice, Chains { corners, ends }: &Chains<Corner>) -> Self {
        if corners.is_empty() {
            return Self::default();
        }
        let corners = Corners::OfTile(Box::new(TileCorners::new(lattice, corners)));
        Self { corners, ends: ends.as_slice().into() }
    }

    /// Returns the corners of all outlines, chain after chain.
    pub fn corners(&self) -> &Corners {
        &self.corners
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// Corners from which no segment runs to the next one, ascending.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// The segment from corner `number`, which is none of [`ends`](Self::ends), to the next one.
    #[inline]
    pub fn segment(&self, number: usize) -> Segment {
        Segment { from: self.corners.get(number), to: self.corners.get(number + 1) }
    }

    /// Numbers of the corners of each outline, first and last.
    pub fn chains(&self) -> impl Iterator<Item = [usize; 2]> {
        let last = self.corners.len().checked_sub(1);
        let ends = self.ends.iter().map(|&end| end as usize).chain(last);
        ends.scan(0, |first, end| Some([std::mem::replace(first, end + 1), end]))
    }

    /// Those outlines whose first corner (north, east; m) `keeps` has.
    #[must_use]
    pub fn only(&self, keeps: impl Fn([f64; 2]) -> bool) -> Self {
        let mut kept = Chains::default();
        for [first, last] in self.chains().filter(|&[first, _]| keeps(self.corners.get(first))) {
            kept.begin(self.corners.get(first));
            kept.corners.extend((first + 1..=last).map(|number| self.corners.get(number)));
        }
        Self::anywhere(kept)
    }

    /// Goes through the segments of all outlines.
    pub fn segments(&self) -> impl Iterator<Item = Segment> {
        let mut ends = self.ends.iter().peekable();
        let numbers = 0..self.corners.len().saturating_sub(1);
        numbers
            .filter(move |&number| ends.next_if(|&&end| end as usize == number).is_none())
            .map(|n| self.segment(n))
    }
}

#[cfg(test)]
mod tests {
    use super::Outlines;
    use crate::Segment;
    use crate::axes::SunAxes;
    use crate::chains::Chains;
    use crate::lattice::{Corner, Lattice, TileCorners};
    use crate::tile::Place;
    use landscape::Sun;
    use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

    fn sorted(segments: impl Iterator<Item = Segment>) -> Vec<[u64; 4]> {
        let bits = |Segment { from, to }: Segment| [from[0], from[1], to[0], to[1]].map(f64::to_bits);
        let mut all: Vec<_> = segments.map(bits).collect();
        all.sort_unstable();
        all
    }

    proptest! {
        /// Outlines that share corners, in any order of their segments: each segment is there as often as it came.
        #[test]
        fn joined_segments_are_those_that_were_given(
            outlines in proptest::collection::vec(proptest::collection::vec([0..4u8, 0..4u8], 3..9), 0..8),
            turn in 0..50usize,
        ) {
            let outlines: Vec<Vec<[f64; 2]>> =
                outlines.iter().map(|corners| corners.iter().map(|corner| corner.map(f64::from)).collect()).collect();
            let straight = Outlines::of(&outlines);
            let mut segments: Vec<Segment> = straight.segments().collect();
            prop_assert_eq!(segments.len(), outlines.iter().map(Vec::len).sum::<usize>());
            let turn = turn % segments.len().max(1);
            segments.rotate_left(turn);
            segments.reverse();
            let joined = Outlines::joined(&segments);
            prop_assert_eq!(sorted(joined.segments()), sorted(segments.into_iter()));
            let mut first = 0;
            for end in joined.ends().iter().map(|&end| end as usize).chain(joined.corners().len().checked_sub(1)) {
                prop_assert_eq!(joined.corners().get(first), joined.corners().get(end), "closed");
                first = end + 1;
            }
            prop_assert!(first == joined.corners().len());
        }

        /// What a tile's outlines tell, in whatever way they are asked, is what those anywhere tell of the same places.
        #[test]
        fn outlines_of_a_tile_are_those_of_its_places(
            corners in proptest::collection::vec((any::<i32>(), -160..=160i16), 0..30),
            ends in proptest::collection::btree_set(0..30u32, 0..5),
            azimuth in -4.0..4.0f64,
        ) {
            let lattice = Lattice::new(0.05, Place { level: 3, at: [-7, 40] });
            let lattice = lattice.on_ground(SunAxes::new(&Sun { azimuth, elevation: 0.1 }));
            let corners: Vec<Corner> =
                corners.into_iter().map(|(along, across)| Corner { along, across }).collect();
            let ends: Vec<u32> = ends.into_iter().filter(|&end| (end as usize) < corners.len()).collect();
            let of_tile = TileCorners::new(lattice, &corners);
            let chains = Chains { corners, ends };
            let outlines = Outlines::of_tile(lattice, &chains);
            let places = (0..chains.corners.len()).map(|number| of_tile.get(number)).collect();
            let anywhere = Outlines::anywhere(Chains { corners: places, ends: chains.ends.clone() });
            prop_assert!(outlines.corners().iter().eq(anywhere.corners().iter()));
            prop_assert_eq!(sorted(outlines.segments()), sorted(anywhere.segments()));
            prop_assert!(of_tile.iter().eq(chains.corners.iter().copied()));
            for first in 0..of_tile.len() {
                let some = of_tile.some::<4>(first);
                for n in 0..4 {
                    let corner = of_tile.get((first + n).min(of_tile.len() - 1));
                    prop_assert_eq!([some[0][n], some[1][n]], corner);
                }
            }
        }
    }

    #[test]
    fn an_outline_has_three_corners_or_more() {
        assert!(Outlines::closed(&[[0.0, 0.0], [1.0, 0.0]]).is_empty());
        assert_eq!(Outlines::closed(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).segments().count(), 3);
    }
}
