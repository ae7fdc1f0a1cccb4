//! Mounds fail, in numbers: real waves show less than false normals (acceptance test 14).

use faces::{
    Board, Cone, CornerNormals, Mesh, Pattern, SeaState, Shading, Vertex, Weights, brightness, sun_vector,
};
use glam::DVec3;
use quantities::{radians, unit_interval};

use crate::WHITE;

/// Contrast of the 5th to the 95th percentile.
fn contrast(mut light: Vec<f64>) -> f64 {
    light.sort_by(f64::total_cmp);
    let at = |part: f64| light[(part * (light.len() - 1) as f64) as usize];
    let (low, high) = (at(0.05), at(0.95));
    (high - low) / (high + low)
}

fn board() -> Board {
    Board::new(10.0, 0..60, 0..60).expect("a board")
}

/// Mounds of up to 0.5 m.
fn mounds() -> Mesh {
    let place = |vertex: faces::GridVertex| {
        let height = 0.5 * unit_interval(1, &[vertex.row as u64, vertex.column as u64]);
        Vertex::at(DVec3::new(vertex.place[0], vertex.place[1], height))
    };
    board().cut("mounds", (WHITE, Shading::Smooth), 7200, place).expect("mounds").mesh
}

/// Brightness at all corners of triangles, and at their centroids.
fn light(normals: &CornerNormals, faces: usize, sun: DVec3) -> [Vec<f64>; 2] {
    let corners =
        |face| normals.of_face(face).iter().map(|normal| brightness(*normal, sun)).collect::<Vec<_>>();
    let all = (0..faces).flat_map(corners).collect();
    let centroid = |face| corners(face).iter().take(3).sum::<f64>() / 3.0;
    [all, (0..faces).map(centroid).collect()]
}

#[test]
fn mounds_show_less_than_false_normals_and_smooth_ones_least() {
    let sun = sun_vector(0.0, radians(30.0));
    let mesh = mounds();
    let faceted = contrast(mesh.normals().iter().map(|normal| brightness(*normal, sun)).collect());
    let smooth = CornerNormals::new(&mesh, Weights::Equal);
    let [corners, centroids] = light(&smooth, mesh.faces().len(), sun).map(contrast);
    let cone = Cone::new(16, radians(75.0)).expect("a cone");
    let place = |vertex: faces::GridVertex| Vertex {
        place: DVec3::new(vertex.place[0], vertex.place[1], 0.0),
        normal: Some(cone.normal(Pattern::Random { seed: 1 }.number(vertex, 16))),
    };
    let sea = board().cut("sea", (WHITE, Shading::Smooth), 7200, place).expect("a sea").mesh;
    let false_normals = CornerNormals::new(&sea, Weights::Equal);
    let low = sun_vector(0.0, SeaState::Moderate.elevation(&cone).expect("an elevation"));
    let [sea_corners, sea_centroids] = light(&false_normals, 7200, low).map(contrast);
    println!(
        "faceted {faceted:.3}, smooth {corners:.3} and {centroids:.3}, false {sea_corners:.3} and {sea_centroids:.3}"
    );
    let close =
        |found: f64, expected: f64| assert!((found - expected).abs() < 0.05 * expected + 0.001, "{found}");
    close(faceted, 0.059);
    close(corners, 0.024);
    close(centroids, 0.016);
    close(sea_corners, 0.30);
    close(sea_centroids, 0.20);
    assert!(
        centroids < corners && corners < faceted && faceted < sea_centroids && sea_centroids < sea_corners
    );
}

#[test]
fn a_random_pattern_loses_contrast_towards_the_centres() {
    let cone = Cone::new(16, radians(75.0)).expect("a cone");
    let place = |vertex: faces::GridVertex| Vertex {
        place: DVec3::new(vertex.place[0], vertex.place[1], 0.0),
        normal: Some(cone.normal(Pattern::Random { seed: 3 }.number(vertex, 16))),
    };
    let wide = Board::new(1.0, 0..200, 0..200).expect("a board");
    let sea = wide.cut("sea", (WHITE, Shading::Smooth), 80_000, place).expect("a sea").mesh;
    let normals = CornerNormals::new(&sea, Weights::Equal);
    let elevation = radians(60.0);
    let spread = |light: Vec<f64>| {
        let mean = light.iter().sum::<f64>() / light.len() as f64;
        (light.iter().map(|one| (one - mean) * (one - mean)).sum::<f64>() / light.len() as f64).sqrt()
    };
    let [corners, centroids] = light(&normals, 80_000, sun_vector(1.0, elevation)).map(spread);
    let amplitude = cone.amplitude(elevation);
    assert!((corners * 2.0_f64.sqrt() / amplitude - 1.0).abs() < 0.02, "{corners}");
    assert!((centroids * 6.0_f64.sqrt() / amplitude - 1.0).abs() < 0.02, "{centroids}");
}
