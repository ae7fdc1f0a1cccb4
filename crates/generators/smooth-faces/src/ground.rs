//! The ground of a frame as the last list.

use faces::ModelShading;
use generator::{Label, Stage};
use ground_mesh::{GroundMesh, MeshError, Rings, Vertex};
use landscape::Sun;
use quantities::luminance;
use rayon::prelude::*;
use scene_sampler::{Camera, Wedge};

use crate::list::List;
use crate::piece::Corner;
use crate::scene::SceneBuilder;
use crate::shown::{Geometry, in_runs};

/// Its priority: behind everything else.
pub const PRIORITY: i64 = i64::MAX;

/// Adds the ground that the camera may show, under the sun of a time (s).
///
/// # Errors
/// If the eye is not over the bank, or the rings are out of range.
pub fn add(scene: &mut SceneBuilder<'_>, stage: &Stage, rings: Rings, time: f64) -> Result<(), MeshError> {
    let wedge = Wedge::new(scene.camera, &stage.view);
    let mut mesh = GroundMesh::default();
    mesh.fill_where(&stage.landscape, scene.camera.eye, rings, |area| wedge.may_show(area))?;
    let sun = stage.scenery.sun(time);
    let number = scene.start(List {
        name: "ground".into(),
        label: Label::Terrain,
        priority: PRIORITY,
        level: None,
        sun: sun.direction(),
        has_own_sun: false,
        shown: [scene.frame; 4],
        has_fallen: false,
    });
    let work = Geometry {
        vertices: mesh.vertices().len() as u64,
        faces: mesh.triangles().len() as u64,
        triangles: 0,
    };
    scene.shown.work.add(work);
    let (screen, is_flat) = (scene.screen(), scene.run.shading == ModelShading::Flat);
    let corners: Vec<Corner> =
        mesh.vertices().par_iter().map(|vertex| corner(screen.camera, stage, &sun, vertex)).collect();
    let runs = in_runs(mesh.triangles().len(), |shown, face| {
        let mut of_face = mesh.triangles()[face].map(|vertex| corners[vertex as usize]);
        if is_flat {
            let mean = of_face.iter().map(|corner| corner.brightness).sum::<f64>() / 3.0;
            of_face.iter_mut().for_each(|corner| corner.brightness = mean);
        }
        shown.add(screen, &of_face, [1.0; 3], [number, face as u32]);
    });
    scene.shown.append(runs);
    Ok(())
}

/// A vertex in camera axes with the light of the scene's law; a colour of the ground becomes its luminance.
fn corner(camera: &Camera, stage: &Stage, sun: &Sun, vertex: &Vertex) -> Corner {
    let to_eye = (camera.eye - vertex.place).normalize_or_zero().to_array();
    let light = sun.shade(vertex.slopes, to_eye, *stage.landscape.photometry());
    let brightness = (luminance(vertex.albedo) * light).clamp(0.0, 1.0);
    Corner { place: camera.place(vertex.place), brightness }
}
