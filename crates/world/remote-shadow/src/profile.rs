//! Shadow along one sun-parallel profile: the running maximum of G (11.1).

use crate::ground::{LitGround, Spot};

/// Steps of bisection within one spacing: a start or an end is good to 2^-12 of it.
const HALVINGS: u32 = 12;

/// A stretch of a profile that lies in shadow: from, to (m away from the sun).
pub(crate) type Interval = [f64; 2];

/// Walks along one profile, away from the sun.
pub(crate) struct Walk<'a> {
    lit: LitGround<'a>,
    p: f64,
    /// The running maximum of G cos e (m).
    top: f64,
    dark_from: Option<f64>,
    intervals: Vec<Interval>,
}

impl<'a> Walk<'a> {
    /// Shadow on the profile `p` (m) at `spots + 1` places from `start` (m) on, `spacing` (m) apart; everything
    /// before them reaches up to `top` (m).
    ///
    /// Between two places it is taken that G has one top or one valley at most, where its slopes call for it. Outside
    /// the ground nothing changes.
    pub(crate) fn intervals(
        lit: LitGround<'a>,
        p: f64,
        start: f64,
        spacing: f64,
        spots: usize,
        top: f64,
    ) -> Vec<Interval> {
        let mut walk = Self { lit, p, top, dark_from: None, intervals: Vec::new() };
        let mut last = None;
        for k in 0..=spots {
            let q = start + k as f64 * spacing;
            let next = lit.spot(p, q);
            match (last, next) {
                (Some(last), Some(next)) => walk.step(last, next),
                // Ground begins here: nobody sees what is before it.
                (None, Some(next)) => walk.enter(next, (q - spacing).max(start)),
                _ => {}
            }
            last = next;
        }
        walk.brighten(start + spots as f64 * spacing);
        walk.intervals
    }

    fn enter(&mut self, spot: Spot, edge: f64) {
        if spot.g < self.top {
            self.darken(edge);
        } else {
            self.brighten(edge);
            self.top = spot.g;
        }
    }

    fn step(&mut self, a: Spot, b: Spot) {
        if self.dark_from.is_none() {
            self.step_in_light(a, b);
        } else if b.g >= self.top {
            let end = self.end_between(a.q, b.q);
            self.brighten(end);
            self.step_in_light(Spot { q: end, g: self.top, rise: 0.0 }, b);
        } else if a.rise > 0.0 && b.rise < 0.0 && crossing_of_tangents(a, b) > self.top {
            self.step_over_a_top(a, b);
        }
    }

    fn step_in_light(&mut self, a: Spot, b: Spot) {
        if b.rise >= 0.0 && b.g >= self.top {
            self.top = b.g;
            return;
        }
        let crest = self.crest_between(a, b);
        if b.g >= crest.g {
            self.top = b.g;
            self.darken(b.q);
        } else {
            self.top = self.top.max(crest.g);
            self.darken(crest.q);
        }
    }

    /// A top that may stand out of the shadow between two places that lie in it.
    fn step_over_a_top(&mut self, a: Spot, b: Spot) {
        let crest = self.crest_between(a, b);
        if crest.g > self.top {
            let end = self.end_between(a.q, crest.q);
            self.brighten(end);
            self.top = crest.g;
            self.darken(crest.q);
        }
    }

    /// Where the light that reaches `a` leaves the ground before `b`: the tangent, or the kink.
    fn crest_between(&self, a: Spot, b: Spot) -> Spot {
        let (mut low, mut high) = (a, b);
        for _ in 0..HALVINGS {
            let Some(middle) = self.lit.spot(self.p, 0.5 * (low.q + high.q)) else { break };
            if middle.rise >= 0.0 && middle.g >= low.g { low = middle } else { high = middle }
        }
        if high.g > low.g { high } else { low }
    }

    /// Where G passes the running maximum between a place below it and one that is not.
    fn end_between(&self, mut low: f64, mut high: f64) -> f64 {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let below = self.lit.spot(self.p, middle).is_none_or(|spot| spot.g < self.top);
            if below { low = middle } else { high = middle }
        }
        high
    }

    fn darken(&mut self, q: f64) {
        self.dark_from = self.dark_from.or(Some(q));
    }

    fn brighten(&mut self, q: f64) {
        if let Some(from) = self.dark_from.take()
            && q > from
        {
            self.intervals.push([from, q]);
        }
    }
}

/// Height at which the tangents of a rising and a falling place meet: no smooth top between is higher.
fn crossing_of_tangents(a: Spot, b: Spot) -> f64 {
    let along = (b.g - a.g - b.rise * (b.q - a.q)) / (a.rise - b.rise);
    a.g + a.rise * along
}

#[cfg(test)]
mod tests {
    use super::{Interval, Walk};
    use crate::caster::Upstream;
    use crate::ground::{GroundSheets, LitGround};
    use crate::tests::cratered;
    use landscape::Sun;
    use quantities::radians;
    use std::sync::Arc;

    const SPACING: f64 = 0.5;

    fn clipped(all: &[Interval], from: f64, to: f64) -> Vec<Interval> {
        let part = all.iter().map(|&[a, b]| [a.max(from), b.min(to)]);
        part.filter(|&[a, b]| b - a > 1e-3).collect()
    }

    #[test]
    fn a_tile_is_a_part_of_the_whole_profile() {
        let ground = GroundSheets::new(Arc::new(cratered(6, 120)));
        let sun = Sun { azimuth: radians(215.0), elevation: radians(4.0) };
        let lit = LitGround::new(&ground, &sun, SPACING);
        let [p, q] = lit.axes.to_sun_axes([300.0, 300.0]);
        let (middle, mut compared) = ((q / SPACING).round() as i64, 0);
        for n in 0..60 {
            let p = ((p / SPACING).round() + 3.0 * f64::from(n) - 90.0) * SPACING;
            let sunward = (middle - 1200) as f64 * SPACING;
            let whole = Walk::intervals(lit, p, sunward, SPACING, 2400, f64::NEG_INFINITY);
            for tile in -2..2 {
                let first = middle + 64 * tile;
                let upstream = Upstream::new(lit, p, first);
                let top = upstream.top(upstream.best(None)).unwrap_or(f64::NEG_INFINITY);
                let start = first as f64 * SPACING;
                let end = start + 64.0 * SPACING;
                let part = clipped(&Walk::intervals(lit, p, start, SPACING, 64, top), start, end);
                let expected = clipped(&whole, start, end);
                assert_eq!(part.len(), expected.len(), "p {p}, from {start}: {part:?}, {expected:?}");
                for (found, expected) in part.iter().flatten().zip(expected.iter().flatten()) {
                    assert!((found - expected).abs() < 0.01 * SPACING, "p {p}: {found}, {expected}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 100, "{compared}");
    }
}
