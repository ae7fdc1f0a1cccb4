//! The digital side of a frame: bodies into spans.

use std::ops::Range;

use glam::DVec3;
use solids::Body;

use crate::face::{Corner, Outline};
use crate::view::{Place, Sighting, project};
use crate::{FaceLight, NEAREST, Span, SpanTable, ViewPlane};

/// A body that is to be drawn.
#[derive(Debug, Clone, Copy)]
pub struct Drawn<'a> {
    /// The body.
    pub body: &'a Body,
    /// Whether it is in remote shadow, and black.
    pub dark: bool,
}

/// What a frame took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Census {
    /// Bodies transformed and projected.
    pub drawn: u64,
    /// Bodies outside the picture, or between two sweeps.
    pub outside: u64,
    /// Bodies skipped because a vertex is nearer than [`NEAREST`], or behind the eye.
    pub too_near: u64,
    /// Vertices projected.
    pub vertices: u64,
    /// Meetings of faces with sweeps; each is two edges.
    pub spans: u64,
}

/// The generator: its tables and buffers, kept from frame to frame.
#[derive(Debug, Clone, Default)]
pub struct PolyhedronGenerator {
    table: SpanTable,
    corners: Vec<Corner>,
    outline: Outline,
}

/// A body as it is seen.
struct Aspect<'a> {
    body: &'a Body,
    dark: bool,
    eye: DVec3,
    /// Sweeps that may meet it.
    sweeps: Range<usize>,
}

/// What all bodies of a frame share.
struct Frame<'a> {
    view: &'a ViewPlane,
    sighting: Sighting,
    tangents: &'a [f64],
    light: &'a FaceLight,
    sides: [f64; 2],
}

impl PolyhedronGenerator {
    /// Spans of the last frame.
    pub fn table(&self) -> &SpanTable {
        &self.table
    }

    /// Draws `bodies` for sweeps at ascending `tangents` (of the azimuth against the heading). The field must
    /// be such that a fan of sweeps covers it: pitch plus half its height less than 80 degrees.
    pub fn run<'a>(
        &mut self,
        view: &ViewPlane,
        tangents: &[f64],
        light: &FaceLight,
        bodies: impl Iterator<Item = Drawn<'a>>,
    ) -> Census {
        let frame = Frame::new(view, tangents, light);
        let mut census = Census::default();
        self.table.clear();
        for (index, Drawn { body, dark }) in bodies.enumerate() {
            let (eye, foot_range) = frame.sighting.eye_for(body.foot);
            let Some(sweeps) = frame.sweeps(eye, body) else {
                census.outside += 1;
                continue;
            };
            let aspect = Aspect { body, dark, eye, sweeps };
            if !self.project(&frame, &aspect) {
                census.too_near += 1;
                continue;
            }
            census.drawn += 1;
            census.vertices += self.corners.len() as u64;
            let (object, foot_range) = (body.object, foot_range as f32);
            self.draw(&frame, &aspect, Span { body: index as u32, object, foot_range, ..Span::default() });
        }
        self.table.sort(tangents.len());
        census.spans = self.table.len() as u64;
        census
    }

    /// Projects the vertices; false if one is too near.
    fn project(&mut self, frame: &Frame, aspect: &Aspect) -> bool {
        let tangents = &frame.tangents[aspect.sweeps.clone()];
        self.corners.clear();
        for vertex in aspect.body.vertices() {
            let ahead = frame.sighting.turn(vertex - aspect.eye);
            if ahead.x <= NEAREST {
                return false;
            }
            self.corners.push(Corner::new(project(ahead), &frame.sighting, tangents));
        }
        true
    }

    fn draw(&mut self, frame: &Frame, aspect: &Aspect, stamp: Span) {
        let Aspect { body, dark, eye, sweeps } = aspect;
        let tangents = &frame.tangents[sweeps.clone()];
        for (index, face) in body.solid.faces().iter().enumerate() {
            if body.normal(index).dot(*eye - body.on_face(index)) <= 0.0 {
                continue;
            }
            let corners = face.corners.iter().map(|&corner| self.corners[corner as usize]);
            let first = self.outline.cross(corners, frame.view.tan_half_height, &frame.sighting, tangents);
            let reflectivity = frame.light.reflectivity(body, index, *dark) as f32;
            let stamp = Span { reflectivity, ..stamp };
            for (step, ends) in self.outline.crossings.iter().enumerate() {
                let span = frame.span(ends, stamp);
                if span.top < span.bottom {
                    self.table.push(sweeps.start + first + step, span);
                }
            }
        }
    }
}

impl<'a> Frame<'a> {
    fn new(view: &'a ViewPlane, tangents: &'a [f64], light: &'a FaceLight) -> Self {
        let sighting = Sighting::new(view);
        let spreads = [-view.tan_half_height, view.tan_half_height].map(|y| sighting.spread(y));
        let edge = |tangent: Option<&f64>| tangent.copied().unwrap_or_default();
        let [left, right] = [edge(tangents.first()), edge(tangents.last())];
        let sides = [
            spreads.map(|spread| left * spread).into_iter().fold(f64::INFINITY, f64::min),
            spreads.map(|spread| right * spread).into_iter().fold(f64::NEG_INFINITY, f64::max),
        ];
        Self { view, sighting, tangents, light, sides }
    }

    /// The sweeps that may meet a body, by its bounding sphere; nothing if it is outside the picture.
    fn sweeps(&self, eye: DVec3, body: &Body) -> Option<Range<usize>> {
        let ahead = self.sighting.turn(body.centre - eye);
        let reaches =
            |across: f64, edge: f64| across - edge * ahead.x <= body.radius * (1.0 + edge * edge).sqrt();
        let [left, right] = self.sides;
        let half_height = self.view.tan_half_height;
        let is_in = ahead.x + body.radius > NEAREST
            && reaches(ahead.y, right)
            && reaches(-ahead.y, -left)
            && reaches(ahead.z, half_height)
            && reaches(-ahead.z, half_height);
        let sweeps = self.sweeps_around(ahead, body.radius);
        (is_in && !sweeps.is_empty()).then_some(sweeps)
    }

    /// None for what passes between two sweeps: most small rocks far away.
    fn sweeps_around(&self, ahead: DVec3, radius: f64) -> Range<usize> {
        let forward = self.sighting.forward_of(ahead);
        let [nearest, farthest] = [forward - radius, forward + radius];
        if nearest <= 0.0 {
            return 0..self.tangents.len();
        }
        let [left, right] = [ahead.y - radius, ahead.y + radius];
        let sweep = |across: f64| self.tangents.partition_point(|&tangent| tangent < across);
        sweep((left / nearest).min(left / farthest))..sweep((right / nearest).max(right / farthest))
    }

    fn span(&self, [upper, lower]: &[Place; 2], stamp: Span) -> Span {
        let line =
            |place: &Place| (0.5 * self.view.lines * (place.y / self.view.tan_half_height + 1.0)) as f32;
        Span {
            top: line(upper),
            bottom: line(lower),
            near: [upper, lower].map(|place| self.sighting.near(place) as f32),
            depth: [upper, lower].map(|place| place.depth as f32),
            ..stamp
        }
    }
}
