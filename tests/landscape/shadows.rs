//! Remote shadow: the gate against marching to the sun, and what the laws let shadow do.

use generator::PlaneKind;
use hardware_model::ShadowParts;
use landscape::{Landscape, Source, Sun};
use quantities::radians;
use scenario::{ShadowedBodies, TextureInShadow, TrackPatch};

use crate::landscape::set::{REGION, REGIONS, Set, craters, flat, patch, rolling, standing_box, sun, wave};

/// Distance from a shadow's edge within which the gate may differ (m): two profiles.
const EDGE: f64 = 0.1;

/// Whether ground stands between a place of the ground and the sun, by steps of 0.1 m.
fn is_dark(ground: &Landscape, [x, y]: [f64; 2], sun: &Sun, highest: f64) -> bool {
    let [north, east, up] = sun.direction();
    let flat = libm::hypot(north, east);
    let Some(height) = ground.height(x, y) else { return false };
    let mut way = 0.02;
    loop {
        let line = height + way * up / flat;
        if line > highest {
            return false;
        }
        match ground.height(x + way * north / flat, y + way * east / flat) {
            Some(other) if other > line + 1e-6 => return true,
            Some(_) => way += 0.1,
            None => return false,
        }
    }
}

#[test]
fn the_gate_is_what_marching_to_the_sun_finds() {
    for (seed, azimuth, elevation) in [(1, 80.0, 4.0), (2, 200.0, 7.0), (3, 331.0, 3.0)] {
        let mut set = Set::over(rolling(seed, 6.0))
            .with_fine_shadows([0.5 * EDGE, 5e-4])
            .under(sun(azimuth, elevation));
        let (middle, raster) = (set.foot(), &mut set.stage.settings.raster);
        (raster.sweeps, raster.columns, raster.samples) = (5, 5, 160);
        set.stage.settings.range.end = 120.0;
        let set = set.with_craters(craters(seed, 40, middle, 90.0, 24.0));
        let light = set.stage.scenery.sun(0.0);
        let drawn = set.machine(&["sc.gate", "mu.*", "sweep.range"]);
        let mut found = [0; 2];
        for sweep in 0..5 {
            let gate = wave(&drawn, sweep, "sc.gate");
            assert_eq!(gate, wave(&drawn, sweep, "mu.vs2"));
            let reflected = wave(&drawn, sweep, "mu.reflectivity");
            for (sample, &range) in wave(&drawn, sweep, "sweep.range").iter().enumerate() {
                let place = set.place(sweep, range);
                let around = [[0.0; 2], [EDGE, 0.0], [-EDGE, 0.0], [0.0, EDGE], [0.0, -EDGE]];
                let dark = around
                    .map(|[a, b]| is_dark(&set.stage.landscape, [place[0] + a, place[1] + b], &light, 12.0));
                if dark.iter().any(|other| *other != dark[0]) {
                    continue;
                }
                found[usize::from(dark[0])] += 1;
                let what = format!("seed {seed}, sweep {sweep}, {range} m at {place:?}");
                assert_eq!(gate[sample] == 1.0, dark[0], "{what}");
                assert!(!dark[0] || reflected[sample] == 0.0, "{what}");
            }
        }
        println!("seed {seed}: {found:?} of 800");
        assert!(found.iter().all(|count| *count > 40), "seed {seed}: {found:?} lit and dark");
    }
}

/// A map in a scan converter that is read beside its place shows the shadow of where it is read, all over the picture: tiles
/// that the eye does not see are among those that the sweeps meet.
#[test]
fn a_displaced_map_shows_the_shadow_of_where_it_is_read() {
    for (seed, offset, gain) in [(1, [0.0, 0.12], 0.0), (2, [-0.08, -0.05], 0.3), (3, [0.06, 0.0], -0.3)] {
        let mut set =
            Set::over(rolling(seed, 6.0)).with_fine_shadows([0.5 * EDGE, 5e-4]).under(sun(80.0, 4.0));
        let raster = &mut set.stage.settings.raster;
        (raster.sweeps, raster.columns, raster.samples) = (5, 5, 160);
        set.stage.settings.range.end = 120.0;
        set.stage.settings.shadow_controller = ShadowParts::ScanConverter { offset, gain };
        let middle = set.foot();
        let set = set.with_craters(craters(seed, 60, middle, 150.0, 24.0));
        let light = set.stage.scenery.sun(0.0);
        // All of the ground is the map.
        let side = REGION * REGIONS as f64;
        let drawn = set.machine(&["sc.gate", "sweep.range"]);
        let mut found = [0; 2];
        for sweep in 0..5 {
            let gate = wave(&drawn, sweep, "sc.gate");
            for (sample, &range) in wave(&drawn, sweep, "sweep.range").iter().enumerate() {
                let [x, y] = set.place(sweep, range);
                let read = |place: f64, offset: f64| {
                    0.5 * side + (place - 0.5 * side - offset * side) / (1.0 + gain)
                };
                let place = [read(x, offset[0]), read(y, offset[1])];
                let around = [[0.0; 2], [EDGE, 0.0], [-EDGE, 0.0], [0.0, EDGE], [0.0, -EDGE]];
                let dark = around
                    .map(|[a, b]| is_dark(&set.stage.landscape, [place[0] + a, place[1] + b], &light, 12.0));
                if dark.iter().all(|other| *other == dark[0]) {
                    found[usize::from(dark[0])] += 1;
                    assert_eq!(gate[sample] == 1.0, dark[0], "seed {seed}, sweep {sweep}, {range} m");
                }
            }
        }
        println!("seed {seed}: {found:?} of 800");
        assert!(found.iter().all(|count| *count > 40), "seed {seed}: {found:?} lit and dark");
    }
}

