//! Chains of corners as they are found.

/// Closed chains of corners, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Chains<P> {
    pub(crate) corners: Vec<P>,
    /// Last corner of each chain but the last one, ascending.
    pub(crate) ends: Vec<u32>,
}

impl<P> Default for Chains<P> {
    fn default() -> Self {
        Self { corners: Vec::new(), ends: Vec::new() }
    }
}

impl<P: Copy> Chains<P> {
    /// Those that `pieces` (from, to) make in whatever order they come; each end of one is to be the beginning of another.
    /// Corners of one `key` are the same.
    pub(crate) fn joined<K: Ord>(pieces: &[[P; 2]], key: impl Fn(P) -> K) -> Self {
        let mut by_start: Vec<u32> = (0..pieces.len() as u32).collect();
        let start = |&index: &u32| key(pieces[index as usize][0]);
        by_start.sort_by_key(start);
        let mut is_taken = vec![false; pieces.len()];
        let mut take = |from: P| {
            let first = by_start.partition_point(|index| start(index) < key(from));
            let mut here = by_start[first..].iter().take_while(|index| start(index) == key(from));
            let next = *here.find(|&&index| !is_taken[index as usize])? as usize;
            is_taken[next] = true;
            Some(pieces[next][1])
        };
        let mut chains = Self::default();
        for [from, _] in pieces {
            let mut next = take(*from);
            if next.is_some() {
                chains.begin(*from);
            }
            while let Some(corner) = next {
                chains.corners.push(corner);
                next = if key(corner) == key(*from) { None } else { take(corner) };
            }
        }
        chains
    }

    /// Ends a chain, if there is one, and begins the next.
    pub(crate) fn begin(&mut self, corner: P) {
        self.ends.extend(self.corners.len().checked_sub(1).map(|last| last as u32));
        self.corners.push(corner);
    }

    /// Whether ends are ascending numbers of corners.
    pub(crate) fn is_whole(&self) -> bool {
        let ascend = self.ends.is_sorted_by(|a, b| a < b);
        ascend && self.ends.last().is_none_or(|&last| (last as usize) < self.corners.len())
    }
}
