//! A sea of true waves: where rays meet it, its light by area, and what stands in it.

use std::sync::Arc;

use generator::{Label, PlaneKind, Planes};
use quantities::radians;
use scenario::{Curvature, FaceLists, OpenSea, PixelRule, Pose, Projection, Scenery};
use wind_waves::{Wind, WindWaves};

use crate::scenes::{landscape, laws, plane, planes, pose, ray, settings, standing_box, sun, value};

const PIXELS: [u32; 2] = [41, 31];
/// Elevation of the sun (degrees); it stands in the south.
const SUN: f64 = 40.0;
const COLOUR: [f64; 3] = [0.2, 0.4, 0.8];
const WIND: Wind = Wind { speed: 7.0, towards: 0.4, seed: 3, components: 32, shortest: 4.0 };

fn sea(area: [f64; 4]) -> OpenSea {
    OpenSea { waves: WindWaves::new(&WIND).unwrap(), area, height: 2.0, colour: COLOUR }
}

fn scenery(sea: OpenSea) -> Scenery {
    let lists = FaceLists { open_sea: Some(sea), ..FaceLists::default() };
    Scenery::still(sun(180.0, SUN)).with_face_lists(Arc::new(lists))
}

fn usual(curvature: Curvature) -> hardware_model::Settings {
    settings(PIXELS[0], PIXELS[1], laws(Projection::Exact, curvature, PixelRule::Centre), [1.0, 150.0])
}

/// Over ground of 400 m x 400 m at height 0, `change` over the sea.
fn drawn(pose: &Pose, curvature: Curvature, change: impl FnOnce(Scenery) -> Scenery) -> Planes {
    let ground = landscape(plane(100.0, [4, 4], 0.0, [0.0; 2]), 0.5);
    planes(&ground, change(scenery(sea([0.0, 0.0, 400.0, 400.0]))), &usual(curvature), pose)
}

fn is_sea(planes: &Planes, index: usize) -> bool {
    value(planes, PlaneKind::Label, index) == f64::from(Label::Sea.code())
}

/// The range is the first at which the ray is under the water: marching finds no earlier one, and the place is on the water.
#[test]
fn rays_meet_the_first_water() {
    for (curvature, pitch) in
        [(Curvature::None, -6.0), (Curvature::Exact, -2.0), (Curvature::Parabolic, -35.0)]
    {
        let mut pose = pose([30.0, 200.0, 7.0], pitch, 10.0);
        pose.time = 13.0;
        let found = drawn(&pose, curvature, |scenery| scenery);
        let (sea, settings) = (sea([0.0; 4]), usual(curvature));
        let surface = sea.waves.at(pose.time);
        let mut met = 0;
        for index in (0..(PIXELS[0] * PIXELS[1]) as usize).filter(|&index| is_sea(&found, index)) {
            let ray = ray(&settings, &pose, index);
            let gap = |range: f64| {
                let place = [0, 1].map(|axis| pose.eye[axis] + range * ray.direction[axis]);
                let drop = match curvature {
                    Curvature::None => 0.0,
                    _ => range * range / (2.0 * landscape::LUNOID_RADIUS),
                };
                sea.height + surface.at(place).height - (pose.eye[2] + ray.rise * range + drop)
            };
            let range = value(&found, PlaneKind::Range, index);
            assert!(gap(range).abs() < 1e-4, "{index}: {} m off the water at {range} m", gap(range));
            let step = 0.02;
            let before = (50..).map(|k| f64::from(k) * step).take_while(|at| *at < range - 2.0 * step);
            assert!(before.into_iter().all(|at| gap(at) < 1e-6), "{index}: water before {range} m");
            let place = [0, 1].map(|axis| pose.eye[axis] + range * ray.direction[axis]);
            let height = sea.height + surface.at(place).height;
            assert!((value(&found, PlaneKind::Height, index) - height).abs() < 1e-4);
            met += 1;
        }
        assert!(met > 300, "{met} pixels of sea under {curvature:?}");
    }
}

