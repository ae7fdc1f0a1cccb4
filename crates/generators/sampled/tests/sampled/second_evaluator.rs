//! Random scenes against an evaluator that shares no code with the generator and knows no limits (acceptance test 2).

use std::sync::Arc;

use crate::eye::Eye;
use crate::shots::{HOME, Shot, is_same, lamp, level_ground};
use glam::{DMat3, DVec3};
use landscape::Attitude;
use quantities::{sin_cos, unit_interval};
use scenario::{LightPoint, LightSource, Medium, Sheet, Standing};
use solids::{Body, Kind, Solid};

const COLUMNS: u32 = 24;
const LINES: u32 = 16;
const ALBEDO: f64 = 0.6;

/// Offsets of the pattern `4` as the specification types them (1/32 pixel).
const OFFSETS: [[f64; 2]; 4] = [[12.0, 4.0], [28.0, 12.0], [4.0, 20.0], [20.0, 28.0]];

/// How far a snapped corner can move an edge (pixels): half a step of 1/256 along both axes.
const EDGE: f64 = 1.0 / 256.0;

/// How near to the rim of a disc rounding may decide (pixels).
const RIM: f64 = 1e-6;

/// Least diameter of light points (pixels).
const LEAST: f64 = 1.5;

/// A random scene before level ground: 7 sheets, 2 boxes, 50 lamps.
fn scene(seed: u64) -> Shot {
    let part = |what: u64, k: u64| unit_interval(seed, &[what, k]);
    let between = |low: f64, high: f64, what: u64, k: u64| low + (high - low) * part(what, k);
    let mut shot = Shot::new(COLUMNS, LINES, between(14.0, 45.0, 0, 0));
    shot.run.sampling.translucent = None;
    shot.run.sampling.lights = None;
    shot.run.ground_half_side = between(100.0, 800.0, 0, 5);
    shot.ground = level_ground(HOME, ALBEDO);
    shot.pose.eye[2] = between(1.0, 6.0, 0, 1);
    shot.pose.attitude =
        Attitude { roll: 0.0, pitch: between(-0.5, 0.2, 0, 2), heading: between(-3.0, 3.0, 0, 3) };
    shot.pose.yoke = between(-0.4, 0.4, 0, 4);
    let eye = shot.eye();
    let place = |what: u64, k: u64, depth: f64| {
        let at = [between(-6.0, 30.0, what, k), between(-6.0, 20.0, what, k + 1)];
        eye.place(at, depth)
    };
    let colour = |what: u64| [10, 11, 12].map(|k| part(what, k));
    shot.effects.sheets = (0..7)
        .map(|id| {
            let what = 100 + u64::from(id);
            let corners = (0..3).map(|k| place(what, 3 * k, between(1.0, 30.0, what, 3 * k + 2))).collect();
            let dust = Medium::Dust { kappa: 0.2 * part(what, 13), thickness: 0.1 + 3.0 * part(what, 14) };
            let medium = match id % 3 {
                0 => Medium::Share(0.0),
                1 => Medium::Share(part(what, 15)),
                _ => dust,
            };
            Sheet { id, corners, colour: colour(what), medium, priority: 0 }
        })
        .collect();
    shot.effects.lights = (0..50)
        .map(|id| {
            let what = 1000 + u64::from(id);
            let at = place(what, 0, between(4.0, 40.0, what, 2));
            let light = lamp(id, at, between(0.02, 1.2, what, 3));
            LightPoint { colour: colour(what), intensity: part(what, 4), ..light }
        })
        .collect();
    shot.standing = (0..2).map(|object| standing_box(object, seed, &eye)).collect();
    shot
}

/// A box in view, with a colour and a turn of its own, that floats or sinks.
fn standing_box(object: u32, seed: u64, eye: &Eye) -> Standing {
    let part = |k: u64| unit_interval(seed, &[50 + u64::from(object), k]);
    let half = DVec3::new(part(0), part(1), part(2)) * 2.0 + 0.2;
    let solid = Solid::boxed(-half, half, 1.0).unwrap();
    let solid = Arc::new(solid.coloured([part(3), part(4), part(5)]).unwrap());
    let turn = DMat3::from_euler(glam::EulerRot::XYZ, part(6), part(7), part(8));
    let foot = eye.place([24.0 * part(9), 16.0 * part(10)], 6.0 + 20.0 * part(11));
    let body = Body::place(object, Kind::Culture, &solid, foot, &turn, 1.0);
    Standing { from: 0.0, until: f64::INFINITY, body }
}

