//! Pictures of the machine against `exact`, block by block, and against closed forms where there are any.

use compare::{EdgeLimits, edge_mask};
use features::{Crater, Shape};
use generator::PlaneKind;
use hardware_model::{HardwareModel, LevelSwitch, Yoke};
use landscape::{Bank, CraterGrain, Landscape, Level, Photometry, Silhouette, Source};
use lunoid_tests::{Dice, level_of};
use quantities::radians;
use scenario::{
    BodyVisibility, FeatureLight, Laws, Projection, ShadowFineness, ShadowedBodies, TextureInShadow,
};

use crate::landscape::set::{REGION, Set, craters, flat, rolling, standing_box, sun, wave};

/// How a picture of the machine agrees with that of `exact`.
#[derive(Debug, Clone, Copy)]
pub struct Agreement {
    /// Share of the pixels outside the mask that are off by more than 2 levels of 255.
    pub off: f64,
    /// Share of the pixels that the mask of edges leaves out.
    pub masked: f64,
}

/// Draws `set` on both.
pub fn agreement(set: &Set) -> Agreement {
    let (machine, exact) = (set.machine(&[]), set.exact());
    let mask = edge_mask(&exact, &EdgeLimits::default()).unwrap();
    let expected = exact.get(PlaneKind::Intensity).unwrap();
    let pixels = machine.picture.iter().zip(expected).zip(&mask.pixels);
    let off = pixels.filter(|((a, b), masked)| !**masked && (*a - *b).abs() > 2.0 / 255.0).count();
    Agreement { off: off as f64 / expected.len() as f64, masked: mask.share() }
}

/// At most this share of the pixels may be off: a fifth of the tolerance of first light.
const OFF: f64 = 0.001;

/// Laws that differ in this share of the pixels cannot be taken for one another.
const SEEN: f64 = 3.0 * OFF;

fn check(name: &str, set: &Set, masked: f64) {
    check_to(name, set, OFF, masked);
}

fn check_to(name: &str, set: &Set, off: f64, masked: f64) {
    let found = agreement(set);
    println!("{name}: {:.3} % off, {:.1} % masked", 100.0 * found.off, 100.0 * found.masked);
    assert!(found.off <= off, "{name}: {found:?}");
    assert!(found.masked <= masked, "{name}: a mask must not hide the picture, {found:?}");
}

/// Share of the pixels outside the mask of `a` in which `exact` tells two sets apart: what a check can see.
fn apart(a: &Set, b: &Set) -> f64 {
    let [a, b] = [a, b].map(Set::exact);
    let mask = edge_mask(&a, &EdgeLimits::default()).unwrap();
    let [a, b] = [&a, &b].map(|planes| planes.get(PlaneKind::Intensity).unwrap());
    let off = a.iter().zip(b).zip(&mask.pixels);
    let off = off.filter(|((a, b), masked)| !**masked && (*a - *b).abs() > 2.0 / 255.0).count();
    off as f64 / a.len() as f64
}

/// With so many pixels that a mask of edges leaves most of them.
fn over(level: Level) -> Set {
    let mut set = Set::over(level);
    let raster = &mut set.stage.settings.raster;
    (raster.sweeps, raster.columns, raster.lines) = (144, 144, 84);
    set
}

fn cratered(seed: u64) -> Set {
    let set = over(rolling(seed, 3.0)).under(sun(60.0, 14.0));
    let middle = [set.pose.eye[0] + 50.0, set.pose.eye[1]];
    set.with_craters(craters(seed, 30, middle, 50.0, 16.0))
}

/// The set under the law that `change` sets.
fn law(set: &Set, change: impl FnOnce(&mut Laws)) -> Set {
    let mut set = set.clone();
    change(&mut set.stage.settings.laws);
    set
}

