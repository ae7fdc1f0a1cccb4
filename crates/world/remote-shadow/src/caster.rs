//! The highest caster beyond a place: a search that enters only squares which can hold it.

use features::Crater;
use smallvec::SmallVec;

use crate::control_net::Bends;
use crate::ground::{Lift, LitGround, Spot};
use crate::sheet::{Node, Sheet, highest};

/// Steps of bisection from a lattice point to the top beside it: 2^-14 of the lattice.
const HALVINGS: u32 = 14;
/// Share by which rounding could lift a point over its bound.
const ROUNDING: f64 = 1e-11;

/// The profile on one p, seen from a place on it towards the sun.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Upstream<'a> {
    lit: LitGround<'a>,
    p: f64,
    /// First and last point of the lattice that are searched.
    first: i64,
    last: i64,
    /// The highest before the first.
    known: Best,
}

/// The highest point of the lattice so far, on one profile: its `G cos e` (m) and its number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Best {
    g: f64,
    k: i64,
}

impl Best {
    /// What is known where no point was looked at.
    pub(crate) const NONE: Self = Self { g: f64::NEG_INFINITY, k: i64::MAX };

    /// The point's number, where there is ground.
    pub(crate) fn point(self) -> Option<i64> {
        (self.k != i64::MAX).then_some(self.k)
    }

    /// Of equal points the one nearest to the sun, in whatever order they come.
    fn take(&mut self, g: f64, k: i64) {
        if g > self.g || (g == self.g && k < self.k) {
            *self = Self { g, k };
        }
    }
}

/// What the search knows of one square: only those of its craters that the profile meets, which are few.
struct Square {
    bends: Bends,
    craters: SmallVec<[Met; 8]>,
}

/// A crater that the profile meets.
#[derive(Debug, Clone, Copy)]
struct Met {
    crater: Crater,
    /// How far beside its centre the profile passes, and where (m).
    across: f64,
    q: f64,
}

impl Met {
    /// The highest that the crater is between two places of the profile (m).
    fn between(&self, [from, to]: [f64; 2]) -> f64 {
        let Self { ref crater, across, q } = *self;
        let distance = |along: f64| (across * across + along * along).sqrt();
        let (a, b) = (distance(from - q), distance(to - q));
        let near = if from <= q && q <= to { across.abs() } else { a.min(b) };
        if near >= crater.outer() { 0.0 } else { highest(crater, [near, a.max(b)]) }
    }
}

impl<'a> Upstream<'a> {
    /// The profile `p` (m) up to lattice point `last`.
    pub(crate) fn new(lit: LitGround<'a>, p: f64, last: i64) -> Self {
        Self { lit, p, first: i64::MIN, last, known: Best::NONE }
    }

    /// The same where `known` is the highest up to lattice point `to`: only what lies behind it is searched.
    pub(crate) fn behind(self, to: i64, known: Best) -> Self {
        Self { first: to + 1, known, ..self }
    }

    /// The highest point of the lattice up to the place. `hint`, a point of it, only saves time.
    pub(crate) fn best(&self, hint: Option<i64>) -> Best {
        let mut best = self.known;
        if let Some(k) = hint.filter(|&k| self.first <= k && k <= self.last) {
            self.try_point(k, &mut best);
        }
        for sheet in &self.lit.ground.sheets {
            self.search(sheet, sheet.root(), &mut best);
        }
        best
    }

    /// The largest `G cos e` (m) up to the place, of which `best` is the highest point of the lattice; `None` if there is no ground.
    pub(crate) fn top(&self, best: Best) -> Option<f64> {
        let k = best.point()?;
        Some(best.g.max(self.top_beside(k).unwrap_or(best.g)))
    }

    /// The same from every point of the lattice: what [`best`](Self::best) must agree with.
    #[cfg(test)]
    pub(crate) fn best_of_all(&self) -> Best {
        let mut best = Best::NONE;
        for sheet in &self.lit.ground.sheets {
            if let Some([first, last]) = self.clip(sheet.corners(sheet.root())) {
                for k in first..=last {
                    self.try_point(k, &mut best);
                }
            }
        }
        best
    }

