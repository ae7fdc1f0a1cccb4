//! One level of the bank as squares with a ceiling each, and the pyramid of maxima over them.

use features::{Crater, Features};
use landscape::{Landscape, Level};
use rayon::prelude::*;

use crate::control_net::{Bends, bends};
use crate::numbers::Numbers;

/// Smallest side of a square (m): below this a ceiling costs more than it saves.
const SMALLEST_SIDE: f64 = 8.0;
/// Most squares of a level, unless it has more regions.
const MOST_SQUARES: usize = 1 << 18;
/// Share of a height by which rounding could lift the ground over a ceiling.
const ROUNDING: f64 = 1e-12;

/// Share by which a crater is taken larger when its squares are looked for: rounding must not lose one.
const REACH_ROUNDING: f64 = 1e-9;

/// Squares of a level: regions, or equal parts of them.
#[derive(Debug)]
pub(crate) struct Sheet {
    origin: [f64; 2],
    side: f64,
    counts: [usize; 2],
    parts: usize,
    /// Bending of each region, east fastest; infinite where a finer level lies over a part of it.
    bends: Vec<[Bound; 3]>,
    /// Maxima: squares first, then four by four up to one.
    layers: Vec<Layer>,
    steps: Steps,
    /// Craters of each square: those from `starts[n]` to `starts[n + 1]`, ascending; empty where the level has no craters.
    starts: Numbers,
    craters: Numbers,
}

#[derive(Debug)]
struct Layer {
    counts: [usize; 2],
    /// Ceiling of each square as a number of steps; see [`Steps`].
    ceilings: Vec<u16>,
}

/// Heights as numbers of steps, which are in their order; 0 is minus infinity.
#[derive(Debug, Clone, Copy, Default)]
struct Steps {
    /// Height of number 1, and of a step (m).
    lowest: f64,
    step: f64,
}

impl Steps {
    /// Steps over all of some heights (m), finite or minus infinity.
    fn over(heights: &[f64]) -> Self {
        let finite = heights.iter().filter(|height| height.is_finite());
        let [low, high] =
            finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &at| [low.min(at), high.max(at)]);
        // A few numbers are left for what rounding takes.
        let step = (high - low).max(1e-9 * (1.0 + high.abs())) / f64::from(u16::MAX - 8);
        Self { lowest: low, step }
    }

    fn height(&self, number: u16) -> f64 {
        if number == 0 { f64::NEG_INFINITY } else { self.lowest + f64::from(number - 1) * self.step }
    }

    /// The least number whose height is not below `bound` (m).
    fn upwards(&self, bound: f64) -> u16 {
        if bound == f64::NEG_INFINITY {
            return 0;
        }
        let near = 1 + ((bound - self.lowest) / self.step) as u16;
        (near.saturating_sub(1)..=u16::MAX).find(|&number| self.height(number) >= bound).unwrap_or(u16::MAX)
    }
}

/// A square of a sheet's pyramid: layer 0 holds the squares themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Node {
    pub(crate) layer: usize,
    pub(crate) at: [usize; 2],
}

/// Where a place lies in a level and its sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stand {
    pub(crate) region: [usize; 2],
    pub(crate) local: [f64; 2],
    pub(crate) square: Node,
}

impl Sheet {
    /// The sheet of level `index` of the bank. Squares that lie wholly under a finer level are never met: their
    /// ceiling is minus infinity.
    pub(crate) fn new(landscape: &Landscape, index: usize) -> Self {
        let level = &landscape.bank().levels()[index];
        let finer = &landscape.bank().levels()[..index];
        let regions = level.corners().map(|count| count - 1);
        let parts = parts(level.region_size(), regions);
        let counts = regions.map(|count| count * parts);
        let side = level.region_size() / parts as f64;
        let mut sheet = Self {
            origin: level.origin(),
            side,
            counts,
            parts,
            bends: Vec::new(),
            layers: Vec::new(),
            steps: Steps::default(),
            starts: Numbers::default(),
            craters: Numbers::default(),
        };
        sheet.bends = (0..regions[0] * regions[1])
            .into_par_iter()
            .map(|n| sheet.region_bends(level, [n / regions[1], n % regions[1]], finer).map(Bound::over))
            .collect();
        sheet.sort_in(landscape.features(), finer);
        let heights: Vec<f64> = (0..counts[0] * counts[1])
            .into_par_iter()
            .map(|n| sheet.ceiling_of(level, finer, landscape.features(), [n / counts[1], n % counts[1]]))
            .collect();
        sheet.steps = Steps::over(&heights);
        let ceilings = heights.into_iter().map(|height| sheet.steps.upwards(height)).collect();
        sheet.layers = pyramid(Layer { counts, ceilings });
        sheet
    }

