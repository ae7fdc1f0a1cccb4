//! Smooth-shaded faces against the check values of their specification, closed forms and bad input.

mod bad_faces;
mod bow_wakes;
mod cones;
mod effects;
mod flights;
mod groups;
mod interpolation;
mod library;
mod models;
mod mounds;
mod patterns;
mod sea;
mod sequences;
mod shading;
mod ships;
mod suns;

use faces::{Face, Mesh, Vertex};
use glam::DVec3;

/// White: linear red, green, blue.
const WHITE: [f64; 3] = [1.0; 3];

/// Vertices without normals of their own at places (m).
fn vertices(places: &[[f64; 3]]) -> Vec<Vertex> {
    places.iter().map(|&place| Vertex::at(DVec3::from_array(place))).collect()
}

/// A mesh of smooth white faces, of which none is left out.
fn smooth(places: &[[f64; 3]], faces: &[&[u32]]) -> Mesh {
    let faces = faces.iter().map(|corners| Face::smooth(corners.to_vec(), WHITE)).collect();
    let loaded = Mesh::load("test", vertices(places), faces).expect("faces that can be drawn");
    assert!(loaded.warnings.is_empty(), "{:?}", loaded.warnings);
    loaded.mesh
}

/// Requires two numbers to be equal within 1e-12, the digits of the check values.
#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12, "{found} instead of {expected}");
}
