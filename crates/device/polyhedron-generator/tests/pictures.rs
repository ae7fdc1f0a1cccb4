//! Spans against closed forms and against rays.

use std::sync::Arc;

use glam::{DMat3, DVec3, EulerRot};
use polyhedron_generator::{
    Census, Drawn, FaceLight, Field, LeftOut, NoHold, Overlay, PolyhedronGenerator, Sight, Span, ViewPlane,
};
use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, Strategy, prop_assert, prop_assert_eq, proptest};
use proptest::sample::select;
use scenario::{BodyShading, BodyVisibility, Curvature, PixelRule, Projection};
use solids::{Body, Kind, Solid, rocks};

const LAWS: [Projection; 3] = [Projection::Exact, Projection::AsReported, Projection::Corrected];
const LINES: usize = 200;

fn view(projection: Projection, eye: [f64; 3], heading: f64, pitch: f64) -> ViewPlane {
    let curvature = Curvature::None;
    ViewPlane { eye, heading, pitch, projection, curvature, tan_half_height: 0.3, lines: LINES as f64 }
}

fn tangents(edge: f64, sweeps: usize) -> Vec<f64> {
    let count = sweeps as f64;
    (0..sweeps).map(|sweep| edge * (2.0 * sweep as f64 + 1.0 - count) / count).collect()
}

fn boxed(low: [f64; 3], high: [f64; 3], object: u32) -> Body {
    let (low, high) = (DVec3::from_array(low), DVec3::from_array(high));
    let foot = ((low + high) * 0.5).truncate().extend(0.0);
    let solid = Arc::new(Solid::boxed(low - foot, high - foot, 0.8).unwrap());
    Body::place(object, Kind::Culture, &solid, foot, &DMat3::IDENTITY, 1.0)
}

fn light() -> FaceLight {
    FaceLight { sun: DVec3::new(-0.6, 0.48, 0.64), shading: BodyShading::Flat }
}

fn run<'a>(
    view: &ViewPlane,
    tangents: &[f64],
    bodies: impl IntoIterator<Item = &'a Body>,
) -> (PolyhedronGenerator, Census) {
    run_under(&light(), view, tangents, bodies)
}

fn run_under<'a>(
    light: &FaceLight,
    view: &ViewPlane,
    tangents: &[f64],
    bodies: impl IntoIterator<Item = &'a Body>,
) -> (PolyhedronGenerator, Census) {
    let mut generator = PolyhedronGenerator::default();
    let field = Field::new(view, tangents);
    let bodies: Vec<_> = bodies.into_iter().collect();
    let drawn = |body: &&'a Body| Some(Drawn { aspect: field.aspect(body)?, dark: false });
    let census = generator.run(&field, light, &bodies, drawn);
    (generator, census)
}

/// No ground in front of anything.
const OPEN: Option<&NoHold> = None;

#[test]
fn a_cube_straight_ahead_has_its_closed_form_at_every_sweep() {
    let cube = boxed([9.0, -1.0, 0.0], [11.0, 1.0, 2.0], 4);
    let tangents = tangents(0.4, 161);
    for projection in LAWS {
        let (generator, census) = run(&view(projection, [0.0, 0.0, 1.5], 0.0, 0.0), &tangents, [&cube]);
        assert_eq!((census.drawn, census.vertices), (1, 8));
        for (sweep, &tangent) in tangents.iter().enumerate() {
            let spans = generator.table().sweep(sweep).spans();
            if tangent.abs() > 1.0 / 9.0 {
                assert_eq!(spans, [], "{projection:?}, sweep {sweep}");
                continue;
            }
            // The front face alone: from 0.5 m above to 1.5 m below the eye, 9 m ahead.
            let &[Span { top, bottom, reflectivity, ramp, near, depth, body, object, foot_range }] = spans
            else {
                panic!("{spans:?}");
            };
            let line = |y: f64| ((y / 0.3 + 1.0) * 0.5 * LINES as f64) as f32;
            assert!((top - line(-0.5 / 9.0)).abs() < 1e-4 && (bottom - line(1.5 / 9.0)).abs() < 1e-4);
            let range = (9.0 * (1.0 + tangent * tangent).sqrt()) as f32;
            assert!(near.iter().all(|near| (near * range - 1.0).abs() < 1e-6));
            assert!(depth.iter().all(|depth| (depth * 9.0 - 1.0).abs() < 1e-6));
            assert!((reflectivity - 0.48).abs() < 1e-6, "0.8 of 0.6");
            assert_eq!((body, object, foot_range, ramp), (0, 4, 10.0, 0.0));
        }
    }
}

