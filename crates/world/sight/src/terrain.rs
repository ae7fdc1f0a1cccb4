//! Ground in closed form: the polynomial regions and craters of a landscape.

use std::ops::ControlFlow;

use features::Crater;
use landscape::Landscape;
use landscape::patch::Patch;

use crate::Curvature;
use crate::line::Line;
use crate::search::{Searcher, search};
use crate::stretch::{Passage, Stretch};
use crate::tier::{Region, Tier};
use crate::way::Way;

/// The ground of a landscape, ready for lines of sight: terrain of the finest level that has a place, and craters.
#[derive(Debug, Clone)]
pub struct Terrain {
    landscape: Landscape,
    tiers: Vec<Tier>,
}

/// A line of sight over its way.
#[derive(Debug, Clone, Copy)]
pub struct Look<'a> {
    pub way: &'a Way,
    pub line: &'a Line,
    pub curvature: Curvature,
}

impl Terrain {
    /// The ground of a landscape; bounds over its regions are made by the threads of the caller's pool.
    pub fn new(landscape: Landscape) -> Self {
        let tier = |level| Tier::new(level, landscape.features());
        let tiers = landscape.bank().levels().iter().map(tier).collect();
        Self { landscape, tiers }
    }

    /// The landscape that hides.
    pub fn landscape(&self) -> &Landscape {
        &self.landscape
    }

    /// Height (m) of the ground at a place (north, east, m); `None` off all levels.
    pub fn height(&self, [north, east]: [f64; 2]) -> Option<f64> {
        self.landscape.height(north, east)
    }

    /// Goes along the whole way, from the observer on, region by region of the finest level at each place.
    pub(crate) fn walk(&self, look: &Look<'_>, searcher: &mut impl Searcher) {
        let mut cuts = vec![0.0, 1.0];
        for level in self.landscape.bank().levels() {
            look.way.edges(level, &mut cuts);
        }
        cuts.sort_unstable_by(f64::total_cmp);
        for ends in cuts.windows(2) {
            if self.zone(look, [ends[0], ends[1]], searcher).is_break() {
                return;
            }
        }
    }

    /// A stretch over one level.
    fn zone(&self, look: &Look<'_>, ends: [f64; 2], searcher: &mut impl Searcher) -> ControlFlow<()> {
        let [x, y] = look.way.place(0.5 * (ends[0] + ends[1]));
        let levels = self.landscape.bank().levels();
        let Some(index) = levels.iter().position(|level| level.locate(x, y).is_some()) else {
            return ControlFlow::Continue(());
        };
        let mut cuts = ends.to_vec();
        look.way.borders(&levels[index], ends, &mut cuts);
        cuts.sort_unstable_by(f64::total_cmp);
        for ends in cuts.windows(2).filter(|ends| ends[0] < ends[1]) {
            self.region(look, index, [ends[0], ends[1]], searcher)?;
        }
        ControlFlow::Continue(())
    }

    /// A stretch over one region of a level.
    fn region(
        &self,
        look: &Look<'_>,
        index: usize,
        ends: [f64; 2],
        searcher: &mut impl Searcher,
    ) -> ControlFlow<()> {
        let level = &self.landscape.bank().levels()[index];
        let [x, y] = look.way.place(0.5 * (ends[0] + ends[1]));
        let Some((at, _)) = level.locate(x, y) else { return ControlFlow::Continue(()) };
        let region = self.tiers[index].region(at);
        let highest = region.highest(ends.map(|share| look.way.local(level, at, share)));
        let bound = look.line.lowest(ends) + searcher.raise() * ends[0] - highest;
        if searcher.passes(ends, bound) {
            return ControlFlow::Continue(());
        }
        let patch = Patch::new(level, at);
        self.rings(look, region, ends, &mut |ends, craters| {
            let [from, to] = ends.map(|share| look.way.local(level, at, share));
            let line = (look.line, look.curvature);
            let (stretch, part) = Stretch::new(look.way, line, ends, patch.along(from, to), craters);
            search(&stretch, &part, searcher)
        })
    }

    /// Cuts a stretch at the circles of craters.
    fn rings(
        &self,
        look: &Look<'_>,
        region: &Region,
        ends: [f64; 2],
        stretch: &mut impl FnMut([f64; 2], &[Crater]) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let craters: Vec<Crater> =
            region.craters.iter().map(|&index| self.landscape.features().crater(index)).collect();
        let mut cuts = ends.to_vec();
        for crater in &craters {
            Passage::new(look.way, crater).crossings(look.way.length, crater, ends, &mut cuts);
        }
        cuts.sort_unstable_by(f64::total_cmp);
        for ends in cuts.windows(2).filter(|ends| ends[0] < ends[1]) {
            stretch([ends[0], ends[1]], &craters)?;
        }
        ControlFlow::Continue(())
    }
}