/// A processor that has no body ready has nothing to do for those behind the eye: their shadows fall into the picture.
#[test]
fn shadows_of_bodies_behind_need_no_processor() {
    let set = Set::over(flat()).under(sun(184.0, 15.0)).with_shadows();
    let [behind, ahead] = [set.ahead(-10.0, 3.0), set.ahead(60.0, 0.0)];
    let one = set.clone().with_bodies(vec![standing_box(0, behind, 2.0, 12.0)]);
    let mut both =
        set.with_bodies(vec![standing_box(0, behind, 2.0, 12.0), standing_box(1, ahead, 2.0, 12.0)]);
    both.stage.settings.cpu.vertex = 100_000_000_000_000_000;
    let [one, both] = [one, both].map(|set| set.machine(&["sc.gate"]));
    let mut dark = 0;
    for sweep in 0..64 {
        let [expected, found] = [&one, &both].map(|drawn| wave(drawn, sweep, "sc.gate"));
        assert_eq!(expected, found, "sweep {sweep}");
        dark += expected.iter().filter(|&&gate| gate == 1.0).count();
    }
    assert!(dark > 500, "{dark}");
}

/// Level ground under a high sun, with texture, and shadow from 20 m to 30 m ahead.
fn shaded(law: TextureInShadow) -> Set {
    let set = Set::over(flat()).under(sun(45.0, 40.0)).with_shadows().with_texture(Source::Random);
    let [x, y] = set.foot();
    let mut set = set.with_patches(vec![patch([x + 20.0, y - 40.0, x + 30.0, y + 40.0])]);
    set.stage.settings.laws.texture_in_shadow = law;
    set
}

#[test]
fn texture_in_shadow_follows_its_law() {
    let lit = libm::sin(radians(40.0));
    for law in [TextureInShadow::On, TextureInShadow::Off] {
        let set = shaded(law);
        let drawn = set.machine(&["txg.texture", "sc.gate", "mu.reflectivity", "sweep.range"]);
        let mut grained = 0;
        for sweep in 0..set.stage.settings.raster.sweeps {
            let signal = |name: &str| wave(&drawn, sweep, name);
            for (sample, &range) in signal("sweep.range").iter().enumerate() {
                let [x, y] = set.place(sweep, range);
                let ahead = x - set.pose.eye[0];
                let grain = set.stage.landscape.texture().unwrap().at(x, y, range);
                assert!((signal("txg.texture")[sample] - grain).abs() < 1e-9, "{range} m");
                let most = 0.1 * (1.0 - range / 60.0).max(0.0) + 0.05 * (1.0 - range / 30.0).max(0.0);
                assert!(grain.abs() <= most, "{range} m: {grain}, at most {most} is left of it");
                let dark = (20.0..=30.0).contains(&ahead);
                assert_eq!(signal("sc.gate")[sample] == 1.0, dark, "{range} m");
                let expected = match (dark, law) {
                    (false, _) => lit + grain,
                    (true, TextureInShadow::On) => grain,
                    (true, TextureInShadow::Off) => 0.0,
                };
                let found = signal("mu.reflectivity")[sample];
                assert!((found - expected.clamp(0.0, 1.0)).abs() < 1e-9, "{law:?}, {range} m: {found}");
                grained += usize::from(dark && grain > 0.01);
            }
        }
        assert!(grained > 100, "{grained}");
    }
}

/// A wall of ground and a box behind it, the sun low behind the wall.
fn behind_a_rim(law: ShadowedBodies, azimuth: f64) -> Set {
    let set = Set::over(flat()).under(sun(azimuth, 5.0)).with_shadows();
    let [x, y] = set.foot();
    let rim = features::Shape::RimmedBowl { r1: 20.0, r2: 32.0 };
    let rim = features::Crater::new([x + 50.0, y - 45.0], rim, 4.0, 3.0).unwrap();
    let mut set = set.with_craters(vec![rim]);
    let foot = set.ahead(50.0, 0.0);
    set = set.with_bodies(vec![standing_box(0, foot, 2.0, 2.0)]);
    set.stage.settings.laws.shadowed_bodies = law;
    set
}

