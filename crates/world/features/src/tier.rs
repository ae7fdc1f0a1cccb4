//! One tier of the index: craters of about one size, by the cell in which their centres lie.

use crate::Craters;
use crate::Outlook;
use crate::fan::Fan;
use crate::spot::{Scale, Spot, with_slack};

/// Cells a crater at most: bounds the memory of a tier whose craters are few and far between.
const CELLS_PER_CRATER: usize = 1;

/// Craters of about one size in a grid of square cells, not smaller than the largest of them. Each stands once, in the
/// cell of its centre, or in the border cell nearest to it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tier {
    /// South-west corner of the grid (m).
    corner: [f64; 2],
    /// Side of a cell (m).
    side: f64,
    /// Inverse of the side of a cell (1/m).
    cells_a_metre: f64,
    /// Cells to the north and to the east.
    cells: [usize; 2],
    /// Farthest that a crater reaches from its centre (m), with slack.
    reach: f64,
    /// Largest way from the floor of a crater to the crest of its rim (m).
    relief: f64,
    /// Where the craters of each cell begin in `spots`; one more at the end. East fastest.
    begins: Vec<u32>,
    /// The craters cell by cell, ascending within a cell.
    spots: Vec<Spot>,
    /// What their numbers mean.
    scale: Scale,
}

impl Tier {
    /// A tier of `members`, indices into `all`, ascending and at least one.
    pub fn new(all: &Craters, members: &[u32]) -> Self {
        let outer = members.iter().map(|&index| all.get(index).outer()).fold(0.0, f64::max);
        let reach = with_slack(outer);
        let relief = members.iter().map(|&index| all.get(index).relief()).fold(0.0, f64::max);
        let spans = [0, 1].map(|axis| middle_span(all, members, axis));
        let mut tier = Self {
            corner: spans.map(|[low, _]| low),
            side: 2.0 * reach,
            cells_a_metre: 0.0,
            cells: [1; 2],
            reach,
            relief,
            begins: Vec::new(),
            spots: Vec::new(),
            scale: Scale::new(spans.iter().fold(0.0, |most, [low, high]| (high - low).max(most)), reach),
        };
        tier.lay_out(spans, CELLS_PER_CRATER * members.len() + 16);
        tier.fill(all, members);
        tier
    }

    /// Doubles the cells until there are at most `most` of them.
    fn lay_out(&mut self, spans: [[f64; 2]; 2], most: usize) {
        loop {
            let counts = spans.map(|[low, high]| ((high - low) / self.side).floor() + 1.0);
            if counts[0] * counts[1] <= most as f64 {
                self.cells_a_metre = 1.0 / self.side;
                self.cells = counts.map(|count| count as usize);
                return;
            }
            self.side *= 2.0;
        }
    }

    /// Counting sort by cell.
    fn fill(&mut self, all: &Craters, members: &[u32]) {
        let cell = |index: u32| {
            let [x, y] = all.get(index).centre();
            self.cell(0, x) * self.cells[1] + self.cell(1, y)
        };
        let mut ends = vec![0; self.cells[0] * self.cells[1] + 1];
        members.iter().for_each(|&index| ends[cell(index) + 1] += 1);
        (1..ends.len()).for_each(|at| ends[at] += ends[at - 1]);
        let begins = ends.clone();
        let mut spots = vec![Spot::default(); members.len()];
        for &index in members {
            let end = &mut ends[cell(index)];
            let (centre, outer) = all.circle(index);
            spots[*end as usize] = self.scale.spot(self.offset(centre), outer, index);
            *end += 1;
        }
        (self.begins, self.spots) = (begins, spots);
    }

    /// Cell of a coordinate along an axis; beyond the border, the border cell.
    fn cell(&self, axis: usize, place: f64) -> usize {
        // A float below 0 becomes 0.
        (((place - self.corner[axis]) * self.cells_a_metre) as usize).min(self.cells[axis] - 1)
    }

    /// Craters whose bounding squares may meet the box.
    pub fn near_box(&self, low: [f64; 2], high: [f64; 2]) -> impl Iterator<Item = u32> {
        let [rows, columns] = [0, 1]
            .map(|axis| [self.cell(axis, low[axis] - self.reach), self.cell(axis, high[axis] + self.reach)]);
        let (low, high) = (self.steps(low), self.steps(high));
        let runs = (rows[0]..=rows[1]).flat_map(move |row| self.run(row, columns));
        runs.filter(move |spot| self.scale.meets_box(**spot, low, high)).map(|spot| spot.index())
    }

