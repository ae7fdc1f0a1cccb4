//! Lamps, stars, sheets, overlays and discs of the sky in whole pictures.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::scenes::{landscape, laws, plane, planes, pose, settings, standing_box, sun, value};
use exact::{Columns, Exact, View};
use generator::{Generator, Label, PlaneKind, Planes, Session, Stage};
use glam::DVec3;
use hardware_model::Settings;
use landscape::Landscape;
use quantities::{luminance, radians};
use scenario::{
    Carried, Curvature, DiscFace, Effects, FieldOfView, LightPoint, LightSource, Medium, Overlay, PixelRule,
    Pose, Projection, Scenery, Sheet, SkyDisc,
};
use signal::Probe;

const PIXELS: [u32; 2] = [60, 40];
const EYE: [f64; 3] = [50.0, 100.0, 2.0];

fn usual() -> Settings {
    settings(
        PIXELS[0],
        PIXELS[1],
        laws(Projection::Exact, Curvature::None, PixelRule::LineMean),
        [1.0, 140.0],
    )
}

/// The same with a field of view of so many degrees across and square pixels.
fn narrow(degrees: f64) -> Settings {
    let tan_half_width = libm::tan(radians(degrees / 2.0));
    let mut settings = usual();
    settings.raster.field = FieldOfView { tan_half_width, tan_half_height: tan_half_width * 40.0 / 60.0 };
    settings
}

fn ground() -> Arc<Landscape> {
    landscape(plane(50.0, [4, 4], 0.0, [0.0; 2]), 0.5)
}

/// Under a sun 30 degrees high: level ground has reflectivity 0.25.
fn scenery(effects: Effects) -> Scenery {
    Scenery::still(sun(180.0, 30.0)).with_effects(vec![Carried::still(effects)])
}

/// Level ground with effects, seen to the north from 2 m above it.
fn seen(effects: Effects) -> Planes {
    seen_from(effects, &pose(EYE, 0.0, 0.0), &usual())
}

fn seen_from(effects: Effects, pose: &Pose, settings: &Settings) -> Planes {
    planes(&ground(), scenery(effects), settings, pose)
}

fn lamp(at: [f64; 3]) -> LightPoint {
    LightPoint {
        id: 0,
        source: LightSource::Lamp { at: DVec3::from_array(at), diameter: 0.5 },
        colour: [1.0; 3],
        intensity: 1.0,
        lobe: None,
        priority: 0,
        calligraphic: false,
    }
}

fn star(direction: DVec3, magnitude: f64) -> LightPoint {
    let source = LightSource::Star { direction: direction.normalize(), magnitude };
    LightPoint { source, ..lamp([0.0; 3]) }
}

fn lights(lights: Vec<LightPoint>) -> Effects {
    Effects { lights, ..Effects::default() }
}

/// An upright sheet across the view at 20 m, half of it under the ground.
fn curtain(share: f64) -> Sheet {
    let corners = [[90.0, -3.0], [110.0, -3.0], [110.0, 3.0], [90.0, 3.0]];
    let corners = corners.map(|[east, up]| DVec3::new(70.0, east, up)).to_vec();
    Sheet { id: 0, corners, colour: [1.0; 3], medium: Medium::Share(share), priority: 0 }
}

fn ball(direction: DVec3, phase: f64) -> SkyDisc {
    // The sun stands aside by the phase from straight behind the eye.
    let to_sun = -direction * libm::cos(phase) + DVec3::Y * libm::sin(phase);
    let face = DiscFace::Ball { albedo: [0.5; 3], sun: to_sun };
    SkyDisc { direction, angular_diameter: radians(1.899), face }
}

/// What effects add over the whole picture.
fn sum(with: &Planes, without: &Planes) -> f64 {
    let all = 0..(PIXELS[0] * PIXELS[1]) as usize;
    all.map(|index| value(with, PlaneKind::Intensity, index) - value(without, PlaneKind::Intensity, index))
        .sum()
}

fn focal(settings: &Settings) -> f64 {
    let field = settings.raster.field;
    (f64::from(PIXELS[0]) / (2.0 * field.tan_half_width) * f64::from(PIXELS[1])
        / (2.0 * field.tan_half_height))
        .sqrt()
}