/// Boxes up to `farthest` m ahead, the largest as wide as a thirtieth of that.
fn strewn(set: Set, seed: u64, count: u32, farthest: f64) -> Set {
    let mut dice = Dice::new(seed);
    let bodies = (0..count).map(|object| {
        let ahead = dice.between(0.1, 1.0) * farthest;
        let place = set.ahead(ahead, 0.4 * ahead * dice.between(-1.0, 1.0));
        let half = farthest * dice.between(0.003, 0.015);
        standing_box(object, place, half, 2.0 * half)
    });
    let bodies = bodies.collect();
    set.with_bodies(bodies)
}

#[test]
fn craters_of_all_types() {
    for seed in [1, 2] {
        check("craters", &cratered(seed), 0.5);
    }
}

#[test]
fn light_of_features_under_both_laws() {
    let [reported, combined] = [FeatureLight::AsReported, FeatureLight::Combined]
        .map(|which| law(&cratered(3), |laws| laws.feature_light = which));
    check("feature light as reported", &reported, 0.5);
    check("feature light combined", &combined, 0.5);
    assert!(apart(&reported, &combined) > 0.05);
}

#[test]
fn photometry() {
    for photometry in [Photometry::LunarLambert, Photometry::Specular { strength: 1.0, exponent: 8 }] {
        let set = cratered(4).dressed(|ground| ground.with_photometry(photometry));
        check("photometry", &set, 0.5);
        assert!(apart(&set, &cratered(4)) > 0.05);
    }
}

#[test]
fn remote_shadow() {
    for reach in [None, Some(60.0)] {
        let mut set = cratered(5).under(sun(250.0, 4.0));
        set.stage.settings.shadows = Some(ShadowFineness { finest: 0.1, angle: 1e-3, reach });
        check("shadow", &set, 0.6);
        let mut lit = set.clone();
        lit.stage.settings.shadows = None;
        assert!(apart(&set, &lit) > SEEN, "{reach:?}: {}", apart(&set, &lit));
    }
}

#[test]
fn texture_in_light_and_shadow() {
    for source in [Source::Random, Source::Pattern] {
        let set = cratered(7).under(sun(250.0, 4.0)).with_shadows().with_texture(source);
        let [on, off] = [TextureInShadow::On, TextureInShadow::Off]
            .map(|which| law(&set, |laws| laws.texture_in_shadow = which));
        check("texture in shadow", &on, 0.6);
        check("no texture in shadow", &off, 0.6);
        assert!(apart(&on, &off) > SEEN, "{}", apart(&on, &off));
    }
}

/// Rubble in craters of one type, dust in those of another.
#[test]
fn texture_of_craters() {
    let plain = cratered(7).with_texture(Source::Random);
    let set = plain.clone().dressed(|ground| ground.with_crater_grain(CraterGrain::new([3.0, 0.0, 2.0])));
    check("texture of craters", &set, 0.6);
    assert!(apart(&set, &plain) > SEEN, "{}", apart(&set, &plain));
}

#[test]
fn bodies_under_both_laws_of_visibility() {
    let set = strewn(over(rolling(8, 9.0)).under(sun(120.0, 30.0)), 8, 90, 160.0);
    let [whole, depth] = [BodyVisibility::AsReported, BodyVisibility::Depth]
        .map(|which| law(&set, |laws| laws.body_visibility = which));
    check("bodies as reported", &whole, 0.7);
    check("bodies by depth", &depth, 0.7);
    assert!(apart(&whole, &depth) > SEEN, "{}", apart(&whole, &depth));
}

/// A rim as high as the eye hides the feet of three boxes, not their heads: by depth the heads are seen, as reported
/// nothing.
#[test]
fn bodies_behind_a_rim_under_both_laws() {
    let set = over(flat()).under(sun(150.0, 30.0));
    let [x, y] = set.foot();
    let rim = Crater::new([x + 60.0, y], Shape::RimmedBowl { r1: 20.0, r2: 32.0 }, 2.0, 3.0).unwrap();
    let set = set.with_craters(vec![rim]);
    let behind = [-12.0, 0.0, 12.0].map(|starboard| set.ahead(110.0, starboard));
    let bodies = (0..).zip(behind).map(|(object, foot)| standing_box(object, foot, 5.0, 7.0));
    let set = set.clone().with_bodies(bodies.collect());
    let [whole, depth] = [BodyVisibility::AsReported, BodyVisibility::Depth]
        .map(|which| law(&set, |laws| laws.body_visibility = which));
    assert_eq!((whole.machine(&[]).counts["bodies"], depth.machine(&[]).counts["bodies"]), (0, 3));
    check("behind a rim as reported", &whole, 0.5);
    check("behind a rim by depth", &depth, 0.5);
    assert!(apart(&depth, &whole) > SEEN, "{}", apart(&depth, &whole));
}