#[test]
fn with_pitch_level_edges_stay_level_and_sweeps_lie_where_the_law_says() {
    let cube = boxed([9.0, -1.0, 0.0], [11.0, 1.0, 1.2], 0);
    let (pitch, tangents) = (-0.12, tangents(0.2, 301));
    let (sin, cos) = (libm::sin(pitch), libm::cos(pitch));
    // Y of a point `up` over the eye and `ahead` of it, on the centre sweep and (level edges) on all others.
    let y = |ahead: f64, up: f64| (sin * ahead - cos * up) / (cos * ahead + sin * up);
    for projection in LAWS {
        let (generator, _) = run(&view(projection, [0.0, 0.0, 1.5], 0.0, pitch), &tangents, [&cube]);
        for (sweep, &tangent) in tangents.iter().enumerate() {
            let straight = projection == Projection::Exact;
            // Side edges of the front face: Exact has them at one azimuth, the others at the top's X.
            let widest = if straight { 1.0 / 9.0 } else { 1.0 / (9.0 * cos - 0.3 * sin) };
            if tangent.abs() > widest - 1e-3 {
                continue;
            }
            let line = |y: f64| ((y / 0.3 + 1.0) * 0.5 * LINES as f64) as f32;
            let spans = generator.table().sweep(sweep).spans();
            let front = spans.iter().find(|span| (span.reflectivity - 0.48).abs() < 1e-5).unwrap();
            assert!((front.top - line(y(9.0, -0.3))).abs() < 1e-4, "{projection:?} {sweep}: {front:?}");
            let top = spans.iter().find(|span| (span.reflectivity - 0.512).abs() < 1e-5).unwrap();
            assert!((top.bottom - front.top).abs() < 1e-4);
            if tangent.abs() < 0.9 / 11.0 {
                assert!((top.top - line(y(11.0, -0.3))).abs() < 1e-4);
                let (half, lateral) = (0.5 * (top.top + top.bottom) as f64, tangent);
                let y = (half / (0.5 * LINES as f64) - 1.0) * 0.3;
                let (forward, x) =
                    (cos + y * sin, if straight { lateral * (cos + y * sin) } else { lateral });
                let range = 0.3 / (y * cos - sin) * (forward * forward + x * x).sqrt();
                let middle = f64::from(top.near_at(0.5));
                assert!(
                    (middle * range - 1.0).abs() < if straight { 2e-6 } else { 1e-5 },
                    "{middle} {range}"
                );
            }
        }
    }
}

#[test]
fn behind_beside_and_too_near_is_skipped_and_counted() {
    let bodies = [
        boxed([-12.0, -1.0, 0.0], [-10.0, 1.0, 2.0], 0),
        boxed([5.0, 20.0, 0.0], [7.0, 22.0, 2.0], 1),
        boxed([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0], 2),
        boxed([0.04, -0.1, 1.0], [2.0, 0.1, 2.0], 3),
        boxed([0.06, -0.1, 1.0], [2.0, 0.1, 1.4], 4),
    ];
    let view = view(Projection::Exact, [0.0, 0.0, 1.5], 0.0, 0.0);
    let (generator, census) = run(&view, &tangents(0.4, 50), &bodies);
    assert_eq!((census.too_near, census.drawn), (2, 1));
    assert!((0..50).all(|sweep| generator.table().sweep(sweep).spans().iter().all(|span| span.object == 4)));
    assert!(!generator.table().is_empty());
    assert_eq!(generator.table().sweep(50).spans(), []);
}

#[test]
fn a_body_in_shadow_is_black_and_the_table_forgets_the_last_frame() {
    let cube = boxed([9.0, -1.0, 0.0], [11.0, 1.0, 2.0], 0);
    let (mut generator, tangents) = (PolyhedronGenerator::default(), tangents(0.4, 41));
    let view = view(Projection::Exact, [0.0, 0.0, 1.5], 0.0, 0.0);
    let field = Field::new(&view, &tangents);
    let dark = |(): &()| Some(Drawn { aspect: field.aspect(&cube)?, dark: true });
    generator.run(&field, &light(), &[()], dark);
    assert_eq!(generator.table().sweep(20).spans()[0].reflectivity, 0.0);
    let mut overlay = Overlay::default();
    let mut row = [0.7; LINES];
    overlay.overlay(generator.table().sweep(20), BodyVisibility::Depth, OPEN, PixelRule::Centre, &mut row);
    assert!(row.contains(&0.0), "a black body is there all the same");
    generator.run(&Field::new(&view, &tangents), &light(), &[], dark);
    assert!(generator.table().is_empty());
}