#[test]
fn a_lamp_in_the_sky_has_its_light_in_the_raster_and_of_a_beam() {
    let bare = seen(Effects::default());
    for calligraphic in [false, true] {
        for distance in [10.0, 30.0, 80.0] {
            let at = [EYE[0] + distance, EYE[1] + 0.03 * distance, EYE[2] + 0.12 * distance];
            let found = seen(lights(vec![LightPoint { calligraphic, ..lamp(at) }]));
            let away = DVec3::from_array(at).distance(DVec3::from_array(EYE));
            let diameter = 0.5 * focal(&usual()) / away;
            let expected = PI * diameter * diameter / 4.0;
            assert!((sum(&found, &bare) / expected - 1.0).abs() < 2e-6, "{calligraphic} {distance}");
        }
    }
}

/// Where the light is, the pixel of the projection is, whatever the attitude and the yoke.
#[test]
fn lamps_stand_in_true_perspective_under_every_attitude() {
    for projection in [Projection::Exact, Projection::AsReported, Projection::Corrected] {
        for (pitch, heading, yoke) in [(0.0, 0.0, 0.0), (-9.0, 40.0, 30.0), (-90.0, 70.0, -20.0)] {
            if projection != Projection::Exact && pitch < -80.0 {
                continue;
            }
            let settings = settings(
                PIXELS[0],
                PIXELS[1],
                laws(projection, Curvature::None, PixelRule::Centre),
                [1.0, 140.0],
            );
            let pose = Pose { yoke: radians(yoke), ..pose([100.0, 100.0, 30.0], pitch, heading) };
            let view = View::new(projection, &pose.attitude).with_yoke(pose.yoke);
            let at = DVec3::from_array(pose.eye) + view.perspective(0.1, -0.05).normalize() * 25.0;
            let bright = LightPoint { calligraphic: true, ..lamp(at.to_array()) };
            let found = seen_from(lights(vec![bright]), &pose, &settings);
            let bare = seen_from(Effects::default(), &pose, &settings);
            let (mut light, mut middle) = (0.0, [0.0; 2]);
            for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
                let [one, other] = [&found, &bare].map(|planes| value(planes, PlaneKind::Intensity, index));
                light += one - other;
                middle[0] += (one - other) * ((index % 60) as f64 + 0.5);
                middle[1] += (one - other) * ((index / 60) as f64 + 0.5);
            }
            let field = settings.raster.field;
            let expected =
                [30.0 * (1.0 + 0.1 / field.tan_half_width), 20.0 * (1.0 - 0.05 / field.tan_half_height)];
            let off = [0, 1].map(|axis| (middle[axis] / light - expected[axis]).abs());
            assert!(off[0] < 1e-3 && off[1] < 1e-3, "{projection:?} {pitch} {yoke}: {off:?}");
        }
    }
}

/// A box hides the lower half of a lamp behind it; the lamp before it shows whole; the one in it not at all.
#[test]
fn a_body_hides_what_is_behind_it() {
    let stage = |lights: Vec<LightPoint>| {
        let scenery = scenery(Effects { lights, ..Effects::default() });
        let scenery = scenery.with_bodies(vec![standing_box(1, [70.0, 100.0, 0.0], 2.0, 2.0)]);
        planes(&ground(), scenery, &usual(), &pose(EYE, 0.0, 0.0))
    };
    let bare = stage(Vec::new());
    for calligraphic in [false, true] {
        let found = |north: f64, up: f64| {
            let lamp = LightPoint { calligraphic, colour: [1.0; 3], ..lamp([north, 100.0, up]) };
            let diameter = 0.5 * focal(&usual()) / (north - EYE[0]);
            sum(&stage(vec![lamp]), &bare) / (PI * diameter.max(1.5) * diameter.max(1.5) / 4.0)
        };
        // The box is black from here: its lit side is in the south, where the sun and the eye are.
        let half = found(90.0, 2.0)
            / (0.5 * focal(&usual()) / 40.0 / 1.5).min(1.0)
            / (0.5 * focal(&usual()) / 40.0 / 1.5).min(1.0);
        assert!((half - 0.5).abs() < 0.01, "{calligraphic}: {half}");
        assert!(found(70.0, 1.0).abs() < 1e-6);
    }
    let before = stage(vec![lamp([60.0, 100.0, 2.0])]);
    assert_eq!(value(&before, PlaneKind::Intensity, 20 * 60 + 30), 1.0);
    assert_eq!(value(&before, PlaneKind::Label, 20 * 60 + 30), f64::from(Label::Light.code()));
    assert_eq!(value(&before, PlaneKind::Range, 20 * 60 + 30), value(&bare, PlaneKind::Range, 20 * 60 + 30));
}