    fn q(&self, k: i64) -> f64 {
        k as f64 * self.lit.lattice
    }

    fn spot(&self, q: f64) -> Option<Spot> {
        self.lit.spot(self.p, q)
    }

    fn try_point(&self, k: i64, best: &mut Best) -> Option<Lift> {
        let lift = self.lit.lift(self.p, self.q(k));
        if let Some(lift) = lift {
            best.take(lift.g, k);
        }
        lift
    }

    /// First and last lattice point at or just outside the square between two corners that count; `None` if the
    /// profile misses it.
    fn clip(&self, [low, high]: [[f64; 2]; 2]) -> Option<[i64; 2]> {
        let start = self.lit.axes.to_ground([self.p, 0.0]);
        let away = self.lit.axes.away();
        let mut span = [f64::NEG_INFINITY, self.q(self.last)];
        for axis in 0..2 {
            if away[axis] == 0.0 {
                if start[axis] < low[axis] || start[axis] > high[axis] {
                    return None;
                }
                continue;
            }
            let from = (low[axis] - start[axis]) / away[axis];
            let to = (high[axis] - start[axis]) / away[axis];
            span = [span[0].max(from.min(to)), span[1].min(from.max(to))];
        }
        let lattice = self.lit.lattice;
        let [first, last] = [(span[0] / lattice).floor() as i64, (span[1] / lattice).ceil() as i64];
        let (first, last) = (first.max(self.first), last.min(self.last));
        (span[0] <= span[1] + lattice && first <= last).then_some([first, last])
    }

    fn search(&self, sheet: &'a Sheet, node: Node, best: &mut Best) {
        let Some(span) = self.clip(sheet.corners(node)) else { return };
        if self.bound(sheet.ceiling(node), span) < best.g {
            return;
        }
        if node.layer == 0 {
            return self.search_square(sheet, node, span, best);
        }
        // The one that promises most comes first: it spares the others.
        let mut children = [(f64::NEG_INFINITY, node); 4];
        for (slot, child) in children.iter_mut().zip(sheet.children(node)) {
            if let Some(span) = self.clip(sheet.corners(child)) {
                *slot = (self.bound(sheet.ceiling(child), span), child);
            }
        }
        children.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (bound, child) in children {
            if bound > f64::NEG_INFINITY && bound >= best.g {
                self.search(sheet, child, best);
            }
        }
    }

    /// No point with a height up to `ceiling` (m) in the span can have a larger `G cos e`.
    fn bound(&self, ceiling: f64, span: [i64; 2]) -> f64 {
        let sin = self.lit.axes.sin;
        let q = (self.q(span[0]) * sin).max(self.q(span[1]) * sin);
        ceiling * self.lit.axes.cos + q + ROUNDING * (ceiling.abs() + q.abs())
    }

    fn search_square(&self, sheet: &'a Sheet, node: Node, [first, last]: [i64; 2], best: &mut Best) {
        // Points just outside belong to the neighbours, whose bending is theirs.
        self.try_point(first, best);
        if last > first {
            self.try_point(last, best);
        }
        if last - first >= 2 {
            let ends = [first + 1, last - 1];
            let lifts = ends.map(|k| self.try_point(k, best));
            let square = Square { bends: sheet.bends(node), craters: self.met(sheet.craters(node)) };
            self.halve(&square, ends, lifts, best);
        }
    }

    fn halve(&self, square: &Square, [a, b]: [i64; 2], ends: [Option<Lift>; 2], best: &mut Best) {
        if b - a < 2 || self.bound_between(square, [a, b], ends) < best.g {
            return;
        }
        let middle = a + (b - a) / 2;
        let lift = self.try_point(middle, best);
        let halves = [([a, middle], [ends[0], lift]), ([middle, b], [lift, ends[1]])];
        let g = |end: Option<Lift>| end.map_or(f64::NEG_INFINITY, |lift| lift.g);
        let first = usize::from(g(ends[1]) > g(ends[0]));
        for half in [first, 1 - first] {
            let (span, ends) = halves[half];
            self.halve(square, span, ends, best);
        }
    }