#[test]
fn a_body_in_remote_shadow_vanishes_or_is_black() {
    let drawn = |law, azimuth| behind_a_rim(law, azimuth).machine(&["pg.*"]);
    let present = |drawn: &lunoid_tests::Drawn, name: &str| -> f64 {
        (0..64).flat_map(|sweep| wave(drawn, sweep, name)).sum()
    };
    let [vanished, black] = [ShadowedBodies::Vanish, ShadowedBodies::Dark].map(|law| drawn(law, 270.0));
    assert_eq!((vanished.counts["bodies"], present(&vanished, "pg.present")), (0, 0.0));
    assert_eq!((black.counts["bodies"], present(&black, "pg.reflectivity")), (1, 0.0));
    assert!(present(&black, "pg.present") > 10.0);
    // With the sun on its other side it stands in the light under either law.
    let [a, b] = [ShadowedBodies::Vanish, ShadowedBodies::Dark].map(|law| drawn(law, 100.0));
    assert_eq!(a.picture, b.picture);
    assert!(present(&a, "pg.reflectivity") > 1.0);
}

/// A patch laid after two seconds: on the ground from then on, in the machine as in `exact`.
#[test]
fn tracks_lie_from_when_they_are_laid() {
    let set = Set::over(flat()).under(sun(45.0, 40.0)).with_shadows();
    let [x, y] = set.foot();
    let mut set =
        set.with_patches(vec![TrackPatch { laid: 2.0, ..patch([x + 20.0, y - 9.0, x + 40.0, y + 9.0]) }]);
    for (time, lies) in [(0.0, false), (1.999, false), (2.0, true), (9.0, true)] {
        set.pose.time = time;
        assert_eq!(set.machine(&[]).counts["shadow_toggles"] > 0, lies, "{time} s");
        let dark = |picture: &[f32]| picture.iter().filter(|value| **value == 0.0).count();
        let [machine, exact] =
            [dark(&set.machine(&[]).picture), dark(set.exact().get(PlaneKind::Intensity).unwrap())];
        assert!(machine.abs_diff(exact) < 40, "{time} s: {machine} {exact} dark pixels");
    }
}

/// Whether a box of the given half width and height, on level ground, stands between a place and the sun. The place is that
/// north and east of the foot of the box (m).
fn is_behind_box(place: [f64; 2], half: f64, height: f64, sun: &Sun) -> bool {
    let [north, east, up] = sun.direction();
    // On the way to the sun: where the line comes over the box and where it leaves it.
    let [mut over, mut beyond] = [0.0f64, f64::INFINITY];
    for (at, step) in place.into_iter().zip([north, east]) {
        let ends = [(-half - at) / step, (half - at) / step];
        (over, beyond) = (over.max(ends[0].min(ends[1])), beyond.min(ends[0].max(ends[1])));
    }
    over < beyond && over * up < height
}

/// Boxes beside the view, of whose long shadows the far part alone lies in it: the middle of the shadow does not.
#[test]
fn what_stands_beside_the_view_casts_its_shadow_into_it() {
    const BOX: [f64; 2] = [1.0, 12.0];
    for side in [-1.0, 1.0] {
        let set = Set::over(flat()).under(sun(side * 93.0, 15.0)).with_shadows();
        let edge = set.direction(if side < 0.0 { 0 } else { set.stage.settings.raster.sweeps - 1 });
        let (light, ahead) = (set.stage.scenery.sun(0.0), 60.0);
        // The shadow is 45 m long; of it, 30 m lie outside.
        let foot = set.ahead(ahead, ahead * edge[1] / edge[0] + side * 30.0);
        let set = set.with_bodies(vec![standing_box(0, foot, BOX[0], BOX[1])]);
        let drawn = set.machine(&["sc.gate", "sweep.range"]);
        let mut found = [0; 2];
        for sweep in 0..set.stage.settings.raster.sweeps {
            for (gate, &range) in
                wave(&drawn, sweep, "sc.gate").iter().zip(wave(&drawn, sweep, "sweep.range"))
            {
                let [x, y] = set.place(sweep, range);
                let dark = [[0.0; 2], [EDGE, 0.0], [-EDGE, 0.0], [0.0, EDGE], [0.0, -EDGE]]
                    .map(|[a, b]| is_behind_box([x + a - foot[0], y + b - foot[1]], BOX[0], BOX[1], &light));
                if dark.iter().all(|other| *other == dark[0]) {
                    found[usize::from(dark[0])] += 1;
                    assert_eq!(*gate == 1.0, dark[0], "sweep {sweep}, {range} m, side {side}");
                }
            }
        }
        println!("side {side}: {found:?} lit and dark");
        assert!(found[1] > 60, "side {side}: {found:?} lit and dark");
    }
}
