//! Which part of the problem area a frame can show (section 17, each frame).

use landscape::Level;

/// The ground that a frame's fan of sweeps covers: a sector less than half a turn wide, or all around.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sector {
    /// Foot of the eye: in regions from the corner lattice's origin, where regions are asked for.
    pub foot: [f64; 2],
    /// Cosine and sine of the azimuth of the leftmost and of the rightmost sweep; none of a sector that goes all around.
    pub edges: Option<[[f64; 2]; 2]>,
    /// Ground range of the last sample, in the same lengths.
    pub range: f64,
}

impl Sector {
    /// The stored regions (north, east) that the sector touches, row by row: what a data bank must have ready. A
    /// few beside its edges may be among them, none that a sweep enters is missing.
    pub fn regions(&self, level: &Level) -> impl Iterator<Item = [usize; 2]> {
        let sector = *self;
        let last = level.corners().map(|corners| corners as f64 - 2.0);
        let bound = move |axis: usize, place: f64| place.floor().clamp(0.0, last[axis]) as usize;
        let rows = bound(0, sector.foot[0] - sector.range)..bound(0, sector.foot[0] + sector.range) + 1;
        rows.flat_map(move |m| {
            let [west, east] = sector.columns(m);
            (bound(1, west)..bound(1, east) + 1).map(move |n| [m, n])
        })
        .filter(move |&region| sector.touches(region))
    }

    /// Columns of row `m` between which the sector's regions lie: within the range and between the edges, with one more
    /// on either side for what rounding loses.
    fn columns(&self, m: usize) -> [f64; 2] {
        let north = m as f64 - self.foot[0];
        let [mut west, mut east] = [-self.range, self.range];
        // A corner (a, b) from the foot is on the inner side of an edge where p b + q a is not below 0.
        let sides = |[left, right]: [[f64; 2]; 2]| [[left[0], -left[1]], [-right[0], right[1]]];
        for [p, q] in self.edges.into_iter().flat_map(sides) {
            let across = -(q * north).max(q * (north + 1.0)) / p;
            if p > 0.0 {
                west = west.max(across);
            } else if p < 0.0 {
                east = east.min(across);
            }
        }
        [self.foot[1] + west - 2.0, self.foot[1] + east + 1.0]
    }

    fn touches(&self, [m, n]: [usize; 2]) -> bool {
        let from_foot = |m: usize, n: usize| [m as f64 - self.foot[0], n as f64 - self.foot[1]];
        self.is_between(from_foot(m, n), from_foot(m + 1, n + 1))
    }

    /// Whether the sector may touch a rectangle, wherever it lies. `low` and `high`: its south-west and north-east corner, from the
    /// foot, in the lengths of the sector.
    pub fn meets(&self, low: [f64; 2], high: [f64; 2]) -> bool {
        let is_ahead = |[left, right]: [[f64; 2]; 2]| {
            let ahead = [left[0] + right[0], left[1] + right[1]];
            let farthest = (0..2).map(|axis| (ahead[axis] * low[axis]).max(ahead[axis] * high[axis]));
            farthest.sum::<f64>() >= -1e-9
        };
        self.edges.is_none_or(is_ahead) && self.is_between(low, high)
    }

    /// Whether a rectangle has a corner on the inner side of both edges, if there are any, and is not beyond the range.
    fn is_between(&self, low: [f64; 2], high: [f64; 2]) -> bool {
        let corners = [low, [low[0], high[1]], [high[0], low[1]], high];
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        // A sweep along a boundary belongs to both regions: rounding must not lose one.
        let inner = |side: f64| side >= -1e-9;
        let nearest = [0, 1].map(|axis| if low[axis] > 0.0 { low[axis] } else { high[axis].min(0.0) });
        let is_between = |[left, right]: [[f64; 2]; 2]| {
            corners.iter().any(|&corner| inner(cross(left, corner)))
                && corners.iter().any(|&corner| inner(cross(corner, right)))
        };
        self.edges.is_none_or(is_between)
            && nearest[0] * nearest[0] + nearest[1] * nearest[1] <= self.range * self.range + 1e-9
    }
}

