//! The faces of a frame for a judge that draws them by area: without sampling points, stacks or lists.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use generator::{FaceScene, Look, ScreenFace};
use glam::DVec3;
use light_points::Light;
use raster::DistancePlane;
use scenario::SkyDisc;
use translucency::Feature;

use crate::camera::Camera;
use crate::faces::Surface;
use crate::lights::Point;
use crate::parameters::Parameters;
use crate::scene::{DISC_PRIORITY, Scene};
use crate::tile::mapped;

/// Corners of the polygon that stands for a disc. Chosen: with the area of the disc it is off by 0.1 % of its radius at most.
const CORNERS: u32 = 48;

/// A look that leaves what is behind it as it is.
const NOTHING: Look = Look { light: [0.0; 3], translucency: [1.0; 3] };

/// What a face of the judge is in the scene.
#[derive(Debug, Clone, Copy)]
enum Source {
    /// A triangle of the list.
    Triangle(u32),
    /// A light of the raster, with its own light and translucency.
    Light([f64; 3], f64),
    /// A disc of the sky.
    Disc(u32),
}

/// The faces of a scene; its calligraphic points are no faces.
pub fn faces(scene: Scene, run: &Parameters) -> FaceScene {
    let mut faces = Vec::new();
    let mut sources = Vec::new();
    for (number, triangle) in (0..).zip(&scene.faces.triangles) {
        let Some((plane, surface)) = scene.faces.seen(number, &scene.camera) else { continue };
        let (priority, id) = match surface {
            Surface::Ready(feature) => (feature.priority(), feature.id()),
            Surface::Mapped(ground) => (ground.priority, ground.id),
            Surface::Dust(sheet) => {
                let (sheet, id) = &scene.dust[sheet as usize];
                (i32::from(sheet.priority), *id)
            }
        };
        faces.push(ScreenFace { corners: triangle.corners().to_vec(), q: of_plane(&plane), priority, id });
        sources.push(Source::Triangle(number));
    }
    for point in scene.lights.points.iter().filter(|point| !point.is_calligraphic) {
        let (face, source) = of_light(point, run);
        faces.push(face);
        sources.push(source);
    }
    for (number, (disc, id)) in (0..).zip(&scene.discs) {
        let priority = DISC_PRIORITY - number as i32;
        faces.extend(outline(disc, &scene.camera).map(|corners| {
            sources.push(Source::Disc(number));
            ScreenFace { corners, q: [0.0; 3], priority, id: *id }
        }));
    }
    let scene = Arc::new(scene);
    FaceScene {
        faces,
        looks: Box::new(move |face, place| look(&scene, sources[face], place)),
        coincidence: 0.0,
    }
}

fn of_plane(plane: &DistancePlane) -> [f64; 3] {
    [plane.slope[0], plane.slope[1], plane.origin]
}

/// A disc of the area of the light's own; its light is not normalised, as no sampling point is counted.
fn of_light(point: &Point, run: &Parameters) -> (ScreenFace, Source) {
    let light = Light::new(point.disc.intensity, run.blending);
    let colour = point.colour().map(|channel| light.added * channel);
    let corners = circle(|sin, cos| {
        let radius = 0.5 * point.disc.diameter * widened();
        [point.middle[0] + radius * cos, point.middle[1] + radius * sin]
    });
    let face = ScreenFace {
        corners,
        q: [0.0, 0.0, point.q],
        priority: point.feature.priority(),
        id: point.feature.id(),
    };
    (face, Source::Light(colour, light.translucency))
}

/// By how much the polygon's corners lie beyond the circle of the same area.
fn widened() -> f64 {
    let angle = TAU / f64::from(CORNERS);
    (2.0 * PI / (f64::from(CORNERS) * quantities::sin_cos(angle).0)).sqrt()
}

/// Corners of a polygon, from sine and cosine of their angles.
fn circle<T>(corner: impl Fn(f64, f64) -> T) -> Vec<T> {
    let at = |k: u32| quantities::sin_cos(TAU * f64::from(k) / f64::from(CORNERS));
    (0..CORNERS).map(at).map(|(sin, cos)| corner(sin, cos)).collect()
}

/// The outline of a disc of the sky on the screen; `None` if it reaches behind the eye.
fn outline(disc: &SkyDisc, camera: &Camera) -> Option<Vec<[f64; 2]>> {
    let (sin, cos) = quantities::sin_cos(0.5 * disc.angular_diameter * widened());
    let aside = disc.direction.any_orthonormal_vector();
    let above = disc.direction.cross(aside);
    let direction = |s: f64, c: f64| camera.direction(disc.direction * cos + (aside * c + above * s) * sin);
    let rim: Vec<DVec3> = circle(direction);
    let is_before = rim.iter().all(|direction| direction.z > 0.0);
    is_before.then(|| rim.into_iter().map(|direction| camera.projection.project(direction)).collect())
}

fn look(scene: &Scene, source: Source, place: [f64; 2]) -> Look {
    match source {
        Source::Light(light, translucency) => Look { light, translucency: [translucency; 3] },
        Source::Disc(number) => {
            let disc = &scene.discs[number as usize].0;
            // Beyond the rim, where the polygon has its corners, the rim's light goes on.
            let ray = scene.camera.ray(place).normalize();
            let light =
                disc.light(ray).or_else(|| disc.light((ray + 0.05 * (disc.direction - ray)).normalize()));
            Look { light: light.unwrap_or_default(), translucency: [0.0; 3] }
        }
        Source::Triangle(number) => match scene.faces.seen(number, &scene.camera) {
            None => NOTHING,
            Some((_, Surface::Ready(feature))) => of_feature(&feature, place),
            Some((plane, Surface::Mapped(ground))) => {
                let map = scene.ground_map.as_ref();
                let feature = map.and_then(|map| mapped(ground, map, &plane, &scene.camera, place).ok());
                feature.map_or(NOTHING, |feature| of_feature(&feature, place))
            }
            Some((_, Surface::Dust(sheet))) => {
                let sheet = &scene.dust[sheet as usize].0;
                let share = sheet.translucency(scene.camera.ray(place).normalize().dot(sheet.normal()));
                Look { light: sheet.colour.map(|channel| (1.0 - share) * channel), translucency: [share; 3] }
            }
        },
    }
}

fn of_feature(feature: &Feature, place: [f64; 2]) -> Look {
    Look { light: feature.light_at(place), translucency: [feature.translucency(); 3] }
}