/// The ray of a pixel meets level ground at 2 m over its tangent: before 20 m the curtain is hidden.
#[test]
fn ground_cuts_a_sheet_where_depth_says() {
    let (found, bare) =
        (seen(Effects { sheets: vec![curtain(0.25)], ..Effects::default() }), seen(Effects::default()));
    let field = usual().raster.field;
    let row = |index: usize| (index / 60) as f64;
    let mut counts = [0; 3];
    for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
        let [low, high] = [0.0, 1.0].map(|down| field.tan_half_height * ((row(index) + down) / 20.0 - 1.0));
        let [top, foot] = [-1.0 / 20.0, 2.0 / 20.0];
        let shown = ((high.min(foot) - low.max(top)) / (high - low)).max(0.0);
        let opaque = value(&bare, PlaneKind::Intensity, index);
        let light = value(&found, PlaneKind::Intensity, index);
        let is_across = (5..55).contains(&(index % 60));
        counts[usize::from(shown > 0.0) + usize::from(shown >= 1.0)] += usize::from(is_across);
        if is_across {
            let expected = shown * 0.75 + (1.0 - 0.75 * shown) * opaque;
            assert!((light - expected).abs() < 0.01, "{index}: {light}, not {expected}");
            let is_full = shown <= 0.0 || shown >= 1.0;
            assert!(!is_full || (light - expected).abs() < 2e-7, "{index}: {light}, not {expected}");
        }
    }
    assert!(counts.iter().all(|&count| count > 40), "{counts:?}");
}

#[test]
fn a_star_is_hidden_by_ground_and_by_the_earth() {
    let bare = seen(Effects::default());
    let up = DVec3::new(1.0, 0.03, 0.1);
    let flux = |magnitude: f64| libm::exp10(-0.4 * (magnitude - exact::WHITE_MAGNITUDE));
    for magnitude in [-3.0, 0.03, 4.0] {
        let found = seen(lights(vec![star(up, magnitude)]));
        let expected = flux(magnitude) * PI * 1.5 * 1.5 / 4.0;
        assert!((sum(&found, &bare) / expected - 1.0).abs() < 1e-6, "{magnitude}");
    }
    let below = seen(lights(vec![star(DVec3::new(1.0, 0.03, -0.1), 0.0)]));
    assert_eq!(sum(&below, &bare), 0.0);
    let earth = SkyDisc { angular_diameter: radians(8.0), ..ball(up.normalize(), PI) };
    let dark = seen(Effects { discs: vec![earth], ..Effects::default() });
    let both = seen(Effects { discs: vec![earth], ..lights(vec![star(up, 0.0)]) });
    assert_eq!(sum(&both, &dark), 0.0);
}

/// Lit area by pixels within 3 %, and the light of a ball of Lambert's law within 0.5 %.
#[test]
fn the_earth_has_its_phase() {
    let settings = narrow(3.0);
    // Only sky: the eye looks over the edge of the ground from far above.
    let pose = pose([50.0, 100.0, 1e5], 0.0, 0.0);
    let radius = focal(&settings) * libm::tan(radians(1.899 / 2.0));
    for degrees in [0.0, 40.0, 90.0, 135.0] {
        let phase = radians(degrees);
        let found =
            seen_from(Effects { discs: vec![ball(DVec3::X, phase)], ..Effects::default() }, &pose, &settings);
        let values: Vec<f64> = (0..2400).map(|index| value(&found, PlaneKind::Intensity, index)).collect();
        let area = PI * radius * radius;
        let light = values.iter().sum::<f64>() / area;
        let lambert = 2.0 / 3.0 * 0.5 * (libm::sin(phase) + (PI - phase) * libm::cos(phase)) / PI;
        assert!((light - lambert).abs() < 0.005 * lambert.max(0.05), "{degrees}: {light}, not {lambert}");
        // Half of a pixel that a rim crosses is lit in the mean.
        let lit = values.iter().filter(|&&value| value > 0.0).count() as f64;
        let rim = PI * radius * (1.0 + libm::cos(phase).abs()) / 2.0 + PI * radius;
        let expected = area * (1.0 + libm::cos(phase)) / 2.0;
        assert!((lit - 0.32 * rim - expected).abs() < 0.03 * area, "{degrees}: {lit}, not {expected}");
        assert!(found.get(PlaneKind::Label).unwrap().iter().all(|&label| label == 0.0));
    }
}

