//! A convex outline cut by a plane.

use glam::DVec3;

/// Half of space: places where `normal . place` is at least `offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Half {
    /// Direction in which the half reaches, of any length.
    pub normal: DVec3,
    /// Value of `normal . place` on the plane.
    pub offset: f64,
}

impl Half {
    /// What lies at height `up` (m) or above.
    pub fn above(up: f64) -> Self {
        Self { normal: DVec3::Z, offset: up }
    }

    /// Distance of a place from the plane, in lengths of the normal; negative outside.
    pub fn inside(&self, place: DVec3) -> f64 {
        self.normal.dot(place) - self.offset
    }

    /// The part of a convex outline in the half, corners in the same order; empty where there is none.
    pub fn clip(&self, outline: &[DVec3]) -> Vec<DVec3> {
        self.cut(outline, |corner| *corner, |from, to, share| from + (to - from) * share)
    }

    /// The same of corners that carry more than their place; `mix` gives the corner at a share of the way between two.
    pub fn cut<T: Copy>(
        &self,
        outline: &[T],
        place: impl Fn(&T) -> DVec3,
        mix: impl Fn(T, T, f64) -> T,
    ) -> Vec<T> {
        let mut kept = Vec::with_capacity(outline.len() + 1);
        for (k, &to) in outline.iter().enumerate() {
            let from = outline[(k + outline.len() - 1) % outline.len()];
            let (before, after) = (self.inside(place(&from)), self.inside(place(&to)));
            if (before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0) {
                kept.push(mix(from, to, before / (before - after)));
            }
            if after >= 0.0 {
                kept.push(to);
            }
        }
        kept
    }
}
