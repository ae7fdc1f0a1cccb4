//! The node table of the outline algorithm: where lines of several figures meet, and which leave each node (19.5).
//!
//! Outlines that cross without a common corner change from one to the other there, so crossings are nodes too; the
//! report follows the corners that are there already (section 21, row 24).

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

/// Places nearer to each other than this share of the extent are one node.
const SAME: f64 = 1e-11;

/// Nodes and the lines between them.
#[derive(Debug, Clone, Default)]
pub struct NodeTable {
    nodes: Vec<DVec2>,
    /// Nodes at the other ends of the lines that leave each node.
    leaving: Vec<BTreeSet<usize>>,
    cells: BTreeMap<[i64; 2], Vec<usize>>,
    same: f64,
}

impl NodeTable {
    /// The table of closed polygons. Each line stands there with its complement, the line back.
    pub fn new(figures: &[Vec<DVec2>]) -> Self {
        let extent = figures.iter().flatten().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        let mut table = Self { same: SAME * extent.max(f64::MIN_POSITIVE), ..Self::default() };
        let lines: Vec<[DVec2; 2]> = figures
            .iter()
            .flat_map(|figure| figure.iter().zip(figure.iter().cycle().skip(1)))
            .map(|(&from, &to)| [from, to])
            .collect();
        for (index, line) in lines.iter().enumerate() {
            let mut on_line = vec![line[0], line[1]];
            for (_, other) in lines.iter().enumerate().filter(|(number, _)| *number != index) {
                on_line.extend(table.meetings(line, other));
            }
            table.add_line(line, on_line);
        }
        table
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Place of a node.
    pub fn place(&self, node: usize) -> DVec2 {
        self.nodes[node]
    }

    /// Nodes that lines lead to from a node.
    pub fn leaving(&self, node: usize) -> impl Iterator<Item = usize> {
        self.leaving[node].iter().copied()
    }

    /// Places on `line` that it has in common with `other`: ends of the other that lie on it, or the crossing.
    fn meetings(&self, line: &[DVec2; 2], other: &[DVec2; 2]) -> Vec<DVec2> {
        let touching: Vec<DVec2> =
            other.iter().copied().filter(|&end| distance(line, end) <= self.same).collect();
        if touching.is_empty() { crossing(line, other).into_iter().collect() } else { touching }
    }

    /// Adds the pieces of a line between the nodes on it.
    fn add_line(&mut self, line: &[DVec2; 2], mut places: Vec<DVec2>) {
        let along = line[1] - line[0];
        let way = |place: &DVec2| (*place - line[0]).dot(along);
        places.sort_by(|a, b| way(a).total_cmp(&way(b)));
        let nodes: Vec<usize> = places.into_iter().map(|place| self.node(place)).collect();
        for pair in nodes.windows(2).filter(|pair| pair[0] != pair[1]) {
            self.leaving[pair[0]].insert(pair[1]);
            self.leaving[pair[1]].insert(pair[0]);
        }
    }

    /// The node at a place.
    fn node(&mut self, place: DVec2) -> usize {
        let cell = place.to_array().map(|part| (part / (2.0 * self.same)).round() as i64);
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [cell[0] + i, cell[1] + j]));
        let near = |&&node: &&usize| self.nodes[node].distance(place) <= self.same;
        let found = around.filter_map(|key| self.cells.get(&key)?.iter().find(near)).next();
        found.copied().unwrap_or_else(|| {
            self.nodes.push(place);
            self.leaving.push(BTreeSet::new());
            self.cells.entry(cell).or_default().push(self.nodes.len() - 1);
            self.nodes.len() - 1
        })
    }
}

/// Distance of a place from a line.
fn distance(line: &[DVec2; 2], place: DVec2) -> f64 {
    let along = line[1] - line[0];
    let share = (place - line[0]).dot(along) / along.length_squared();
    place.distance(line[0] + along * share.clamp(0.0, 1.0))
}

/// Where two lines cross, if they do.
fn crossing(line: &[DVec2; 2], other: &[DVec2; 2]) -> Option<DVec2> {
    let (along, across) = (line[1] - line[0], other[1] - other[0]);
    let sides = line.map(|end| across.perp_dot(end - other[0]));
    let others = other.map(|end| along.perp_dot(end - line[0]));
    let is_parted = |[a, b]: [f64; 2]| (a > 0.0) != (b > 0.0);
    (is_parted(sides) && is_parted(others)).then(|| line[0] + along * (sides[0] / (sides[0] - sides[1])))
}
