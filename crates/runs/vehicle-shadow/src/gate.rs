//! Where a television line is dark: stretches between its intersections with outlines.

use glam::DVec2;

/// Stretches of X on one line, ascending and apart once [`Gate::join`] has run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Gate(Vec<[f64; 2]>);

impl Gate {
    /// Adds a stretch from `stretch[0]` to `stretch[1]`.
    pub fn add(&mut self, stretch: [f64; 2]) {
        self.0.push(stretch);
    }

    /// Adds what lies inside a closed polygon on the line at `y`; tells how many of its edges the line meets. An edge
    /// holds its upper end and not its lower one, so a corner counts once.
    pub fn add_polygon(&mut self, polygon: &[DVec2], y: f64) -> usize {
        let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
        let crossed = edges.filter(|(from, to)| (from.y <= y) != (to.y <= y));
        let mut at: Vec<f64> =
            crossed.map(|(from, to)| from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y))).collect();
        at.sort_by(f64::total_cmp);
        self.0.extend(at.as_chunks().0);
        at.len()
    }

    /// Adds what another gate holds.
    pub fn add_all(&mut self, other: &Self) {
        self.0.extend_from_slice(&other.0);
    }

    /// Makes one stretch of those that overlap or touch.
    pub fn join(&mut self) {
        self.0.sort_by(|a, b| a[0].total_cmp(&b[0]));
        self.0.dedup_by(|next, last| {
            let touches = next[0] <= last[1];
            if touches {
                last[1] = last[1].max(next[1]);
            }
            touches
        });
    }

    /// Returns the stretches; each begins and ends in X.
    pub fn stretches(&self) -> &[[f64; 2]] {
        &self.0
    }

    /// Whether `x` is dark.
    pub fn holds(&self, x: f64) -> bool {
        self.0.iter().any(|[from, to]| (*from..*to).contains(&x))
    }
}

/// The gates of all lines of a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Gates {
    /// One a line, from the top.
    pub lines: Vec<Gate>,
    /// Intersections of lines with edges.
    pub crossings: u64,
    /// Most edges that one line meets: each takes a line generator.
    pub line_generators: u64,
}

impl Gates {
    /// Gates of lines, each with how many edges it meets.
    pub(crate) fn of(lines: Vec<(Gate, usize)>) -> Self {
        let crossings = lines.iter().map(|(_, edges)| *edges as u64).sum();
        let line_generators = lines.iter().map(|(_, edges)| *edges as u64).max().unwrap_or(0);
        Self { lines: lines.into_iter().map(|(gate, _)| gate).collect(), crossings, line_generators }
    }
}

/// What darkens a picture, line by line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PictureGates {
    /// One for each point of the sun: the vehicle's shadow, and tracks.
    pub suns: Vec<Gates>,
    /// Tracks alone, one a line; empty where there can be none.
    pub tracks: Vec<Gate>,
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::Gate;

    fn polygon(corners: &[[f64; 2]]) -> Vec<DVec2> {
        corners.iter().map(|&corner| DVec2::from_array(corner)).collect()
    }

    #[test]
    fn a_corner_on_the_line_counts_once() {
        let diamond = polygon(&[[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]);
        for (y, expected) in [(0.0, Some([-1.0, 1.0])), (0.5, Some([-0.5, 0.5])), (1.0, None), (2.0, None)] {
            let mut gate = Gate::default();
            gate.add_polygon(&diamond, y);
            assert_eq!(gate.stretches().first().copied(), expected, "{y}");
        }
    }

    #[test]
    fn overlapping_stretches_are_one() {
        let mut gate = Gate::default();
        for stretch in [[3.0, 4.0], [0.0, 1.0], [0.5, 2.0], [2.0, 2.5], [0.2, 0.3]] {
            gate.add(stretch);
        }
        gate.join();
        assert_eq!(gate.stretches(), [[0.0, 2.5], [3.0, 4.0]]);
        assert!(gate.holds(2.4) && !gate.holds(2.5) && !gate.holds(2.7));
    }

    #[test]
    fn a_hollow_polygon_has_two_stretches() {
        let cup = polygon(&[
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 2.0],
            [2.0, 2.0],
            [2.0, 0.0],
            [3.0, 0.0],
            [3.0, 3.0],
            [0.0, 3.0],
        ]);
        let mut gate = Gate::default();
        assert_eq!(gate.add_polygon(&cup, 1.0), 4);
        assert_eq!(gate.stretches(), [[0.0, 1.0], [2.0, 3.0]]);
    }
}
