//! First light's definition of done: same laws and pixel rule, default range programme, 1000 samples; at most
//! 0.5 % of the pixels off by more than 2 grey levels outside the mask of edges, ridge lines within one line.

use lunoid_tests::Shipped;
use lunoid_tests::shipped::{FULL_LANDSCAPE, TERRAIN};

/// Half of the sweeps: the full raster is for `--example agreement` in release.
fn halved(name: &str) -> Shipped {
    let sweeps = Shipped::read(name, None).settings.raster.sweeps;
    Shipped::read(name, Some(sweeps / 2))
}

#[test]
fn terrain_agrees_with_exact() {
    for name in TERRAIN {
        let shipped = halved(name);
        assert_eq!(shipped.settings.raster.samples, 1000, "{name}");
        let frame = shipped.frames() / 2;
        let found = shipped.agreement(frame);
        println!("{name} frame {frame}: {found:?}");
        assert!(found.off <= 0.005, "{name} frame {frame}: {found:?}");
        assert!(found.masked <= 0.2, "{name} frame {frame}: a mask must not hide the picture, {found:?}");
        assert!(found.ridge <= 1, "{name} frame {frame}: {found:?}");
    }
}

/// The full landscape at a small raster. A line covers four times the ground that it covers at the full one, so `exact`
/// itself sees less of fine grain in it, and the tolerance is twice that of the full raster (docs/measuring.md). A turned
/// picture is read from between the lines and sweeps: there it is that of the spot.
fn small_landscapes_agree_with_exact(names: &[&str]) {
    assert!(!names.is_empty());
    for name in names {
        let shipped = Shipped::read(name, Some(240));
        let found = shipped.agreement(shipped.frames() / 2);
        println!("{name}: {found:?}");
        let turned = shipped.settings.yoke.is_some();
        assert!(found.off <= if turned { 0.02 } else { 0.01 }, "{name}: {found:?}");
        assert!(found.masked <= 0.5, "{name}: a mask must not hide the picture, {found:?}");
    }
}

#[test]
fn the_first_of_the_full_landscapes_agrees_with_exact() {
    small_landscapes_agree_with_exact(&FULL_LANDSCAPE[..1]);
}

#[test]
#[ignore = "long: .ci/long runs it"]
fn the_other_full_landscapes_agree_with_exact() {
    small_landscapes_agree_with_exact(&FULL_LANDSCAPE[1..]);
}

#[test]
fn a_wrong_law_is_noticed() {
    let mut shipped = Shipped::read("rough-ride", Some(240));
    let exact = shipped.exact(20);
    shipped.settings.laws.projection = scenario::Projection::AsReported;
    let machine = shipped.machine(20);
    let found = compare::compare(&machine.picture, &exact.picture, None, &[2]).unwrap();
    assert!(found.beyond[0].share > 0.1, "{:?}", found.beyond);
}