/// From straight above the light of a pixel is the mean of Lambert's law over the waves in it.
#[test]
fn light_is_the_mean_over_the_area_of_a_pixel() {
    let pose = pose([200.0, 200.0, 260.0], -90.0, 0.0);
    let found = drawn(&pose, Curvature::None, |scenery| scenery);
    let (sea, field) = (sea([0.0; 4]), usual(Curvature::None).raster.field);
    let surface = sea.waves.at(0.0);
    let (up, south) = (libm::sin(radians(SUN)), -libm::cos(radians(SUN)));
    for [column, line] in [[20, 15], [3, 4], [33, 22], [11, 27]] {
        let mut sum = 0.0;
        for k in 0..60 * 60 {
            let at = [
                column as f64 + (f64::from(k % 60) + 0.5) / 60.0,
                line as f64 + (f64::from(k / 60) + 0.5) / 60.0,
            ];
            let x = field.tan_half_width * (2.0 * at[0] / f64::from(PIXELS[0]) - 1.0);
            let y = field.tan_half_height * (2.0 * at[1] / f64::from(PIXELS[1]) - 1.0);
            // The ray ends where it meets the water: a few steps from the calm water find the place.
            let mut water = surface.at([200.0; 2]);
            for _ in 0..8 {
                let depth = 258.0 - water.height;
                water = surface.at([200.0 - y * depth, 200.0 + x * depth]);
            }
            let [north, east] = water.slopes;
            sum += (up - north * south).max(0.0) / (1.0 + north * north + east * east).sqrt() / 3600.0;
        }
        let index = line * PIXELS[0] as usize + column;
        let light = value(&found, PlaneKind::Green, index);
        assert!((light - COLOUR[1] * sum).abs() < 0.01 * COLOUR[1], "{column}, {line}: {light} of {sum}");
    }
}

/// A slope along the sun changes light by the cotangent of the sun's elevation: the spread of light is that of the slopes.
#[test]
fn the_spread_of_light_is_that_of_the_slopes() {
    let (mut light, mut time) = (Vec::new(), 0.0);
    while time < 200.0 {
        let mut pose = pose([200.0, 200.0, 40.0], -90.0, 0.0);
        pose.time = time;
        let found = drawn(&pose, Curvature::None, |scenery| scenery);
        light.extend(
            (0..PIXELS[0] * PIXELS[1]).step_by(37).map(|k| value(&found, PlaneKind::Red, k as usize)),
        );
        time += 11.0;
    }
    let mean = light.iter().sum::<f64>() / light.len() as f64;
    let variance = light.iter().map(|of| (of - mean) * (of - mean)).sum::<f64>() / light.len() as f64;
    let slopes = sea([0.0; 4]).waves.slope_variance(radians(180.0)).sqrt();
    let expected = slopes / libm::tan(radians(SUN));
    assert!((variance.sqrt() / mean / expected - 1.0).abs() < 0.1, "{} {expected}", variance.sqrt() / mean);
}

/// Ground under the calm water is never seen through a trough, and a box shows from the water up.
#[test]
fn ground_lies_under_the_water_and_boxes_stand_in_it() {
    let pose = pose([150.0, 200.0, 9.0], -12.0, 0.0);
    // The calm water stands at the height of the ground: half of the waves are troughs below it.
    let low = OpenSea { height: 0.0, ..sea([0.0, 0.0, 400.0, 400.0]) };
    let ground = landscape(plane(100.0, [4, 4], 0.0, [0.0; 2]), 0.5);
    let found = planes(&ground, scenery(low), &usual(Curvature::None), &pose);
    let bare = (0..(PIXELS[0] * PIXELS[1]) as usize)
        .filter(|&index| value(&found, PlaneKind::Label, index) == f64::from(Label::Terrain.code()));
    assert_eq!(bare.count(), 0);
    let found = drawn(&pose, Curvature::None, |scenery| {
        Scenery::clone(&scenery).with_bodies(vec![standing_box(0, [185.0, 200.0, 0.0], 4.0, 8.0)])
    });
    let surface = sea([0.0; 4]).waves.at(0.0);
    let culture = f64::from(Label::Culture.code());
    let boxes: Vec<usize> = (0..(PIXELS[0] * PIXELS[1]) as usize)
        .filter(|&index| value(&found, PlaneKind::Label, index) == culture)
        .collect();
    assert!(boxes.len() > 20);
    let crest = surface.crest();
    assert!(boxes.iter().all(|&index| value(&found, PlaneKind::Height, index) > 2.0 - crest));
    let lowest = boxes.iter().map(|&index| value(&found, PlaneKind::Height, index)).fold(9.0, f64::min);
    assert!(lowest > 1.0 && lowest < 4.0, "the box begins at the water, {lowest} m");
}