#[test]
fn the_sun_has_its_diameter() {
    let settings = narrow(1.0);
    let face = DiscFace::Sun { colour: [1.0; 3] };
    let disc = SkyDisc { direction: DVec3::X, angular_diameter: radians(0.532906214492), face };
    let pose = pose([50.0, 100.0, 1e5], 0.0, 0.0);
    let found = seen_from(Effects { discs: vec![disc], ..Effects::default() }, &pose, &settings);
    let light: f64 = (0..2400).map(|index| value(&found, PlaneKind::Intensity, index)).sum();
    let diameter = 2.0 * (light / PI).sqrt();
    let expected = 2.0 * focal(&settings) * libm::tan(radians(0.532906214492 / 2.0));
    assert!((diameter / expected - 1.0).abs() < 1e-3, "{diameter}, not {expected}");
}

#[test]
fn an_overlay_lies_over_everything_by_its_area() {
    // From the middle of pixel 10 to three quarters of pixel 20, and from line 5 to a quarter of line 9.
    let [left, right] = [10.5, 20.75].map(|x| x / 30.0 - 1.0);
    let [top, bottom] = [5.0, 9.25].map(|y| y / 20.0 - 1.0);
    let corners = vec![[left, top], [right, top], [right, bottom], [left, bottom]];
    let overlay = Overlay { id: 0, corners, colour: [0.5; 3], share: 0.0, priority: 0 };
    let clear = Overlay { share: 0.75, ..overlay.clone() };
    let bright = LightPoint { intensity: 1.0, ..lamp([51.0, 99.7, 2.2]) };
    let found = seen(Effects { overlays: vec![overlay], ..lights(vec![bright]) });
    for (index, share) in [(5 * 60 + 10, 0.5), (6 * 60 + 15, 1.0), (7 * 60 + 20, 0.75), (9 * 60 + 15, 0.25)] {
        let bare = value(&seen(lights(vec![bright])), PlaneKind::Intensity, index);
        let expected = share * 0.5 + (1.0 - share) * bare;
        assert!((value(&found, PlaneKind::Intensity, index) - expected).abs() < 0.02, "{index}");
    }
    assert_eq!(value(&found, PlaneKind::Label, 6 * 60 + 15), f64::from(Label::EyeFixed.code()));
    let alone = seen(Effects { overlays: vec![clear], ..Effects::default() });
    for (index, share) in [(5 * 60 + 10, 0.5), (6 * 60 + 15, 1.0), (7 * 60 + 20, 0.75), (9 * 60 + 15, 0.25)] {
        let bare = value(&seen(Effects::default()), PlaneKind::Intensity, index);
        let expected = share * 0.25 * 0.5 + (1.0 - 0.25 * share) * bare;
        assert!((value(&alone, PlaneKind::Intensity, index) - expected).abs() < 1e-7, "{index}");
        assert_eq!(value(&alone, PlaneKind::Label, index), 0.0);
    }
}