    /// Where a place (m) lies in `level`, whose sheet this is; `None` outside.
    pub(crate) fn stand(&self, level: &Level, [x, y]: [f64; 2]) -> Option<Stand> {
        let (region, local) = level.locate(x, y)?;
        let part = |axis: usize| ((local[axis] * self.parts as f64) as usize).min(self.parts - 1);
        let at = [region[0] * self.parts + part(0), region[1] * self.parts + part(1)];
        Some(Stand { region, local, square: Node { layer: 0, at } })
    }

    /// The square that holds all others.
    pub(crate) fn root(&self) -> Node {
        Node { layer: self.layers.len() - 1, at: [0, 0] }
    }

    /// Upper bound of the height in a node (m).
    pub(crate) fn ceiling(&self, node: Node) -> f64 {
        let layer = &self.layers[node.layer];
        self.steps.height(layer.ceilings[node.at[0] * layer.counts[1] + node.at[1]])
    }

    /// South-west and north-east corner of a node (m).
    pub(crate) fn corners(&self, node: Node) -> [[f64; 2]; 2] {
        let edge = |axis: usize, end: usize| {
            let place = ((node.at[axis] + end) << node.layer).min(self.counts[axis]);
            self.origin[axis] + place as f64 * self.side
        };
        [[edge(0, 0), edge(1, 0)], [edge(0, 1), edge(1, 1)]]
    }

    /// The nodes, four at most, that a node above layer 0 is made of.
    pub(crate) fn children(&self, node: Node) -> impl Iterator<Item = Node> {
        let layer = node.layer - 1;
        let counts = self.layers[layer].counts;
        (0..4)
            .map(move |k| Node { layer, at: [2 * node.at[0] + k / 2, 2 * node.at[1] + k % 2] })
            .filter(move |child| child.at[0] < counts[0] && child.at[1] < counts[1])
    }

    /// Bending of the ground in a node of layer 0.
    pub(crate) fn bends(&self, node: Node) -> Bends {
        let regions = self.counts[1] / self.parts;
        self.bends[node.at[0] / self.parts * regions + node.at[1] / self.parts].map(Bound::value)
    }

    /// Indices of the craters that reach into a node of layer 0, ascending.
    pub(crate) fn craters(&self, node: Node) -> impl Iterator<Item = u32> {
        let square = node.at[0] * self.counts[1] + node.at[1];
        let start = |n: usize| if n < self.starts.len() { self.starts.get(n) as usize } else { 0 };
        self.craters.of(start(square)..start(square + 1))
    }

    fn region_bends(&self, level: &Level, region: [usize; 2], finer: &[Level]) -> Bends {
        let low: [f64; 2] =
            std::array::from_fn(|axis| level.origin()[axis] + region[axis] as f64 * level.region_size());
        let high = low.map(|edge| edge + level.region_size());
        let overlaid = |fine: &Level| {
            let [south, west, north, east] = fine.extent();
            low[0] < north && high[0] > south && low[1] < east && high[1] > west
        };
        if finer.iter().any(overlaid) { [f64::INFINITY; 3] } else { bends(level, region) }
    }

    fn sort_in(&mut self, features: &Features, finer: &[Level]) {
        let all = features.craters();
        let own = || (0u32..).zip(all.iter()).filter(|(_, crater)| !self.is_of(crater, finer));
        if own().next().is_none() {
            return;
        }
        let squares = self.counts[0] * self.counts[1];
        let mut starts = vec![0u32; squares + 1];
        for (_, crater) in own() {
            self.for_squares(&crater, |square| starts[square + 1] += 1);
        }
        for square in 0..squares {
            starts[square + 1] += starts[square];
        }
        let mut sorted = Numbers::new(starts[squares] as usize, all.len() as u32);
        let mut next = starts.clone();
        for (index, crater) in own() {
            self.for_squares(&crater, |square| {
                sorted.set(next[square] as usize, index);
                next[square] += 1;
            });
        }
        (self.starts, self.craters) = (Numbers::like(&starts), sorted);
    }

    /// Whether a crater lies wholly on a finer level, so that nobody meets it here.
    fn is_of(&self, crater: &Crater, finer: &[Level]) -> bool {
        let (centre, outer) = (crater.centre(), crater.outer());
        let reach = outer + self.margin(outer);
        finer.iter().any(|fine| covers(fine, [centre.map(|c| c - reach), centre.map(|c| c + reach)]))
    }

    /// What rounding could take from the reach of a crater (m).
    fn margin(&self, outer: f64) -> f64 {
        REACH_ROUNDING * (outer + self.side)
    }

