//! Effects over surfaces that are told in closed form, in f64: planes round to f32.

use std::f64::consts::PI;

use glam::DVec3;
use landscape::{Attitude, Bank, Landscape, Level};
use scenario::{Curvature, Effects, FieldOfView, LightPoint, LightSource, Medium, Projection, Sheet};

use super::matter::Back;
use super::placing::Placing;
use super::screen::Screen;
use super::stack::Surface;
use super::{Features, Mix};
use crate::view::View;
use crate::{Ceilings, Outlook};

const SIZE: [usize; 2] = [1000, 600];
/// Focal length of 1000 pixels over 50 degrees, as in the check values.
const FOCAL: f64 = 1_072.253_460_254_779;
const EYE: DVec3 = DVec3::new(0.0, 0.0, 50.0);

/// The same at every place.
struct Even(Back);

impl Surface for Even {
    fn back(&mut self, _: [f64; 2]) -> Back {
        self.0
    }

    fn lit(&mut self, _: [f64; 2]) -> (Back, [f64; 3]) {
        (self.0, [0.25; 3])
    }
}

/// Ground 10 m away below a line `y = slope x + height` of the screen (pixels), sky above.
struct Ridge {
    height: f64,
    slope: f64,
}

impl Surface for Ridge {
    fn back(&mut self, [x, y]: [f64; 2]) -> Back {
        if y < self.height + self.slope * x { Back::SKY } else { Back { depth: 10.0, is_open: false } }
    }

    fn lit(&mut self, at: [f64; 2]) -> (Back, [f64; 3]) {
        let back = self.back(at);
        (back, if back.is_open { [0.0; 3] } else { [0.5; 3] })
    }
}

/// Effects before an eye 50 m over the origin of flat ground that looks north.
fn features(effects: &Effects) -> Features {
    features_over(effects, Curvature::None)
}

