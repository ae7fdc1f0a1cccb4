//! Light of the faces.

use glam::DVec3;
use photometry::Photometry;
use scenario::BodyShading;
use signal::Number;
use solids::Body;

/// Words that smooth light takes more at each crossing of a face and a sweep: both ends of a ramp in place of one value would be one more;
/// the specification of the option counts two (inferred).
pub const RAMP_WORDS: u64 = 2;

/// Light of a frame on the faces of bodies. What is diffuse the report computes before the mission; what depends on the eye comes anew in each frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceLight {
    /// Unit vector to the sun: north, east, up.
    pub sun: DVec3,
    /// Whether a face has one reflectivity, or a ramp between those of its corners.
    pub shading: BodyShading,
}

/// How a body whose law is not Lambert's returns light to an eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Returned {
    law: Photometry,
    /// Unit vector from the middle of the body to the eye: north, east, up. The processor takes one for each body.
    to_eye: DVec3,
}

impl Returned {
    /// That of `body`, which an eye at `eye` (north, east, up; m) sees; none under Lambert's law, which does not ask where the eye is.
    pub fn new(body: &Body, eye: DVec3) -> Option<Self> {
        let law = body.solid.photometry();
        (law != Photometry::Lambert).then(|| Self { law, to_eye: (eye - body.centre).normalize_or(DVec3::Z) })
    }
}

impl FaceLight {
    /// Reflectivity of a face under Lambert's law, 0..=1, by its unit normal (north, east, up): `max(n.s, 0)` times its albedo.
    #[inline(always)]
    pub(crate) fn diffuse<N: Number>(&self, normal: [N; 3], albedo: N) -> N {
        along(normal, self.sun).at_least(albedo.like(0.0)) * albedo
    }

    /// The same under the law of its body.
    #[inline(always)]
    pub(crate) fn reflectivity<N: Number>(&self, normal: [N; 3], albedo: N, returned: &Returned) -> N {
        let [mu0, mu] = [self.sun, returned.to_eye].map(|way| along(normal, way));
        returned.law.returned(albedo, [mu0, mu, albedo.like(self.sun.dot(returned.to_eye))])
    }
}

/// Cosine between a unit normal (north, east, up) and a unit vector.
#[inline(always)]
fn along<N: Number>([north, east, up]: [N; 3], way: DVec3) -> N {
    north * north.like(way.x) + east * north.like(way.y) + up * north.like(way.z)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DMat3, DVec3};
    use photometry::Photometry;
    use scenario::BodyShading;
    use solids::{Body, Kind, Solid};

    use super::{FaceLight, Returned};

    /// A box of 2 m about the origin, of albedo 0.25.
    fn body(law: Photometry) -> Body {
        let solid = Solid::boxed(-DVec3::ONE, DVec3::ONE, 0.25).unwrap().reflecting(law);
        Body::place(1, Kind::Culture, &Arc::new(solid), DVec3::ZERO, &DMat3::IDENTITY, 1.0)
    }

    #[test]
    fn a_face_that_mirrors_the_sun_to_the_eye_has_the_whole_highlight() {
        let light = FaceLight { sun: DVec3::new(0.6, 0.0, 0.8), shading: BodyShading::Flat };
        let of_the_top = |law, eye| -> f64 {
            let up = [0.0, 0.0, 1.0];
            match Returned::new(&body(law), eye) {
                None => light.diffuse(up, 0.25),
                Some(returned) => light.reflectivity(up, 0.25, &returned),
            }
        };
        let gloss = Photometry::Specular { strength: 2.0, exponent: 8 };
        let (mirrored, beside) = (DVec3::new(-60.0, 0.0, 80.0), DVec3::new(-80.0, 0.0, 60.0));
        assert_eq!(of_the_top(Photometry::Lambert, mirrored), 0.25 * 0.8);
        assert!((of_the_top(gloss, mirrored) - 3.0 * 0.25 * 0.8).abs() < 1e-15);
        // The cosine between the mirrored sun and that eye is 0.96.
        let expected = (1.0 + 2.0 * libm::pow(0.96, 8.0)) * 0.25 * 0.8;
        assert!((of_the_top(gloss, beside) - expected).abs() < 1e-14);
        // A register holds no more than 1.
        let strong = Photometry::Specular { strength: 100.0, exponent: 8 };
        assert_eq!(of_the_top(strong, mirrored), 1.0);
    }
}
