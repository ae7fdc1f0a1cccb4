//! Coarser panels: a ground without cracks, beside the panels by no more than is allowed.

use std::collections::HashMap;
use std::sync::Arc;

use generator::PlaneKind;
use glam::DVec3;
use panels::{Bounds, Choice, Diagonal, Mesh, Parameters};
use photo_drape::Ground;
use proptest::prelude::*;
use scenario::{Curvature, FieldOfView, Pose, View};
use scene_sampler::Camera;

use crate::shots::{SIDE, draw, landscape, light, photograph, pose, run, session, sky, stage, waves};

/// Panels of hilly ground of some metres to the north and east, with posts `spacing` apart.
fn mesh([north, east]: [f64; 2], spacing: f64, diagonal: Diagonal) -> Mesh {
    let ground = Ground::new(&landscape(9.0), [0.0, 0.0, north, east], spacing).unwrap();
    Mesh::new(Arc::new(ground), diagonal)
}

fn view(half: f64, curvature: Curvature) -> View {
    let mut view = stage(landscape(0.0), Vec::new(), 200, half).view;
    view.field = FieldOfView { tan_half_width: half, tan_half_height: half };
    view.laws.curvature = curvature;
    view
}

fn choice(mesh: &Mesh, pose: &Pose, view: &View, pixels: f64) -> Choice {
    let bounds = Bounds::new(mesh, view.laws.curvature);
    Choice::new(mesh, &bounds, &Camera::new(pose, view), pixels)
}

/// Places of the corners of all triangles.
fn triangles<'a>(mesh: &'a Mesh, choice: &'a Choice) -> impl Iterator<Item = [DVec3; 3]> + use<'a> {
    choice.triangles.iter().map(|corners| corners.map(|corner| mesh.vertex(choice.posts[corner as usize])))
}

/// Twice the area on the map, above 0 where corners run counter-clockwise seen from above.
fn doubled_area([a, b, c]: [DVec3; 3]) -> f64 {
    let [b, c] = [b - a, c - a];
    b.y * c.x - b.x * c.y
}

/// Sides that have a triangle on one side alone, by the posts at their ends.
fn open_sides(choice: &Choice) -> Vec<[u32; 2]> {
    let mut sides = HashMap::new();
    for corners in &choice.triangles {
        for side in 0..3 {
            let ends = [corners[side], corners[(side + 1) % 3]];
            assert_eq!(sides.insert(ends, ()), None, "two triangles on one side of a side");
        }
    }
    let open = sides.keys().filter(|[a, b]| !sides.contains_key(&[*b, *a]));
    open.map(|ends| ends.map(|end| choice.posts[end as usize])).collect()
}

/// An eye over the south-western corner that sees all of the ground ahead, and an allowance (pixels).
fn eyes() -> impl Strategy<Value = (Pose, f64)> {
    (1.0..200.0, 20.0..70.0, 0.05..40.0)
        .prop_map(|(height, heading, pixels)| (pose([-300.0, -300.0, height], heading, -20.0), pixels))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Whatever is halved, the triangles cover all ground once, and only its border has one side.
    #[test]
    fn the_ground_is_covered_once_and_has_no_crack(
        (pose, pixels) in eyes(),
        size in (20.0..SIDE, 20.0..SIDE),
        spacing in 3.0..9.0,
        is_stated in any::<bool>(),
    ) {
        let diagonal = if is_stated { Diagonal::Stated } else { Diagonal::Shorter };
        let mesh = mesh([size.0, size.1], spacing, diagonal);
        let choice = choice(&mesh, &pose, &view(30.0, Curvature::None), pixels);
        let areas: Vec<f64> = triangles(&mesh, &choice).map(doubled_area).collect();
        prop_assert!(areas.iter().all(|area| *area > 0.0));
        let [rows, columns] = mesh.ground().size();
        let cells = (rows - 1) * (columns - 1);
        prop_assert!((areas.iter().sum::<f64>() / (2.0 * cells as f64 * spacing * spacing) - 1.0).abs() < 1e-9);
        let last = [rows - 1, columns - 1];
        for ends in open_sides(&choice) {
            let [a, b] = ends.map(|post| [post as usize / columns, post as usize % columns]);
            let is_border = (0..2).any(|axis| a[axis] == b[axis] && [0, last[axis]].contains(&a[axis]));
            prop_assert!(is_border, "{a:?} to {b:?} of {rows} x {columns}");
        }
    }
}

