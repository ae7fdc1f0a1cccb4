//! Scan lines: directions, uncut faces, slots, threads.

use faces::{
    Cut, Face, Group, Interpolation, Mesh, Pattern, Ramp, Scan, ScreenCorner, SeaState, SunProgramme, Vertex,
};
use generator::PlaneKind;
use glam::DVec3;
use quantities::unit_interval;
use scenario::{Carrier, FaceKind, FaceList};
use smooth_faces::{Hardware, Parameters};

use crate::shots::{
    PIXELS, apart, draw, from_above, gear, light, pose, run, sea, sea_list, session, session_on, stage,
};

/// A diamond on the map whose corners are dark to the west and east, bright to the north and south, under a sun from straight above.
pub fn diamond() -> FaceList {
    let corner = |north: f64, east: f64, up: f64| Vertex {
        place: DVec3::new(150.0 + north, 100.0 + east, 0.0),
        normal: Some(DVec3::new(1.0 - up, 0.0, up).normalize()),
    };
    // A normal that lies has brightness 0, one that stands has 1.
    let vertices = vec![
        corner(30.0, 0.0, 1.0),
        corner(0.0, -30.0, 0.0),
        corner(-30.0, 0.0, 1.0),
        corner(0.0, 30.0, 0.0),
    ];
    let mesh = Mesh::load("diamond", vertices, vec![Face::smooth(vec![0, 1, 2, 3], [1.0; 3])]).unwrap().mesh;
    let zenith = faces::TurningSun::new(std::f64::consts::FRAC_PI_2, 0.0, faces::Turn::STILL).unwrap();
    let group = Group::new("diamond", mesh, 1).under(SunProgramme::Turning(zenith));
    FaceList::new(group, FaceKind::Effect, Carrier::Map(0.0))
}

#[test]
fn an_uncut_diamond_depends_on_the_direction_of_the_scan() {
    let middle = |scan, cut| {
        let run = Parameters { scan, cut, ..run() };
        let session = session(stage(vec![diamond()]), run);
        let picture = light(&*session, 0, &from_above());
        picture[PIXELS / 2 * PIXELS + PIXELS / 2]
    };
    let uncut = [Scan::Horizontal, Scan::Vertical].map(|scan| middle(scan, Cut::Uncut));
    assert!(uncut[0] < 0.05 && uncut[1] > 0.95, "0 against 1: {uncut:?}");
    let cut = [Scan::Horizontal, Scan::Vertical].map(|scan| middle(scan, Cut::Fan));
    assert!((cut[0] - cut[1]).abs() < 1e-6, "{cut:?}");
}

#[test]
fn cut_faces_are_the_same_in_both_directions() {
    for interpolation in [Interpolation::Screen, Interpolation::Perspective] {
        let [vertical, horizontal] = [Scan::Vertical, Scan::Horizontal].map(|scan| {
            let run = Parameters { scan, interpolation, ..run() };
            let sea = sea(SeaState::High, Pattern::Random { seed: 2 });
            light(&*session(stage(vec![sea_list(&sea)]), run), 9, &pose([100.0, 100.0, 20.0], 10.0, -40.0))
        });
        let apart = apart(&vertical, &horizontal);
        assert!(apart < 1e-5, "{interpolation:?}: {apart}");
    }
}

/// A triangle whose corners have depths and brightnesses of their own, and its corners on the screen from above.
fn steep_triangle(number: u64) -> (FaceList, [ScreenCorner; 3]) {
    let random = |corner: u64, of: u64| unit_interval(number, &[corner, of]);
    let sun = DVec3::Z;
    let corner = |corner: u64| {
        let place = DVec3::new(
            110.0 + 80.0 * random(corner, 0),
            60.0 + 80.0 * random(corner, 1),
            80.0 * random(corner, 2),
        );
        let elevation = std::f64::consts::FRAC_PI_2 * random(corner, 3);
        let normal = DVec3::new(libm::cos(elevation), 0.0, libm::sin(elevation));
        let depth = 120.0 - place.z;
        let at = [place.y - 100.0, 150.0 - place.x].map(|off| PIXELS as f64 * (0.5 + off / depth));
        let vertex = Vertex { place, normal: Some(normal) };
        (vertex, ScreenCorner { at, depth, brightness: normal.dot(sun) })
    };
    let corners = [0, 1, 2].map(corner);
    let vertices = corners.iter().map(|(vertex, _)| *vertex).collect();
    let face = Face::smooth(vec![0, 1, 2], [1.0; 3]).both_sides();
    let mesh = Mesh::load("triangle", vertices, vec![face]).unwrap().mesh;
    let zenith = faces::TurningSun::new(std::f64::consts::FRAC_PI_2, 0.0, faces::Turn::STILL).unwrap();
    let group = Group::new("triangle", mesh, 1).under(SunProgramme::Turning(zenith));
    (FaceList::new(group, FaceKind::Effect, Carrier::Map(0.0)), corners.map(|(_, corner)| corner))
}

