//! Scenes whose picture is known in closed form.

use crate::scenes::{draw, landscape, laws, level, plane, pose, settings, sun};
use exact::{Ceilings, LINE_MEAN_TOLERANCE, Outlook, Ray, Sight, View};
use hardware_model::{Raster, Settings};
use landscape::{LUNOID_RADIUS, Level, basis};
use scenario::{Curvature, PixelRule, Pose, Projection};

/// The ray through the centre of a pixel, as far as the view law goes.
fn ray(settings: &Settings, pose: &Pose, column: usize, line: f64) -> Ray {
    let Raster { columns, lines, field, .. } = settings.raster;
    let x = field.tan_half_width * (2.0 * (column as f64 + 0.5) / f64::from(columns) - 1.0);
    let y = field.tan_half_height * (2.0 * line / f64::from(lines) - 1.0);
    View::new(settings.laws.projection, &pose.attitude).ray(x, y)
}

fn range_of(sight: Sight) -> f64 {
    match sight {
        Sight::Ground(spot) => spot.range,
        Sight::Sky | Sight::TooNear | Sight::Cut(_) => f64::INFINITY,
    }
}

/// Looks north from `eye` over `level`.
fn looking_north(
    level: &Level,
    eye: [f64; 3],
    curvature: Curvature,
    ranges: [f64; 2],
    rises: &[f64],
) -> Vec<Sight> {
    let ground = landscape(level.clone(), 1.0);
    let ceilings = Ceilings::new(&ground);
    let outlook = Outlook::new(&ground, &ceilings, eye, curvature, ranges, None);
    rises.iter().map(|&rise| outlook.look(&Ray { direction: [1.0, 0.0], rise })).collect()
}

/// Every pixel of a picture of a plane against `s = H / (slope along the azimuth - rise)`.
fn check_plane(slopes: [f64; 2], projection: Projection, pitch: f64, heading: f64) {
    let (height, ranges) = (1.63, [2.0, 300.0]);
    let level = plane(40.0, [20, 20], 12.0, slopes);
    let eye = [400.0, 390.0, 12.0 + 400.0 * slopes[0] + 390.0 * slopes[1] + height];
    let settings = settings(24, 40, laws(projection, Curvature::None, PixelRule::Centre), ranges);
    let pose = pose(eye, pitch, heading);
    let sun = sun(70.0, 24.0);
    let (intensity, range) = draw(&landscape(level, 0.5), sun, &settings, &pose);
    let lambert = 0.5 * sun.reflectivity(slopes);
    let mut kinds = [0; 2];
    for (index, (&intensity, &range)) in intensity.iter().zip(&range).enumerate() {
        let ray = ray(&settings, &pose, index % 24, (index / 24) as f64 + 0.5);
        let slope = slopes[0] * ray.direction[0] + slopes[1] * ray.direction[1];
        let expected = height / (slope - ray.rise);
        if expected >= ranges[0] && expected <= ranges[1] {
            assert!((f64::from(intensity) - lambert).abs() < 1e-7, "{index}: {intensity}, not {lambert}");
            assert!((f64::from(range) / expected - 1.0).abs() < 1e-7, "{index}: {range}, not {expected}");
            kinds[0] += 1;
        } else {
            assert_eq!((intensity, range), (0.0, f32::INFINITY), "{index}");
            kinds[1] += 1;
        }
    }
    assert!(kinds.iter().all(|&count| count > 100), "{kinds:?}: both ground and sky");
}

#[test]
fn a_flat_plane_is_sin_e_below_its_horizon() {
    for projection in [Projection::Exact, Projection::AsReported, Projection::Corrected] {
        check_plane([0.0, 0.0], projection, 0.0, 33.0);
    }
    check_plane([0.0, 0.0], Projection::Exact, -4.0, 290.0);
    check_plane([0.0, 0.0], Projection::AsReported, 3.0, 180.0);
}

#[test]
fn a_tilted_plane_has_one_shade_and_a_tilted_horizon() {
    for projection in [Projection::Exact, Projection::AsReported, Projection::Corrected] {
        check_plane([0.08, -0.05], projection, 0.0, 0.0);
        check_plane([0.02, 0.07], projection, 4.0, 135.0);
    }
}

#[test]
fn ground_range_is_height_over_depression() {
    let level = plane(40.0, [20, 20], 12.0, [0.0; 2]);
    let rises: Vec<f64> = (1..200).map(|step| -0.4 * f64::from(step) / 200.0 - 0.005).collect();
    let sights = looking_north(&level, [3.0, 17.0, 13.63], Curvature::None, [1.0, 700.0], &rises);
    for (rise, sight) in rises.into_iter().zip(sights) {
        let expected = 1.63 / -rise;
        assert!((range_of(sight) / expected - 1.0).abs() < 1e-9, "{rise}: {sight:?}, not {expected}");
    }
}

