//! Shadows that can be told in advance.

use crate::common::{flat, landscape, mountain, ray_is_blocked, winding};
use features::{Crater, Shape};
use landscape::Sun;
use quantities::{radians, sin_cos};
use remote_shadow::{Resolution, ShadowBank, Tile};
use std::sync::Arc;

/// Ranges (m) along a line from `start` at which the winding of the boundaries changes.
fn changes(tiles: &[Arc<Tile>], start: [f64; 2], direction: [f64; 2], length: f64) -> Vec<f64> {
    let at = |way: f64| winding(tiles, [0, 1].map(|axis: usize| start[axis] + way * direction[axis]));
    let step = 0.37;
    let mut found = Vec::new();
    let mut way = 0.0;
    while way < length {
        if at(way) != at(way + step) {
            let (mut low, mut high) = (way, way + step);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if at(middle) == at(low) { low = middle } else { high = middle }
            }
            found.push(high);
        }
        way += step;
    }
    found
}

/// Section 11.1: in a bowl the shadow ends `r1 (1 - r1 tan e / a)` beyond the centre; 23.4 has the number.
#[test]
fn the_shadow_in_a_bowl_ends_where_it_must() {
    let bowl = Crater::new([320.0, 320.0], Shape::Bowl { r1: 100.0 }, 20.0, 0.0).unwrap();
    let bank = ShadowBank::new(
        Arc::new(landscape(&flat(640.0), vec![bowl])),
        Resolution { finest: 0.5, angle: 0.0 },
    );
    for azimuth in [0.0, 37.0, 90.0, 200.0] {
        let sun = Sun { azimuth: radians(azimuth), elevation: radians(5.0) };
        let tiles = bank.around(&sun, [320.0, 320.0], 140.0, None);
        let (sin, cos) = sin_cos(sun.azimuth);
        // Beside the middle by 1 mm: profiles pass through the centre only by chance.
        let start = [320.0 + 120.0 * cos - 1e-3 * sin, 320.0 + 120.0 * sin + 1e-3 * cos];
        let found = changes(&tiles, start, [-cos, -sin], 230.0);
        assert_eq!(found.len(), 2, "{azimuth}: {found:?}");
        assert!((found[0] - 20.0).abs() < 2e-3, "{azimuth}: starts {} m before the centre", 120.0 - found[0]);
        assert!((found[1] - 120.0 - 56.25566823703998).abs() < 2e-3, "{azimuth}: {}", found[1] - 120.0);
    }
}

#[test]
fn a_sun_in_the_zenith_casts_nothing() {
    let bank = ShadowBank::new(Arc::new(crate::common::cratered(3)), Resolution { finest: 1.0, angle: 0.0 });
    assert!(bank.around(&Sun { azimuth: 1.0, elevation: radians(90.0) }, [320.0; 2], 100.0, None).is_empty());
    let steep = Sun { azimuth: 1.0, elevation: radians(80.0) };
    assert!(bank.around(&steep, [320.0; 2], 100.0, None).iter().all(|tile| tile.outlines.is_empty()));
}

#[test]
fn below_the_horizon_all_is_dark() {
    let land = landscape(&flat(640.0), Vec::new());
    let bank = ShadowBank::new(Arc::new(land), Resolution { finest: 1.0, angle: 0.0 });
    let tiles = bank.around(&Sun { azimuth: 0.3, elevation: -0.02 }, [320.0; 2], 100.0, None);
    assert_eq!(winding(&tiles, [313.3, 340.1]), 1);
    let not_a_number = Sun { azimuth: f64::NAN, elevation: 0.1 };
    assert!(bank.around(&not_a_number, [320.0; 2], 100.0, None).is_empty());
}

#[test]
fn a_mountain_many_kilometres_away_throws_its_shadow() {
    let land = Arc::new(mountain([20_000.0, 2000.0], 300.0));
    let bank = ShadowBank::new(land.clone(), Resolution { finest: 1.0, angle: 1e-3 });
    let sun = Sun { azimuth: radians(0.0), elevation: radians(1.0) };
    // The tip lies some 17 km south of the top, which is far outside of what is asked for.
    let tip = |east: f64| {
        let (mut dark, mut lit) = (18_000.0, 100.0);
        for _ in 0..50 {
            let middle = 0.5 * (dark + lit);
            if ray_is_blocked(&land, &sun, [middle, east], 310.0) { dark = middle } else { lit = middle }
        }
        dark
    };
    for east in [1990.3, 2100.0] {
        let edge = tip(east);
        assert!(edge < 4500.0, "{edge}");
        let tiles = bank.around(&sun, [edge + 20.0, east], 60.0, None);
        let found = changes(&tiles, [edge + 30.0, east], [-1.0, 0.0], 60.0);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0] - 30.0).abs() < 0.5, "{east}: {} m off", found[0] - 30.0);
    }
}

#[test]
fn a_shadow_leaves_the_ground_and_comes_back() {
    // Two crests of one height: the second stands in the shadow of the first but for what is above the ray.
    let massif = |north: f64, height: f64| landscape::relief::Massif {
        at: [north, 400.0],
        height,
        radius: 260.0,
        detail: 120.0,
        ruggedness: 0.0,
    };
    let relief = landscape::relief::Relief {
        massifs: vec![massif(1500.0, 60.0), massif(800.0, 50.0)],
        ..flat(2000.0)
    };
    let land = Arc::new(landscape(&relief, Vec::new()));
    let sun = Sun { azimuth: 0.0, elevation: radians(3.0) };
    let bank = ShadowBank::new(land.clone(), Resolution { finest: 1.0, angle: 0.0 });
    let tiles = bank.around(&sun, [800.0, 400.0], 790.0, None);
    let found = changes(&tiles, [1580.0, 400.3], [-1.0, 0.0], 1500.0);
    assert_eq!(found.len(), 3, "dark, lit on the second crest, dark: {found:?}");
    for way in found {
        let blocked = |way: f64| ray_is_blocked(&land, &sun, [1580.0 - way, 400.3], 70.0);
        assert_ne!(blocked(way - 0.3), blocked(way + 0.3), "{way}");
    }
}
