//! Gates from the tiles of a shadow bank against the shadow of single points.

use features::{Crater, Features, Shape};
use hardware_model::ShadowParts;
use landscape::relief::{Relief, Undulation};
use landscape::{Bank, Landscape, Sun};
use quantities::{radians, sin_cos, unit_interval};
use remote_shadow::{Outlines, Resolution, ShadowBank};
use shadow_controller::ShadowController;
use std::sync::Arc;

fn landscape() -> Landscape {
    let mut relief = Relief::flat(5, [640.0, 640.0], 40.0);
    relief.undulation =
        Some(Undulation { rms_height: 5.0, hurst: 0.9, shortest: 120.0, longest: 600.0, waves: 100 });
    let crater = |n: u64| {
        let random = |word: u64| unit_interval(5, &[n, word]);
        let r1 = 6.0 + 20.0 * random(0);
        let shape = Shape::RimmedBowl { r1, r2: 1.5 * r1 };
        Crater::new([640.0 * random(1), 640.0 * random(2)], shape, 0.3 * r1, 0.05 * r1).unwrap()
    };
    let bank = Bank::new("rolling", vec![relief.build().unwrap()], None).unwrap();
    Landscape::new(bank, 1.0).with_features(Features::new((0..60).map(crater).collect()))
}

#[test]
fn the_gate_is_dark_where_the_ground_is() {
    let bank = ShadowBank::new(Arc::new(landscape()), Resolution { finest: 0.25, angle: 4e-3 });
    let sun = Sun { azimuth: radians(110.0), elevation: radians(5.0) };
    let (eye, reach, heading) = ([200.0, 180.0], 300.0, 0.9);
    let direction = |azimuth: f64| {
        let (sin, cos) = sin_cos(azimuth);
        [cos, sin]
    };
    let directions: Vec<_> =
        (0..101).map(|n| direction(heading + radians(0.5 * f64::from(n) - 25.0))).collect();
    let tiles = bank.around(&sun, eye, reach, Some([directions[0], directions[100]]));
    let lists: Vec<&Outlines> = tiles.iter().map(|tile| &tile.outlines).collect();
    let parts = ShadowParts::Digital { line_generators: None };
    let mut gates = Vec::new();
    ShadowController { parts, map_centre: [0.0; 2], map_side: 1.0, tells_lines: true }.gates(
        eye,
        &directions,
        reach,
        &lists,
        &mut gates,
    );
    let (mut dark_points, mut slivers) = (0, 0);
    for (sweep, (gate, d)) in gates.iter().zip(&directions).enumerate() {
        slivers += gate.toggles.windows(2).filter(|pair| pair[1] - pair[0] < 1e-4).count();
        for n in 0..60 {
            let range = 1.0 + (reach - 2.0) * unit_interval(sweep as u64, &[n]);
            // Across the sun boundaries are good to one spacing, which slants along the sweep.
            let spacing = (4e-3 * range).max(0.25);
            if gate.toggles.iter().any(|toggle| (toggle - range).abs() < 4.0 * spacing) {
                continue;
            }
            let found = gate.dark_at_start ^ (gate.toggles.iter().filter(|&&t| t <= range).count() % 2 == 1);
            let dark = bank.is_dark(&sun, [eye[0] + range * d[0], eye[1] + range * d[1]]);
            assert_eq!(found, dark, "sweep {sweep}, range {range}");
            dark_points += u32::from(dark);
        }
    }
    assert!(dark_points > 500, "{dark_points}");
    assert!(slivers < 5, "edges of tiles leave {slivers} slivers");
}