/// A flat convex polygon in axes right, down, ahead.
struct Polygon {
    corners: Vec<DVec3>,
    /// Normal in the axes of the eye, as long as one.
    normal: DVec3,
    colour: [f64; 3],
    medium: Medium,
    diameter: f64,
}

impl Polygon {
    fn new(corners: Vec<DVec3>, colour: [f64; 3], medium: Medium) -> Self {
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        let lengths = corners.iter().flat_map(|a| corners.iter().map(|b| (*a - *b).length()));
        let diameter = lengths.fold(0.0, f64::max);
        Self { corners, normal, colour, medium, diameter }
    }

    /// How near it is along a ray, 1/m; `None` beside it, `Err` where a snapped corner may decide.
    fn nearness(&self, ray: DVec3, focal: f64) -> Result<Option<f64>, Unsure> {
        let side = self.normal.dot(self.corners[0]).signum();
        let mut inside = f64::INFINITY;
        for (k, corner) in self.corners.iter().enumerate() {
            let edge = corner.cross(self.corners[(k + 1) % self.corners.len()]);
            let pixels = side * edge.dot(ray) * focal / edge.truncate().length();
            inside = inside.min(pixels);
        }
        if inside.abs() < EDGE {
            return Err(Unsure);
        }
        let q = self.normal.dot(ray) / self.normal.dot(self.corners[0]);
        Ok((inside > 0.0 && q > 0.0).then_some(q))
    }

    /// Share of light that it lets through along the ray of a pixel's middle.
    fn share(&self, middle: DVec3) -> f64 {
        match self.medium {
            Medium::Share(share) => share,
            Medium::Dust { kappa, thickness } => {
                let cosine = (self.normal.dot(middle) / middle.length()).abs();
                libm::exp(-kappa * (thickness / cosine).min(self.diameter))
            }
        }
    }
}

/// A place that rounding may decide.
struct Unsure;

/// A lamp's disc with the light that it adds and lets through.
struct Disc {
    middle: [f64; 2],
    radius: f64,
    q: f64,
    light: [f64; 3],
    share: f64,
}

impl Disc {
    /// The disc of a lamp; its light is divided by what it covers, on the screen and beside it.
    fn new(light: &LightPoint, eye: &Eye, focal: f64, from: DVec3) -> Result<Self, Unsure> {
        let LightSource::Lamp { at, diameter } = light.source else { panic!("a lamp") };
        let projected = diameter * focal / (at - from).length();
        let radius = projected.max(LEAST) / 2.0;
        let share = (projected / LEAST).min(1.0);
        let intensity = light.intensity * share * share;
        let middle = eye.project(at);
        let mut covered = 0;
        let reach = radius.ceil() as i32 + 1;
        for y in -reach..=reach {
            for x in -reach..=reach {
                let pixel = [middle[0].floor() + f64::from(x), middle[1].floor() + f64::from(y)];
                for offset in OFFSETS {
                    let point = [0, 1].map(|axis| pixel[axis] + offset[axis] / 32.0);
                    covered += u32::from(is_under(middle, radius, point)?);
                }
            }
        }
        let area = std::f64::consts::PI * radius * radius;
        let shown = intensity * area * 4.0 / f64::from(covered);
        let share = 1.0 - shown.min(1.0);
        Ok(Self { middle, radius, q: 1.0 / eye.seen(at).z, light: light.colour.map(|c| shown * c), share })
    }
}

fn is_under(middle: [f64; 2], radius: f64, point: [f64; 2]) -> Result<bool, Unsure> {
    let away = libm::hypot(point[0] - middle[0], point[1] - middle[1]);
    if (away - radius).abs() < RIM { Err(Unsure) } else { Ok(away < radius) }
}

/// The scene in the axes of its eye.
struct Evaluator {
    eye: Eye,
    focal: f64,
    polygons: Vec<Polygon>,
    discs: Vec<Disc>,
}

