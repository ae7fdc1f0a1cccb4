//! A sea of true waves: the first place where a ray meets the water, and its light.

use generator::{Label, Shade};
use glam::DVec3;
use scenario::OpenSea;
use wind_waves::{Rise, WaveSurface};

use crate::outlook::Outlook;
use crate::seen::Seen;

/// A ray that comes so near to the water (m) meets it.
const TOUCH: f64 = 1e-9;

/// The water of a frame.
#[derive(Debug)]
pub struct Water<'a> {
    surface: WaveSurface,
    sea: &'a OpenSea,
    /// Unit vector to the sun: north, east, up.
    sun: DVec3,
}

/// A ray over the water, as a function of ground range.
struct Sight<'a> {
    outlook: &'a Outlook<'a>,
    direction: [f64; 2],
    rise: f64,
    /// Height of the eye above the calm water (m).
    height: f64,
}

impl Sight<'_> {
    /// Place on the map at a range.
    fn place(&self, range: f64) -> [f64; 2] {
        let [north, east, _] = self.outlook.eye();
        [north + range * self.direction[0], east + range * self.direction[1]]
    }

    /// Height above the calm water (m) at a range, and by how much it grows for each metre; the growth never falls.
    fn height_and_slope(&self, range: f64) -> [f64; 2] {
        let [drop, slope] = self.outlook.drop_and_slope(range);
        [self.height + self.rise * range + drop, self.rise + slope]
    }
}

impl<'a> Water<'a> {
    /// The water of a sea at a time (s) under a sun.
    pub fn new(sea: &'a OpenSea, time: f64, sun: DVec3) -> Self {
        Self { surface: sea.waves.at(time), sea, sun }
    }

    /// Whether ground at a place (m) lies under the calm water.
    pub fn covers(&self, [north, east]: [f64; 2], height: f64) -> bool {
        let [south, west, north_edge, east_edge] = self.sea.area;
        (south..=north_edge).contains(&north)
            && (west..=east_edge).contains(&east)
            && height <= self.sea.height
    }

    /// What a ray of the true perspective (unit vector over the ground, and rise) shows of the water, nearer than `before` (m).
    pub fn look(&self, outlook: &Outlook, ray: DVec3, before: f64) -> Option<Seen> {
        let height = outlook.eye()[2] - self.sea.height;
        let sight = Sight { outlook, direction: [ray.x, ray.y], rise: ray.z, height };
        let [from, to] = self.within(&sight)?;
        let range = self.meet(&sight, [from, to.min(before)])?;
        Some(self.seen(range, self.surface.at(sight.place(range))))
    }

    /// Ranges between which a ray is over the area of the sea.
    fn within(&self, sight: &Sight) -> Option<[f64; 2]> {
        let (outlook, area) = (sight.outlook, self.sea.area);
        let (mut from, mut to) = (outlook.near(), outlook.far());
        for axis in 0..2 {
            let (eye, step) = (outlook.eye()[axis], sight.direction[axis]);
            let edges = [area[axis] - eye, area[axis + 2] - eye];
            if step == 0.0 {
                if !(edges[0]..=edges[1]).contains(&0.0) {
                    return None;
                }
                continue;
            }
            let ends = edges.map(|edge| edge / step);
            from = from.max(ends[0].min(ends[1]));
            to = to.min(ends[0].max(ends[1]));
        }
        (from < to).then_some([from, to])
    }

    /// The first range at which a ray that begins above the water meets it.
    ///
    /// The gap is the water less the ray. No step goes farther than where the gap can reach 0: the water bends by no more than
    /// [`WaveSurface::bend`], the ray bends upwards alone, and above all crests there is no water.
    fn meet(&self, sight: &Sight, [from, to]: [f64; 2]) -> Option<f64> {
        let (crest, bend) = (self.surface.crest(), self.surface.bend());
        let mut range = from;
        while range < to {
            let [height, slope] = sight.height_and_slope(range);
            if height > crest {
                if slope >= 0.0 {
                    return None;
                }
                range += ((height - crest) / -slope).max(TOUCH / -slope);
                continue;
            }
            let water = self.surface.at(sight.place(range));
            let gap = water.height - height;
            if gap >= -TOUCH {
                // A ray that begins under water shows none.
                return (range > from).then_some(range);
            }
            let closing = water.slopes[0] * sight.direction[0] + water.slopes[1] * sight.direction[1] - slope;
            range += reach(gap, closing, bend);
        }
        None
    }

    fn seen(&self, range: f64, water: Rise) -> Seen {
        let normal = DVec3::new(-water.slopes[0], -water.slopes[1], 1.0).normalize();
        let lit = normal.dot(self.sun);
        Seen {
            light: self.sea.colour.map(|channel| channel * lit.max(0.0)),
            range,
            height: self.sea.height + water.height,
            normal: normal.to_array(),
            reflectivity: self.sea.colour,
            shade: if lit > 0.0 { Shade::Lit } else { Shade::Local },
            label: Label::Sea,
        }
    }
}

/// The least step after which a gap below 0 can be 0, if it grows by `closing` for each unit, and that grows by no more than `bend`.
fn reach(gap: f64, closing: f64, bend: f64) -> f64 {
    let root = (closing * closing - 2.0 * bend * gap).sqrt();
    if closing > 0.0 { -2.0 * gap / (closing + root) } else { (root - closing) / bend }
}

#[cfg(test)]
mod tests {
    use super::reach;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]
        /// The gap of the steepest allowed growth is 0 there and below 0 before.
        #[test]
        fn no_gap_closes_before_its_reach(gap in -50.0..-1e-9f64, closing in -30.0..30.0f64, bend in 1e-6..5.0f64) {
            let step = reach(gap, closing, bend);
            let gap_at = |at: f64| gap + closing * at + 0.5 * bend * at * at;
            let size = gap.abs() + (closing * step).abs() + bend * step * step;
            prop_assert!(gap_at(step).abs() < 1e-12 * size, "{}", gap_at(step));
            prop_assert!((0..50).all(|k| gap_at(step * f64::from(k) / 50.0) < 1e-12 * size));
        }
    }
}