#[test]
fn the_horizon_of_the_lunoid() {
    let (height, double) = (1.63, 2.0 * LUNOID_RADIUS);
    let level = plane(500.0, [12, 2], 0.0, [0.0; 2]);
    let horizon = -(4.0 * height / double).sqrt();
    let eye = [100.0, 500.0, height];
    let look = |rise: f64| looking_north(&level, eye, Curvature::Parabolic, [1.5, 5000.0], &[rise])[0];
    assert_eq!(look(horizon * (1.0 - 1e-9)), Sight::Sky);
    assert!((range_of(look(horizon * (1.0 + 1e-9))) - 2379.9).abs() < 0.5);
    for factor in [1.0001, 1.01, 1.5, 10.0, 200.0] {
        let rise = horizon * factor;
        // s^2 / 2R + t s + H = 0, the nearer root, without cancellation.
        let root = (rise * rise - 4.0 * height / double).sqrt();
        let expected = 2.0 * height / (root - rise);
        assert!((range_of(look(rise)) / expected - 1.0).abs() < 1e-9, "{factor}");
    }
}

#[test]
fn the_mean_of_a_line_is_the_share_that_ground_covers() {
    let (height, ranges) = (1.63, [7.0, 300.0]);
    let settings = settings(9, 30, laws(Projection::Exact, Curvature::None, PixelRule::LineMean), ranges);
    let pose = pose([400.0, 390.0, height], 0.0, 10.0);
    let sun = sun(70.0, 24.0);
    let (intensity, _) = draw(&landscape(plane(40.0, [20, 20], 0.0, [0.0; 2]), 1.0), sun, &settings, &pose);
    let field = settings.raster.field;
    let mut partial = 0;
    for (index, &found) in intensity.iter().enumerate() {
        let x = field.tan_half_width * ((2 * (index % 9) + 1) as f64 / 9.0 - 1.0);
        // Ground of range s lies at y = H / s * sqrt(1 + x^2); in lines from the top:
        let line_of =
            |range: f64| (height / range * (1.0 + x * x).sqrt() / field.tan_half_height + 1.0) * 15.0;
        let line = (index / 9) as f64;
        let share = (line_of(ranges[0]).min(line + 1.0) - line_of(ranges[1]).max(line)).max(0.0);
        partial += usize::from(share > 0.0 && share < 1.0);
        let expected = share * sun.reflectivity([0.0; 2]);
        assert!(
            (f64::from(found) - expected).abs() < 2.0 * LINE_MEAN_TOLERANCE,
            "{index}: {found}, {expected}"
        );
    }
    assert_eq!(partial, 18, "a horizon and a near edge in every column");
}

/// Level ground with a ridge across at x = 400 m and a hill across at x = 800 m; regions of 40 m.
fn ridge_and_hill() -> Level {
    level(40.0, [25, 4], |m, _| {
        let height = [(10.0, 5.0), (20.0, 50.0)].iter().find(|(row, _)| *row == m).map_or(0.0, |pair| pair.1);
        [height, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    })
}

#[test]
fn a_ridge_hides_the_valley_behind_it() {
    let (eye, height) = ([300.0, 77.0, 1.63], 1.63);
    // Rise of the ridge's near flank, x = 360..400 m, and its largest value by golden section.
    let rise = |u: f64| (5.0 * basis::values(u)[3] - height) / (60.0 + 40.0 * u);
    let (mut low, mut high) = (0.5, 1.0);
    for _ in 0..80 {
        let (a, b) = (high - 0.6180339887498949 * (high - low), low + 0.6180339887498949 * (high - low));
        if rise(a) < rise(b) { low = a } else { high = b }
    }
    let (top, top_range) = (rise(low), 60.0 + 40.0 * low);
    let level = ridge_and_hill();
    let rises = [top - 1e-9, top + 1e-9, top + 1e-3, -0.01];
    let sights = looking_north(&level, eye, Curvature::None, [1.5, 650.0], &rises);
    let ranges: Vec<f64> = sights.into_iter().map(range_of).collect();
    assert!(ranges[0] < top_range && ranges[0] > top_range - 0.1, "just under the ridge line: {ranges:?}");
    // Behind: 50 g(u) - H = t s on the near flank of the hill, x = 760..800 m.
    for (&range, rise) in ranges[1..3].iter().zip([top + 1e-9, top + 1e-3]) {
        let on_hill = 50.0 * basis::values((range - 460.0) / 40.0)[3] - height;
        assert!(range > 460.0 && range < 500.0 && (on_hill - rise * range).abs() < 1e-10, "{range}");
    }
    // A falling ray meets the flank's foot, not the level ground 163 m away that the ridge hides.
    assert!((5.0 * basis::values((ranges[3] - 60.0) / 40.0)[3] - height + 0.01 * ranges[3]).abs() < 1e-10);
    assert!(ranges[3] < top_range);
}
