//! Boulders by distance: all of their faces when near, few when far, none below a pixel.

use generator::{Label, PlaneKind, Planes};
use glam::DVec3;
use lod_mesh::Parameters;
use signal::Probe;

use crate::faults::with_boulder;
use crate::shots::{pose, run, session};

const PIXELS: usize = 64;

/// Faces other than the ground's, and pixels of boulder, with a boulder of about 10 m below an eye so far (m) above.
fn shown(above: f64, least: f64) -> (u64, usize) {
    let session =
        session(with_boulder(DVec3::new(800.0, 800.0, 30.0)), Parameters { boulder_px: least, ..run() });
    let mut planes = Planes::new(PIXELS, PIXELS, &[PlaneKind::Label]);
    let eye = pose([800.0, 800.0, 30.0 + above], 0.0, -90.0);
    let counts = session.frame(0, &eye, &mut planes, &mut Probe::off()).unwrap();
    let rock = f32::from(Label::Rock.code());
    let pixels = planes.get(PlaneKind::Label).unwrap().iter().filter(|label| **label == rock).count();
    (counts["faces"] - counts["ground_triangles"], pixels)
}

#[test]
fn a_boulder_has_fewer_faces_the_farther_it_is() {
    let (all, _) = shown(60.0, 0.0);
    assert!(all > 8, "{all}");
    // 64 pixels are 53 degrees: a metre in 64 m is a pixel.
    assert_eq!(shown(60.0, 1.0).0, all, "more than twelve pixels");
    assert_eq!(shown(200.0, 1.0).0, 8, "an octahedron");
    assert_eq!(shown(200.0, 0.0).0, all, "all are asked for");
    assert_eq!(shown(3000.0, 1.0), (0, 0), "less than a pixel");
}

/// Between one and two least diameters it grows from nothing to its size.
#[test]
fn a_boulder_grows_from_nothing() {
    // Its diameter in pixels: the least one that is drawn, at which it vanishes.
    let [mut drawn, mut gone] = [1.0, 40.0];
    for _ in 0..12 {
        let middle = (drawn + gone) / 2.0;
        if shown(100.0, middle).0 == 0 { gone = middle } else { drawn = middle }
    }
    let pixels = [2.0, 1.7, 1.4, 1.2, 1.0].map(|diameters| shown(100.0, gone / diameters).1);
    assert!(pixels.windows(2).all(|pair| pair[1] < pair[0]), "{pixels:?}");
    assert_eq!(pixels[4], 0);
}
