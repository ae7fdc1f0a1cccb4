//! Light points on the sweeps of a level picture, against closed forms.

use std::f64::consts::PI;

use generator::BeamEntry;
use glam::DVec3;
use hardware_model::AnalogParts;
use light_point_generator::{Before, LightSwitch, Optics, PointTable, Third, beam_entries, draw_beam};
use polyhedron_generator::{Hold, NearTable, Overlay, PartsSwitch, Span, SpanTable, ViewPlane};
use scenario::{BodyVisibility, Curvature, FieldOfView, LightPoint, LightSource, Projection};
use sweep_memory::{Memory, Reading, View};
use sweep_program::Fan;

/// Columns, sweeps and lines of the picture; the focal length is as many pixels.
const SIZE: u32 = 100;
const LINES: usize = SIZE as usize;

/// A lamp straight ahead that is seen in the middle of the picture.
fn lamp(range: f64, diameter: f64, intensity: f64) -> LightPoint {
    LightPoint {
        id: 7,
        source: LightSource::Lamp { at: DVec3::new(range, 0.0, 2.0), diameter },
        colour: [1.0; 3],
        intensity,
        lobe: None,
        priority: 0,
        calligraphic: false,
    }
}

fn star(magnitude: f64) -> LightPoint {
    LightPoint { source: LightSource::Star { direction: DVec3::X, magnitude }, ..lamp(1.0, 1.0, 1.0) }
}

fn by_beam(light: LightPoint) -> LightPoint {
    LightPoint { calligraphic: true, ..light }
}

/// What stands before the lights, the same on every sweep, and how the switch is made.
struct Scene {
    behind: f32,
    /// Range (m) up to which ground is flat, far below, and the line that it reaches there.
    ridge: Option<(f64, f32)>,
    mountains: Option<f32>,
    wall: Option<(f32, [f32; 2])>,
    parts: Option<PartsSwitch>,
    key: Option<f32>,
    sweeps: u32,
}

impl Default for Scene {
    fn default() -> Self {
        let (ridge, mountains, wall, parts, key) = (None, None, None, None, None);
        Self { behind: 0.0, ridge, mountains, wall, parts, key, sweeps: SIZE }
    }
}

impl Scene {
    fn reading(&self) -> Reading {
        let field = FieldOfView { tan_half_width: 0.5, tan_half_height: 0.5 };
        let fan = Fan::covering(Projection::Exact, 0.0, &field, self.sweeps).unwrap();
        let view = View { fan, projection: Projection::Exact, pitch: 0.0, raster: field, field, yoke: 0.0 };
        Reading { memory: Memory::ScanConverter, view, cells: LINES, columns: LINES, lines: LINES }
    }

    /// Every sweep's lines, and the list of the beam.
    fn draw(&self, lights: &[LightPoint]) -> (Vec<Vec<f32>>, Vec<BeamEntry>) {
        let view = ViewPlane {
            eye: [0.0, 0.0, 2.0],
            heading: 0.0,
            pitch: 0.0,
            projection: Projection::Exact,
            curvature: Curvature::None,
            tan_half_height: 0.5,
            lines: f64::from(SIZE),
        };
        let table = PointTable::new(lights, &Optics { view: &view, reading: &self.reading() });
        let ranges = [1.0, 10.0, 100.0, 1000.0, 1e4, 1e5];
        let near = NearTable::new(ranges.map(|range| (1.0 / range) as f32));
        let lines = |sample: usize| match self.ridge {
            Some((range, line)) if ranges[sample] >= range => line,
            _ => 200.0,
        };
        let hold = Hold { near: &near, lines };
        let spans: Vec<Span> = self.wall.iter().map(|&(range, lines)| wall(range, lines)).collect();
        let (standing, mut overlay) = (SpanTable::of_sweep(&spans), Overlay::default());
        overlay.compose(standing.sweep(0), BodyVisibility::Depth, Some(&hold));
        let bodies = self.wall.map(|_| (&overlay, standing.sweep(0)));
        let before = Before { hold: &hold, mountains: self.mountains, bodies };
        let third = Third { parts: self.parts.as_ref(), key: self.key };
        let mut switch = LightSwitch::default();
        let mut rows = vec![vec![self.behind; LINES]; self.sweeps as usize];
        for (row, sweep) in rows.iter_mut().zip(0..) {
            switch.lay(sweep, (&table, table.sweep(sweep)), &before, third, row);
        }
        (rows, beam_entries(&table, switch.take_shares()))
    }

    /// Light (intensity times pixels squared) of raster points over black ground.
    fn light(&self, lights: &[LightPoint]) -> f64 {
        let sum: f64 = self.draw(lights).0.iter().flatten().map(|value| f64::from(*value)).sum();
        sum * f64::from(SIZE) / f64::from(self.sweeps)
    }

    /// Share of its light that the first point of the list shows; 0 if there is none.
    fn fading(&self, lights: &[LightPoint]) -> f64 {
        self.draw(lights).1.first().map_or(0.0, |entry| entry.display_intensity / entry.intensity)
    }
}

