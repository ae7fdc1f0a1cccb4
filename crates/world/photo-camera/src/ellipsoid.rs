//! The body under the photograph: geodetic places, georectangular points, local frames.
//!
//! Georectangular axes: X to latitude 0, longitude 0; Y to longitude 90 degrees east; Z north. A sphere has eccentricity 0.

use glam::{DMat3, DVec3};
use quantities::sin_cos;

use crate::CameraError;

/// A place on a body: angles of its normal and the height along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geodetic {
    /// Geodetic latitude (rad), north positive.
    pub latitude: f64,
    /// Longitude (rad), east positive.
    pub longitude: f64,
    /// Height above the body (m).
    pub height: f64,
}

/// An ellipsoid of revolution, or a sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipsoid {
    semi_major: f64,
    eccentricity_squared: f64,
}

impl Ellipsoid {
    /// Clarke 1866, with the squared eccentricity as the thesis rounds it (reported).
    pub const CLARKE_1866: Self = Self { semi_major: 6_378_206.4, eccentricity_squared: 0.006_768_658 };
    /// The Moon as a sphere of 1737.4 km (reported).
    pub const MOON: Self = Self { semi_major: 1_737_400.0, eccentricity_squared: 0.0 };

    /// A body of semi-major axis (m) and squared eccentricity (0 for a sphere).
    ///
    /// # Errors
    ///
    /// If the axis is not above 0, or the squared eccentricity is not in 0..0.5.
    pub fn new(semi_major: f64, eccentricity_squared: f64) -> Result<Self, CameraError> {
        let semi_major =
            CameraError::figure("semi-major axis (m)", semi_major, "a finite number above 0", |a| a > 0.0)?;
        let eccentricity_squared = CameraError::figure(
            "squared eccentricity",
            eccentricity_squared,
            "a number from 0 to below 0.5",
            |e| (0.0..0.5).contains(&e),
        )?;
        Ok(Self { semi_major, eccentricity_squared })
    }

    /// Semi-major axis of the body (m).
    pub fn semi_major(&self) -> f64 {
        self.semi_major
    }

    /// Squared eccentricity of the body; 0 for a sphere.
    pub fn eccentricity_squared(&self) -> f64 {
        self.eccentricity_squared
    }

    /// Radius of curvature in the prime vertical (m) at a latitude (rad).
    pub fn prime_vertical(&self, latitude: f64) -> f64 {
        let (sin, _) = sin_cos(latitude);
        self.semi_major / (1.0 - self.eccentricity_squared * sin * sin).sqrt()
    }

    /// The georectangular point (m) of a place.
    pub fn point(&self, place: Geodetic) -> DVec3 {
        let normal = self.prime_vertical(place.latitude);
        let (sin_p, cos_p) = sin_cos(place.latitude);
        let (sin_l, cos_l) = sin_cos(place.longitude);
        let rho = (normal + place.height) * cos_p;
        let polar = normal * (1.0 - self.eccentricity_squared) + place.height;
        DVec3::new(rho * cos_l, rho * sin_l, polar * sin_p)
    }

    /// The place of a georectangular point (m). It holds for points at least `e^2 a` from the centre.
    pub fn place(&self, point: DVec3) -> Geodetic {
        let rho = libm::hypot(point.x, point.y);
        let mut latitude = libm::atan2(point.z, rho * (1.0 - self.eccentricity_squared));
        for _ in 0..MOST_STEPS {
            let next = self.next_latitude(rho, point.z, latitude);
            let step = (next - latitude).abs();
            latitude = next;
            if step < LATITUDE_STEP {
                break;
            }
        }
        let height = self.height(rho, point.z, latitude);
        Geodetic { latitude, longitude: libm::atan2(point.y, point.x), height }
    }

    /// One step of the fixed point `p = atan2(z + e^2 N sin p, rho)`, which is regular at the poles.
    fn next_latitude(&self, rho: f64, z: f64, latitude: f64) -> f64 {
        let (sin, _) = sin_cos(latitude);
        libm::atan2(z + self.eccentricity_squared * self.prime_vertical(latitude) * sin, rho)
    }