/// The same over a lunoid of a shape.
fn features_over(effects: &Effects, curvature: Curvature) -> Features {
    let level = Level::new(20.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
    let ground = Landscape::new(Bank::new("test", vec![level], None).unwrap(), 0.5);
    let ceilings = Ceilings::new(&ground);
    let outlook = Outlook::new(&ground, &ceilings, EYE.to_array(), curvature, [0.0, 99.0], None);
    let tan_half_width = SIZE[0] as f64 / (2.0 * FOCAL);
    let field = FieldOfView { tan_half_width, tan_half_height: tan_half_width * 0.6 };
    let (screen, view) = (Screen::new(SIZE, field), View::new(Projection::Exact, &Attitude::default()));
    let placed = Placing { outlook: &outlook, view: &view, screen }.features(effects);
    Features::new(placed, screen, view)
}

/// A lamp of 0.3 m at `to` (north, east, up; m) from the eye.
fn lamp(to: [f64; 3]) -> LightPoint {
    LightPoint {
        id: 0,
        source: LightSource::Lamp { at: EYE + DVec3::from_array(to), diameter: 0.3 },
        colour: [1.0; 3],
        intensity: 1.0,
        lobe: None,
        priority: 0,
        calligraphic: false,
    }
}

/// An upright square of 200 m across the view, `north` of the eye (m).
fn sheet(north: f64, share: f64, colour: [f64; 3]) -> Sheet {
    let corners = [[-100.0, -100.0], [100.0, -100.0], [100.0, 100.0], [-100.0, 100.0]];
    let corners = corners.map(|[east, up]| EYE + DVec3::new(north, east, up)).to_vec();
    Sheet { id: 7, corners, colour, medium: Medium::Share(share), priority: 0 }
}

/// Mixes of all pixels that a feature can reach.
fn mixes(features: &Features, index: usize, surface: &mut impl Surface) -> Vec<Mix> {
    let [[left, top], [right, bottom]] = features.pixels(index);
    let pixels = (left..right).flat_map(|column| (top..bottom).map(move |line| [column, line]));
    pixels.filter_map(|pixel| features.mix(pixel, true, surface)).collect()
}

/// Light that raster lamps add before a surface, red alone.
fn light(lights: Vec<LightPoint>, surface: &mut impl Surface) -> f64 {
    let features = features(&Effects { lights, ..Effects::default() });
    mixes(&features, 0, surface).iter().map(|mix| mix.added[0]).sum()
}

/// Shares of calligraphic points that reach the eye.
fn shares(effects: &Effects, surface: &mut impl Surface) -> Vec<f64> {
    let features = features(effects);
    let beams = (0..features.all.len()).filter(|&index| features.all[index].beam().is_some());
    let share = |index: usize| {
        let mixes = mixes(&features, index, surface);
        let of_it = mixes.iter().flat_map(|mix| &mix.beams).filter(|reached| reached.index == index);
        let (aperture, visible) =
            of_it.fold((0.0, 0.0), |sum, reached| (sum.0 + reached.aperture, sum.1 + reached.visible));
        visible / aperture
    };
    beams.map(share).collect()
}

/// Area of the disc of a lamp of 0.3 m (pixels squared), were there no least diameter.
fn disc(distance: f64) -> f64 {
    let diameter = 0.3 * FOCAL / distance;
    PI * diameter * diameter / 4.0
}

#[test]
fn a_lamp_follows_the_inverse_square_and_has_no_step() {
    for step in 0..=400 {
        let distance = 50.0 * libm::exp10(f64::from(step) / 200.0);
        let found = light(vec![lamp([distance, 0.0, 0.0])], &mut Even(Back::SKY));
        assert!((found / disc(distance) - 1.0).abs() < 1e-9, "{distance}: {found}");
    }
    for (distance, expected) in [(50.0, 32.507778728809), (400.0, 0.507934042638), (5000.0, 0.003250777873)] {
        let found = light(vec![lamp([distance, 0.0, 0.0])], &mut Even(Back::SKY));
        assert!((found - expected).abs() < 1e-11, "{distance}: {found}");
    }
    let [before, behind] = [214.450692050955, 214.450692050957]
        .map(|distance| light(vec![lamp([distance, 0.0, 0.0])], &mut Even(Back::SKY)));
    assert!((before - behind).abs() < 1e-12 && (before - 1.767145867644).abs() < 1e-11);
}

#[test]
fn a_lamp_keeps_its_light_wherever_it_lies_in_a_pixel() {
    for distance in [60.0, 300.0] {
        for step in 0..100 {
            let along = |k: i32| distance * f64::from(step * k % 100) / 100.0 / FOCAL;
            let at = [distance, along(1), along(37)];
            let away = DVec3::from_array(at).length();
            let found = light(vec![lamp(at)], &mut Even(Back::SKY));
            assert!((found / disc(away) - 1.0).abs() < 1e-9, "{at:?}: {found}");
        }
    }
}

#[test]
fn sheets_dim_lamps_in_the_raster_and_of_a_beam_alike() {
    let sheets = vec![sheet(20.0, 0.7, [0.0; 3]), sheet(30.0, 0.5, [0.0; 3])];
    for distance in [100.0, 1000.0] {
        let mut effects = Effects {
            lights: vec![lamp([distance, 3.0, 1.0])],
            sheets: sheets.clone(),
            ..Effects::default()
        };
        let bare = light(effects.lights.clone(), &mut Even(Back::SKY));
        let found: f64 =
            mixes(&features(&effects), 2, &mut Even(Back::SKY)).iter().map(|mix| mix.added[0]).sum();
        assert!((found / bare - 0.35).abs() < 1e-12, "{}", found / bare);
        effects.lights[0].calligraphic = true;
        assert!((shares(&effects, &mut Even(Back::SKY))[0] - 0.35).abs() < 1e-12);
        // Before the farther sheet; before both.
        effects.lights[0] = LightPoint { calligraphic: true, ..lamp([25.0, 0.0, 0.0]) };
        assert!((shares(&effects, &mut Even(Back::SKY))[0] - 0.7).abs() < 1e-12);
        effects.lights[0] = LightPoint { calligraphic: true, ..lamp([15.0, 0.0, 0.0]) };
        assert!((shares(&effects, &mut Even(Back::SKY))[0] - 1.0).abs() < 1e-12);
    }
}

/// Check values 8.1, in both orders.
#[test]
fn sheets_are_mixed_from_near_to_far() {
    let (one, other) = ((0.7, [0.9, 0.8, 0.6]), (0.5, [0.2, 0.2, 0.3]));
    let opaque = [0.4, 0.35, 0.3];
    let mixed = |near: (f64, [f64; 3]), far: (f64, [f64; 3])| {
        let sheets = vec![sheet(30.0, far.0, far.1), sheet(20.0, near.0, near.1)];
        let features = features(&Effects { sheets, ..Effects::default() });
        let mix = features.mix([500, 300], false, &mut Even(Back { depth: 40.0, is_open: false })).unwrap();
        [0, 1, 2].map(|k| mix.added[k] + mix.through[k] * opaque[k])
    };
    for (found, expected) in
        [(mixed(one, other), [0.48, 0.4325, 0.39]), (mixed(other, one), [0.375, 0.3425, 0.345])]
    {
        assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-12), "{found:?}");
    }
}

