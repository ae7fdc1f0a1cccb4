//! Boulders by distance: none where one is smaller than a pixel, few faces where it is small.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;

use generator::{PrepareError, Stage};
use glam::DVec3;
use scenario::Standing;
use scene_sampler::Camera;
use solids::{Body, Kind, Solid, SolidError};

use crate::name::NAME;

/// Diameters, in least ones, at which a boulder has grown to its size, and from which on it has all of its faces (specification, section 6.6).
const WHOLE: f64 = 2.0;
const ALL_FACES: f64 = 12.0;

/// The shapes of few faces that stand for those of the boulders of a stage.
pub struct FewFaces {
    /// Octahedra, each by the address of its solid. The stage keeps the solids.
    octahedra: BTreeMap<usize, Arc<Solid>>,
}

impl FewFaces {
    /// Those of a stage; `None` if it has no boulder.
    ///
    /// # Errors
    /// If a boulder is flat.
    pub fn of(stage: &Stage) -> Result<Option<Self>, PrepareError> {
        let mut octahedra = BTreeMap::new();
        for body in
            stage.scenery.standing().iter().map(|standing| &standing.body).filter(|body| is_boulder(body))
        {
            if let Entry::Vacant(place) = octahedra.entry(address(&body.solid)) {
                place.insert(Arc::new(octahedron(&body.solid).map_err(refused)?));
            }
        }
        Ok((!octahedra.is_empty()).then_some(Self { octahedra }))
    }

    /// The stage with its boulders as a camera sees them, where one of `least` pixels is the smallest that is drawn: it grows from nothing at that
    /// diameter, and has its size at twice that.
    pub fn seen(&self, stage: &Stage, camera: &Camera, least: f64) -> Stage {
        let shown = |standing: &Standing| {
            let body = match is_boulder(&standing.body) {
                true => self.boulder(&standing.body, diameter(&standing.body, camera) / least)?,
                false => standing.body.clone(),
            };
            Some(Standing { body, ..*standing })
        };
        let standing = stage.scenery.standing().iter().filter_map(shown).collect();
        let scenery = Arc::new((*stage.scenery).clone().with_bodies(standing));
        Stage { scenery, ..stage.clone() }
    }

    /// A boulder of so many least diameters; `None` if it is too small.
    fn boulder(&self, body: &Body, diameters: f64) -> Option<Body> {
        if diameters >= ALL_FACES {
            return Some(body.clone());
        }
        let few = body.shaped(self.octahedra.get(&address(&body.solid))?);
        match diameters {
            ..=1.0 => None,
            ..WHOLE => Some(few.scaled((diameters - 1.0) / (WHOLE - 1.0))),
            _ => Some(few),
        }
    }
}

fn is_boulder(body: &Body) -> bool {
    body.kind == Kind::Rock
}

fn address(solid: &Arc<Solid>) -> usize {
    Arc::as_ptr(solid) as usize
}

fn refused(error: SolidError) -> PrepareError {
    PrepareError::Unsupported {
        generator: NAME,
        what: format!("a boulder of few faces ({error})"),
        remedy: "draw all with lod.boulder_px = 0".into(),
    }
}

/// Diameter (pixels) of a body's sphere; infinite for one that holds the eye.
fn diameter(body: &Body, camera: &Camera) -> f64 {
    let distance = (body.centre - camera.eye).length();
    if distance <= body.radius { f64::INFINITY } else { 2.0 * body.radius * camera.focal() / distance }
}

/// The octahedron of a solid's box, with the mean colour of its faces.
fn octahedron(solid: &Solid) -> Result<Solid, SolidError> {
    let vertices = solid.vertices().iter().copied();
    let [low, high] = vertices.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], vertex| {
        [low.min(vertex), high.max(vertex)]
    });
    let count = solid.faces().len();
    let mean = |of: &dyn Fn(usize) -> f64| (0..count).map(of).sum::<f64>() / count as f64;
    let octahedron = Solid::octahedron(low, high, mean(&|face| solid.faces()[face].albedo))?;
    match solid.is_colourful() {
        true => octahedron.coloured([0, 1, 2].map(|channel| mean(&|face| solid.albedo(face)[channel]))),
        false => Ok(octahedron),
    }
}
