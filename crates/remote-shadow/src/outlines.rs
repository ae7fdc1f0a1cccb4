//! Closed outlines, corner by corner: each is stored once, however many segments meet there.

use crate::Segment;

/// Closed outlines of shadow on the ground (11.2), as chains of corners whose last is the first again.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outlines {
    /// North, east (m); chain after chain.
    corners: Box<[[f64; 2]]>,
    /// Last corner of each chain but the last one, ascending: from there to the next corner there is no segment.
    ends: Box<[u32]>,
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
        chains.finish()
    }

    /// The outlines that `segments` make in whatever order they come; each end of one is to be the beginning of another.
    pub fn joined(segments: &[Segment]) -> Self {
        let mut by_start: Vec<u32> = (0..segments.len() as u32).collect();
        let start = |&index: &u32| place(segments[index as usize].from);
        by_start.sort_by_key(start);
        let mut is_taken = vec![false; segments.len()];
        let mut take = |from: [f64; 2]| {
            let first = by_start.partition_point(|index| start(index) < place(from));
            let mut here = by_start[first..].iter().take_while(|index| start(index) == place(from));
            let next = *here.find(|&&index| !is_taken[index as usize])? as usize;
            is_taken[next] = true;
            Some(segments[next].to)
        };
        let mut chains = Chains::default();
        for Segment { from, .. } in segments {
            let mut next = take(*from);
            if next.is_some() {
                chains.begin(*from);
            }
            while let Some(corner) = next {
                chains.corners.push(corner);
                next = if place(corner) == place(*from) { None } else { take(corner) };
            }
        }
        chains.finish()
    }

    /// Those of which these are [`corners`](Self::corners) and [`ends`](Self::ends); `None` if the latter are not ascending
    /// numbers of corners.
    pub(crate) fn from_parts(corners: Vec<[f64; 2]>, ends: Vec<u32>) -> Option<Self> {
        let ascend = ends.is_sorted_by(|a, b| a < b);
        let are_corners = ends.last().is_none_or(|&last| (last as usize) < corners.len());
        (ascend && are_corners).then(|| Self { corners: corners.into(), ends: ends.into() })
    }

    /// All corners (north, east; m), the first of each outline twice.
    pub fn corners(&self) -> &[[f64; 2]] {
        &self.corners
    }

    /// Corners from which no segment runs to the next one, ascending.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// The segment from corner `number`, which is none of [`ends`](Self::ends), to the next one.
    pub fn segment(&self, number: usize) -> Segment {
        Segment { from: self.corners[number], to: self.corners[number + 1] }
    }

    /// All segments.
    pub fn segments(&self) -> impl Iterator<Item = Segment> {
        let mut ends = self.ends.iter().peekable();
        let numbers = 0..self.corners.len().saturating_sub(1);
        numbers
            .filter(move |&number| ends.next_if(|&&end| end as usize == number).is_none())
            .map(|n| self.segment(n))
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }
}

/// Outlines as they are found.
#[derive(Default)]
struct Chains {
    corners: Vec<[f64; 2]>,
    ends: Vec<u32>,
}

impl Chains {
    /// Ends a chain, if there is one, and begins the next.
    fn begin(&mut self, corner: [f64; 2]) {
        self.ends.extend(self.corners.len().checked_sub(1).map(|last| last as u32));
        self.corners.push(corner);
    }

    fn finish(self) -> Outlines {
        Outlines { corners: self.corners.into(), ends: self.ends.into() }
    }
}

/// A place as a key: the same for the same bits alone.
fn place(corner: [f64; 2]) -> [u64; 2] {
    corner.map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::Outlines;
    use crate::Segment;
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

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
            for end in joined.ends.iter().map(|&end| end as usize).chain(joined.corners.len().checked_sub(1)) {
                prop_assert_eq!(joined.corners[first], joined.corners[end], "closed");
                first = end + 1;
            }
            prop_assert!(first == joined.corners.len());
            prop_assert_eq!(Outlines::from_parts(joined.corners.to_vec(), joined.ends.to_vec()), Some(joined));
        }
    }

    #[test]
    fn an_outline_has_three_corners_or_more() {
        assert!(Outlines::closed(&[[0.0, 0.0], [1.0, 0.0]]).is_empty());
        assert_eq!(Outlines::closed(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).segments().count(), 3);
    }
}