fn wall(range: f32, [top, bottom]: [f32; 2]) -> Span {
    let near = [1.0 / range; 2];
    Span { top, bottom, near, depth: near, foot_range: range, ..Span::default() }
}

#[test]
fn a_lamp_adds_its_colours_luminance_and_dims_what_is_behind() {
    // 40 pixels wide.
    let red = LightPoint { colour: [1.0, 0.0, 0.0], ..lamp(50.0, 20.0, 0.6) };
    let (rows, list) = Scene { behind: 0.3, ..Scene::default() }.draw(&[red]);
    let expected = 0.3 * (1.0 - 0.6) + 0.6 * 0.2126;
    assert!((f64::from(rows[50][50]) - expected).abs() < 1e-6, "{}", rows[50][50]);
    assert_eq!((rows[50][29], rows[50][70], rows[29][50]), (0.3, 0.3, 0.3));
    assert!(list.is_empty());
}

/// Light of a lamp by its distance: no step where its least disc begins, and no twinkle.
#[test]
fn light_follows_the_inverse_square_wherever_the_lamp_lies_among_the_sweeps() {
    for step in 0..60 {
        let range = 5.0 * ratio(step);
        for aside in [0.0, 0.003, 0.0081] {
            let at = DVec3::new(range, aside * range, 2.0 + 0.0047 * range);
            let source = LightSource::Lamp { at, diameter: 0.3 };
            let distance = (at - DVec3::new(0.0, 0.0, 2.0)).length();
            let projected = 0.3 * 100.0 / distance;
            let found = Scene::default().light(&[LightPoint { source, ..lamp(1.0, 1.0, 1.0) }]);
            let expected = PI * projected * projected / 4.0;
            assert!((found / expected - 1.0).abs() < 1e-5, "{range} m: {found}, {expected}");
        }
    }
}

/// Ratios from 1 to 1000.
fn ratio(step: u32) -> f64 {
    libm::pow(1000.0, f64::from(step) / 59.0)
}

#[test]
fn few_sweeps_widen_the_disc_and_keep_its_light() {
    let far = lamp(500.0, 0.3, 1.0);
    let found = Scene { sweeps: 40, ..Scene::default() }.light(&[far]);
    assert!((found / Scene::default().light(&[far]) - 1.0).abs() < 1e-5, "{found}");
    let (_, list) = Scene { sweeps: 40, ..Scene::default() }.draw(&[by_beam(far)]);
    assert!((list[0].diameter_px - 1.5 * 2.5).abs() < 1e-9, "{}", list[0].diameter_px);
}

/// Upper half of a disc of 40 pixels, or all of it where the ridge is farther than the lamp.
#[test]
fn a_ridge_hides_what_lies_below_its_line_if_it_is_nearer() {
    let open = Scene::default().light(&[lamp(50.0, 20.0, 1.0)]);
    for (range, share) in [(10.0, 0.5), (1000.0, 1.0)] {
        let found = Scene { ridge: Some((range, 50.0)), ..Scene::default() }.light(&[lamp(50.0, 20.0, 1.0)]);
        assert!((found / open - share).abs() < 1e-6, "{range} m: {found} of {open}");
    }
}

#[test]
fn a_wall_hides_a_lamp_behind_it_and_not_one_before_it() {
    let lights = [lamp(50.0, 20.0, 1.0)];
    let open = Scene::default().light(&lights);
    for (range, share) in [(20.0, 0.5), (200.0, 1.0)] {
        let found = Scene { wall: Some((range, [50.0, 90.0])), ..Scene::default() }.light(&lights);
        assert!((found / open - share).abs() < 1e-6, "{range} m: {found} of {open}");
    }
    // A wall across the middle leaves both segments.
    let found = Scene { wall: Some((20.0, [40.0, 60.0])), ..Scene::default() }.light(&lights);
    let (radius, half) = (20.0f64, 10.0f64);
    let strip =
        2.0 * (half * (radius * radius - half * half).sqrt() + radius * radius * libm::asin(half / radius));
    assert!((found / open - (1.0 - strip / (PI * radius * radius))).abs() < 2e-3, "{found} of {open}");
}

#[test]
fn far_mountains_hide_stars_and_no_lamp_before_them() {
    let under = Scene { mountains: Some(20.0), ..Scene::default() };
    assert_eq!(under.light(&[star(0.0)]), 0.0);
    assert!(Scene::default().light(&[star(0.0)]) > 1.7);
    assert_eq!(under.light(&[lamp(50.0, 1.0, 1.0)]), Scene::default().light(&[lamp(50.0, 1.0, 1.0)]));
}

#[test]
fn a_nearer_lamp_lies_over_a_farther_one_in_any_order() {
    let (near, far) = (lamp(50.0, 20.0, 0.75), LightPoint { id: 1, ..lamp(100.0, 40.0, 1.0) });
    for lights in [[near, far], [far, near]] {
        let (rows, _) = Scene::default().draw(&lights);
        assert!((rows[50][50] - (0.75 + 0.25)).abs() < 1e-6, "{}", rows[50][50]);
    }
}

