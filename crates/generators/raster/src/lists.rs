//! Which triangles each sub-area lists.

use crate::fixed::STEPS;
use crate::screen::Screen;
use crate::triangle::Triangle;

/// For every sub-area the triangles that may cover sampling points of it (EP-0611021, abstract).
///
/// A sub-area lists a triangle if the triangle's box meets it and each edge function is at least 0 at one of its corners. That
/// never misses; near acute corners it lists a few too many. One value is filled for frame after frame and asks for memory
/// only when a frame has more entries than all before.
#[derive(Debug, Default)]
pub struct Lists {
    /// Sub-area and triangle of every entry, triangle by triangle.
    pairs: Vec<[u32; 2]>,
    /// Where the list of each sub-area begins in `entries`, and where the last one ends.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

impl Lists {
    /// Lists the `triangles`, at most 2^32 of them, by their places in the slice.
    pub fn fill(&mut self, screen: &Screen, triangles: &[Triangle]) {
        self.pairs.clear();
        // A small triangle meets one sub-area, or two.
        self.pairs.reserve(2 * triangles.len());
        self.starts.clear();
        self.starts.resize(screen.sub_areas() + 1, 0);
        for (number, triangle) in triangles.iter().enumerate() {
            for_each_met(screen, triangle, |area| {
                self.pairs.push([area, number as u32]);
                self.starts[area as usize] += 1;
            });
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        self.entries.resize(self.pairs.len(), 0);
        // From the last to the first: `starts` moves from the end of each list to its beginning.
        for &[area, number] in self.pairs.iter().rev() {
            let start = &mut self.starts[area as usize];
            *start -= 1;
            self.entries[*start as usize] = number;
        }
    }

    /// Triangles that the sub-area of a number lists, in their order in the slice.
    pub fn of(&self, sub_area: usize) -> &[u32] {
        &self.entries[self.starts[sub_area] as usize..self.starts[sub_area + 1] as usize]
    }

    /// Takes the entries `(sub-area, triangle)` out of the lists for which `is_kept` is false; the others keep their order.
    pub fn retain(&mut self, mut is_kept: impl FnMut(u32, u32) -> bool) {
        let mut kept = 0;
        for area in 0..self.starts.len().saturating_sub(1) {
            let held = self.starts[area] as usize..self.starts[area + 1] as usize;
            self.starts[area] = kept as u32;
            for entry in held {
                let number = self.entries[entry];
                if is_kept(area as u32, number) {
                    self.entries[kept] = number;
                    kept += 1;
                }
            }
        }
        if let Some(end) = self.starts.last_mut() {
            *end = kept as u32;
        }
        self.entries.truncate(kept);
    }

    /// Entries of all lists together.
    pub fn entries(&self) -> usize {
        self.entries.len()
    }
}

/// Calls `meet` with the number of every sub-area that lists the triangle.
fn for_each_met(screen: &Screen, triangle: &Triangle, mut meet: impl FnMut(u32)) {
    let side = screen.side() as i32 * STEPS;
    let [columns, rows] = screen.counts();
    let range = |low: i32, high: i32, count: u32| {
        // The top-left rule keeps no point on the right or lower border of the box.
        let last = (high - 1).div_euclid(side).min(count as i32 - 1);
        low.div_euclid(side).max(0)..=last
    };
    for row in range(triangle.low.y, triangle.high.y, rows) {
        for column in range(triangle.low.x, triangle.high.x, columns) {
            let (low, high) = ([column * side, row * side], [(column + 1) * side, (row + 1) * side]);
            if triangle.edges.iter().all(|edge| edge.most(low, high) >= 0) {
                meet(row as u32 * columns + column as u32);
            }
        }
    }
}
