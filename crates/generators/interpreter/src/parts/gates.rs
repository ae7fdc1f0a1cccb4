//! Gates behind their comparators, and the fades of the switches that they open (sheet of the mixing unit).

use super::comparator::ComparatorFigures;

/// Where a sweep takes what a comparator sees past its threshold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Ground range of the edge (m).
    pub range: f64,
    /// Slope of what the comparator sees (full scales a metre); infinite for a jump.
    pub slope: f64,
}

impl Edge {
    /// When a comparator has seen it, in steps over samples at these ranges (m); none beyond the first and the last of them.
    pub fn answered(&self, ranges: &[f64], comparator: &ComparatorFigures) -> Option<f64> {
        let sample = ranges.iter().position(|range| *range >= self.range)?;
        let pace = ranges[sample] - ranges[sample.checked_sub(1)?];
        let at = sample as f64 - 1.0 + (self.range - ranges[sample - 1]) / pace;
        Some(at + comparator.on_ramp(self.slope * pace))
    }
}

/// A gate over a sweep: how it begins, and when it changes (steps, ascending).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Gate {
    /// Whether it is open at the first sample.
    pub begins_open: bool,
    /// Instants of its changes.
    pub changes: Vec<f64>,
}

impl Gate {
    /// Of a gate that is `open` at the eye and changes at `edges`, behind its comparator.
    pub fn of_edges(open: bool, edges: &[Edge], ranges: &[f64], comparator: &ComparatorFigures) -> Self {
        let passed = edges.iter().take_while(|edge| edge.range <= ranges[0]).count();
        let mut changes: Vec<f64> =
            edges[passed..].iter().map_while(|edge| edge.answered(ranges, comparator)).collect();
        changes.sort_by(f64::total_cmp);
        Self { begins_open: open ^ (passed % 2 == 1), changes }
    }

    /// Whether it is open at each of so many samples.
    pub fn at_samples(&self, samples: usize) -> Vec<bool> {
        let open = |sample: usize| {
            let before = self.changes.iter().filter(|change| **change <= sample as f64).count();
            self.begins_open ^ (before % 2 == 1)
        };
        (0..samples).map(open).collect()
    }

    /// Distance of each sample from the nearest change (steps).
    pub fn margins(&self, samples: usize) -> Vec<f64> {
        let nearest = |sample: usize| {
            let distances = self.changes.iter().map(|change| (change - sample as f64).abs());
            distances.fold(f64::INFINITY, f64::min)
        };
        (0..samples).map(nearest).collect()
    }
}

/// How far a switch is open: straight lines between knots of instant and value, of which two may be at one instant.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Fade {
    begin: f64,
    /// Instants (steps) and values.
    pub knots: Vec<[f64; 2]>,
}

impl Fade {
    /// Follows a gate; each change is the middle of a line over `transition` steps.
    pub fn of(gate: &Gate, transition: f64) -> Self {
        let begin = f64::from(u8::from(gate.begins_open));
        let mut knots: Vec<[f64; 2]> = Vec::new();
        let mut target = begin;
        for change in &gate.changes {
            let turns = change - 0.5 * transition;
            let value = settle(&mut knots, target, transition, turns, begin);
            knots.push([turns, value]);
            target = 1.0 - target;
        }
        settle(&mut knots, target, transition, f64::INFINITY, begin);
        Self { begin, knots }
    }

    /// Its value just before and just behind an instant (steps).
    pub fn at(&self, time: f64) -> [f64; 2] {
        let before = self.knots.iter().take_while(|knot| knot[0] < time).count();
        let behind = self.knots.iter().take_while(|knot| knot[0] <= time).count();
        if behind > before {
            return [self.knots[before][1], self.knots[behind - 1][1]];
        }
        let value = match (before.checked_sub(1).map(|last| self.knots[last]), self.knots.get(before)) {
            (None, _) => self.begin,
            (Some([_, value]), None) => value,
            (Some([from, value]), Some([to, target])) => {
                value + (target - value) * (time - from) / (to - from)
            }
        };
        [value; 2]
    }
}

/// Goes on from the last knot towards `target`: a knot where it arrives, if by `end`. The value at `end`.
fn settle(knots: &mut Vec<[f64; 2]>, target: f64, transition: f64, end: f64, begin: f64) -> f64 {
    let Some(&[from, value]) = knots.last() else { return begin };
    let arrives = from + (target - value).abs() * transition;
    if arrives <= end {
        knots.push([arrives, target]);
        return target;
    }
    value + (target - value).signum() * (end - from) / transition
}
