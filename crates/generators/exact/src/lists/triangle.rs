//! A triangle of a list of faces on the screen.

use faces::{Detail, Half};
use generator::Look;
use glam::DVec3;
use smallvec::SmallVec;

use crate::effects::Screen;
use crate::standing::NEAR;
use crate::view::View;

/// A corner of a face with its brightness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Place from the eye: north, east, up (m).
    pub place: DVec3,
    /// Brightness, 0 or more.
    pub brightness: f64,
}

/// What all triangles of a face share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paint {
    /// Number of its list in the frame, and of the face in the list.
    pub of: [u32; 2],
    /// Linear red, green, blue of full brightness.
    pub colour: [f64; 3],
    /// Unit normal of the side that is seen: north, east, up.
    pub normal: DVec3,
    /// How it is laid upon what lies behind it; `None` where it stands for itself.
    pub level: Option<Detail>,
}

/// A triangle on the screen.
#[derive(Debug, Clone, PartialEq)]
pub struct Triangle {
    /// What it has from its face.
    pub paint: Paint,
    /// Brightness of its corners.
    pub brightness: [f64; 3],
    /// Height (m) by which the curved ground may stand above its middle, if both have its corners.
    pub sag: f64,
    /// Weights of the corners at a place in pixels: linear functions, all at least 0 inside.
    weights: [[f64; 3]; 3],
    /// How near it is (1/m) at a place in pixels: a linear function.
    pub nearness: [f64; 3],
}

impl Triangle {
    /// The triangle, with the corners in pixels of its part before the eye; `None` if nothing of it can be seen.
    pub fn new(
        corners: [Corner; 3],
        paint: Paint,
        sag: f64,
        (view, screen): (&View, &Screen),
    ) -> Option<(Self, Vec<[f64; 2]>)> {
        let [a, b, c] = corners.map(|corner| view.axes(corner.place));
        let volume = a.dot(b.cross(c));
        let sign = volume.signum();
        let weights = [b.cross(c), c.cross(a), a.cross(b)].map(|across| screen.linear(sign * across));
        let nearness = [0, 1, 2].map(|k| weights.iter().map(|weight| weight[k]).sum::<f64>() / volume.abs());
        let ahead = Half { normal: DVec3::Z, offset: NEAR };
        let part = ahead.clip(&[a, b, c]);
        let outline: Vec<_> = part.iter().map(|at| screen.in_pixels([at.x / at.z, at.y / at.z])).collect();
        let brightness = corners.map(|corner| corner.brightness);
        let is_seen = volume != 0.0 && outline.len() >= 3 && nearness.iter().all(|factor| factor.is_finite());
        is_seen.then_some((Self { paint, brightness, sag, weights, nearness }, outline))
    }

    /// Whether it covers a place in pixels, its edges included.
    pub fn covers(&self, at: [f64; 2]) -> bool {
        self.weights.iter().all(|weight| linear(weight, at) >= 0.0) && linear(&self.nearness, at) > 0.0
    }

    /// Brightness at a place in pixels: linear over the triangle in space.
    pub fn brightness_at(&self, at: [f64; 2]) -> f64 {
        let weights = self.weights.map(|weight| linear(&weight, at));
        let sum: f64 = weights.iter().sum();
        weights.iter().zip(self.brightness).map(|(weight, of)| weight * of).sum::<f64>() / sum
    }

    /// Light of it alone (linear red, green, blue) at a place in pixels.
    pub fn light(&self, at: [f64; 2]) -> [f64; 3] {
        let brightness = self.brightness_at(at).max(0.0);
        self.paint.colour.map(|channel| channel * brightness)
    }

    /// What it does to light at a place in pixels. A sum of levels is not clamped.
    pub fn look(&self, at: [f64; 2]) -> Look {
        let light = self.light(at);
        let translucency = match self.paint.level {
            None | Some(Detail::Replace) => [0.0; 3],
            Some(Detail::Add) => [1.0; 3],
            Some(Detail::AddSoft) => light.map(|channel| 1.0 - channel),
        };
        Look { light, translucency }
    }

    /// Whether it hides what lies behind it.
    pub fn is_opaque(&self) -> bool {
        matches!(self.paint.level, None | Some(Detail::Replace))
    }
}

/// Triangles of a convex outline, from its first corner.
pub fn fan(outline: &[Corner]) -> SmallVec<[[Corner; 3]; 2]> {
    outline.windows(2).skip(1).map(|pair| [outline[0], pair[0], pair[1]]).collect()
}

/// Value of a linear function at a place in pixels.
pub fn linear(of: &[f64; 3], [x, y]: [f64; 2]) -> f64 {
    of[0] * x + of[1] * y + of[2]
}
