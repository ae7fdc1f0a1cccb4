//! The time that a beam has for its points.

/// A calligraphic point for the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamPoint {
    /// Its number, unlike that of any other point of the frame.
    pub id: u32,
    /// Its place on the screen (pixels).
    pub place: [f64; 2],
    /// Light to display: display intensity times area (pixels squared), a number of at least 0.
    pub light: f64,
}

/// Time that a beam takes for a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BeamBudget {
    /// Time of the jump to a point (ns), whatever its length.
    pub jump_ns: u64,
    /// Time for which the point is drawn (ns).
    pub dwell_ns: u64,
}

impl Default for BeamBudget {
    /// 4 µs for a jump and 6 µs for a point. Unsourced.
    fn default() -> Self {
        Self { jump_ns: 4_000, dwell_ns: 6_000 }
    }
}

impl BeamBudget {
    /// How many points fit a field of that length (ns).
    pub fn most(&self, field_ns: u64) -> usize {
        field_ns.checked_div(self.jump_ns + self.dwell_ns).map_or(usize::MAX, |points| points as usize)
    }

    /// Takes the points that do not fit a field (ns) out of `points` and returns them: the faintest, of equally faint ones those with
    /// larger ids. The others keep their order.
    pub fn drop_faintest(&self, points: &mut Vec<BeamPoint>, field_ns: u64) -> Vec<BeamPoint> {
        let excess = points.len().saturating_sub(self.most(field_ns));
        let mut by_light = points.clone();
        by_light.sort_unstable_by(|one, other| one.light.total_cmp(&other.light).then(other.id.cmp(&one.id)));
        by_light.truncate(excess);
        let mut dropped: Vec<u32> = by_light.iter().map(|point| point.id).collect();
        dropped.sort_unstable();
        points.retain(|point| dropped.binary_search(&point.id).is_err());
        by_light
    }
}

/// Orders points to cut jumps (`order = nearest-neighbour`). The beam begins in the top left corner of the screen and goes to the
/// nearest point that it has not drawn. Of two points at one distance it takes the smaller id. The time grows with the square of the
/// number of points.
pub fn nearest_neighbour(points: &mut [BeamPoint]) {
    let mut from = [0.0, 0.0];
    for i in 0..points.len() {
        let left = points[i..].iter().enumerate();
        let nearest = left.min_by(|(_, one), (_, other)| {
            let lengths = [one, other].map(|point| squared(from, point.place));
            lengths[0].total_cmp(&lengths[1]).then(one.id.cmp(&other.id))
        });
        let Some((chosen, _)) = nearest else { return };
        points.swap(i, i + chosen);
        from = points[i].place;
    }
}

fn squared(from: [f64; 2], to: [f64; 2]) -> f64 {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    x * x + y * y
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Length of all jumps (pixels), the first from the screen's top left corner.
    fn path_length(points: &[BeamPoint]) -> f64 {
        let places = points.iter().map(|point| point.place);
        std::iter::once([0.0, 0.0])
            .chain(places.clone())
            .zip(places)
            .map(|(from, to)| squared(from, to).sqrt())
            .sum()
    }

    fn point(id: u32, x: f64, light: f64) -> BeamPoint {
        BeamPoint { id, place: [x, 0.0], light }
    }

    #[test]
    fn the_faintest_are_dropped_and_of_equals_the_larger_ids() {
        let mut points = vec![point(9, 0.0, 0.5), point(2, 0.0, 0.1), point(5, 0.0, 0.5), point(7, 0.0, 0.5)];
        let dropped = BeamBudget::default().drop_faintest(&mut points, 29_999);
        assert_eq!(dropped.iter().map(|point| point.id).collect::<Vec<_>>(), [2, 9]);
        assert_eq!(points.iter().map(|point| point.id).collect::<Vec<_>>(), [5, 7]);
        assert!(BeamBudget::default().drop_faintest(&mut points, 20_000).is_empty());
        assert_eq!(BeamBudget { jump_ns: 0, dwell_ns: 0 }.most(1), usize::MAX);
    }

    #[test]
    fn neighbours_are_taken_one_after_the_other() {
        let mut points = vec![point(1, 9.0, 1.0), point(2, 1.0, 1.0), point(3, 4.0, 1.0), point(0, 4.0, 1.0)];
        assert_eq!(path_length(&points), 9.0 + 8.0 + 3.0);
        nearest_neighbour(&mut points);
        assert_eq!(points.iter().map(|point| point.id).collect::<Vec<_>>(), [2, 0, 3, 1]);
        assert_eq!(path_length(&points), 9.0);
    }
}