/// The ramp of the picture is that of `faces::Ramp`, the plain form, in both directions and both interpolations.
#[test]
fn the_ramp_of_the_picture_is_that_of_the_plain_form() {
    let mut compared = 0;
    for number in 0..12 {
        let (list, corners) = steep_triangle(number);
        // From behind the normals are reversed: those faces are dark.
        let [a, b, c] = corners.map(|corner| corner.at);
        let turns = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        for (scan, interpolation) in [
            (Scan::Vertical, Interpolation::Screen),
            (Scan::Vertical, Interpolation::Perspective),
            (Scan::Horizontal, Interpolation::Screen),
            (Scan::Horizontal, Interpolation::Perspective),
        ] {
            let run = Parameters { scan, interpolation, ..run() };
            let picture = light(&*session(stage(vec![list.clone()]), run), 0, &from_above());
            for line in (0..PIXELS).filter(|_| turns < 0.0) {
                let Some(ramp) = Ramp::of(&corners, scan, line as f64 + 0.5, interpolation) else { continue };
                for place in 0..PIXELS {
                    let at = place as f64 + 0.5;
                    if at <= ramp.ends[0].at || at >= ramp.ends[1].at {
                        continue;
                    }
                    let pixel = match scan {
                        Scan::Vertical => place * PIXELS + line,
                        Scan::Horizontal => line * PIXELS + place,
                    };
                    let found = f64::from(picture[pixel]);
                    assert!(
                        (found - ramp.at(at)).abs() < 1e-6,
                        "{number} {scan:?} {interpolation:?}: {found} {}",
                        ramp.at(at)
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 2000, "{compared} samples");
}

#[test]
fn screen_and_space_differ_where_depths_do() {
    let [screen, space] = [Interpolation::Screen, Interpolation::Perspective].map(|interpolation| {
        let sea = sea(SeaState::High, Pattern::Random { seed: 2 });
        let session = session(stage(vec![sea_list(&sea)]), Parameters { interpolation, ..run() });
        let slant = light(&*session, 0, &pose([100.0, 100.0, 4.0], 0.0, -30.0));
        (slant, light(&*session, 0, &from_above()))
    });
    assert!(apart(&screen.0, &space.0) > 0.01, "{}", apart(&screen.0, &space.0));
    assert!(apart(&screen.1, &space.1) < 1e-6, "from above all depths are one");
}

#[test]
fn pieces_without_a_slot_are_missed_and_are_the_last_ones() {
    let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
    let with = |edges_line| {
        let session = session_on(stage(vec![sea_list(&sea)]), run(), Hardware { edges_line, ..gear() });
        draw(&*session, 0, &pose([10.0, 100.0, 30.0], 0.0, -20.0))
    };
    let (all, counts) = with(None);
    let asked = counts["crossings"];
    assert!(counts["missed"] == 0 && counts["most_crossings"] > 24);
    let (streaked, counts) = with(Some(24));
    // Every line asks for more than 24.
    assert_eq!(counts["missed"], asked - 24 * PIXELS as u64);
    let sky = f32::from(generator::Label::Sky.code());
    let [whole, holes] = [&all, &streaked]
        .map(|planes| planes.get(PlaneKind::Label).unwrap().iter().filter(|label| **label == sky).count());
    assert!(holes > whole, "{holes} {whole}");
}

#[test]
fn threads_change_no_bit() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let sea = sea(SeaState::High, Pattern::Random { seed: 1 });
            let run = Parameters { ground: Parameters::default().ground, ..run() };
            light(&*session(stage(vec![sea_list(&sea)]), run), 5, &pose([100.0, 100.0, 6.0], 20.0, -10.0))
        })
    };
    assert_eq!(with(1), with(3));
}
