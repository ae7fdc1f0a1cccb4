//! How far triangles lie from the ground.

use features::Features;
use glam::DVec3;
use landscape::Landscape;
use rayon::prelude::*;

use crate::mesh::{GroundMesh, Vertex};

/// Parts of a triangle's side between two points at which its error is measured. Chosen: ten points a triangle.
const PARTS: u32 = 3;

/// The largest vertical distance between triangles and ground.
///
/// **Measured**, at ten points of each triangle against the closed form: the error there, plus what it changes by its own slope up to the
/// nearest of these points. Where the ground is a quadratic form over the triangle, nothing exceeds it. A crater that may lie between the
/// points adds its whole relief; of several such craters in a triangle only the largest one counts, so where they overlap the bound
/// is an estimate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HeightError {
    /// In metres, over all triangles.
    pub metres: f64,
    /// In pixels in the middle of a picture: error over distance, times the focal length. Infinite where the eye may lie in a triangle.
    pub pixels: f64,
}

impl HeightError {
    /// The larger of both, figure by figure.
    fn or(self, other: Self) -> Self {
        Self { metres: self.metres.max(other.metres), pixels: self.pixels.max(other.pixels) }
    }
}

impl GroundMesh {
    /// Error of the mesh against the landscape that it was made of, seen from `eye` (m) with a `focal` length (pixels).
    pub fn height_error(&self, landscape: &Landscape, eye: DVec3, focal: f64) -> HeightError {
        let error =
            |near: &mut Vec<u32>, corners: &[u32; 3]| self.error_of(corners, landscape, eye, focal, near);
        self.triangles.par_iter().map_init(Vec::new, error).reduce(HeightError::default, HeightError::or)
    }

    /// Whether the error in the picture is within a tolerance (pixels). It is known as soon as one triangle exceeds it.
    pub(crate) fn is_within(&self, landscape: &Landscape, eye: DVec3, focal: f64, tolerance: f64) -> bool {
        let pixels = |near: &mut Vec<u32>, corners: &[u32; 3]| {
            self.error_of(corners, landscape, eye, focal, near).pixels
        };
        self.triangles.par_iter().map_init(Vec::new, pixels).all(|pixels| pixels <= tolerance)
    }

    fn error_of(
        &self,
        corners: &[u32; 3],
        landscape: &Landscape,
        eye: DVec3,
        focal: f64,
        near: &mut Vec<u32>,
    ) -> HeightError {
        let corners = corners.map(|corner| self.vertices[corner as usize]);
        let metres = measured(landscape, &corners) + between_points(landscape.features(), &corners, near);
        let pixels = if metres == 0.0 { 0.0 } else { focal * metres / distance(&corners, eye, metres) };
        HeightError { metres, pixels }
    }
}

/// Error (m) of a triangle at its points, and near them by its slope.
fn measured(landscape: &Landscape, corners: &[Vertex; 3]) -> f64 {
    let [p, q, r] = corners.map(|corner| corner.place);
    let normal = (q - p).cross(r - p);
    let slopes = [-normal.x / normal.z, -normal.y / normal.z];
    let reach = reach(corners);
    let mut largest = 0.0f64;
    for i in 0..=PARTS {
        for j in 0..=PARTS - i {
            let [to_q, to_r] = [i, j].map(|part| f64::from(part) / f64::from(PARTS));
            let place = p + to_q * (q - p) + to_r * (r - p);
            // Rounding may move a point of a border off the bank.
            let Some(ground) = landscape.at(place.x, place.y) else { continue };
            let [dx, dy] = [0, 1].map(|axis| ground.slopes[axis] - slopes[axis]);
            largest = largest.max((ground.height - place.z).abs() + (dx * dx + dy * dy).sqrt() * reach);
        }
    }
    largest
}

/// Farthest (m, on the map) that a point of a triangle can lie from one of the points at which the error is measured: these cut it into triangles
/// of a third of its sides, and no triangle of a longest side s has a point farther than s over the root of 3 from all corners (Jung).
fn reach(corners: &[Vertex; 3]) -> f64 {
    let flat = corners.map(|corner| DVec3 { z: 0.0, ..corner.place });
    let sides = [0, 1, 2].map(|k| flat[k].distance(flat[(k + 1) % 3]));
    sides.into_iter().fold(0.0, f64::max) / (f64::from(PARTS) * 3.0f64.sqrt())
}

/// Relief (m) of the largest crater that may lie between the points of a triangle.
fn between_points(features: &Features, corners: &[Vertex; 3], near: &mut Vec<u32>) -> f64 {
    if features.is_empty() {
        return 0.0;
    }
    let [low, high] = bounds(corners);
    features.in_box([low.x, low.y], [high.x, high.y], near);
    let reach = reach(corners);
    let small = near.iter().map(|&index| features.crater(index)).filter(|crater| crater.outer() < reach);
    small.map(|crater| crater.highest() - crater.lowest()).fold(0.0, f64::max)
}

/// Least distance (m) between an eye and the box of a triangle that is `metres` thicker up and down.
fn distance(corners: &[Vertex; 3], eye: DVec3, metres: f64) -> f64 {
    let [low, high] = bounds(corners);
    let up = DVec3::new(0.0, 0.0, metres);
    eye.distance(eye.clamp(low - up, high + up))
}

/// Lowest and highest corner of the box around a triangle.
fn bounds(corners: &[Vertex; 3]) -> [DVec3; 2] {
    let [p, q, r] = corners.map(|corner| corner.place);
    [p.min(q).min(r), p.max(q).max(r)]
}
