//! The comparators of the footprints: where the presence line of a sweep changes.
//!
//! A comparator sees `1 - rho^2 / R^2` and answers where this passes its offset o: on the circle of radius
//! `R sqrt(1 - o)`. A sweep that crosses it w before and behind the foot of the centre does so at a slope of `2 w / R^2`.

use features::Crater;
use parts::GateEdge;

use crate::FeatureLoad;

/// A footprint begins or ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rim {
    edge: GateEdge,
    is_entry: bool,
}

/// Adds both rims of a crater as a comparator of offset `offset` (share of full scale) finds them, if it does.
pub(crate) fn collect(crater: &Crater, load: &FeatureLoad, offset: f64, rims: &mut Vec<Rim>) {
    let square = crater.outer() * crater.outer();
    let half = (square * (1.0 - offset) - load.side * load.side).max(0.0).sqrt();
    let [entry, exit] = [-half, half].map(|way| load.middle + way);
    if exit <= entry.max(load.from) {
        return;
    }
    let slope = 2.0 * half / square;
    let begin = if load.from > entry {
        // Late words: it is there at once.
        GateEdge { range: load.from, slope: f64::INFINITY }
    } else {
        GateEdge { range: entry, slope }
    };
    rims.push(Rim { edge: begin, is_entry: true });
    rims.push(Rim { edge: GateEdge { range: exit, slope }, is_entry: false });
}

/// The presence line of a sweep, which begins outside of all footprints, from the rims of all craters; they are sorted.
pub(crate) fn unite(rims: &mut [Rim], edges: &mut Vec<GateEdge>) {
    edges.clear();
    // Footprints that touch are one.
    let order = |a: &Rim, b: &Rim| a.edge.range.total_cmp(&b.edge.range).then(b.is_entry.cmp(&a.is_entry));
    rims.sort_by(order);
    let mut inside = 0_u32;
    for rim in rims.iter() {
        let before = inside;
        inside = if rim.is_entry { inside + 1 } else { inside - 1 };
        if (before > 0) != (inside > 0) {
            edges.push(rim.edge);
        }
    }
}
