//! Boxes in a plane, found by place.

/// A box: low and high corner.
pub type Box2 = [[f64; 2]; 2];

/// Most entries a box takes on average: beyond, cells are made larger.
const ENTRIES: usize = 16;
/// Most cells along an axis.
const LONGEST: f64 = 4096.0;

/// A grid of square cells, each with the boxes that reach into it, ascending. One empty cell lies all around.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Buckets {
    low: [f64; 2],
    size: f64,
    counts: [usize; 2],
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Buckets {
    /// A grid over `boxes`; cells as small as there are boxes, if that does not take too many entries.
    pub fn new(boxes: &[Box2]) -> Self {
        let Some((low, sides)) = hull(boxes) else { return Self::default() };
        let longest = sides[0].max(sides[1]);
        let fair = (sides[0] * sides[1] / boxes.len() as f64).sqrt();
        let mut size = fair.max(longest / LONGEST).max(1e-6 * (1.0 + longest));
        let allowed = ENTRIES * boxes.len() + 4096;
        while boxes.iter().map(|each| cells_of(each, low, size)).sum::<usize>() > allowed {
            size *= 1.5;
        }
        let low = low.map(|low| low - size);
        let counts = sides.map(|side| (side / size) as usize + 3);
        let mut buckets = Self { low, size, counts, starts: Vec::new(), items: Vec::new() };
        buckets.fill(boxes);
        buckets
    }

    /// Counting sort: how many in each cell, then who.
    fn fill(&mut self, boxes: &[Box2]) {
        let mut starts = vec![0; self.counts[0] * self.counts[1] + 1];
        for each in boxes {
            self.cells(each).for_each(|cell| starts[cell + 1] += 1);
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut next = starts.clone();
        self.items = vec![0; starts.last().map_or(0, |&end| end as usize)];
        for (index, each) in boxes.iter().enumerate() {
            for cell in self.cells(each) {
                self.items[next[cell] as usize] = index as u32;
                next[cell] += 1;
            }
        }
        self.starts = starts;
    }

    /// Cells along both axes.
    pub fn counts(&self) -> [usize; 2] {
        self.counts
    }

    /// Side of a cell.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// A place in cells from the grid's corner.
    pub fn in_cells(&self, place: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|axis| (place[axis] - self.low[axis]) / self.size)
    }

    /// The part of the plane where there is anything.
    pub fn hull(&self) -> Box2 {
        let high = std::array::from_fn(|axis| {
            self.low[axis] + self.size * self.counts[axis].saturating_sub(1) as f64
        });
        [self.low.map(|low| low + self.size), high]
    }

    /// Index of a cell.
    pub fn index(&self, [i, j]: [usize; 2]) -> usize {
        i * self.counts[1] + j
    }

    /// The box of a cell.
    pub fn cell_box(&self, [i, j]: [usize; 2]) -> Box2 {
        let corner =
            |i: usize, j: usize| [self.low[0] + self.size * i as f64, self.low[1] + self.size * j as f64];
        [corner(i, j), corner(i + 1, j + 1)]
    }

    /// The boxes that reach into a cell.
    pub fn in_cell(&self, cell: usize) -> &[u32] {
        &self.items[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    /// The boxes that may hold a place.
    pub fn at(&self, place: [f64; 2]) -> &[u32] {
        let [i, j] = self.in_cells(place);
        let inside = i >= 0.0 && j >= 0.0 && i < self.counts[0] as f64 && j < self.counts[1] as f64;
        if inside { self.in_cell(self.index([i as usize, j as usize])) } else { &[] }
    }

    /// Cells that a box reaches into, by index; those outside the grid left out.
    pub fn cells(&self, [low, high]: &Box2) -> impl Iterator<Item = usize> + use<> {
        let columns = self.counts[1];
        let [rows, across] = [0, 1].map(|axis| {
            let cell = |at: f64| ((at - self.low[axis]) / self.size).floor();
            let first = cell(low[axis]).max(0.0);
            let end = (cell(high[axis]) + 1.0).min(self.counts[axis] as f64).max(first);
            first as usize..end as usize
        });
        rows.flat_map(move |i| across.clone().map(move |j| i * columns + j))
    }
}

fn hull(boxes: &[Box2]) -> Option<([f64; 2], [f64; 2])> {
    let mut hull = *boxes.first()?;
    for each in boxes {
        for axis in 0..2 {
            hull[0][axis] = hull[0][axis].min(each[0][axis]);
            hull[1][axis] = hull[1][axis].max(each[1][axis]);
        }
    }
    Some((hull[0], std::array::from_fn(|axis| hull[1][axis] - hull[0][axis])))
}

fn cells_of([low, high]: &Box2, origin: [f64; 2], size: f64) -> usize {
    let along = |axis: usize| {
        let cell = |at: f64| ((at - origin[axis]) / size).floor();
        (cell(high[axis]) - cell(low[axis])) as usize + 1
    };
    along(0) * along(1)
}

#[cfg(test)]
mod tests {
    use super::{Box2, Buckets};
    use proptest::prelude::*;

    #[test]
    fn nothing_is_nowhere() {
        assert!(Buckets::new(&[]).at([0.0; 2]).is_empty());
        let point = Buckets::new(&[[[3.0, 4.0], [3.0, 4.0]]]);
        assert_eq!(point.at([3.0, 4.0]), [0]);
        assert!(point.at([30.0, 4.0]).is_empty());
    }

    proptest! {
        #[test]
        fn every_box_is_found_where_it_is(
            places in proptest::collection::vec((0.0..50.0f64, 0.0..90.0f64, 0.0..20.0f64), 1..60),
            at in (-10.0..90.0f64, -10.0..120.0f64),
        ) {
            let boxes: Vec<Box2> = places.iter().map(|&(x, y, r)| [[x - r, y - r], [x + r, y + r]]).collect();
            let found = Buckets::new(&boxes);
            let found = found.at([at.0, at.1]);
            for (index, [low, high]) in boxes.iter().enumerate() {
                let inside = low[0] <= at.0 && at.0 <= high[0] && low[1] <= at.1 && at.1 <= high[1];
                prop_assert!(!inside || found.contains(&(index as u32)));
            }
            prop_assert!(found.is_sorted());
        }
    }
}