#[test]
fn far_bodies_sink_with_the_lunoid() {
    let tower = boxed([2000.0, -50.0, 0.0], [2010.0, 50.0, 100.0], 0);
    let flat = view(Projection::Exact, [0.0, 0.0, 1.5], 0.0, 0.0);
    let curved = ViewPlane { curvature: Curvature::Parabolic, ..flat };
    let top = |view: &ViewPlane| run(view, &[0.0], [&tower]).0.table().sweep(0).spans()[0].top;
    let drop = 2005.0 * 2005.0 / (2.0 * 1_737_400.0) / 2000.0 / 0.3 * 100.0;
    assert!((top(&curved) - top(&flat) - drop as f32).abs() < 1e-3);
}

#[test]
fn maximum_viewing_distance_of_the_report() {
    // 1000 lines of 30 degrees: 1909.86 m for 1 m, and 1653.99 m for a cube of 0.5 m, 0.866 m across.
    let sight = Sight::new(1000.0, std::f64::consts::PI / 6.0);
    let rock = |north: f64| boxed([north, -0.25, -0.25], [north + 0.5, 0.25, 0.25], 0);
    let mut left_out = LeftOut::default();
    // The sphere around it begins 0.183 m before its front.
    assert!(sight.resolves(DVec3::ZERO, &rock(1654.16), &mut left_out));
    assert_eq!(left_out, LeftOut::default());
    assert!(!sight.resolves(DVec3::ZERO, &rock(1654.18), &mut left_out));
    assert_eq!(left_out.bodies, 1);
    assert!((left_out.cells - 1.0).abs() < 1e-4, "{}", left_out.cells);
    // At twice the distance half a cell each way.
    assert!(!sight.resolves(DVec3::ZERO, &rock(3308.15), &mut left_out));
    assert_eq!(left_out.bodies, 2);
    assert!((left_out.cells - 1.25).abs() < 1e-3, "{}", left_out.cells);
}

/// What a ray through a point of the view-plane meets first, by the planes of the bodies.
fn ray_cast(view: &ViewPlane, bodies: &[Body], tangent: f64, y: f64) -> Option<f64> {
    let (sin, cos) = (libm::sin(view.pitch), libm::cos(view.pitch));
    let (sin_heading, cos_heading) = (libm::sin(view.heading), libm::cos(view.heading));
    let forward = cos + y * sin;
    let x = if view.projection == Projection::Exact { tangent * forward } else { tangent };
    let direction = DVec3::new(
        cos_heading * forward - sin_heading * x,
        sin_heading * forward + cos_heading * x,
        sin - y * cos,
    );
    let eye = DVec3::from_array(view.eye);
    let hits = bodies.iter().filter_map(|body| Some((body.first_hit(eye, direction, 0.0)?, body)));
    let (hit, body) = hits.min_by(|a, b| a.0.distance.total_cmp(&b.0.distance))?;
    body.reflectivities(light().sun).nth(hit.face)
}