#[cfg(test)]
mod tests {
    use super::Sector;
    use landscape::Level;
    use quantities::{radians, sin_cos};

    fn level() -> Level {
        Level::new(1.0, [0.0; 2], [41, 31], vec![[0.0; 9]; 41 * 31]).unwrap()
    }

    fn direction(degrees: f64) -> [f64; 2] {
        let (sin, cos) = sin_cos(radians(degrees));
        [cos, sin]
    }

    /// Regions met by walking many sweeps in small steps.
    fn walked(foot: [f64; 2], heading: f64, range: f64) -> Vec<[usize; 2]> {
        let (level, mut met) = (level(), Vec::new());
        for sweep in 0..=200 {
            let [cos, sin] = direction(heading - 25.0 + 0.25 * f64::from(sweep));
            for step in 0..2000 {
                let way = range * f64::from(step) / 2000.0;
                met.extend(level.locate(foot[0] + way * cos, foot[1] + way * sin).map(|(region, _)| region));
            }
        }
        met.sort_unstable();
        met.dedup();
        met
    }

    #[test]
    fn every_region_that_a_sweep_enters_is_among_them() {
        for (foot, heading) in
            [([20.3, 15.7], 10.0), ([5.0, 5.0], 45.0), ([38.2, 0.4], 200.0), ([0.0, 30.0], -90.0)]
        {
            let edges = Some([direction(heading - 25.0), direction(heading + 25.0)]);
            let listed: Vec<_> = Sector { foot, edges, range: 12.0 }.regions(&level()).collect();
            let walked = walked(foot, heading, 12.0);
            assert!(walked.iter().all(|region| listed.contains(region)), "{foot:?} {heading}");
            assert!(
                listed.len() <= walked.len() + walked.len() / 4 + 8,
                "{} for {}",
                listed.len(),
                walked.len()
            );
        }
    }

    #[test]
    fn rectangles_anywhere() {
        let sector = |heading: f64| Sector {
            foot: [0.0; 2],
            edges: Some([direction(heading - 10.0), direction(heading + 10.0)]),
            range: 50.0,
        };
        let square = |north: f64, east: f64, side: f64| ([north, east], [north + side, east + side]);
        for (heading, (low, high), meets) in [
            (0.0, square(20.0, -5.0, 10.0), true),
            (0.0, square(-30.0, -5.0, 10.0), false),
            (0.0, square(-5.0, -5.0, 10.0), true),
            (180.0, square(-30.0, -5.0, 10.0), true),
            (90.0, square(-5.0, 20.0, 10.0), true),
            (90.0, square(-5.0, -30.0, 10.0), false),
            (0.0, square(60.0, -5.0, 10.0), false),
            (0.0, square(20.0, 15.0, 4.0), false),
        ] {
            assert_eq!(sector(heading).meets(low, high), meets, "{heading} {low:?}");
        }
    }

    #[test]
    fn nothing_behind_and_nothing_beyond() {
        let edges = Some([direction(-25.0), direction(25.0)]);
        let listed: Vec<_> = Sector { foot: [20.5, 15.5], edges, range: 6.0 }.regions(&level()).collect();
        assert!(listed.contains(&[20, 15]) && listed.contains(&[26, 15]));
        assert!(!listed.contains(&[27, 15]) && !listed.contains(&[18, 15]) && !listed.contains(&[20, 20]));
    }

    #[test]
    fn all_around_is_every_sector() {
        let around =
            |edges| Sector { foot: [20.3, 15.7], edges, range: 9.0 }.regions(&level()).collect::<Vec<_>>();
        let all = around(None);
        for heading in (0..360).step_by(20).map(f64::from) {
            let some = around(Some([direction(heading - 25.0), direction(heading + 25.0)]));
            assert!(!some.is_empty() && some.iter().all(|region| all.contains(region)), "{heading}");
        }
        assert!(!all.contains(&[20, 25]) && !all.contains(&[10, 15]));
    }
}