#[test]
fn bodies_in_shadow_under_both_laws() {
    let set = strewn(cratered(9), 9, 60, 70.0).under(sun(240.0, 5.0)).with_shadows();
    let [vanish, dark] = [ShadowedBodies::Vanish, ShadowedBodies::Dark]
        .map(|which| law(&set, |laws| laws.shadowed_bodies = which));
    check("shadowed bodies vanish", &vanish, 0.7);
    check("shadowed bodies are dark", &dark, 0.7);
    assert!(apart(&vanish, &dark) > SEEN, "{}", apart(&vanish, &dark));
}

#[test]
fn a_hill_beyond_the_ground() {
    let hills = Silhouette::new(vec![[-0.6, 0.01], [-0.1, 0.16], [0.1, 0.05], [0.5, 0.12]], 0.4).unwrap();
    let set = over(rolling(10, 3.0)).dressed(|ground| ground.with_silhouettes(vec![hills.clone()]));
    check("silhouette", &set, 0.5);
    assert!(apart(&set, &over(rolling(10, 3.0))) > 0.05);
    // Over level black ground, in closed form: lines from the end of the ground up to the outline.
    let black =
        |ground: Landscape| Landscape::new(ground.bank().clone(), 0.0).with_silhouettes(vec![hills.clone()]);
    let mut set = Set::over(flat()).dressed(black);
    set.pose.attitude.pitch = 0.0;
    let (raster, drawn) = (set.stage.settings.raster, set.machine(&[]));
    let horizon = -set.pose.eye[2] / set.stage.settings.range.end;
    for column in 0..raster.columns {
        let [north, east] = set.direction(column);
        let top = hills.tangent(libm::atan2(east, north)).unwrap();
        let lines = (top - horizon) / north * 0.5 * f64::from(raster.lines) / raster.field.tan_half_height;
        let found = column_sum(&set, &drawn.picture, column) / 0.4;
        assert!((found - lines).abs() < 1e-3, "column {column}: {found} lines, expected {lines}");
    }
}

fn column_sum(set: &Set, picture: &[f32], column: u32) -> f64 {
    let column = picture.iter().skip(column as usize).step_by(set.stage.settings.raster.columns as usize);
    column.map(|&value| f64::from(value)).sum()
}