/// Where marching along a ray first finds a gap of 0 or more (m), infinite up to `far`; and the largest gap well before.
fn marched(gap: impl Fn(f64) -> f64, far: f64) -> [f64; 2] {
    const STEP: f64 = 0.02;
    let (mut before, mut most) = (gap(1.0), f64::NEG_INFINITY);
    for range in (1..).map(|k| 1.0 + STEP * f64::from(k)).take_while(|range| *range < far) {
        let behind = gap(range);
        if behind >= 0.0 {
            // Between two steps the gap grows evenly, nearly.
            return [range - STEP * behind / (behind - before), most];
        }
        // A gap that grows up to where it closes does not count as near.
        most = if before > behind { most.max(before) } else { most };
        before = behind;
    }
    [f64::INFINITY, most.max(before)]
}

/// A beach rises out of the sea. A pixel shows what marching meets first: water, or ground above the calm water. Ground below that hides no
/// water, even where a trough bares it.
#[test]
fn a_beach_hides_water_from_the_calm_line_up_alone() {
    let (base, rise) = (0.0, 0.01);
    let ground = landscape(plane(100.0, [4, 4], base, [rise, 0.0]), 0.5);
    let mut pose = pose([130.0, 200.0, 6.0], -4.0, 0.0);
    let (mut bared, mut shore, mut deep) = (0, 0, 0);
    for time in [0.0, 7.0] {
        pose.time = time;
        let found = planes(&ground, scenery(sea([0.0, 0.0, 400.0, 400.0])), &usual(Curvature::None), &pose);
        let surface = sea([0.0; 4]).waves.at(time);
        for index in (0..(PIXELS[0] * PIXELS[1]) as usize).step_by(5) {
            let ray = ray(&usual(Curvature::None), &pose, index);
            let at = |range: f64| [0, 1].map(|axis| pose.eye[axis] + range * ray.direction[axis]);
            let height = |range: f64| pose.eye[2] + ray.rise * range;
            let [on_ground, _] = marched(|range| base + rise * at(range)[0] - height(range), 149.0);
            let is_under = base + rise * at(on_ground)[0] <= 2.0;
            let limit = if is_under { f64::INFINITY } else { on_ground };
            let gap = |range: f64| 2.0 + surface.at(at(range)).height - height(range);
            let [on_water, nearest] = marched(gap, limit.min(149.0));
            // A ray that nearly touches a crest, or meets both at one place, may go either way.
            if nearest > -1e-3 || limit.min(on_water) > 148.0 {
                continue;
            }
            let (label, range) =
                (value(&found, PlaneKind::Label, index), value(&found, PlaneKind::Range, index));
            let expected = if on_water < limit { Label::Sea } else { Label::Terrain };
            assert_eq!(label, f64::from(expected.code()), "{time} s, pixel {index}: {on_ground} {on_water}");
            assert!((range - limit.min(on_water)).abs() < 0.01, "{time} s, pixel {index}: {range}");
            bared += u32::from(is_under && on_ground < on_water && on_water < limit);
            shore += u32::from(expected == Label::Terrain);
            deep += u32::from(expected == Label::Sea && on_water < on_ground);
        }
    }
    assert!(bared > 8 && shore > 8 && deep > 100, "{bared} bared, {shore} of the shore, {deep} of water");
}

/// Beyond its area there is no water, and an eye under water sees none.
#[test]
fn water_ends_with_its_area() {
    let ground = landscape(plane(100.0, [4, 4], 0.0, [0.0; 2]), 0.5);
    let above = pose([200.0, 200.0, 60.0], -90.0, 0.0);
    let found = planes(&ground, scenery(sea([0.0, 0.0, 200.0, 400.0])), &usual(Curvature::None), &above);
    let middle = |line: usize| line * PIXELS[0] as usize + 20;
    // The view is to the north at the top: the sea is south of the eye.
    assert!(!is_sea(&found, middle(2)) && is_sea(&found, middle(28)));
    let under = planes(
        &ground,
        scenery(sea([0.0, 0.0, 400.0, 400.0])),
        &usual(Curvature::None),
        &pose([200.0, 200.0, 0.3], -10.0, 0.0),
    );
    assert!((0..(PIXELS[0] * PIXELS[1]) as usize).all(|index| !is_sea(&under, index)));
}
