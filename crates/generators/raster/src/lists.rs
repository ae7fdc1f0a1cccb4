//! Which triangles each sub-area lists.

use rayon::prelude::*;

use crate::fixed::STEPS;
use crate::screen::Screen;
use crate::triangle::Triangle;

/// Triangles that a thread lists at a time. Chosen: the lists do not depend on it.
const CHUNK: usize = 16_384;

/// Stretches of sub-areas whose lists are put together by a thread at a time. Chosen likewise.
const STRETCHES: usize = 16;

/// For every sub-area the triangles that may cover sampling points of it (EP-0611021, abstract).
///
/// A sub-area lists a triangle if the triangle's box meets it and each edge function is at least 0 at one of its corners. That
/// never misses; near acute corners it lists a few too many. The threads of the current rayon pool share the triangles out.
#[derive(Debug, Default)]
pub struct Lists {
    /// Where the list of each sub-area begins in `entries`, and where the last one ends.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

impl Lists {
    /// Lists the `triangles`, at most 2^32 of them, by their places in the slice.
    pub fn fill(&mut self, screen: &Screen, triangles: &[Triangle]) {
        if triangles.len() <= CHUNK {
            return self.fill_part(screen, triangles, 0);
        }
        let part = |(at, triangles): (usize, &[Triangle])| {
            let mut part = Self::default();
            part.fill_part(screen, triangles, (at * CHUNK) as u32);
            part
        };
        let parts: Vec<Self> = triangles.par_chunks(CHUNK).enumerate().map(part).collect();
        self.join(&parts, screen.sub_areas());
    }

    /// Lists `triangles`, the first of which has the number `first`.
    fn fill_part(&mut self, screen: &Screen, triangles: &[Triangle], first: u32) {
        // Sub-area and triangle of every entry, triangle by triangle: a small one meets one sub-area, or two.
        let mut pairs = Vec::<[u32; 2]>::with_capacity(2 * triangles.len());
        self.starts.clear();
        self.starts.resize(screen.sub_areas() + 1, 0);
        for (number, triangle) in (first..).zip(triangles) {
            for_each_met(screen, triangle, |area| {
                pairs.push([area, number]);
                self.starts[area as usize] += 1;
            });
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        self.entries.resize(pairs.len(), 0);
        // From the last to the first: `starts` moves from the end of each list to its beginning.
        for &[area, number] in pairs.iter().rev() {
            let start = &mut self.starts[area as usize];
            *start -= 1;
            self.entries[*start as usize] = number;
        }
    }

    /// Puts the lists of parts together, in the order of the parts.
    fn join(&mut self, parts: &[Self], areas: usize) {
        self.starts.clear();
        self.starts.push(0);
        let mut end = 0;
        for area in 0..areas {
            end += parts.iter().map(|part| part.of(area).len() as u32).sum::<u32>();
            self.starts.push(end);
        }
        self.entries.resize(end as usize, 0);
        let mut rest = &mut self.entries[..];
        let mut stretches = Vec::with_capacity(STRETCHES);
        for stretch in 0..STRETCHES {
            let [from, to] = [stretch, stretch + 1].map(|stretch| stretch * areas / STRETCHES);
            let (own, others) = rest.split_at_mut((self.starts[to] - self.starts[from]) as usize);
            stretches.push((from..to, own));
            rest = others;
        }
        stretches.into_par_iter().for_each(|(areas, mut own)| {
            for list in areas.flat_map(|area| parts.iter().map(move |part| part.of(area))) {
                let (filled, others) = own.split_at_mut(list.len());
                filled.copy_from_slice(list);
                own = others;
            }
        });
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