    /// Height (m) along the normal: the sum over both axes has no small divisor anywhere.
    fn height(&self, rho: f64, z: f64, latitude: f64) -> f64 {
        let (sin, cos) = sin_cos(latitude);
        let curvature = 1.0 - self.eccentricity_squared * sin * sin;
        rho * cos + z * sin - self.semi_major * curvature.sqrt()
    }

    /// The local frame of a place.
    pub fn frame(&self, place: Geodetic) -> LocalFrame {
        let (sin_p, cos_p) = sin_cos(place.latitude);
        let (sin_l, cos_l) = sin_cos(place.longitude);
        let east = DVec3::new(-sin_l, cos_l, 0.0);
        let up = DVec3::new(cos_p * cos_l, cos_p * sin_l, sin_p);
        LocalFrame { origin: self.point(place), axes: DMat3::from_cols(east, up.cross(east), up) }
    }

    /// Nearest crossing in front of `eye` (m) by a ray, with the surface at `height` (m): distance along the unit `direction` (m).
    ///
    /// The search begins at the ellipsoid whose half axes are longer by `height`. Its geodetic heights are not quite `height`, so
    /// secants correct the crossing by the height of [`Ellipsoid::place`]. None where the ray passes the body.
    pub fn crossing(&self, eye: DVec3, direction: DVec3, height: f64) -> Option<f64> {
        let polar = self.semi_major * (1.0 - self.eccentricity_squared).sqrt() + height;
        let half_axes = DVec3::new(self.semi_major + height, self.semi_major + height, polar);
        if half_axes.min_element() <= 0.0 {
            return None;
        }
        let first = nearest_root(eye / half_axes, direction / half_axes)?;
        let miss = |distance: f64| self.place(eye + direction * distance).height - height;
        Some(secant(miss, first))
    }
}

/// Most steps of the fixed point: each gains a factor of 1/e^2 or more.
const MOST_STEPS: usize = 60;
/// Step of the latitude (rad) at which the fixed point has arrived.
const LATITUDE_STEP: f64 = 1e-15;

/// First distance above 0 at which `|eye + t direction| = 1`, for an eye outside; the far one for an eye inside.
fn nearest_root(eye: DVec3, direction: DVec3) -> Option<f64> {
    let (a, b, c) = (direction.length_squared(), eye.dot(direction), eye.length_squared() - 1.0);
    // The square of the shortest distance, rather than b^2 - a c: no digits are lost for a far eye.
    let discriminant = a - eye.cross(direction).length_squared();
    if discriminant < 0.0 {
        return None;
    }
    let far = -b + discriminant.sqrt();
    let near = if c > 0.0 { c / far } else { far / a };
    (far > 0.0 && near > 0.0).then_some(near)
}

/// Zero of `miss` near `first`, by secants that stop when they gain nothing.
fn secant(miss: impl Fn(f64) -> f64, first: f64) -> f64 {
    let (mut before, mut at) = (first - 1.0, first);
    let (mut miss_before, mut miss_at) = (miss(before), miss(at));
    for _ in 0..20 {
        if miss_at == 0.0 || miss_at == miss_before {
            break;
        }
        let next = at - miss_at * (at - before) / (miss_at - miss_before);
        let miss_next = miss(next);
        if miss_next.abs() >= miss_at.abs() {
            break;
        }
        (before, at, miss_before, miss_at) = (at, next, miss_at, miss_next);
    }
    at
}

/// East, north, up at a place on a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalFrame {
    /// Origin of the frame, georectangular (m).
    pub origin: DVec3,
    /// Columns: the unit vectors east, north, up in georectangular components.
    pub axes: DMat3,
}

impl LocalFrame {
    /// Local coordinates (m; east, north, up) of a georectangular point (m).
    pub fn local(&self, point: DVec3) -> DVec3 {
        self.axes.transpose() * (point - self.origin)
    }

    /// Georectangular point (m) of local coordinates (m; east, north, up).
    pub fn point(&self, local: DVec3) -> DVec3 {
        self.origin + self.axes * local
    }
}
