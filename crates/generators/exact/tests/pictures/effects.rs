//! Lamps, stars, sheets, overlays and discs of the sky in whole pictures.

mod lights;
mod sheets;
mod sky;
mod together;

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