/// Share of a disc above a line at `height` (radii above its middle).
fn share_above(height: f64) -> f64 {
    0.5 - (libm::asin(height) + height * (1.0 - height * height).sqrt()) / PI
}

#[test]
fn a_beacon_fades_by_the_share_that_a_rising_ridge_leaves_and_ends_at_nothing() {
    let beacon = [by_beam(lamp(50.0, 5.0, 0.9))];
    let mut before = 1.0;
    for step in 0..=100 {
        let line = 56.0 - 0.12 * f64::from(step);
        let found = Scene { ridge: Some((10.0, line as f32)), ..Scene::default() }.fading(&beacon);
        let expected = share_above(((50.0 - line) / 5.0).clamp(-1.0, 1.0));
        assert!(found <= before, "line {line}: {found} after {before}");
        assert!((found - expected).abs() < 0.02, "line {line}: {found}, {expected}");
        before = found;
    }
    assert_eq!(before, 0.0);
    assert!((Scene::default().fading(&beacon) - 1.0).abs() < 1e-15);
}

#[test]
fn a_point_in_line_behind_another_shows_what_that_lets_through() {
    let near = by_beam(lamp(100.0, 10.0, 0.8));
    let far = LightPoint { id: 1, intensity: 0.5, ..by_beam(lamp(1000.0, 20.0, 0.5)) };
    for near in [near, LightPoint { calligraphic: false, ..near }] {
        let (_, list) = Scene::default().draw(&[far, near]);
        let last = list.last().unwrap();
        assert_eq!(last.light, 1);
        // What the raster adds is its light over its chords; a disc of 10 pixels covers itself to a hundredth.
        assert!((last.display_intensity - 0.5 * 0.2).abs() < 0.005, "{}", last.display_intensity);
    }
}

#[test]
fn the_beam_adds_the_light_that_is_left_over_the_picture() {
    let scene = Scene { ridge: Some((10.0, 50.0)), ..Scene::default() };
    let beacon = LightPoint { colour: [0.0, 1.0, 0.0], ..by_beam(lamp(50.0, 5.0, 0.9)) };
    let (rows, list) = scene.draw(&[beacon]);
    assert!(rows.iter().flatten().all(|value| *value == 0.0), "a beam's point is not in the raster");
    let mut pixels = vec![0.25; LINES * LINES];
    draw_beam(&list, [SIZE; 2], &mut pixels);
    let added: f64 = pixels.iter().map(|pixel| f64::from(*pixel) - 0.25).sum();
    let expected = 0.9 * 0.5 * PI * 100.0 / 4.0 * 0.7152;
    assert!((added / expected - 1.0).abs() < 0.02, "{added}, {expected}");
    let brightest = pixels.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1)).unwrap().0;
    assert!([49, 50].contains(&(brightest % LINES)) && [49, 50].contains(&(brightest / LINES)));
}

#[test]
fn a_switch_of_ideal_parts_lays_points_as_one_without_parts() {
    let parts = Some(PartsSwitch::new(1e7, &AnalogParts::ideal(), 1));
    let lights = [lamp(50.0, 7.3, 0.6), LightPoint { id: 2, ..lamp(30.0, 1.0, 0.4) }];
    let wall = Some((20.0, [48.3, 51.9]));
    let (plain, _) = Scene { behind: 0.2, wall, ..Scene::default() }.draw(&lights);
    let (of_parts, _) = Scene { behind: 0.2, wall, parts, ..Scene::default() }.draw(&lights);
    for (one, other) in plain.iter().flatten().zip(of_parts.iter().flatten()) {
        assert!((one - other).abs() < 1e-6, "{one} {other}");
    }
}

#[test]
fn a_switch_keyed_by_its_own_input_stays_closed_for_a_faint_lamp() {
    let lights = [lamp(50.0, 20.0, 0.3)];
    let light = |key| Scene { key: Some(key), ..Scene::default() }.light(&lights);
    assert_eq!(light(0.3), 0.0);
    assert_eq!(light(0.29), Scene::default().light(&lights));
}

#[test]
fn what_sends_no_light_to_the_eye_is_not_there() {
    let behind = lamp(-50.0, 20.0, 1.0);
    let beside = LightPoint {
        source: LightSource::Lamp { at: DVec3::new(50.0, 500.0, 2.0), diameter: 1.0 },
        ..behind
    };
    let in_the_eye = lamp(0.0, 1.0, 1.0);
    for light in [behind, beside, in_the_eye, lamp(50.0, 20.0, 0.0)] {
        let (rows, list) = Scene::default().draw(&[light, by_beam(light)]);
        assert!(list.is_empty() && rows.iter().flatten().all(|value| *value == 0.0), "{light:?}");
    }
}
