//! Outline of several convex figures together: the report's walk from node to node (section 19.5).

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec2;

use crate::node_table::NodeTable;

/// Outer outlines of `figures` (convex, closed) on the view-plane, Y down: one for each group of figures that touch.
/// Holes within a group are lost, as in the report.
///
/// 1. Of the nodes not yet reached take the lowest on the screen.
/// 2. Of the lines that leave it take that with the smallest angle, measured from straight down.
/// 3. Store it, go along it, and measure angles at the far node from its complement, the line back, which comes last.
/// 4. Repeat until the first line is due again.
///
/// Every line has one successor, so a walk comes back to its first line whatever rounding does.
pub fn outlines(figures: &[Vec<DVec2>]) -> Vec<Vec<DVec2>> {
    let table = NodeTable::new(figures);
    let mut open: BTreeSet<usize> = (0..table.len()).collect();
    let lower = |&a: &usize, &b: &usize| {
        let [a, b] = [a, b].map(|node| table.place(node));
        a.y.total_cmp(&b.y).then(b.x.total_cmp(&a.x))
    };
    let mut outlines = Vec::new();
    while let Some(start) = open.iter().copied().max_by(lower) {
        reach(&table, start, &mut open);
        outlines.push(walk(&table, start));
    }
    outlines
}

/// Takes a node, and all that lines lead to from it, out of `open`.
fn reach(table: &NodeTable, start: usize, open: &mut BTreeSet<usize>) {
    let mut next = vec![start];
    while let Some(node) = next.pop() {
        if open.remove(&node) {
            next.extend(table.leaving(node));
        }
    }
}

fn walk(table: &NodeTable, start: usize) -> Vec<DVec2> {
    let mut outline = vec![table.place(start)];
    let Some(first) = turn(table, start, FRAC_PI_2) else { return outline };
    let (mut from, mut at) = (start, first);
    loop {
        let back = angle(table.place(from) - table.place(at));
        let Some(next) = turn(table, at, back) else { return outline };
        (from, at) = (at, next);
        if (from, at) == (start, first) {
            return outline;
        }
        outline.push(table.place(from));
    }
}

/// The line that leaves `node` at the smallest angle behind `from`, in (0, 2 pi].
fn turn(table: &NodeTable, node: usize, from: f64) -> Option<usize> {
    let behind = |next: usize| {
        let turned = angle(table.place(next) - table.place(node)) - from;
        let turned = turned - TAU * (turned / TAU).floor();
        if turned > 0.0 { turned } else { TAU }
    };
    table.leaving(node).min_by(|&a, &b| behind(a).total_cmp(&behind(b)))
}

/// From X towards Y.
fn angle(direction: DVec2) -> f64 {
    libm::atan2(direction.y, direction.x)
}