    fn for_squares(&self, crater: &Crater, mut visit: impl FnMut(usize)) {
        let (centre, outer) = (crater.centre(), crater.outer());
        let margin = self.margin(outer);
        let range = |axis: usize| {
            let at = |place: f64| ((place - self.origin[axis]) / self.side).floor();
            let first = at(centre[axis] - outer - margin).max(0.0) as usize;
            let end = (at(centre[axis] + outer + margin) + 1.0).clamp(0.0, self.counts[axis] as f64) as usize;
            first..end
        };
        for north in range(0) {
            for east in range(1) {
                let corners = self.corners(Node { layer: 0, at: [north, east] });
                if distances(corners, centre)[0] <= outer * (1.0 + REACH_ROUNDING) {
                    visit(north * self.counts[1] + east);
                }
            }
        }
    }

    fn ceiling_of(&self, level: &Level, finer: &[Level], features: &Features, at: [usize; 2]) -> f64 {
        let node = Node { layer: 0, at };
        let corners = self.corners(node);
        if finer.iter().any(|fine| covers(fine, corners)) {
            return f64::NEG_INFINITY;
        }
        let rises = self.craters(node).map(|index| features.crater(index));
        let rise: f64 = rises.map(|crater| highest(&crater, distances(corners, crater.centre()))).sum();
        let terrain = self.terrain_ceiling(level, at);
        let top = terrain + rise;
        top + ROUNDING * (terrain.abs() + rise.abs() + 1.0)
    }

    /// A surface stays below the bilinear one through its corners plus what its bending allows.
    fn terrain_ceiling(&self, level: &Level, at: [usize; 2]) -> f64 {
        let region = at.map(|index| index / self.parts);
        let share = |axis: usize, end: usize| (at[axis] % self.parts + end) as f64 / self.parts as f64;
        let corner = |k: usize| level.height_and_slopes(region, [share(0, k / 2), share(1, k % 2)])[0];
        let highest = (0..4).map(corner).fold(f64::NEG_INFINITY, f64::max);
        let kept = self.bends(Node { layer: 0, at });
        let [hxx, _, hyy] = if kept[0].is_finite() { kept } else { bends(level, region) };
        highest + (hxx + hyy) * self.side * self.side / 8.0
    }
}

/// An upper bound of what is not negative: the upper half of a number's bits, rounded upwards.
#[derive(Debug, Clone, Copy)]
struct Bound(u16);

impl Bound {
    /// The least that is not below `bound`.
    fn over(bound: f64) -> Self {
        let nearest = bound as f32;
        let above = if f64::from(nearest) < bound { nearest.next_up() } else { nearest };
        Self(above.to_bits().div_ceil(1 << u16::BITS) as u16)
    }

    fn value(self) -> f64 {
        f64::from(f32::from_bits(u32::from(self.0) << u16::BITS))
    }
}

/// Nearest and farthest distance (m) from a place to the square between two corners.
fn distances([low, high]: [[f64; 2]; 2], place: [f64; 2]) -> [f64; 2] {
    let away: [[f64; 2]; 2] = std::array::from_fn(|axis| {
        let (below, above) = (low[axis] - place[axis], place[axis] - high[axis]);
        [below.max(above).max(0.0), (-below).max(-above)]
    });
    [0, 1].map(|end| (away[0][end] * away[0][end] + away[1][end] * away[1][end]).sqrt())
}

/// Highest rise (m) of a crater between two distances from its centre: heights rise to the crest, then fall.
pub(crate) fn highest(crater: &Crater, [near, far]: [f64; 2]) -> f64 {
    let crest = crest(crater);
    if near <= crest && crest <= far {
        return crater.rim();
    }
    crater.profile(near)[0].max(crater.profile(far)[0])
}

fn crest(crater: &Crater) -> f64 {
    match crater.shape() {
        features::Shape::Bowl { r1 } => r1,
        features::Shape::RimmedBowl { r1, r2 } => 0.5 * (r1 + r2),
        features::Shape::FlatFloor { r2, r3, .. } => 0.5 * (r2 + r3),
    }
}

fn covers(level: &Level, [low, high]: [[f64; 2]; 2]) -> bool {
    let [south, west, north, east] = level.extent();
    low[0] >= south && high[0] <= north && low[1] >= west && high[1] <= east
}

/// Parts of a region along an axis: a power of two that keeps squares large and few enough.
fn parts(region_size: f64, regions: [usize; 2]) -> usize {
    let mut parts = 1;
    while region_size / (2 * parts) as f64 >= SMALLEST_SIDE
        && regions[0] * regions[1] * 4 * parts * parts <= MOST_SQUARES
    {
        parts *= 2;
    }
    parts
}

