//! The ground of a frame as a mesh, on rings that are chosen once for a mission.

use generator::Stage;
use ground_mesh::{GroundMesh, MeshError, Rings, Vertex, Wish};
use landscape::Sun;
use rayon::prelude::*;
use scene_sampler::{Camera, Corner, Ground, Wedge};

use crate::parameters::Parameters;

/// The coarsest rings whose error in frame 0 is within that of the run parameters, or those of most cells.
pub fn rings(stage: &Stage, run: &Parameters) -> Rings {
    let finest = Rings { half_side: run.ground_half_side, cells: run.ground_cells };
    let start = stage.scenery.start().filter(|_| run.ground_error > 0.0);
    let Some(camera) = start.map(|pose| Camera::new(pose, &stage.view)) else { return finest };
    let wish = Wish {
        half_side: run.ground_half_side,
        most_cells: run.ground_cells,
        focal: focal(&camera),
        tolerance: run.ground_error,
    };
    let wedge = Wedge::new(&camera, &stage.view);
    let fitted =
        GroundMesh::default().fit_where(&stage.landscape, camera.eye, &wish, |area| wedge.may_show(area));
    // A frame that has no mesh says so when it is drawn.
    fitted.map_or(finest, |fitted| fitted.rings)
}

/// Fills `mesh` with the ground that a camera may show.
///
/// # Errors If the eye is not over the bank, or the rings are out of range.
pub fn fill(mesh: &mut GroundMesh, stage: &Stage, rings: Rings, camera: &Camera) -> Result<(), MeshError> {
    let wedge = Wedge::new(camera, &stage.view);
    mesh.fill_where(&stage.landscape, camera.eye, rings, |area| wedge.may_show(area))
}

/// The same as a mesh of its own.
///
/// # Errors As [`fill`].
fn mesh(stage: &Stage, rings: Rings, camera: &Camera) -> Result<GroundMesh, MeshError> {
    let mut mesh = GroundMesh::default();
    fill(&mut mesh, stage, rings, camera)?;
    Ok(mesh)
}

/// A mesh as faces: light and colour at its vertices.
pub fn faces<'a>(stage: &Stage, mesh: &'a GroundMesh, camera: &Camera, sun: &Sun) -> Ground<'a> {
    let law = *stage.landscape.photometry();
    let shaded = |vertex: &Vertex| {
        let to_eye = (camera.eye - vertex.place).normalize_or_zero().to_array();
        let light = sun.shade(vertex.slopes, to_eye, law);
        let colour = vertex.albedo.map(|albedo| (albedo * light).clamp(0.0, 1.0));
        Corner { place: camera.place(vertex.place), colour }
    };
    let corners = mesh.vertices().par_iter().map(shaded).collect();
    Ground { corners, triangles: mesh.triangles(), map: None }
}

/// The mesh of a camera and its error against the closed form of the ground, in words.
///
/// # Errors As [`mesh`].
pub fn told(stage: &Stage, rings: Rings, camera: &Camera) -> Result<String, MeshError> {
    let mesh = mesh(stage, rings, camera)?;
    let error = mesh.height_error(&stage.landscape, camera.eye, focal(camera));
    Ok(format!(
        "{} triangles, {} cells in half a ring, the finest {} m; at most {:.3} m and {:.2} pixels off",
        mesh.triangles().len(),
        rings.cells,
        rings.finest_step(),
        error.metres,
        error.pixels
    ))
}

/// Pixels in a tangent of 1, the larger of both directions.
fn focal(camera: &Camera) -> f64 {
    camera.projection.focal * camera.squeeze().max(1.0)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use ground_mesh::FEWEST_CELLS;
    use landscape::relief::{Relief, Undulation};
    use landscape::{Attitude, Bank, Landscape};
    use quantities::Rate;
    use scenario::{Effects, Pose, View};

    use super::*;
    use crate::scenes;

    /// Gentle ground, seen to the north from its southern part.
    fn stage(has_start: bool) -> Stage {
        let undulation =
            Undulation { rms_height: 2.0, hurst: 0.85, longest: 400.0, shortest: 60.0, waves: 64 };
        let relief = Relief { undulation: Some(undulation), ..Relief::flat(1, [800.0, 800.0], 20.0) };
        let landscape = Landscape::new(Bank::new("test", vec![relief.build().unwrap()], None).unwrap(), 1.0);
        let stage = scenes::stage(Effects::default(), Rate::new(10, 1).unwrap());
        let height = landscape.height(100.0, 400.0).unwrap();
        let start =
            Pose { eye: [100.0, 400.0, height + 20.0], attitude: Attitude::default(), ..scenes::pose() };
        let scenery = (*stage.scenery).clone().with_start(has_start.then_some(start));
        let view = View { columns: 100, lines: 100, ranges: [1.0, 2000.0], ..stage.view };
        Stage { landscape: Arc::new(landscape), scenery: Arc::new(scenery), view }
    }

    #[test]
    fn rings_are_as_coarse_as_the_error_in_frame_0_allows() {
        let stage = stage(true);
        let start = stage.scenery.start().unwrap();
        let camera = Camera::new(start, &stage.view);
        let off = |rings: Rings| {
            mesh(&stage, rings, &camera)
                .unwrap()
                .height_error(&stage.landscape, camera.eye, focal(&camera))
                .pixels
        };
        let run = |ground_error: f64| Parameters { ground_error, ..Parameters::default() };
        let [coarse, fine] = [2.0, 0.5].map(|tolerance| rings(&stage, &run(tolerance)));
        assert!(
            FEWEST_CELLS < coarse.cells && coarse.cells < fine.cells && fine.cells < 128,
            "{coarse:?} {fine:?}"
        );
        assert!(off(coarse) <= 2.0 && off(fine) <= 0.5);
        assert!(off(Rings { cells: fine.cells / 2, ..fine }) > 0.5);
        assert!(told(&stage, fine, &camera).unwrap().contains(&format!("{:.2} pixels off", off(fine))));
    }

    #[test]
    fn rings_have_all_cells_where_nothing_can_be_met() {
        let cells = |has_start, ground_error| {
            rings(&stage(has_start), &Parameters { ground_error, ..Parameters::default() }).cells
        };
        assert_eq!([cells(true, 0.0), cells(true, 1e-6), cells(false, 0.5)], [128; 3]);
    }
}
