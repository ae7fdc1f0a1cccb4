//! Collinearity: eye, image and ground lie on one line.
//!
//! `x = x0 - f (m1 . d)/(m3 . d)`, `y = y0 - f (m2 . d)/(m3 . d)` with d from the perspective centre to the ground. A point is in
//! front where `m3 . d < 0`. A point behind has no image; the equations alone would mirror it.

use glam::DVec3;

use crate::{Affine, CameraError, Ellipsoid, Orientation};

/// Micrometres in a metre.
const MICROMETRES: f64 = 1e6;

/// A photograph's camera: inner and outer orientation, and the affine of its scan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    focal_length: f64,
    principal_point: [f64; 2],
    centre: DVec3,
    orientation: Orientation,
    affine: Affine,
}

/// Where a ground point appears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Image {
    /// The point is in front of the camera.
    Front {
        /// Pixel I, J, continuous; it may lie outside the photograph.
        pixel: [f64; 2],
        /// Distance along the optical axis (m), above 0.
        depth: f64,
    },
    /// The point is behind the camera or in the plane of its centre: it has no image.
    Behind {
        /// Distance along the optical axis (m), 0 or below.
        depth: f64,
    },
}

/// A ray from the perspective centre through a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Perspective centre, georectangular (m).
    pub origin: DVec3,
    /// Unit vector towards the scene.
    pub direction: DVec3,
}

impl Camera {
    /// A camera of focal length (m), principal point x0, y0 (m), perspective centre (m), orientation and affine.
    ///
    /// # Errors
    ///
    /// If the focal length is not above 0, or a figure is not finite.
    pub fn new(
        focal_length: f64,
        principal_point: [f64; 2],
        centre: DVec3,
        orientation: Orientation,
        affine: Affine,
    ) -> Result<Self, CameraError> {
        CameraError::figure("focal length (m)", focal_length, "a finite number above 0", |f| f > 0.0)?;
        for value in principal_point {
            CameraError::figure("principal point (m)", value, "a finite number", |_| true)?;
        }
        for value in centre.to_array() {
            CameraError::figure("perspective centre (m)", value, "a finite number", |_| true)?;
        }
        Ok(Self { focal_length, principal_point, centre, orientation, affine })
    }

    /// Image coordinates x, y (micrometres) and depth (m) of a ground point (m); no coordinates where the depth is not above 0.
    fn collinear(&self, point: DVec3) -> (Option<[f64; 2]>, f64) {
        let seen = self.orientation.image(point - self.centre);
        let depth = -seen.z;
        let [x0, y0] = self.principal_point;
        let at = |zero: f64, across: f64| MICROMETRES * (zero + self.focal_length * across / depth);
        ((depth > 0.0).then(|| [at(x0, seen.x), at(y0, seen.y)]), depth)
    }

    /// Image coordinates x, y (micrometres) of a georectangular point (m) in front of the camera.
    pub fn image(&self, point: DVec3) -> Option<[f64; 2]> {
        self.collinear(point).0
    }

    /// Where a georectangular point (m) appears, in pixels.
    pub fn project(&self, point: DVec3) -> Image {
        match self.collinear(point) {
            (Some(image), depth) => Image::Front { pixel: self.affine.pixel(image), depth },
            (None, depth) => Image::Behind { depth },
        }
    }

    /// The ray through a pixel I, J.
    pub fn ray(&self, pixel: [f64; 2]) -> Ray {
        let [x, y] = self.affine.image(pixel).map(|micrometres| micrometres / MICROMETRES);
        let [x0, y0] = self.principal_point;
        let image = DVec3::new(x - x0, y - y0, -self.focal_length);
        Ray { origin: self.centre, direction: self.orientation.ground(image).normalize() }
    }

    /// Focal length of the camera (m).
    pub fn focal_length(&self) -> f64 {
        self.focal_length
    }

    /// Principal point x0, y0 in the image plane (m).
    pub fn principal_point(&self) -> [f64; 2] {
        self.principal_point
    }

    /// Perspective centre, georectangular (m).
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// The orientation of the image axes.
    pub fn orientation(&self) -> Orientation {
        self.orientation
    }

    /// The affine from pixels to micrometres.
    pub fn affine(&self) -> Affine {
        self.affine
    }
}

impl Ray {
    /// The point (m) where the ray meets a plane through `origin` (m) with `normal`; none behind the eye or along the plane.
    pub fn on_plane(&self, origin: DVec3, normal: DVec3) -> Option<DVec3> {
        let distance = (origin - self.origin).dot(normal) / self.direction.dot(normal);
        (distance.is_finite() && distance > 0.0).then(|| self.origin + self.direction * distance)
    }

    /// The first point (m) where the ray meets the surface at `height` (m) above a body; none where the ray passes it.
    pub fn on_body(&self, body: &Ellipsoid, height: f64) -> Option<DVec3> {
        let distance = body.crossing(self.origin, self.direction, height)?;
        Some(self.origin + self.direction * distance)
    }
}
