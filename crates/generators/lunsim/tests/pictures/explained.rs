//! `explain` of a pixel against the planes of the same frame.

use generator::{Fact, PlaneKind, Planes};
use scenario::{Curvature, Laws, PixelRule};
use signal::Probe;

use crate::scenes::{bowl, plain, pose, prepare, settings, stage, sun};

const SIDE: usize = 60;
const EYE: [f64; 3] = [2500.0, 4000.0, 900.0];
const KINDS: [PlaneKind; 5] =
    [PlaneKind::Height, PlaneKind::Range, PlaneKind::Reflectivity, PlaneKind::Shadow, PlaneKind::Intensity];

/// The numbers of a fact.
fn numbers(facts: &[Fact], what: &str) -> Vec<f64> {
    let fact = facts.iter().find(|fact| fact.what == what).unwrap_or_else(|| panic!("no {what}: {facts:?}"));
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    fact.value.split(|c| !is_of_number(c)).filter_map(|word| word.parse().ok()).collect()
}

/// A bowl before an observer who looks to the north-east, so that no axis of the grid is one of the map.
#[test]
fn a_pixel_is_told_as_the_planes_have_it() {
    let mut settings = settings(SIDE as u32, 30.0, 128);
    settings.parameters.restrictions = false;
    settings.view.laws =
        Laws { curvature: Curvature::Parabolic, pixel_rule: PixelRule::Centre, ..settings.view.laws };
    let ground = plain(8000.0, vec![bowl([3500.0, 4700.0], 500.0, 150.0)]);
    let session = prepare(stage(&ground, sun(270.0, 15.0), &settings)).unwrap();
    let pose = pose(EYE, -30.0, 40.0);
    let mut planes = Planes::new(SIDE, SIDE, &KINDS);
    session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap();
    let (mut dark, mut below) = (0, 0);
    for pixel in (0..SIDE * SIDE).step_by(7) {
        let facts = session.explain(0, &pose, [pixel % SIDE, pixel / SIDE]).unwrap();
        let [height, range, reflectivity, shadow, intensity] =
            KINDS.map(|kind| f64::from(planes.get(kind).unwrap()[pixel]));
        let ground = numbers(&facts, "ground");
        assert!((ground[2] - height).abs() < 0.006, "{facts:?} {height}");
        assert!(
            (libm::hypot(ground[0] - EYE[0], ground[1] - EYE[1]) - range).abs() < 0.2,
            "{facts:?} {range}"
        );
        assert!((numbers(&facts, "light")[0] - reflectivity).abs() < 6e-5, "{facts:?} {reflectivity}");
        let is_dark = facts.iter().any(|fact| fact.what == "light" && fact.value.ends_with("in shadow"));
        assert_eq!(is_dark, shadow > 0.0, "{facts:?}");
        let [code, _, highest] = numbers(&facts, "code")[..] else { panic!("{facts:?}") };
        let grey = code / highest * settings.view.display.white;
        assert!((grey - intensity).abs() < 1e-6, "{facts:?} {intensity}");
        let [south, north, west, east, ..] = numbers(&facts, "viewed area")[..] else { panic!("{facts:?}") };
        assert!(
            (south - 1.0..north + 1.0).contains(&ground[0]) && (west - 1.0..east + 1.0).contains(&ground[1])
        );
        (dark, below) = (dark + usize::from(is_dark), below + usize::from(height < -50.0));
    }
    assert!(dark > 5 && below > 5, "{dark} {below}");
}