fn pyramid(base: Layer) -> Vec<Layer> {
    let mut layers = vec![base];
    while let Some(below) = layers.last().filter(|layer| layer.ceilings.len() > 1) {
        let above = halved(below);
        layers.push(above);
    }
    layers
}

fn halved(below: &Layer) -> Layer {
    let counts = below.counts.map(|count| count.div_ceil(2));
    let mut ceilings = vec![0; counts[0] * counts[1]];
    for north in 0..below.counts[0] {
        for east in 0..below.counts[1] {
            let above = &mut ceilings[north / 2 * counts[1] + east / 2];
            *above = (*above).max(below.ceilings[north * below.counts[1] + east]);
        }
    }
    Layer { counts, ceilings }
}

#[cfg(test)]
mod tests {
    use super::{Bound, Node, Sheet, Steps};
    use crate::tests::{cratered, two_levels};
    use proptest::prelude::{prop_assert, proptest};

    proptest! {
        /// A bound of a quarter of the digits is still one, and no higher than it must be.
        #[test]
        fn a_rounded_bound_is_the_least_that_is_one(bound in 0.0..1e6f64, part in 0.0..1e-3f64) {
            for bound in [bound, bound * part, f64::from(bound as f32), Bound::over(bound).value()] {
                let rounded = Bound::over(bound);
                prop_assert!(rounded.value() >= bound);
                prop_assert!(bound == 0.0 || Bound(rounded.0 - 1).value() < bound);
            }
        }
    }

    #[test]
    fn bounds_without_end_stay_so() {
        for bound in [0.0, f64::INFINITY] {
            assert_eq!(Bound::over(bound).value(), bound);
        }
    }

    proptest! {
        /// In steps a ceiling is still one, and no higher than it must be; steps keep the order.
        #[test]
        fn a_ceiling_in_steps_is_the_least_that_is_one(
            mut heights in proptest::collection::vec(-9e3..9e3f64, 1..50), scale in 0.0..1.0f64, level: bool,
        ) {
            heights.iter_mut().for_each(|height| *height *= if level { 0.0 } else { scale * scale * scale });
            heights.push(f64::NEG_INFINITY);
            let steps = Steps::over(&heights);
            for &height in &heights {
                let number = steps.upwards(height);
                prop_assert!(steps.height(number) >= height);
                prop_assert!(number <= 1 || steps.height(number - 1) < height, "{}", height);
            }
            heights.sort_by(f64::total_cmp);
            prop_assert!(heights.windows(2).all(|pair| steps.upwards(pair[0]) <= steps.upwards(pair[1])));
        }
    }

    #[test]
    fn craters_stand_where_they_are_met() {
        let landscape = two_levels();
        let [fine, coarse] = [0, 1].map(|index| Sheet::new(&landscape, index));
        let features = landscape.features();
        let over_the_edge = |&index: &u32| {
            let (centre, outer) = (features.crater(index).centre(), features.crater(index).outer());
            centre.iter().any(|c| c - outer < 1e-6 || c + outer > 2000.0 - 1e-6)
        };
        let all = features.craters().len() as u32;
        let held = |sheet: &Sheet| -> Vec<u32> { sheet.craters.of(0..sheet.craters.len()).collect() };
        let [in_fine, in_coarse] = [held(&fine), held(&coarse)];
        assert!((0..all).filter(over_the_edge).all(|index| in_coarse.contains(&index)));
        assert!(in_coarse.iter().all(over_the_edge) && !in_coarse.is_empty());
        assert!((0..all).filter(|index| !over_the_edge(index)).all(|index| in_fine.contains(&index)));
    }

    #[test]
    fn no_ground_stands_above_its_ceiling() {
        let landscape = cratered(5, 200);
        let sheet = Sheet::new(&landscape, 0);
        let mut closest = f64::INFINITY;
        for n in 0..40_000u64 {
            let place = [0, 1].map(|axis| 600.0 * quantities::unit_interval(9, &[n, axis]));
            let height = landscape.height(place[0], place[1]).unwrap();
            for layer in 0..sheet.layers.len() {
                let at = place.map(|along| (along / sheet.side) as usize >> layer);
                let gap = sheet.ceiling(Node { layer, at }) - height;
                assert!(gap >= 0.0, "{place:?} at layer {layer}: {gap} m");
                closest = closest.min(gap);
            }
        }
        assert!(closest < 0.3, "ceilings are of use: {closest} m");
    }

    #[test]
    fn children_tile_their_parent() {
        let sheet = Sheet::new(&cratered(1, 0), 0);
        let mut squares = vec![sheet.root()];
        while squares[0].layer > 0 {
            squares = squares.iter().flat_map(|&node| sheet.children(node)).collect();
        }
        assert_eq!(squares.len(), sheet.counts[0] * sheet.counts[1]);
    }
}
