//! The characteristic vehicle function: the vehicle as one string of points (section 19.2).

use std::collections::BTreeSet;
use std::ops::Range;

use glam::DVec3;
use solids::Solid;

/// A point of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StringPoint {
    /// Place in vehicle axes: forward, starboard, down from the eye (m).
    pub at: DVec3,
    /// Whether the line to the next point is displayed. A trace line only keeps the string connected.
    pub shown: bool,
}

/// A vehicle as a string of points: every edge of every convex figure is displayed once.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CharacteristicFunction {
    points: Vec<StringPoint>,
    figures: Vec<Range<usize>>,
    vertices: usize,
}

impl CharacteristicFunction {
    /// The string of convex parts in common body axes (forward, starboard, up; the foot point at the origin), for an
    /// eye `eye_height` (m) above the foot point.
    pub fn of_parts<'a>(parts: impl IntoIterator<Item = &'a Solid>, eye_height: f64) -> Self {
        let mut function = Self::default();
        for part in parts {
            let start = function.points.len();
            let to_vehicle = |at: DVec3| DVec3::new(at.x, at.y, eye_height - at.z);
            for trail in trails(part) {
                let last = trail.len() - 1;
                let point = |(index, vertex): (usize, usize)| StringPoint {
                    at: to_vehicle(part.vertices()[vertex]),
                    shown: index < last,
                };
                function.points.extend(trail.into_iter().enumerate().map(point));
            }
            function.figures.push(start..function.points.len());
            function.vertices += part.vertices().len();
        }
        function
    }

    /// The points, in order.
    pub fn points(&self) -> &[StringPoint] {
        &self.points
    }

    /// Which points each convex figure has.
    pub fn figures(&self) -> &[Range<usize>] {
        &self.figures
    }

    /// Different points: an end point that is used twice is worked out once.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// Lines of a figure, each with whether it is displayed. The last leads on to the next figure.
    pub(crate) fn lines(&self, figure: &Range<usize>) -> impl Iterator<Item = (DVec3, DVec3, bool)> {
        let next = |index: usize| self.points.get(index + 1).map(|to| (self.points[index], to.at));
        figure.clone().filter_map(next).map(|(from, to)| (from.at, to, from.shown))
    }
}

/// Trails over the edges of a solid, each edge in one of them. Two corners of odd degree are the ends of one trail, so
/// beginning at such corners makes the fewest.
fn trails(solid: &Solid) -> Vec<Vec<usize>> {
    let mut open: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); solid.vertices().len()];
    for face in solid.faces() {
        for (&from, &to) in face.corners.iter().zip(face.corners.iter().cycle().skip(1)) {
            open[from as usize].insert(to as usize);
            open[to as usize].insert(from as usize);
        }
    }
    let mut trails = Vec::new();
    while let Some(start) = begin(&open) {
        let mut trail = vec![start];
        let mut at = start;
        while let Some(next) = open[at].pop_first() {
            open[next].remove(&at);
            trail.push(next);
            at = next;
        }
        trails.push(trail);
    }
    trails
}

fn begin(open: &[BTreeSet<usize>]) -> Option<usize> {
    let odd = open.iter().position(|others| others.len() % 2 == 1);
    odd.or_else(|| open.iter().position(|others| !others.is_empty()))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use glam::DVec3;
    use solids::{Solid, culture};

    use super::CharacteristicFunction;

    #[test]
    fn a_box_is_four_trails() {
        let part = Solid::boxed(DVec3::new(-1.0, -2.0, 0.5), DVec3::new(1.0, 2.0, 3.0), 1.0).unwrap();
        let function = CharacteristicFunction::of_parts([&part], 2.0);
        // Eight corners of degree 3 are the ends of four trails: 12 lines displayed, and a trace behind each trail.
        assert_eq!(function.points().len(), 16);
        assert_eq!(function.points().iter().filter(|point| point.shown).count(), 12);
        assert!(!function.points()[15].shown);
        assert_eq!(function.vertices(), 8);
        // The eye is 2 m up: the bottom lies 1.5 m below it, the top 1 m above.
        let downs: Vec<f64> = function.points().iter().map(|point| point.at.z).collect();
        assert!(downs.iter().all(|&down| down == 1.5 || down == -1.0));
    }

    #[test]
    fn every_edge_is_displayed_once() {
        let parts = culture::model("rover").unwrap();
        let function = CharacteristicFunction::of_parts(&parts, 1.6334);
        assert_eq!(function.figures().len(), parts.len());
        for (part, figure) in parts.iter().zip(function.figures()) {
            let edges = part.faces().iter().map(|face| face.corners.len()).sum::<usize>() / 2;
            let mut shown = BTreeMap::new();
            for (from, to, _) in function.lines(figure).filter(|line| line.2) {
                let mut ends = [from, to].map(|end| end.to_array().map(f64::to_bits));
                ends.sort();
                *shown.entry(ends).or_insert(0) += 1;
            }
            assert_eq!(shown.len(), edges);
            assert!(shown.values().all(|&count| count == 1));
        }
    }
}
