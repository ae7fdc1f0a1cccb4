//! Distance on a plane, linear on the screen.

use glam::DVec3;

use crate::projection::Projection;

/// `q = 1 / w` of a plane over the screen, with w the depth along the view axis (m): `q(x, y) = q_x x + q_y y + q_0`.
///
/// On a plane `n . P = k` the ray `r` of a pixel meets depth `w = k / (n . r)`, and `r` is linear in x and y (EP-0611021 asks
/// for a function of the distance). Larger q is nearer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistancePlane {
    /// Change of q a pixel to the right and a pixel down (1/m).
    pub slope: [f64; 2],
    /// q at the screen's top left corner (1/m).
    pub origin: f64,
}

impl DistancePlane {
    /// The plane through three points in camera axes (m). `None` if they lie on one line, if the plane goes through the eye,
    /// which sees it as a line, or if they are not finite.
    pub fn new([p, q, r]: [DVec3; 3], projection: &Projection) -> Option<Self> {
        let normal = (q - p).cross(r - p);
        let over_k = normal / normal.dot(p);
        let slope = [over_k.x / projection.focal, over_k.y / projection.focal];
        let origin = over_k.z - slope[0] * projection.centre[0] - slope[1] * projection.centre[1];
        [slope[0], slope[1], origin].iter().all(|value| value.is_finite()).then_some(Self { slope, origin })
    }

    /// q (1/m) at a place on the screen (pixels).
    pub fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.slope[0] * x + self.slope[1] * y + self.origin
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROJECTION: Projection = Projection { focal: 500.0, centre: [256.0, 256.0] };

    #[test]
    fn distance_of_the_check_plane() {
        let corners = [[-20.0, 5.0, 50.0], [20.0, 5.0, 50.0], [0.0, -5.0, 400.0]].map(DVec3::from_array);
        let place = [256.0, 287.25];
        let q = DistancePlane::new(corners, &PROJECTION).unwrap().at(place);
        assert!((q - 0.014166666666667).abs() < 1e-15, "{q}");
        assert!((1.0 / q - 70.588235294118).abs() < 1e-11, "{}", 1.0 / q);
        let distance = PROJECTION.ray(place).length() / q;
        assert!((distance - 70.725968567124).abs() < 1e-11, "{distance}");
    }

    #[test]
    fn corners_lie_on_their_plane() {
        let corners = [[3.0, 1.0, 9.0], [-2.0, 4.0, 30.0], [1.0, -8.0, 12.0]].map(DVec3::from_array);
        let plane = DistancePlane::new(corners, &PROJECTION).unwrap();
        for corner in corners {
            let w = 1.0 / plane.at(PROJECTION.project(corner));
            assert!((w - corner.z).abs() < 1e-11 * corner.z, "{w} for {}", corner.z);
        }
    }

    #[test]
    fn planes_without_an_area_are_none() {
        let through_the_eye = [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 1.0, 5.0]];
        let line = [[1.0, 2.0, 3.0], [2.0, 3.0, 4.0], [3.0, 4.0, 5.0]];
        let unknown = [[1.0, f64::NAN, 3.0], [2.0, 3.0, 4.0], [3.0, 4.0, 6.0]];
        for corners in [through_the_eye, line, unknown] {
            assert_eq!(DistancePlane::new(corners.map(DVec3::from_array), &PROJECTION), None);
        }
    }
}