    /// Bound between two points of a square: a chord plus what the bending allows, and each crater's highest.
    fn bound_between(&self, square: &Square, span: [i64; 2], ends: [Option<Lift>; 2]) -> f64 {
        let [Some(a), Some(b)] = ends else { return f64::INFINITY };
        let [n, e] = self.lit.axes.away();
        let [hxx, hxy, hyy] = square.bends;
        let bend = n * n * hxx + 2.0 * (n * e).abs() * hxy + e * e * hyy;
        let [from, to] = [self.q(span[0]), self.q(span[1])];
        let length = to - from;
        let rise: f64 = square.craters.iter().map(|met| met.between([from, to])).sum();
        let terrain = a.terrain.max(b.terrain);
        let cos = self.lit.axes.cos;
        let bound = terrain + cos * (bend * length * length / 8.0 + rise);
        bound + ROUNDING * (terrain.abs() + rise.abs() + 1.0)
    }

    /// Those of the craters that the profile meets.
    fn met(&self, craters: impl Iterator<Item = u32>) -> SmallVec<[Met; 8]> {
        let features = self.lit.ground.landscape.features();
        let meets = |k: u32| {
            let (centre, outer) = features.craters().circle(k);
            let [p, q] = self.lit.axes.to_sun_axes(centre);
            let across = self.p - p;
            (across.abs() < outer).then(|| Met { crater: features.crater(k), across, q })
        };
        craters.filter_map(meets).collect()
    }

    /// The top between a lattice point and its neighbour on the rising side (11.1 step 2: at kinks the kink).
    fn top_beside(&self, k: i64) -> Option<f64> {
        let here = self.spot(self.q(k))?;
        if here.rise > 0.0 && k == self.last {
            return None;
        }
        let [mut low, mut high] =
            if here.rise > 0.0 { [here.q, self.q(k + 1)] } else { [self.q(k - 1), here.q] };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.spot(middle)?.rise > 0.0 { low = middle } else { high = middle }
        }
        Some(self.spot(low)?.g.max(self.spot(high)?.g))
    }
}

#[cfg(test)]
mod tests {
    use super::Upstream;
    use crate::ground::{GroundSheets, LitGround};
    use crate::tests::{cratered, rough, two_levels};
    use landscape::Sun;
    use quantities::radians;
    use std::sync::Arc;

    fn same_as_all(landscape: landscape::Landscape, lattice: f64, places: [f64; 2]) {
        let ground = GroundSheets::new(Arc::new(landscape));
        for (azimuth, elevation) in [(33.0, 0.4), (180.0, 3.0), (251.0, 10.0), (90.0, 40.0), (0.0, 90.0)] {
            let sun = Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
            let lit = LitGround::new(&ground, &sun, lattice);
            for n in 0..40 {
                let place =
                    [0, 1].map(|axis| places[1] * quantities::unit_interval(4, &[n, axis]) + places[0]);
                let [p, q] = lit.axes.to_sun_axes(place);
                let last = (q / lattice).floor() as i64;
                let upstream = Upstream::new(lit, p, last);
                let all = upstream.best_of_all();
                assert_eq!(upstream.best(None), all);
                assert_eq!(upstream.best(Some(last - 7)), all);
                for before in [1, 64, 700] {
                    let known = Upstream::new(lit, p, last - before).best(None);
                    assert_eq!(upstream.behind(last - before, known).best(Some(last - 7)), all, "{before}");
                }
            }
        }
    }

    #[test]
    fn pruning_changes_no_bit() {
        same_as_all(cratered(1, 150), 0.5, [0.0, 600.0]);
    }

    #[test]
    fn pruning_changes_no_bit_on_rough_ground() {
        same_as_all(rough(), 0.25, [0.0, 400.0]);
    }

    #[test]
    fn pruning_changes_no_bit_over_two_levels() {
        same_as_all(two_levels(), 4.0, [-3000.0, 8000.0]);
    }
}
