//! Which of many small regions of the map come near a place.

use std::collections::BTreeMap;

/// Boxes on the map by the square cells that they meet.
#[derive(Debug, Clone, Default)]
pub struct Cells {
    cells: BTreeMap<[i64; 2], Vec<usize>>,
}

/// Side of a cell (m): of the size of a few patches of track.
const SIDE: f64 = 1.0;

fn span([low, high]: [[f64; 2]; 2]) -> impl Iterator<Item = [i64; 2]> {
    let key = |place: [f64; 2]| place.map(|part| (part / SIDE).floor() as i64);
    let ([south, west], [north, east]) = (key(low), key(high));
    (south..=north).flat_map(move |x| (west..=east).map(move |y| [x, y]))
}

impl Cells {
    /// The boxes (low and high corner; north, east; m), by number.
    pub fn new(boxes: impl Iterator<Item = [[f64; 2]; 2]>) -> Self {
        let mut cells = Self::default();
        for (number, corners) in boxes.enumerate() {
            span(corners).for_each(|key| cells.cells.entry(key).or_default().push(number));
        }
        cells
    }

    /// Numbers of the boxes that may meet the box around two places, ascending, each once.
    pub fn near(&self, a: [f64; 2], b: [f64; 2]) -> Vec<usize> {
        if self.cells.is_empty() {
            return Vec::new();
        }
        let corners = [[a[0].min(b[0]), a[1].min(b[1])], [a[0].max(b[0]), a[1].max(b[1])]];
        let mut found: Vec<usize> =
            span(corners).filter_map(|key| self.cells.get(&key)).flatten().copied().collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

#[cfg(test)]
mod tests {
    use super::Cells;

    #[test]
    fn boxes_are_found_in_every_cell_that_they_meet() {
        let boxes = [[[0.2, 0.2], [0.4, 0.4]], [[-0.5, 0.5], [0.5, 1.5]], [[7.0, 7.0], [8.0, 8.0]]];
        let cells = Cells::new(boxes.into_iter());
        assert_eq!(cells.near([0.5, 0.5], [0.6, 0.6]), [0, 1]);
        assert_eq!(cells.near([-0.1, 1.2], [-0.3, 1.1]), [1]);
        assert_eq!(cells.near([6.5, 8.5], [9.5, 7.5]), [2]);
        assert!(cells.near([3.0, 3.0], [4.0, 4.0]).is_empty());
    }
}