/// Check values 8.1: a lamp of intensity 0.35 between a sheet and the opaque.
#[test]
fn a_lamp_hides_as_much_as_it_shines() {
    let lamp = LightPoint { colour: [1.0, 0.9, 0.7], intensity: 0.35, ..lamp([30.0, 0.0, 0.0]) };
    let effects =
        Effects { lights: vec![lamp], sheets: vec![sheet(20.0, 0.7, [0.9, 0.8, 0.6])], ..Effects::default() };
    let mix =
        features(&effects).mix([500, 300], false, &mut Even(Back { depth: 40.0, is_open: false })).unwrap();
    let found = [0, 1, 2].map(|k| mix.added[k] + mix.through[k] * [0.4, 0.35, 0.3][k]);
    let expected = [0.697, 0.61975, 0.488];
    assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-12), "{found:?}");
}

#[test]
fn dust_is_darker_on_a_longer_path() {
    let dust = Sheet { medium: Medium::Dust { kappa: 0.05, thickness: 10.0 }, ..sheet(20.0, 0.0, [0.0; 3]) };
    let features = features(&Effects { sheets: vec![dust], ..Effects::default() });
    for pixel in [[500, 300], [0, 300], [990, 20]] {
        let mix = features.mix(pixel, false, &mut Even(Back::SKY)).unwrap();
        let [x, y] = [0, 1].map(|axis| (pixel[axis] as f64 + 0.5 - SIZE[axis] as f64 / 2.0) / FOCAL);
        let path = 10.0 * (1.0 + x * x + y * y).sqrt();
        assert!((mix.through[0] - libm::exp(-0.05 * path)).abs() < 1e-12, "{pixel:?}");
    }
}

/// Share of a circle of radius 1 that lies above a chord `height` below its middle.
fn above(height: f64) -> f64 {
    let height = height.clamp(-1.0, 1.0);
    (PI - libm::acos(height) + height * (1.0 - height * height).sqrt()) / PI
}

/// A disc of 3.2 pixels sinks behind a ridge. Level ridges are met to 1/128 of a pixel, others to 1/14 in each pixel.
#[test]
fn a_ridge_hides_the_share_below_it() {
    let radius = 0.15 * FOCAL / 100.0;
    for (slope, tolerance) in [(0.0, 0.009), (0.3, 0.02), (-1.0, 0.02)] {
        let mut last = 1.0 + tolerance;
        for step in 0..=100 {
            let height = 2.5 - f64::from(step) / 20.0;
            let across = libm::hypot(1.0, slope);
            let mut ridge = Ridge { height: 300.0 + height - slope * 500.0, slope };
            let beam = LightPoint { calligraphic: true, ..lamp([100.0, 0.0, 0.0]) };
            let found = shares(&Effects { lights: vec![beam], ..Effects::default() }, &mut ridge)[0];
            let raster = light(vec![lamp([100.0, 0.0, 0.0])], &mut ridge) / disc(100.0);
            let expected = above(height / across / radius);
            assert!((found - expected).abs() < tolerance, "{slope} {height}: {found}, not {expected}");
            assert!((raster - found).abs() < 1e-12 && found <= last + 1e-12);
            last = found;
        }
        assert_eq!(last, 0.0);
    }
}

/// A near disc that covers all pixels of the far one, and one that ends in the same pixels as it.
#[test]
fn the_nearer_of_two_calligraphic_points_veils_the_farther() {
    let near = |north| LightPoint { intensity: 0.8, calligraphic: true, ..lamp([north, 0.0, 0.0]) };
    let far = LightPoint { id: 1, intensity: 0.6, calligraphic: true, ..lamp([110.0, 0.0, 0.0]) };
    for (north, tolerance) in [(50.0, 1e-12), (100.0, 2e-3)] {
        for lights in [vec![near(north), far], vec![far, near(north)]] {
            let is_near = lights[0].id == 0;
            let found = shares(&Effects { lights, ..Effects::default() }, &mut Even(Back::SKY));
            let [first, second] = if is_near { [found[0], found[1]] } else { [found[1], found[0]] };
            assert!((first - 1.0).abs() < 1e-12 && (second - 0.2).abs() < tolerance, "{found:?}");
        }
    }
}

