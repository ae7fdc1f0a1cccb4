//! The digital side of a frame: bodies into spans.

use std::ops::Range;

use glam::DVec3;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;
use solids::Body;

use crate::face::{Corner, Outline};
use crate::view::{Place, Sighting, project};
use crate::{FaceLight, NEAREST, Span, SpanTable, ViewPlane};

/// Bodies that are drawn together.
const TOGETHER: usize = 16;

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

/// The generator: its table, kept from frame to frame.
#[derive(Debug, Clone, Default)]
pub struct PolyhedronGenerator {
    table: SpanTable,
}

/// A body as it is seen.
struct Aspect<'a> {
    body: &'a Body,
    dark: bool,
    eye: DVec3,
    /// Sweeps that may meet it.
    sweeps: Range<usize>,
}

/// The sweeps of a frame, as bodies are seen by them.
#[derive(Debug)]
pub struct Field<'a> {
    view: &'a ViewPlane,
    sighting: Sighting,
    tangents: &'a [f64],
    sides: [f64; 2],
}

/// What some bodies leave: spans with their sweeps, in the order of bodies and faces.
type Found = (Census, Vec<(u32, Span)>);

/// Buffers that are kept from body to body.
#[derive(Debug, Default)]
struct Pencil {
    corners: Vec<Corner>,
    outline: Outline,
}

impl PolyhedronGenerator {
    /// Spans of the last frame.
    pub fn table(&self) -> &SpanTable {
        &self.table
    }

    /// Forgets the spans of the last frame, and their room.
    pub fn forget(&mut self) {
        self.table = SpanTable::default();
    }

    /// Draws `bodies`.
    pub fn run(&mut self, field: &Field<'_>, light: &FaceLight, bodies: &[Drawn<'_>]) -> Census {
        let some = bodies.par_chunks(TOGETHER).enumerate();
        let draw = |pencil: &mut Pencil, (number, bodies): (usize, &[Drawn<'_>])| {
            pencil.draw_all(field, light, number * TOGETHER, bodies)
        };
        let found: Vec<Found> = some.map_init(Pencil::default, draw).collect();
        let mut census = Census::default();
        found.iter().for_each(|(some, _)| census.add(some));
        self.table.fill(field.tangents.len(), found.iter().flat_map(|(_, spans)| spans));
        census
    }
}

impl Census {
    fn add(&mut self, other: &Self) {
        self.drawn += other.drawn;
        self.outside += other.outside;
        self.too_near += other.too_near;
        self.vertices += other.vertices;
        self.spans += other.spans;
    }
}

impl Pencil {
    /// Draws bodies of which the first has number `first`.
    fn draw_all(
        &mut self,
        field: &Field<'_>,
        light: &FaceLight,
        first: usize,
        bodies: &[Drawn<'_>],
    ) -> Found {
        let (mut census, mut spans) = Found::default();
        for (index, &Drawn { body, dark }) in (first..).zip(bodies) {
            let (eye, foot_range) = field.sighting.eye_for(body.foot);
            let Some(sweeps) = field.sweeps(eye, body) else {
                census.outside += 1;
                continue;
            };
            let aspect = Aspect { body, dark, eye, sweeps };
            if !self.project(field, &aspect) {
                census.too_near += 1;
                continue;
            }
            census.drawn += 1;
            census.vertices += self.corners.len() as u64;
            let (object, foot_range) = (body.object, foot_range as f32);
            let stamp = Span { body: index as u32, object, foot_range, ..Span::default() };
            self.draw(field, light, &aspect, stamp, &mut spans);
        }
        census.spans = spans.len() as u64;
        spans.shrink_to_fit();
        (census, spans)
    }

    /// Projects the vertices; false if one is too near.
    fn project(&mut self, field: &Field<'_>, aspect: &Aspect<'_>) -> bool {
        let tangents = &field.tangents[aspect.sweeps.clone()];
        self.corners.clear();
        for vertex in aspect.body.vertices() {
            let ahead = field.sighting.turn(vertex - aspect.eye);
            if ahead.x <= NEAREST {
                return false;
            }
            self.corners.push(Corner::new(project(ahead), &field.sighting, tangents));
        }
        true
    }

    fn draw(
        &mut self,
        field: &Field<'_>,
        light: &FaceLight,
        aspect: &Aspect<'_>,
        stamp: Span,
        spans: &mut Vec<(u32, Span)>,
    ) {
        let Aspect { body, dark, eye, sweeps } = aspect;
        let tangents = &field.tangents[sweeps.clone()];
        for (index, face) in body.solid.faces().iter().enumerate() {
            if body.normal(index).dot(*eye - body.on_face(index)) <= 0.0 {
                continue;
            }
            let corners = face.corners.iter().map(|&corner| self.corners[corner as usize]);
            let first = self.outline.cross(corners, field.view.tan_half_height, &field.sighting, tangents);
            let reflectivity = light.reflectivity(body, index, *dark) as f32;
            let stamp = Span { reflectivity, ..stamp };
            for (step, ends) in self.outline.crossings.iter().enumerate() {
                let span = field.span(ends, stamp);
                if span.top < span.bottom {
                    spans.push(((sweeps.start + first + step) as u32, span));
                }
            }
        }
    }
}

impl<'a> Field<'a> {
    /// Sweeps at ascending `tangents` (of the azimuth against the heading). The field of view must be such that a fan of
    /// sweeps covers it: pitch plus half its height less than 80 degrees.
    pub fn new(view: &'a ViewPlane, tangents: &'a [f64]) -> Self {
        let sighting = Sighting::new(view);
        let spreads = [-view.tan_half_height, view.tan_half_height].map(|y| sighting.spread(y));
        let edge = |tangent: Option<&f64>| tangent.copied().unwrap_or_default();
        let [left, right] = [edge(tangents.first()), edge(tangents.last())];
        let sides = [
            spreads.map(|spread| left * spread).into_iter().fold(f64::INFINITY, f64::min),
            spreads.map(|spread| right * spread).into_iter().fold(f64::NEG_INFINITY, f64::max),
        ];
        Self { view, sighting, tangents, sides }
    }

    /// Whether a body may be in the picture, and on a sweep.
    pub fn meets(&self, body: &Body) -> bool {
        self.sweeps(self.sighting.eye_for(body.foot).0, body).is_some()
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
