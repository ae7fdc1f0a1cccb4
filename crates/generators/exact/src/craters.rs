//! Where the craters are: lists and bounds over a grid of cells, and the cells that a line passes.

use features::{Crater, Features, Rise, Shape};

use crate::buckets::{Box2, Buckets};
use crate::line::Line;
use crate::walk::Walk;

/// All craters of a landscape, by place.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Craters {
    buckets: Buckets,
    /// The most that craters add anywhere in a cell (m).
    rises: Vec<f64>,
}

/// A part of a line inside one cell, or where there are no craters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Its ends (m of range).
    pub ends: [f64; 2],
    /// Index of the cell; `None` where there are no craters.
    pub cell: Option<usize>,
}

impl Craters {
    /// Lists and bounds for `features`.
    pub fn new(features: &Features) -> Self {
        let buckets =
            Buckets::new(&features.craters().iter().map(|crater| footprint(&crater)).collect::<Vec<_>>());
        let [rows, columns] = buckets.counts();
        let highest = |index: usize| {
            let cell = buckets.cell_box([index / columns, index % columns]);
            let crater = |&crater: &u32| highest(&features.crater(crater), &cell);
            buckets.in_cell(index).iter().map(crater).sum()
        };
        let rises = (0..rows * columns).map(highest).collect();
        Self { buckets, rises }
    }

    /// Craters that may reach into a cell, ascending.
    pub fn in_cell(&self, cell: usize) -> &[u32] {
        self.buckets.in_cell(cell)
    }

    /// The most that craters add anywhere in a cell (m).
    pub fn rise(&self, cell: usize) -> f64 {
        self.rises[cell]
    }

    /// The most that craters add anywhere in a box (m); `None` if there are none.
    pub fn highest_in(&self, area: &Box2) -> Option<f64> {
        let cells = self.buckets.cells(area).filter(|&cell| !self.in_cell(cell).is_empty());
        cells.map(|cell| self.rises[cell].max(0.0)).reduce(f64::max)
    }

    /// What craters add at a place.
    pub fn at(&self, features: &Features, place: [f64; 2]) -> Rise {
        let mut rise = Rise::default();
        for &index in self.buckets.at(place) {
            add(&mut rise, &features.crater(index), place);
        }
        rise
    }

    /// The parts of a stretch of `line`, in order: before the craters, cell by cell, and behind them.
    pub fn parts(&self, line: &Line, [from, to]: [f64; 2]) -> impl Iterator<Item = Part> + use<> {
        let inside = clip(line, &self.buckets.hull(), [from, to]).unwrap_or([to, to]);
        let (origin, size) = (self.buckets.in_cells(line.origin), self.buckets.size());
        let step = line.direction.map(|direction| direction / size);
        let [rows, columns] = self.buckets.counts();
        let walk = Walk::new([rows, columns], origin, step, inside[0], inside[1]).into_iter().flatten();
        let cell = move |[i, j]: [usize; 2]| i * columns + j;
        let cells = walk.map(move |each| Part { ends: [each.from, each.to], cell: Some(cell(each.region)) });
        let outside = |ends| Some(Part { ends, cell: None }).filter(|part| part.ends[1] > part.ends[0]);
        outside([from, inside[0]]).into_iter().chain(cells).chain(outside([inside[1], to]))
    }
}

fn add(rise: &mut Rise, crater: &Crater, [x, y]: [f64; 2]) {
    let [dx, dy] = [x - crater.centre()[0], y - crater.centre()[1]];
    let rho = (dx * dx + dy * dy).sqrt();
    if rho >= crater.outer() {
        return;
    }
    let [height, slope] = crater.profile(rho);
    rise.height += height;
    rise.present = true;
    if rho > 0.0 {
        rise.slopes[0] += slope * dx / rho;
        rise.slopes[1] += slope * dy / rho;
    }
}

fn footprint(crater: &Crater) -> Box2 {
    let (centre, outer) = (crater.centre(), crater.outer());
    [centre.map(|place| place - outer), centre.map(|place| place + outer)]
}

/// The most that a crater adds in a box: heights rise up to the crest and fall behind it.
fn highest(crater: &Crater, [low, high]: &Box2) -> f64 {
    let crest = match crater.shape() {
        Shape::Bowl { r1 } => r1,
        Shape::RimmedBowl { r1, r2 } => 0.5 * (r1 + r2),
        Shape::FlatFloor { r2, r3, .. } => 0.5 * (r2 + r3),
    };
    let (mut near, mut far) = (0.0, 0.0);
    for axis in 0..2 {
        let [below, above] = [low[axis] - crater.centre()[axis], crater.centre()[axis] - high[axis]];
        let (least, most) = (below.max(above).max(0.0), (-below).max(-above).max(0.0));
        near += least * least;
        far += most * most;
    }
    // Rounding of distances, and of the forms that are summed along a line.
    crater.profile(crest.clamp(near.sqrt(), far.sqrt()))[0] + 1e-9 * (crater.depth() + crater.rim())
}

/// The part of a stretch over a box.
fn clip(line: &Line, [low, high]: &Box2, [mut from, mut to]: [f64; 2]) -> Option<[f64; 2]> {
    for axis in 0..2 {
        let (at, step) = (line.origin[axis], line.direction[axis]);
        if step == 0.0 {
            if at < low[axis] || at > high[axis] {
                return None;
            }
            continue;
        }
        let ends = [(low[axis] - at) / step, (high[axis] - at) / step];
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    (from < to).then_some([from, to])
}