/// Two opaque sheets cross 20 m ahead on an upright line through a pixel: each is seen on its side of the line.
#[test]
fn sheets_that_cross_in_a_pixel_share_it() {
    let red = sheet(20.0, 0.0, [1.0, 0.0, 0.0]);
    let turn = |corner: &DVec3, east: f64| DVec3::new(20.0 + 0.1 * (corner.y - east), corner.y, corner.z);
    for share in [0.1, 0.5, 0.85] {
        let east = 20.0 * (3.0 + share) / FOCAL;
        let corners = red.corners.iter().map(|corner| turn(corner, east)).collect();
        let green = Sheet { id: 8, corners, colour: [0.0, 1.0, 0.0], ..red.clone() };
        let features = features(&Effects { sheets: vec![red.clone(), green], ..Effects::default() });
        let mix = features.mix([503, 300], false, &mut Even(Back::SKY)).unwrap();
        assert!((mix.added[1] - share).abs() < 1.0 / 128.0, "{share}: {mix:?}");
        assert!((mix.added[0] + mix.added[1] - 1.0).abs() < 1e-12 && mix.through == [0.0; 3]);
    }
}

/// Two sheets side by side are one: no gap of light shows between them.
#[test]
fn sheets_that_share_an_edge_let_through_what_one_does() {
    let half = |low: f64, high: f64, id: u32| {
        let corners = [[low, -100.0], [high, -100.0], [high, 100.0], [low, 100.0]];
        let corners = corners.map(|[east, up]| EYE + DVec3::new(20.0, east + 0.004 * up, up)).to_vec();
        Sheet { id, corners, colour: [0.5; 3], medium: Medium::Share(0.5), priority: 0 }
    };
    let sheets = vec![half(-100.0, 0.007, 1), half(0.007, 100.0, 2)];
    let features = features(&Effects { sheets, ..Effects::default() });
    for line in 0..600 {
        for column in 496..504 {
            let mix = features.mix([column, line], false, &mut Even(Back::SKY)).unwrap();
            assert!((mix.through[0] - 0.5).abs() < 1e-9 && (mix.added[0] - 0.25).abs() < 0.001, "{mix:?}");
        }
    }
}

#[test]
fn things_stand_lower_by_the_drop_of_the_lunoid() {
    let effects = Effects {
        lights: vec![lamp([9e3, 0.0, 0.0])],
        sheets: vec![sheet(9e3, 0.5, [0.0; 3])],
        ..Effects::default()
    };
    let drop = FOCAL * landscape::parabolic_drop(9e3) / 9e3;
    let [flat, bent] = [Curvature::None, Curvature::Parabolic].map(|curvature| {
        let features = features_over(&effects, curvature);
        [0, 1].map(|index| features.all[index].outline.bounds(&features.screen)[0][1])
    });
    assert!(
        drop > 2.0 && (0..2).all(|index| (bent[index] - flat[index] - drop).abs() < 1e-9),
        "{flat:?} {bent:?}"
    );
    let beyond = Effects { lights: vec![lamp([2e6, 0.0, 0.0])], ..Effects::default() };
    assert!(features_over(&beyond, Curvature::Exact).all.is_empty());
}

#[test]
fn what_is_no_place_is_not_drawn() {
    let lights =
        [[0.0; 3], [1e-4, 0.0, 0.0], [f64::NAN, 0.0, 0.0], [-50.0, 0.0, 0.0], [f64::INFINITY, 0.0, 0.0]];
    let lights = lights.map(lamp).to_vec();
    let edge = EYE + DVec3::X;
    let sheets = vec![
        sheet(f64::NAN, 0.5, [0.0; 3]),
        sheet(0.0, 0.5, [0.0; 3]),
        sheet(-5.0, 0.5, [0.0; 3]),
        Sheet { corners: vec![edge, edge, edge], ..sheet(1.0, 0.5, [0.0; 3]) },
        Sheet { corners: Vec::new(), ..sheet(1.0, 0.5, [0.0; 3]) },
    ];
    assert!(features(&Effects { lights, sheets, ..Effects::default() }).all.is_empty());
}
