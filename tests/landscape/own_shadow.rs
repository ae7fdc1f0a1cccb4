//! The vehicle's own shadow: the gate against rays to the sun, the picture against `exact`.

use generator::{Label, PlaneKind};
use glam::DVec3;
use landscape::{Attitude, Landscape};
use quantities::radians;
use scenario::VehicleShape;
use solids::{Body, culture};

use crate::landscape::pictures::agreement;
use crate::landscape::set::{Set, craters, rolling, sun, wave};

/// Distance from an edge of shadow within which the gate may differ (m): an outline is followed over the ground point by
/// point, half a metre apart at most, and is straight between them.
const EDGE: f64 = 0.04;

/// Share of the places away from edges at which it differs all the same: where an outline runs over a rim it breaks, and
/// between two of its points it is drawn straight.
const OFF: f64 = 0.002;

/// A rover on rough ground, its nose down and rolled, the sun behind it.
fn driven(seed: u64, azimuth: f64, elevation: f64) -> Set {
    let set = Set::over(rolling(seed, 2.0)).under(sun(azimuth, elevation)).with_fine_shadows([0.02, 5e-4]);
    let foot = set.foot();
    let mut set = set.with_craters(craters(seed, 24, [foot[0] + 9.0, foot[1]], 8.0, 3.0));
    set.pose.eye[2] = set.ahead(0.0, 0.0)[2] + 1.6334;
    set.pose.attitude = Attitude { roll: radians(5.0), pitch: radians(-7.0), heading: 0.0 };
    set.stage.settings.range.start = 1.5;
    set.stage.settings.range.end = 40.0;
    set
}

fn rover(set: &Set) -> Set {
    let parts = culture::model("rover").expect("a rover").into_iter().map(Into::into).collect();
    set.clone().with_vehicle(VehicleShape { parts, eye_height: 1.6334 })
}

/// Whether a part stands between a place of the ground and the sun.
fn is_cast_on(ground: &Landscape, [x, y]: [f64; 2], bodies: &[Body], to_sun: DVec3) -> bool {
    let Some(height) = ground.height(x, y) else { return false };
    bodies.iter().any(|body| body.first_hit(DVec3::new(x, y, height), to_sun, 0.0).is_some())
}

#[test]
fn the_gate_is_where_rays_to_the_sun_meet_the_vehicle() {
    for (seed, azimuth, elevation) in [(1, 184.0, 12.0), (2, 165.0, 25.0), (3, 200.0, 9.0)] {
        let alone = driven(seed, azimuth, elevation);
        let with = rover(&alone);
        let (scenery, ground) = (&with.stage.scenery, &with.stage.landscape);
        let bodies = scenery.own_bodies(with.pose.eye, with.pose.attitude);
        let to_sun = DVec3::from_array(scenery.sun(0.0).direction());
        let [drawn, without] = [&with, &alone].map(|set| set.machine(&["sc.gate", "sweep.range"]));
        let (mut found, mut off) = ([0; 2], 0);
        for sweep in 0..with.stage.settings.raster.sweeps {
            let (gate, other) = (wave(&drawn, sweep, "sc.gate"), wave(&without, sweep, "sc.gate"));
            for (sample, &range) in wave(&drawn, sweep, "sweep.range").iter().enumerate() {
                if other[sample] == 1.0 {
                    assert_eq!(gate[sample], 1.0, "what is dark without a vehicle is dark with one");
                    continue;
                }
                let [x, y] = with.place(sweep, range);
                let around = [[0.0; 2], [EDGE, 0.0], [-EDGE, 0.0], [0.0, EDGE], [0.0, -EDGE]];
                let dark = around.map(|[a, b]| is_cast_on(ground, [x + a, y + b], &bodies, to_sun));
                if dark.iter().all(|other| *other == dark[0]) {
                    found[usize::from(dark[0])] += 1;
                    off += usize::from((gate[sample] == 1.0) != dark[0]);
                }
            }
        }
        println!("seed {seed}: {found:?}, {off} off");
        assert!(found.iter().all(|count| *count > 1500), "seed {seed}: {found:?} lit and dark");
        assert!(off as f64 <= OFF * f64::from(found[0] + found[1]), "seed {seed}: {off} of {found:?}");
    }
}

#[test]
fn the_picture_is_that_of_exact_and_shows_no_vehicle() {
    for (seed, azimuth, elevation) in [(4, 186.0, 14.0), (5, 172.0, 30.0)] {
        let alone = driven(seed, azimuth, elevation);
        let mut with = rover(&alone);
        let raster = &mut with.stage.settings.raster;
        (raster.sweeps, raster.columns, raster.lines) = (144, 144, 84);
        let found = agreement(&with);
        println!("seed {seed}: {:.3} % off, {:.1} % masked", 100.0 * found.off, 100.0 * found.masked);
        assert!(found.off <= 0.001 && found.masked < 0.35, "seed {seed}: {found:?}");
        let planes = with.exact();
        let labels = planes.get(PlaneKind::Label).unwrap();
        assert!(!labels.contains(&f32::from(Label::Culture.code())), "it casts and is not seen");
        assert_eq!(with.machine(&[]).counts["bodies"], 0);
    }
}