/// Some of everything.
fn fair() -> Effects {
    let warm = |light: LightPoint| LightPoint { colour: [1.0, 0.8, 0.5], ..light };
    let beam = |light: LightPoint| LightPoint { calligraphic: true, ..light };
    let stars = (0..40).map(|k| {
        let [a, b] = [f64::from(k * 7 % 40), f64::from(k * 11 % 40)].map(|at| at / 40.0 - 0.5);
        LightPoint { id: 10 + k, ..star(DVec3::new(1.0, a, 0.25 + b / 3.0), 0.1 * f64::from(k)) }
    });
    let lamps = [
        lamp([58.0, 102.0, 2.2]),
        warm(lamp([75.0, 97.0, 1.6])),
        beam(lamp([80.0, 104.0, 2.4])),
        beam(warm(lamp([66.0, 96.0, 0.5]))),
    ];
    Effects {
        lights: lamps.into_iter().chain(stars).collect(),
        sheets: vec![curtain(0.4), Sheet { colour: [0.6, 0.4, 0.2], id: 1, ..leaning() }],
        overlays: vec![Overlay {
            id: 0,
            corners: vec![[-1.0, 0.9], [1.0, 0.8], [1.0, 1.0], [-1.0, 1.0]],
            colour: [0.1; 3],
            share: 0.2,
            priority: 0,
        }],
        discs: vec![ball(DVec3::new(1.0, -0.3, 0.2).normalize(), 1.0)],
    }
}

/// A sheet of dust that goes through the curtain.
fn leaning() -> Sheet {
    let corners = [[60.0, 94.0, 0.2], [82.0, 98.0, 0.2], [82.0, 98.0, 4.0], [60.0, 94.0, 4.0]];
    let medium = Medium::Dust { kappa: 0.3, thickness: 1.0 };
    Sheet { corners: corners.map(DVec3::from_array).to_vec(), medium, ..curtain(0.0) }
}

fn session(effects: Effects) -> (Box<dyn Session>, Stage) {
    let stage = Stage { landscape: ground(), scenery: Arc::new(scenery(effects)), view: usual().view() };
    (Exact.prepare(stage.clone()).unwrap(), stage)
}

#[test]
fn any_number_of_threads_gives_the_same_bits_and_so_does_a_column_alone() {
    let (session, stage) = session(fair());
    let pose = Pose { yoke: 0.1, ..pose(EYE, 2.0, 0.0) };
    let picture = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut planes = Planes::new(60, 40, &PlaneKind::ALL);
        pool.install(|| session.frame(0, &pose, &mut planes, &mut Probe::off()).unwrap());
        planes
    };
    let one = picture(1);
    let bits = |planes: &Planes| -> Vec<u32> {
        PlaneKind::ALL
            .iter()
            .flat_map(|&kind| planes.get(kind).unwrap())
            .map(|value| value.to_bits())
            .collect()
    };
    assert_eq!(bits(&one), bits(&picture(2)));
    let columns = Columns::new(stage);
    for column in 0..60 {
        let alone = columns.column(0, &pose, column, &PlaneKind::ALL).unwrap();
        for kind in PlaneKind::ALL {
            let picture: Vec<f32> = one.get(kind).unwrap().iter().skip(column).step_by(60).copied().collect();
            assert_eq!(alone.get(kind).unwrap(), picture, "{column} {}", kind.name());
        }
    }
}

#[test]
fn intensity_is_the_luminance_and_no_value_is_no_number() {
    let found = seen(fair());
    let (mut colours, mut labels) = (0, [0; 3]);
    for index in 0..(PIXELS[0] * PIXELS[1]) as usize {
        let colour = PlaneKind::COLOUR.map(|kind| value(&found, kind, index));
        let intensity = value(&found, PlaneKind::Intensity, index);
        assert!((intensity - luminance(colour)).abs() < 1e-6, "{index}");
        assert!(PlaneKind::ALL.iter().all(|&kind| !value(&found, kind, index).is_nan()));
        colours += usize::from(colour[0] > colour[2] + 1e-3);
        let label = value(&found, PlaneKind::Label, index) as usize;
        if let Some(count) = label.checked_sub(usize::from(Label::Light.code())) {
            labels[count] += 1;
        }
    }
    assert!(colours > 50 && labels.iter().all(|&count| count > 0), "{colours} {labels:?}");
    let (_, stage) = session(fair());
    assert!(stage.is_colourful() && !session(lights(vec![lamp(EYE)])).1.is_colourful());
}

#[test]
fn a_lamp_at_the_eye_leaves_the_picture_as_it_is() {
    let bare = seen(Effects::default());
    let nowhere = [EYE, [f64::NAN; 3], [EYE[0], EYE[1], EYE[2] + 5e-4]].map(lamp).to_vec();
    let found = seen(lights(nowhere));
    for kind in PlaneKind::ALL {
        assert_eq!(found.get(kind), bare.get(kind), "{}", kind.name());
    }
}
