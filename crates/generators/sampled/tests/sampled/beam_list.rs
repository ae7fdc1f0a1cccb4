//! What leaves for the beam: its list, its order, its layer; and what one sampling point says of itself.

use crate::shots::{Shot, is_same_sum};
use generator::PlaneKind;
use sampled::{BeamLayer, BeamOrder};
use scenario::LightPoint;
use serde_json::Value;

/// Three calligraphic lamps over grey ground: one clear, one half behind a pane, one wholly behind a wall.
fn three_lamps() -> Shot {
    let mut shot = Shot::new(48, 32, 300.0);
    let lamp = |id: u32, at: [f64; 2]| LightPoint { calligraphic: true, ..shot.lamp(id, at, 100.0, 0.8) };
    let lights = vec![lamp(0, [40.2, 9.7]), lamp(1, [9.6, 9.2]), lamp(2, [24.4, 9.5])];
    let box_at = |x: f64| [[x, 2.0], [x + 6.0, 2.0], [x + 6.0, 16.0], [x, 16.0]];
    let pane = shot.sheet(0, &box_at(6.6), 50.0, [0.0; 3], 0.25);
    let wall = shot.sheet(1, &box_at(21.4), 50.0, [0.3; 3], 0.0);
    (shot.effects.lights, shot.effects.sheets) = (lights, vec![pane, wall]);
    shot
}

fn light(frame: &crate::shots::Frame) -> f64 {
    frame.sum(PlaneKind::Red)
}

#[test]
fn the_list_says_what_the_beam_layer_shows() {
    let mut shot = three_lamps();
    let points = shot.session().beam_list(0, &shot.pose).unwrap().unwrap();
    let numbers: Vec<u32> = points.iter().map(|point| point.light).collect();
    assert_eq!(numbers, [0, 1], "near to far; what is hidden is not sent");
    let shares = points.iter().map(|point| point.attenuation / f64::from(point.aperture)).collect::<Vec<_>>();
    assert!((shares[0] - 1.0).abs() < 1e-12 && (shares[1] - 0.25).abs() < 1e-12, "{shares:?}");
    shot.run.sampling.beam_layer = BeamLayer::Beam;
    let area = |diameter: f64| std::f64::consts::PI * diameter * diameter / 4.0;
    let sent = points.iter().map(|point| point.display_intensity * area(point.diameter_px)).sum::<f64>();
    assert!(is_same_sum(light(&shot.draw()), sent));
}

#[test]
fn layers_add_up_to_the_picture() {
    let mut shot = three_lamps();
    let [both, raster, beam] = [BeamLayer::Both, BeamLayer::Raster, BeamLayer::Beam].map(|layer| {
        shot.run.sampling.beam_layer = layer;
        shot.draw()
    });
    for pixel in 0..48 * 32 {
        let sum = raster.colour(pixel)[0] + beam.colour(pixel)[0];
        assert!((both.colour(pixel)[0] - sum).abs() < 1e-6, "{pixel}");
    }
    assert!(light(&raster) > 0.0 && light(&beam) > 0.0);
}

#[test]
fn the_nearest_neighbour_cuts_jumps_and_no_light() {
    let mut shot = three_lamps();
    shot.effects.sheets.clear();
    let far = light(&shot.draw());
    let path = |shot: &Shot| {
        let points = shot.session().beam_list(0, &shot.pose).unwrap().unwrap();
        let places = points.iter().map(|point| point.place_px).collect::<Vec<_>>();
        let jump = |pair: &[[f64; 2]]| libm::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
        ([[0.0; 2]].into_iter().chain(places).collect::<Vec<_>>()).windows(2).map(jump).sum::<f64>()
    };
    let usual = path(&shot);
    shot.run.sampling.beam_order = BeamOrder::NearestNeighbour;
    assert!(path(&shot) < 0.7 * usual, "{} {usual}", path(&shot));
    assert!(is_same_sum(light(&shot.draw()), far));
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// Weights and rest sum to 1, the colour is the sum of the lights, and the pane and the lamp that cover it are told.
#[test]
fn a_sampling_point_tells_all_that_it_holds() {
    let shot = three_lamps();
    let session = shot.session();
    let told = session.sampling_point(0, &shot.pose, [9, 9], 2).unwrap().unwrap();
    let layers = told["stack"].as_array().unwrap();
    let weights: f64 = layers.iter().map(|layer| number(&layer["weight"])).sum();
    assert!((weights + number(&told["rest"]) - 1.0).abs() < 1e-12);
    for channel in 0..3 {
        let sum: f64 = layers.iter().map(|layer| number(&layer["light"][channel])).sum();
        assert!((sum - number(&told["colour"][channel])).abs() < 1e-12);
    }
    assert!((number(&layers[0]["depth_m"]) - 50.0).abs() < 1e-3, "{told}");
    let covering: Vec<&Value> =
        told["list"].as_array().unwrap().iter().filter(|entry| entry["covers"] == true).collect();
    assert!(covering.iter().any(|entry| entry["light"] == 1 && entry["drawn_by"] == "beam"), "{told}");
    let beam = &told["beam"][0];
    assert_eq!((beam["light"].as_u64(), number(&beam["share"])), (Some(1), 0.25));
    assert!(session.sampling_point(0, &shot.pose, [9, 9], 4).unwrap().is_none(), "pattern 4 has four");
}

/// A stack that keeps one of two panes can be wrong by what lies behind the first.
#[test]
fn a_frame_tells_the_largest_loss() {
    let mut shot = Shot::new(16, 16, 300.0);
    shot.effects.sheets = vec![shot.filling(0, 10.0, [0.5; 3], 0.5), shot.filling(1, 20.0, [1.0; 3], 0.5)];
    assert_eq!(shot.draw().counts["loss_bound_ppm"], 0);
    shot.run.sampling.translucent = Some(1);
    assert_eq!(shot.draw().counts["loss_bound_ppm"], 500_000);
}
