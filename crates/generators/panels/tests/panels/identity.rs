//! From the photograph's own camera the drape gives the photograph back.

use panels::{Parameters, Shading};

use crate::shots::{draw, landscape, light, photograph, pose, run, session, stage, waves};

/// Largest and mean distance of the picture from the photograph, from its own camera.
fn apart(shading: Shading, spacing: f64) -> [f64; 2] {
    let photo = photograph(160, 1500.0, waves);
    let lights: Vec<f64> = (0..160 * 160).map(|pixel| photo.light_of(pixel % 160, pixel / 160)).collect();
    let run = Parameters { shading, spacing: Some(spacing), ..run() };
    let session = session(stage(landscape(6.0), vec![photo], 160, 0.08), run);
    let planes = draw(&*session, 160, &pose([200.0, 200.0, 1500.0], 0.0, -90.0));
    let found = light(&planes).iter().zip(&lights).map(|(found, light)| (f64::from(*found) - light).abs());
    let (mut most, mut sum) = (0.0_f64, 0.0);
    found.for_each(|apart| (most, sum) = (most.max(apart), sum + apart));
    [most, sum / lights.len() as f64]
}

#[test]
fn pixel_by_pixel_it_is_the_photograph() {
    let [most, _] = apart(Shading::Texture, 5.0);
    assert!(most < 1.0 / 255.0, "{most}");
}

#[test]
fn smaller_panels_are_nearer_to_it() {
    let means = [20.0, 10.0, 5.0].map(|spacing| apart(Shading::Panel, spacing)[1]);
    assert!(means.windows(2).all(|pair| pair[1] < 0.6 * pair[0]), "{means:?}");
    // A mixed vertex is the mean of a hexagon of panels; until panels are as small as pixels its error falls faster.
    let mixed = [20.0, 10.0, 5.0].map(|spacing| apart(Shading::Gouraud, spacing)[1]);
    assert!(mixed.windows(2).all(|pair| pair[1] < 0.45 * pair[0]), "{mixed:?}");
}