#[test]
fn two_levels() {
    let fine = rolling(11, 3.0);
    let coarse = level_of(4.0 * REGION, [-16.0 * REGION; 2], [13; 2], |m, n| {
        [2.0 * libm::sin(m as f64) * libm::cos(1.7 * n as f64), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    });
    for blend in [0.0, 50.0] {
        let bank = Bank::new("two", vec![fine.clone(), coarse.clone()], None).unwrap();
        let mut set = over(fine.clone()).dressed(|ground| Landscape::new(bank, ground.albedo()));
        set.stage.settings.levels = Some(LevelSwitch { range: 90.0, blend });
        set.stage.settings.range.end = 400.0;
        set.pose.eye[2] += 6.0;
        // A sudden step is drawn over the samples beside it, and is no edge of the mask.
        check_to("two levels", &set, if blend == 0.0 { 0.003 } else { OFF }, 0.5);
        let mut one = set.clone();
        one.stage.settings.levels = None;
        assert!(apart(&set, &one) > 0.02, "{}", apart(&set, &one));
    }
}

#[test]
fn a_turned_yoke() {
    for (degrees, projection) in
        [(12.0, Projection::Exact), (-20.0, Projection::Exact), (12.0, Projection::AsReported)]
    {
        let mut set = strewn(cratered(12), 12, 30, 70.0);
        set.stage.settings.laws.projection = projection;
        // One camera in perspective: bodies are so under every projection.
        if projection == Projection::AsReported {
            set = set.with_bodies(Vec::new());
        }
        set.stage.settings.yoke =
            Some(Yoke { step: 0.0, rate: 1.0, travel: radians(40.0), ..HardwareModel::ideal().yoke });
        (set.stage.settings.raster.sweeps, set.pose.yoke) = (400, radians(degrees));
        let turned = agreement(&set);
        println!("yoke at {degrees} deg, {projection:?}: {turned:?}");
        assert!(turned.off <= 0.003, "{degrees} deg, {projection:?}: {turned:?}");
        let mut upright = set.clone();
        upright.pose.yoke = 0.0;
        assert!(apart(&set, &upright) > 0.1);
    }
}

/// Check value of section 23.4: an eye 1.63 m high, 50 m before the rim of a bowl of 10 m radius and 2 m depth, does
/// not see its near side up to 68.37 m.
#[test]
fn the_near_rim_hides_the_bowl() {
    let mut set = Set::over(flat());
    (set.stage.settings.raster.sweeps, set.stage.settings.raster.columns) = (1, 1);
    set.stage.settings.raster.samples = 4000;
    set.pose.eye[2] = 1.63;
    let [x, y] = set.foot();
    let crater = Crater::new([x + 60.0, y], Shape::Bowl { r1: 10.0 }, 2.0, 0.0).unwrap();
    let set = set.with_craters(vec![crater]);
    let drawn = set.machine(&["dpp.blank", "sweep.range"]);
    let mut blanked = 0;
    for (blank, &range) in wave(&drawn, 0, "dpp.blank").iter().zip(wave(&drawn, 0, "sweep.range")) {
        // The sample behind the rim still reads a hold that has just moved.
        if (50.0..50.06).contains(&range) || (range - 68.37).abs() < 1e-2 {
            continue;
        }
        assert_eq!(*blank == 1.0, (50.0..68.37).contains(&range), "{range} m");
        blanked += usize::from(*blank == 1.0);
    }
    assert!(blanked > 100, "{blanked}");
}

/// The front of a box 3 m wide and 2 m high, 12 m ahead: a rectangle on the view-plane.
#[test]
fn the_outline_of_a_box() {
    let mut set = Set::over(flat()).under(sun(180.0, 30.0));
    set.pose.attitude.pitch = 0.0;
    let black = |ground: Landscape| Landscape::new(ground.bank().clone(), 0.0);
    let foot = set.ahead(13.5, 0.0);
    // Lower than the box, so that its top is not seen.
    set.pose.eye[2] = 1.0;
    let set = set.dressed(black).with_bodies(vec![standing_box(0, foot, 1.5, 2.0)]);
    let (raster, drawn) = (set.stage.settings.raster, set.machine(&[]));
    let lit = libm::cos(radians(30.0));
    let lines = 2.0 / 12.0 * 0.5 * f64::from(raster.lines) / raster.field.tan_half_height;
    let half = 1.5 / 12.0 * 0.5 * f64::from(raster.columns) / raster.field.tan_half_width;
    for column in 0..raster.columns {
        let offset = (f64::from(column) + 0.5 - 0.5 * f64::from(raster.columns)).abs();
        let expected = if offset < half { lines } else { 0.0 };
        let found = column_sum(&set, &drawn.picture, column) / lit;
        assert!((found - expected).abs() < 1e-3, "column {column}: {found} lines, expected {expected}");
    }
    // Half of it above the line of sight.
    let upper = drawn.picture.len() / 2;
    let [above, below] =
        [&drawn.picture[..upper], &drawn.picture[upper..]].map(|half| half.iter().sum::<f32>());
    assert!((above - below).abs() < 1e-3, "{above} {below}");
}