impl Evaluator {
    fn new(shot: &Shot) -> Result<Self, Unsure> {
        let eye = shot.eye();
        let focal = f64::from(COLUMNS) / (2.0 * shot.view.field.tan_half_width);
        let (sin, cos) = sin_cos(shot.sun.elevation);
        let (sin_a, cos_a) = sin_cos(shot.sun.azimuth);
        let sun = DVec3::new(cos * cos_a, cos * sin_a, sin);
        let border = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]
            .map(|[x, y]| eye.seen(DVec3::new(2.0 * HOME * x, 2.0 * HOME * y, 0.0)));
        let ground = Polygon::new(border.to_vec(), [ALBEDO * sin; 3], Medium::Share(0.0));
        let mut polygons = vec![ground];
        for sheet in &shot.effects.sheets {
            let corners = sheet.corners.iter().map(|corner| eye.seen(*corner)).collect();
            polygons.push(Polygon::new(corners, sheet.colour, sheet.medium));
        }
        for standing in &shot.standing {
            polygons.extend(faces(&standing.body, sun, &eye));
        }
        let from = DVec3::from_array(shot.pose.eye);
        let lights = shot.effects.lights.iter();
        let discs: Result<Vec<_>, _> = lights.map(|light| Disc::new(light, &eye, focal, from)).collect();
        Ok(Self { eye, focal, polygons, discs: discs? })
    }

    /// Colour of a pixel, of all its sampling points.
    fn pixel(&self, column: u32, line: u32) -> Result<[f64; 3], Unsure> {
        let corner = [column, line].map(f64::from);
        let mut sum = [0.0; 3];
        for offset in OFFSETS {
            let point = [0, 1].map(|axis| corner[axis] + offset[axis] / 32.0);
            let colour = self.point(point, corner.map(|at| at + 0.5))?;
            sum = [0, 1, 2].map(|k| sum[k] + colour[k] / 4.0);
        }
        Ok(sum)
    }

    /// Colour of a sampling point: everything that covers it, sorted and composed.
    fn point(&self, point: [f64; 2], middle: [f64; 2]) -> Result<[f64; 3], Unsure> {
        let ray = self.eye.ray(point);
        let mut found: Vec<(f64, [f64; 3], f64)> = Vec::new();
        for polygon in &self.polygons {
            if let Some(q) = polygon.nearness(ray, self.focal)? {
                let share = polygon.share(self.eye.ray(middle));
                found.push((q, polygon.colour.map(|channel| (1.0 - share) * channel), share));
            }
        }
        for disc in &self.discs {
            if is_under(disc.middle, disc.radius, point)? {
                found.push((disc.q, disc.light, disc.share));
            }
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        if found.windows(2).any(|pair| pair[0].0 - pair[1].0 < 1e-12) {
            return Err(Unsure);
        }
        let (mut colour, mut through) = ([0.0; 3], 1.0);
        for (_, light, share) in found {
            colour = [0, 1, 2].map(|k| colour[k] + through * light[k]);
            through *= share;
        }
        Ok(colour)
    }
}

/// The six faces of a box, lit by Lambert's law.
fn faces(body: &Body, sun: DVec3, eye: &Eye) -> Vec<Polygon> {
    let vertices: Vec<DVec3> = body.vertices().collect();
    let solid = &body.solid;
    let face = |(number, face): (usize, &solids::Face)| {
        let corners: Vec<DVec3> = face.corners.iter().map(|&k| vertices[k as usize]).collect();
        let outward = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        let centre = vertices.iter().sum::<DVec3>() / vertices.len() as f64;
        let outward = if outward.dot(corners[0] - centre) > 0.0 { outward } else { -outward };
        let lit = solid.albedo(number).map(|albedo| albedo * outward.dot(sun).max(0.0));
        let seen = corners.iter().map(|corner| eye.seen(*corner)).collect();
        Polygon::new(seen, lit, Medium::Share(0.0))
    };
    solid.faces().iter().enumerate().map(face).collect()
}

#[test]
fn every_pixel_is_what_a_second_evaluator_says() {
    let (mut compared, mut skipped) = (0, 0);
    for seed in 0..200 {
        let shot = scene(seed);
        let frame = shot.draw();
        assert_eq!(frame.counts["lost_lights"] + frame.counts["lost_surfaces"], 0);
        let Ok(evaluator) = Evaluator::new(&shot) else {
            skipped += COLUMNS * LINES;
            continue;
        };
        for index in 0..COLUMNS * LINES {
            let Ok(expected) = evaluator.pixel(index % COLUMNS, index / COLUMNS) else {
                skipped += 1;
                continue;
            };
            let found = frame.colour(index as usize);
            let same = found.iter().zip(expected).all(|(found, expected)| is_same(*found, expected));
            assert!(
                same,
                "scene {seed}, pixel {} {}: {found:?}, not {expected:?}",
                index % COLUMNS,
                index / COLUMNS
            );
            compared += 1;
        }
    }
    assert!(compared > 4 * skipped, "{compared} compared, {skipped} skipped");
}
