//! The ground of a frame: panels in camera axes with their light.

use glam::DVec3;
use rayon::prelude::*;
use scene_sampler::{Camera, Corner, Ground, GroundMap};

use crate::coarser::Choice;
use crate::parameters::Shading;
use crate::prepared::Prepared;

/// Panels of a frame whose corners have numbers of their own.
pub struct Own(Vec<[u32; 3]>);

impl Own {
    /// The numbers of corners, three a panel, where each panel has one light.
    pub fn new(prepared: &Prepared) -> Self {
        let count = match prepared.run.shading {
            Shading::Panel => prepared.mesh.count() as u32,
            Shading::Texture | Shading::Gouraud => 0,
        };
        Self((0..count).map(|panel| [0, 1, 2].map(|corner| 3 * panel + corner)).collect())
    }
}

/// The ground as a camera sees it at `time` (s), with the panels of `choice` where there is one.
pub fn ground<'a>(
    prepared: &'a Prepared,
    own: &'a Own,
    choice: Option<&'a Choice>,
    camera: &Camera,
    time: f64,
) -> Ground<'a> {
    let mesh = &prepared.mesh;
    let sun = prepared.stage.scenery.sun(time).direction();
    let map = match &prepared.relit {
        Some(relit) => relit.map(sun),
        None if prepared.run.shading == Shading::Texture => photographs(prepared, camera),
        None => None,
    };
    match prepared.run.shading {
        Shading::Texture => {
            let corner = |vertex: DVec3| Corner { place: camera.place(vertex), colour: [0.0; 3] };
            match choice {
                Some(Choice { posts, triangles }) => {
                    let corners = posts.par_iter().map(|post| corner(mesh.vertex(*post))).collect();
                    Ground { corners, triangles, map }
                }
                None => {
                    let corners = mesh.of_vertices(|_, vertex| corner(vertex));
                    Ground { corners, triangles: mesh.panels(), map }
                }
            }
        }
        Shading::Gouraud => {
            let corners = mesh.of_vertices(|number, vertex| {
                let grey = || f64::from(prepared.vertices[number]);
                Corner { place: camera.place(vertex), colour: colour(map.as_ref(), vertex, camera, grey) }
            });
            Ground { corners, triangles: mesh.panels(), map: None }
        }
        Shading::Panel => {
            let corners = (0..mesh.count()).into_par_iter().flat_map_iter(|panel| {
                let corners = mesh.corners(panel);
                let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
                let colour = colour(map.as_ref(), middle, camera, || prepared.greys[panel].light);
                corners.map(|vertex| Corner { place: camera.place(vertex), colour })
            });
            Ground { corners: corners.collect(), triangles: &own.0, map: None }
        }
    }
}

/// What photographs show in the pixels of a camera.
fn photographs(prepared: &Prepared, camera: &Camera) -> Option<GroundMap> {
    let half_pixel = 0.5 / camera.focal();
    GroundMap::of_photographs(prepared.drape.clone(), half_pixel, prepared.unseen.clone())
}

/// Colour at a place: by the map of ground that is lit anew, or grey.
fn colour(map: Option<&GroundMap>, place: DVec3, camera: &Camera, grey: impl Fn() -> f64) -> [f64; 3] {
    match map {
        Some(map) => map.at(place, camera.eye),
        None => [grey().clamp(0.0, 1.0); 3],
    }
}