/// Without an allowance the triangles are the panels, with their own diagonals.
#[test]
fn as_fine_as_can_be_they_are_the_panels() {
    for (size, diagonal) in [
        ([160.0, 310.0], Diagonal::Shorter),
        ([160.0, 160.0], Diagonal::Stated),
        ([5.0, 5.0], Diagonal::Stated),
    ] {
        let mesh = mesh(size, 5.0, diagonal);
        let choice =
            choice(&mesh, &pose([-20.0, -20.0, 30.0], 45.0, -30.0), &view(50.0, Curvature::None), 0.0);
        let turned = |[a, b, c]: [u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap();
        let mut found: Vec<_> = choice
            .triangles
            .iter()
            .map(|corners| turned(corners.map(|corner| choice.posts[corner as usize])))
            .collect();
        let mut expected: Vec<_> = mesh.panels().iter().copied().map(turned).collect();
        found.sort_unstable();
        expected.sort_unstable();
        assert!(found == expected, "{size:?}, {diagonal:?}: {} and {}", found.len(), expected.len());
    }
}

/// Height (m) of the panels at a place.
fn height(mesh: &Mesh, place: DVec3) -> f64 {
    let (cell, shares) = mesh.ground().cell([place.x, place.y]);
    let [a, b, c] = mesh.corners(mesh.panel_at(cell, shares));
    let normal = (b - a).cross(c - a);
    a.z - (normal.x * (place.x - a.x) + normal.y * (place.y - a.y)) / normal.z
}

/// Each place of the coarser ground lies so near the panels that they differ by no more pixels than is allowed.
#[test]
fn no_place_lies_farther_beside_the_panels_than_is_allowed() {
    let mesh = mesh([SIDE; 2], 2.0, Diagonal::Shorter);
    for curvature in [Curvature::None, Curvature::Parabolic, Curvature::Exact] {
        let view = view(0.5, curvature);
        for (pixels, eye) in
            [(0.5, pose([200.0, 20.0, 25.0], 80.0, -10.0)), (3.0, pose([-90.0, -80.0, 60.0], 40.0, -20.0))]
        {
            let camera = Camera::new(&eye, &view);
            let choice = choice(&mesh, &eye, &view, pixels);
            let mut most = 0.0_f64;
            for [a, b, c] in triangles(&mesh, &choice) {
                for step in 0..66 {
                    let (u, v) = (f64::from(step % 11) / 10.0, f64::from(step / 11) / 10.0);
                    if u + v > 1.0 {
                        continue;
                    }
                    let place = a + (b - a) * u + (c - a) * v;
                    let panel = DVec3::new(place.x, place.y, height(&mesh, place));
                    let [found, expected] = [place, panel].map(|place| camera.place(place));
                    if found.z < 1.0 || expected.z < 1.0 {
                        continue;
                    }
                    let [found, expected] = [found, expected].map(|place| camera.projection.project(place));
                    let is_shown = |at: [f64; 2]| at.iter().all(|at| (0.0..=200.0).contains(at));
                    if is_shown(expected) {
                        most = most.max(libm::hypot(found[0] - expected[0], found[1] - expected[1]));
                    }
                }
            }
            let panels = mesh.count();
            assert!(most <= pixels, "{curvature:?}: {most} pixels of {pixels}");
            assert!(most > 0.05 * pixels, "{curvature:?}: {most} pixels of {pixels}: more than is needed");
            assert!(choice.triangles.len() * 4 < panels, "{} of {panels} panels", choice.triangles.len());
        }
    }
}

/// Coarser panels give the picture of the panels. Outlines move by less than a pixel, and light hardly changes.
#[test]
fn the_picture_is_that_of_the_panels() {
    let pixels = 160;
    let make = |coarser_px| {
        let stage = stage(landscape(9.0), vec![photograph(800, 600.0, waves)], pixels as u32, 0.5);
        session(stage, Parameters { spacing: Some(1.0), coarser_px, ..run() })
    };
    let (fine, coarser) = (make(0.0), make(0.5));
    for eye in [pose([200.0, 20.0, 25.0], 80.0, -10.0), pose([200.0, 200.0, 250.0], 0.0, -90.0)] {
        let [expected, found] = [&fine, &coarser].map(|session| draw(&**session, pixels, &eye));
        let apart = light(&expected).iter().zip(light(&found)).map(|(a, b)| f64::from((a - b).abs()));
        let mean = apart.sum::<f64>() / (pixels * pixels) as f64;
        assert!(mean > 0.0 && mean < 2e-3, "{mean}");
        let off = sky(&expected).abs_diff(sky(&found));
        assert!(off <= pixels, "{off} pixels of sky more or less");
        if eye.attitude.pitch < -1.0 {
            assert_eq!(sky(&found), sky(&expected), "a crack would show sky");
        }
        let nearer = |planes: &generator::Planes| planes.get(PlaneKind::Distance).unwrap().to_vec();
        let far =
            nearer(&expected).into_iter().zip(nearer(&found)).filter(|(a, b)| (a / b - 1.0).abs() > 0.1);
        assert!(far.count() < pixels, "more than the outlines of hills");
    }
    let panels = |session: &dyn generator::Session| {
        let eye = pose([200.0, 20.0, 25.0], 80.0, -10.0);
        let mut planes = generator::Planes::new(pixels, pixels, &[PlaneKind::Intensity]);
        let counts = session.frame(0, &eye, &mut planes, &mut signal::Probe::off()).unwrap();
        counts.get("panels").unwrap()
    };
    let [all, some] = [&fine, &coarser].map(|session| panels(&**session));
    assert!(all == 2 * 400 * 400 && some * 8 < all, "{some} of {all} panels");
    // Whoever judges has all of them.
    let judged = |session: &dyn generator::Session| {
        session.faces(0, &pose([200.0, 20.0, 25.0], 80.0, -10.0)).unwrap().unwrap().faces
    };
    assert!(judged(&*fine) == judged(&*coarser));
}
