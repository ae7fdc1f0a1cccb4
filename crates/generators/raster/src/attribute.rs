//! Values of the corners of a triangle, in between.

use glam::DVec3;

use crate::projection::Projection;

/// A value that is linear over the plane of a triangle in space. On the screen it is a linear function of the place over
/// `q = 1 / w`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attribute {
    slope: [f64; 2],
    origin: f64,
    least: f64,
    most: f64,
}

impl Attribute {
    /// The value that has `values` at `corners` (camera axes, m). A plane that goes through the eye, or that is none, has the mean of
    /// `values` all over.
    pub fn new(corners: [DVec3; 3], values: [f64; 3], projection: &Projection) -> Self {
        Self::over(&Corners::new(corners), values, projection)
    }

    /// The channels of three colours (red, green, blue) at `corners`, as [`Attribute::new`] has each. Greys are worked out once.
    pub fn channels(corners: [DVec3; 3], colours: [[f64; 3]; 3], projection: &Projection) -> [Self; 3] {
        let corners = Corners::new(corners);
        let values = |k: usize| [colours[0][k], colours[1][k], colours[2][k]];
        let (red, green, blue) = (values(0), values(1), values(2));
        let first = Self::over(&corners, red, projection);
        if red == green && red == blue {
            return [first; 3];
        }
        [first, Self::over(&corners, green, projection), Self::over(&corners, blue, projection)]
    }

    fn over(corners: &Corners, values: [f64; 3], projection: &Projection) -> Self {
        let [least, most] = [
            values.into_iter().fold(f64::INFINITY, f64::min),
            values.into_iter().fold(f64::NEG_INFINITY, f64::max),
        ];
        let [at_first, at_second, at_third] = corners.faces;
        let gradient = (at_first * values[0] + at_second * values[1] + at_third * values[2]) / corners.volume;
        let slope = [gradient.x, gradient.y].map(|along| along / projection.focal);
        let origin = gradient.z - slope[0] * projection.centre[0] - slope[1] * projection.centre[1];
        if gradient.is_finite() && origin.is_finite() {
            return Self { slope, origin, least, most };
        }
        let mean = values.iter().sum::<f64>() / 3.0;
        Self { slope: [0.0; 2], origin: 0.0, least: mean, most: mean }
    }

    /// The value at a place on the screen (pixels) where the plane has `q` (1/m). Beyond the triangle it stays between the least and
    /// the greatest value of the corners.
    pub fn at(&self, [x, y]: [f64; 2], q: f64) -> f64 {
        // What is no number is the least value.
        ((self.slope[0] * x + self.slope[1] * y + self.origin) / q).max(self.least).min(self.most)
    }
}

/// What the corners of a triangle come to, whatever their values.
struct Corners {
    /// Cross products of the other two corners, corner by corner.
    faces: [DVec3; 3],
    /// Six times the volume of the corners with the eye; 0 if their plane goes through it.
    volume: f64,
}

impl Corners {
    fn new([p, q, r]: [DVec3; 3]) -> Self {
        let first = q.cross(r);
        Self { faces: [first, r.cross(p), p.cross(q)], volume: p.dot(first) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::DistancePlane;

    const PROJECTION: Projection = Projection { focal: 500.0, centre: [256.0, 256.0] };
    const CORNERS: [[f64; 3]; 3] = [[-20.0, 5.0, 50.0], [20.0, 5.0, 50.0], [0.0, -5.0, 400.0]];

    #[test]
    fn corners_and_the_middle_have_their_values() {
        let (corners, values) = (CORNERS.map(DVec3::from_array), [0.25, 1.0, 0.5]);
        let plane = DistancePlane::new(corners, &PROJECTION).unwrap();
        let attribute = Attribute::new(corners, values, &PROJECTION);
        let at = |point: DVec3| {
            let place = PROJECTION.project(point);
            attribute.at(place, plane.at(place))
        };
        for (corner, value) in corners.into_iter().zip(values) {
            assert!((at(corner) - value).abs() < 1e-12, "{} for {value}", at(corner));
        }
        // In space, not on the screen: the middle is the mean.
        let middle = corners.iter().sum::<DVec3>() / 3.0;
        assert!((at(middle) - 1.75 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn channels_are_the_attributes_of_their_values() {
        let corners = CORNERS.map(DVec3::from_array);
        for colours in [[[0.1, 0.2, 0.3], [0.5, 0.2, 0.9], [0.4, 0.7, 0.3]], [[0.1; 3], [0.5; 3], [0.4; 3]]] {
            let one = |k: usize| {
                Attribute::new(corners, [colours[0][k], colours[1][k], colours[2][k]], &PROJECTION)
            };
            assert_eq!(Attribute::channels(corners, colours, &PROJECTION), [0, 1, 2].map(one));
        }
    }

    #[test]
    fn beyond_the_triangle_it_stays_between_its_corners() {
        let corners = CORNERS.map(DVec3::from_array);
        let attribute = Attribute::new(corners, [0.25, 1.0, 0.5], &PROJECTION);
        for (place, q) in [([1e6, 0.0], 0.02), ([-1e6, 3.0], 0.02), ([256.0, 256.0], 0.0), ([0.0, 0.0], -1.0)]
        {
            assert!((0.25..=1.0).contains(&attribute.at(place, q)), "{place:?}");
        }
        let through_the_eye = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 1.0, 5.0]].map(DVec3::from_array);
        assert_eq!(Attribute::new(through_the_eye, [0.0, 0.5, 1.0], &PROJECTION).at([3.0, 4.0], 0.1), 0.5);
    }
}
