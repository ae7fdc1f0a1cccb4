//! What a frame takes, step by step of the program: pieces are counted, times follow from them.

use landscape::Landscape;
use rayon::prelude::*;
use scenario::Curvature;
use timing::Task;

use crate::film::Film;
use crate::grid::Grid;
use crate::hardware::Hardware;
use crate::observer::Observer;
use crate::projection::SKY;
use crate::shadow::March;

/// The unit that works a frame out, and the one that exposes it.
pub(crate) const COMPUTER: &str = "cpu";
pub(crate) const RECORDER: &str = "recorder";

/// Operations of one piece of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Operations {
    adds: u64,
    multiplications: u64,
    divisions: u64,
    roots: u64,
    /// Tests, stores, branches, shifts.
    others: u64,
}

impl Operations {
    const fn of(adds: u64, multiplications: u64, divisions: u64, roots: u64, others: u64) -> Self {
        Self { adds, multiplications, divisions, roots, others }
    }

    /// Returns the time of these operations (ns).
    fn time(&self, hardware: &Hardware) -> u64 {
        self.adds * hardware.add
            + self.multiplications * hardware.multiply
            + self.divisions * hardware.divide
            + self.roots * hardware.root
            + self.others * hardware.instruction
    }
}

/// Pieces of every step of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Work {
    /// Craters of the map whose bounding squares were held against the viewed area (blocks 6, 7).
    pub squares: u64,
    /// Distances of points from the centres of craters in whose bounding squares they lie (block 10).
    pub distances: u64,
    /// Craters of the three types evaluated at points inside them (block 10).
    pub craters: [u64; 3],
    /// Points from which the drop of the lunoid was taken, by the parabola and by the sphere (block 10).
    pub drops: [u64; 2],
    /// Slopes, two a point (blocks 9, 11, 12, 18).
    pub slopes: u64,
    /// Points lit by Lambert's law (block 13).
    pub lit: u64,
    /// The march for remote shadow (block 13).
    pub march: March,
    /// Points projected (block 14).
    pub projected: u64,
    /// Positions written, each as often as it was (block 14).
    pub written: u64,
    /// Positions that show ground, turned into a code (block 14).
    pub coded: u64,
    /// Points on the film: plotting instructions (block 15).
    pub plotted: u64,
    /// Output blocks (block 15).
    pub blocks: u64,
}

impl Work {
    /// Of a frame in which no ground is in view: every crater was held against it.
    pub fn of_nothing(landscape: &Landscape) -> Self {
        Self { squares: landscape.features().craters().len() as u64, ..Self::default() }
    }

    /// Of a picture; points and blocks of its film are those of `columns`.
    pub fn of(
        film: &Film<'_>,
        landscape: &Landscape,
        march: March,
        columns: &[(usize, Vec<(usize, u32)>)],
    ) -> Self {
        let Film { plot, grid, observer, light, .. } = film;
        let points = light.len() as u64;
        let [distances, craters @ ..] = craters(grid, observer, landscape);
        Self {
            distances,
            craters,
            drops: [Curvature::Parabolic, Curvature::Exact]
                .map(|law| if grid.curvature == law { points } else { 0 }),
            slopes: 2 * points,
            lit: points,
            march,
            projected: plot.projected,
            written: plot.written,
            coded: plot.seen.iter().filter(|point| **point != SKY).count() as u64,
            plotted: columns.iter().map(|(_, points)| points.len() as u64).sum(),
            blocks: columns.len() as u64,
            ..Self::of_nothing(landscape)
        }
    }

    /// Steps that had something to do, in the order of the flowchart, timed in ticks of a nanosecond.
    pub fn tasks(&self, hardware: &Hardware) -> Vec<Task> {
        let computed =
            |task: &'static str, pieces: u64, each: Operations| (COMPUTER, task, pieces, each.time(hardware));
        let [bowls, rimmed, flat] = self.craters;
        let March { points, between } = self.march;
        let of = Operations::of;
        [
            // Both ends of the square on both axes, each compared.
            computed("squares", self.squares, of(4, 0, 0, 0, 4)),
            // sqrt(dx^2 + dy^2), held against the outer radius.
            computed("distances", self.distances, of(3, 2, 0, 1, 1)),
            // a ((rho / r1)^2 - 1), added; the rim delta (1 - ((2 rho - r1 - r2) / (r2 - r1))^2) is the longer of two branches.
            computed("type-1", bowls, of(2, 2, 1, 0, 1)),
            computed("type-2", rimmed, of(4, 3, 1, 0, 2)),
            computed("type-3", flat, of(4, 3, 1, 0, 3)),
            // s^2 times 1 / 2R.
            computed("drops", self.drops[0], of(2, 3, 0, 0, 1)),
            // s^2 / (R + sqrt(R^2 - s^2)).
            computed("drops", self.drops[1], of(3, 2, 1, 1, 1)),
            // A difference times 1 / (2 steps).
            computed("slopes", self.slopes, of(1, 1, 0, 0, 1)),
            // n . s / |n|.
            computed("light", self.lit, of(4, 4, 1, 1, 2)),
            // The fall, a comparison, the greater kept.
            computed("march", points, of(1, 0, 0, 0, 2)),
            computed("march-between", between, of(3, 1, 0, 0, 2)),
            // Turn by the elevation, two quotients, two positions.
            computed("projection", self.projected, of(5, 6, 2, 0, 2)),
            computed("overwriting", self.written, of(0, 0, 0, 0, 2)),
            computed("codes", self.coded, of(1, 1, 0, 0, 2)),
            // Column, line and code into one word by shifts and masks.
            computed("instructions", self.plotted, of(0, 0, 0, 0, 8)),
            // A call of the channel.
            computed("blocks", self.blocks, of(0, 0, 0, 0, 500)),
            (RECORDER, "plotting", self.plotted, hardware.point),
        ]
        .into_iter()
        .filter(|(_, _, pieces, _)| *pieces > 0)
        .map(|(unit, task, pieces, each)| Task {
            unit: unit.into(),
            task: task.into(),
            pieces,
            ticks: pieces * each,
        })
        .collect()
    }
}

/// Craters in whose bounding squares the points of `grid` lie, and those of the three types in which they lie: summed
/// over the points.
fn craters(grid: &Grid, observer: &Observer, landscape: &Landscape) -> [u64; 4] {
    let features = landscape.features();
    let count = |found: &mut Vec<u32>, index: usize| {
        let place = grid.inside(landscape, observer, index);
        features.in_box(place, place, found);
        let mut counts = [found.len() as u64, 0, 0, 0];
        for crater in found.iter().map(|&index| features.crater(index)) {
            let [dx, dy] = [0, 1].map(|axis| place[axis] - crater.centre()[axis]);
            let is_inside = (dx * dx + dy * dy).sqrt() < crater.outer();
            counts[crater.type_number() as usize] += u64::from(is_inside);
        }
        counts
    };
    let points = (0..grid.size * grid.size).into_par_iter().with_min_len(grid.size);
    let sum = |a: [u64; 4], b: [u64; 4]| std::array::from_fn(|kind| a[kind] + b[kind]);
    points.map_init(Vec::new, count).reduce(|| [0; 4], sum)
}