fn stones() -> impl Strategy<Value = Vec<Body>> {
    let stone = (0..rocks::SHAPES, [2.5..9.0f64, -2.0..2.0, -0.8..0.8], 0.0..6.0f64, 0.4..2.5f64);
    vec(stone, 1..7).prop_map(|stones| {
        let shapes: Vec<Arc<Solid>> = rocks::shapes(5).unwrap().into_iter().map(Arc::new).collect();
        let body = |(index, (shape, foot, turn, size)): (usize, (usize, [f64; 3], f64, f64))| {
            let turn = DMat3::from_rotation_z(turn) * DMat3::from_rotation_y(0.5 * turn);
            Body::place(index as u32, Kind::Rock, &shapes[shape], DVec3::from_array(foot), &turn, size)
        };
        stones.into_iter().enumerate().map(body).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn lines_show_what_rays_meet(
        bodies in stones(),
        projection in select(&LAWS[..]),
        pitch in -0.4..0.4f64,
        heading in -0.3..0.3f64,
    ) {
        let view = view(projection, [0.3, 0.1, 0.4], heading, pitch);
        let tangents = tangents(0.45, 37);
        let near = |body: &Body| body.vertices().any(|vertex| {
            let away = vertex - DVec3::from_array(view.eye);
            let level = away.x * libm::cos(heading) + away.y * libm::sin(heading);
            libm::cos(pitch) * level + libm::sin(pitch) * away.z <= 0.06
        });
        let bodies: Vec<Body> = bodies.into_iter().filter(|body| !near(body)).collect();
        let (generator, census) = run(&view, &tangents, &bodies);
        prop_assert!(census.too_near == 0);
        let mut overlay = Overlay::default();
        for (sweep, &tangent) in tangents.iter().enumerate() {
            let mut row = [-1f32; LINES];
            overlay.overlay(generator.table().sweep(sweep), BodyVisibility::Depth, OPEN, PixelRule::Centre, &mut row);
            for (line, &found) in row.iter().enumerate() {
                let ray = |off: f64| {
                    let y = ((line as f64 + 0.5 + off) / (0.5 * LINES as f64) - 1.0) * view.tan_half_height;
                    ray_cast(&view, &bodies, tangent, y).unwrap_or(-1.0)
                };
                let met = ray(0.0);
                // An edge within a thousandth of a line may go either way.
                let at_edge = ray(-1e-3) != met || ray(1e-3) != met;
                prop_assert!(at_edge || (f64::from(found) - met).abs() < 1e-6, "sweep {sweep}, line {line}: {found}, {met}");
            }
        }
    }

    #[test]
    fn line_means_are_means_of_what_rays_meet(bodies in stones(), pitch in -0.3..0.3f64) {
        let view = view(Projection::Exact, [-1.0, 0.0, 0.4], 0.0, pitch);
        let tangents = [-0.07, 0.02, 0.11];
        let (generator, _) = run(&view, &tangents, &bodies);
        let mut overlay = Overlay::default();
        for (sweep, &tangent) in tangents.iter().enumerate() {
            let (mut row, mut gate) = ([0.25f32; LINES], [0f32; LINES]);
            overlay.overlay(generator.table().sweep(sweep), BodyVisibility::Depth, OPEN, PixelRule::LineMean, &mut row);
            overlay.present(PixelRule::LineMean, &mut gate);
            const PARTS: usize = 100;
            for line in 0..LINES {
                let mut mean = [0.0; 2];
                for part in 0..PARTS {
                    let place = line as f64 + (part as f64 + 0.5) / PARTS as f64;
                    let y = (place / (0.5 * LINES as f64) - 1.0) * view.tan_half_height;
                    let met = ray_cast(&view, &bodies, tangent, y);
                    mean[0] += met.unwrap_or(0.25) / PARTS as f64;
                    mean[1] += f64::from(u8::from(met.is_some())) / PARTS as f64;
                }
                prop_assert!((f64::from(row[line]) - mean[0]).abs() < 0.03, "line {line}: {}, {}", row[line], mean[0]);
                prop_assert!((f64::from(gate[line]) - mean[1]).abs() < 0.03);
            }
        }
    }
}

/// A rock of the shapes of a seed with normals at its corners, before an eye at the origin that looks north.
fn round_rock(shape: usize, foot: [f64; 3], turns: [f64; 3]) -> Body {
    let solid = rocks::shapes(7).unwrap().swap_remove(shape).rounded();
    let turn = DMat3::from_euler(EulerRot::ZYX, turns[0], turns[1], turns[2]);
    Body::place(1, Kind::Rock, &Arc::new(solid), DVec3::from_array(foot), &turn, 1.5)
}

/// Triangles of a body that look at the eye, from the first corner of each face: places on the view-plane, and light at the corners.
fn triangles(body: &Body) -> Vec<[[f64; 3]; 3]> {
    let (turn, _) = body.to_ground();
    let vertices: Vec<DVec3> = body.vertices().collect();
    let mut triangles = Vec::new();
    for (number, (face, normal)) in body.solid.faces().iter().zip(body.normals()).enumerate() {
        if normal.dot(vertices[face.corners[0] as usize]) >= 0.0 {
            continue;
        }
        let normals = body.solid.corner_normals(number).unwrap();
        let corner = |at: usize| {
            let place = vertices[face.corners[at] as usize];
            let light = face.albedo * (turn * normals[at]).dot(light().sun).max(0.0);
            [place.y / place.x, -place.z / place.x, light]
        };
        triangles.extend((2..face.corners.len()).map(|last| [0, last - 1, last].map(corner)));
    }
    triangles
}

/// How far inside the nearest triangle a place of the view-plane is, and the light of that triangle there, in proportion.
fn light_on(triangles: &[[[f64; 3]; 3]], [x, y]: [f64; 2]) -> (f64, f64) {
    let area =
        |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let of = |corners: &[[f64; 3]; 3]| {
        let [a, b, c] = corners.map(|[x, y, _]| [x, y]);
        let at = [x, y];
        let shares = [area(at, b, c), area(a, at, c), area(a, b, at)].map(|part| part / area(a, b, c));
        let light = (0..3).map(|corner| shares[corner] * corners[corner][2]).sum();
        (shares.into_iter().fold(f64::INFINITY, f64::min), light)
    };
    triangles.iter().map(of).max_by(|(a, _), (b, _)| a.total_cmp(b)).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Rocks in the picture as a whole and in part: reflectivity runs along each sweep as it does on the triangles.
    #[test]
    fn smooth_light_is_linear_over_each_triangle(
        shape in 0..rocks::SHAPES,
        foot in [4.0..12.0f64, -2.0..2.0, -2.5..1.5],
        turns in [-3.0..3.0f64, -3.0..3.0, -3.0..3.0],
    ) {
        let body = round_rock(shape, foot, turns);
        let view = view(Projection::Exact, [0.0; 3], 0.0, 0.0);
        let tangents = tangents(0.4, 97);
        let smooth = FaceLight { shading: BodyShading::Smooth, ..light() };
        let (generator, census) = run_under(&smooth, &view, &tangents, [&body]);
        prop_assert_eq!(census.ramp_words, 2 * census.spans);
        let triangles = triangles(&body);
        for (sweep, &tangent) in tangents.iter().enumerate() {
            for span in generator.table().sweep(sweep).spans() {
                for share in [0.1, 0.5, 0.9] {
                    let line = span.line_at(share);
                    let y = (f64::from(line) / (0.5 * LINES as f64) - 1.0) * 0.3;
                    let (inside, expected) = light_on(&triangles, [tangent, y]);
                    // Beside an edge, rounding decides whose light it is.
                    if inside > 1e-3 && span.bottom - span.top > 0.01 {
                        let found = f64::from(span.reflectivity + span.ramp * (line - span.top));
                        prop_assert!((found - expected).abs() < 1e-3, "{found} {expected}");
                    }
                }
            }
        }
        // The outline is that of the body with flat light, whose picture does not know of normals.
        let flat_solid = rocks::shapes(7).unwrap().swap_remove(shape);
        let flat_body = body.rounded(&Arc::new(flat_solid));
        let (flat, none) = run(&view, &tangents, [&body]);
        let (plain, _) = run(&view, &tangents, [&flat_body]);
        prop_assert_eq!(none.ramp_words, 0);
        for sweep in 0..tangents.len() {
            let [flat, plain, smooth] = [&flat, &plain, &generator].map(|of| of.table().sweep(sweep).spans());
            prop_assert_eq!(flat, plain);
            let covered = |spans: &[Span]| spans.iter().map(|span| span.bottom - span.top).sum::<f32>();
            prop_assert!((covered(smooth) - covered(flat)).abs() < 1e-3);
        }
    }
}

#[test]
fn a_rounded_rock_in_shadow_is_black() {
    let body = round_rock(0, [6.0, 0.0, -1.0], [0.3, 0.1, 0.0]);
    let view = view(Projection::Exact, [0.0; 3], 0.0, 0.0);
    let tangents = tangents(0.4, 97);
    let field = Field::new(&view, &tangents);
    let smooth = FaceLight { shading: BodyShading::Smooth, ..light() };
    let mut generator = PolyhedronGenerator::default();
    let census =
        generator.run(&field, &smooth, &[()], |()| Some(Drawn { aspect: field.aspect(&body)?, dark: true }));
    assert!(census.spans > 20, "{census:?}");
    for sweep in 0..tangents.len() {
        let spans = generator.table().sweep(sweep).spans();
        assert!(spans.iter().all(|span| span.reflectivity == 0.0 && span.ramp == 0.0));
    }
}