    /// Craters whose circles may meet the stretch of a length (m) from a point on along a unit vector: row by row,
    /// only the cells beside it.
    pub fn near_stretch(
        &self,
        from: [f64; 2],
        direction: [f64; 2],
        length: f64,
    ) -> impl Iterator<Item = u32> {
        let to = [0, 1].map(|axis| from[axis] + length * direction[axis]);
        let (south, north) = (from[0].min(to[0]), from[0].max(to[0]));
        let rows = [self.cell(0, south - self.reach), self.cell(0, north + self.reach)];
        let drift = direction[1] / direction[0];
        let columns = move |row: usize| {
            let [west, east] = self.east_range(row, [from, to], drift);
            [self.cell(1, west - self.reach), self.cell(1, east + self.reach)]
        };
        let runs = (rows[0]..=rows[1]).map(move |row| self.run(row, columns(row)));
        let (start, length) = (self.steps(from), self.scale.steps(length));
        let met =
            runs.flatten().filter(move |spot| self.scale.meets_stretch(**spot, start, direction, length));
        met.map(|spot| spot.index())
    }

    /// Craters whose circles may meet a ray of the fan: row by row, only the cells between its edges and beside them.
    pub fn near_fan(&self, fan: Fan) -> impl Iterator<Item = u32> {
        let runs = self.runs(fan);
        let fan = fan.in_units(self.steps(fan.origin()), self.scale.steps(1.0));
        runs.flatten().filter(move |spot| self.scale.meets_fan(**spot, &fan)).map(|spot| spot.index())
    }

    /// Craters in the cells that a fan meets, row by row.
    fn runs(&self, fan: Fan) -> impl Iterator<Item = &[Spot]> {
        let sides = fan.sides();
        let (south, north) = fan.northings();
        let rows = [self.cell(0, south - self.reach), self.cell(0, north + self.reach)];
        let columns = move |row: usize| {
            let met = sides.iter().filter(|side| self.is_near_row(row, side)).map(|&[from, to]| {
                let drift = (to[1] - from[1]) / (to[0] - from[0]);
                self.east_range(row, [from, to], drift)
            });
            let hull = |[west, east]: [f64; 2], [w, e]: [f64; 2]| [west.min(w), east.max(e)];
            let [west, east] = met.fold([f64::INFINITY, f64::NEG_INFINITY], hull);
            [self.cell(1, west - self.reach), self.cell(1, east + self.reach)]
        };
        (rows[0]..=rows[1]).map(move |row| self.run(row, columns(row)))
    }

    /// Range from which on no crater of the tier can be told (m).
    pub fn told_to(&self, outlook: &Outlook) -> f64 {
        outlook.reach(self.relief, self.reach)
    }

    /// Craters in the cells that a fan meets.
    pub fn count(&self, fan: Fan) -> u64 {
        self.runs(fan).map(|run| run.len() as u64).sum()
    }

    /// Radius that no crater of the tier exceeds (m).
    pub fn outer(&self) -> f64 {
        self.reach
    }

    /// Whether a stretch comes within reach of a row of cells; the rows at the border hold all that lies beyond.
    fn is_near_row(&self, row: usize, [from, to]: &[[f64; 2]; 2]) -> bool {
        let south_edge = self.corner[0] + row as f64 * self.side;
        let is_border = row == 0 || row + 1 == self.cells[0];
        is_border
            || (from[0].min(to[0]) <= south_edge + self.side + self.reach
                && from[0].max(to[0]) >= south_edge - self.reach)
    }

    fn offset(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| place[axis] - self.corner[axis])
    }

    /// The same in steps of the spots.
    fn steps(&self, place: [f64; 2]) -> [f64; 2] {
        self.offset(place).map(|way| self.scale.steps(way))
    }

    /// Where the stretch runs, from west to east, while it is within reach of a row of cells (m); `drift` is its way to
    /// the east a metre to the north.
    fn east_range(&self, row: usize, [from, to]: [[f64; 2]; 2], drift: f64) -> [f64; 2] {
        let [west, east] = [from[1].min(to[1]), from[1].max(to[1])];
        let south_edge = self.corner[0] + row as f64 * self.side;
        // The rows at the border hold all that lies beyond; a stretch along a row is in it all the way.
        if row == 0 || row + 1 == self.cells[0] || !drift.is_finite() {
            return [west, east];
        }
        let meets = [south_edge - self.reach, south_edge + self.side + self.reach]
            .map(|edge| from[1] + (edge - from[0]) * drift);
        let [first, last] = [meets[0].min(meets[1]), meets[0].max(meets[1])];
        [first, last].map(|place| place.max(west).min(east))
    }

    fn run(&self, row: usize, [first, last]: [usize; 2]) -> &[Spot] {
        let at = |column: usize| self.begins[row * self.cells[1] + column] as usize;
        &self.spots[at(first)..at(last.max(first) + 1)]
    }
}

/// Coordinates between which nearly all centres lie: from the 2nd to the 98th hundredth, stretched by as much again.
/// A few craters far away then make the cells no larger.
fn middle_span(all: &Craters, members: &[u32], axis: usize) -> [f64; 2] {
    let mut places: Vec<f64> = members.iter().map(|&index| all.get(index).centre()[axis]).collect();
    let (first, last) = (places.len() / 50, places.len() - 1 - places.len() / 50);
    let low = *places.select_nth_unstable_by(first, f64::total_cmp).1;
    let high = *places.select_nth_unstable_by(last, f64::total_cmp).1;
    let margin = 0.025 * (high - low);
    [low - margin, high + margin]
}
