//! The digital side of a frame: bodies into spans.

use std::ops::Range;

use fearless_simd::{Level, dispatch};
use glam::DVec3;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSlice;
use scenario::BodyShading;
use signal::Number;
use solids::{Body, Solid};

use crate::face::{Corner, Crossing, Outline};
use crate::light::Returned;
use crate::likeness::{Eye, Likeness, UNSEEN};
use crate::meetings::Meetings;
use crate::table::Drawing;
use crate::view::{Place, Sighting};
use crate::{FaceLight, NEAREST, RAMP_WORDS, Span, SpanTable, ViewPlane};

/// Bodies that are looked at, and drawn, together.
const TOGETHER: usize = 128;

/// A body that may be in the picture and on a sweep, as it lies before the eye.
#[derive(Debug, Clone)]
pub struct Aspect<'a> {
    body: &'a Body,
    eye: DVec3,
    /// Horizontal range of the foot point of its object (m).
    foot_range: f64,
    /// Sweeps that may meet it.
    sweeps: Range<usize>,
}

/// A body that is to be drawn.
#[derive(Debug, Clone)]
pub struct Drawn<'a> {
    /// The body before the eye.
    pub aspect: Aspect<'a>,
    /// Whether it is in remote shadow, and black.
    pub dark: bool,
}

/// What a frame took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Census {
    /// Bodies transformed and projected.
    pub drawn: u64,
    /// Bodies skipped because a vertex is nearer than [`NEAREST`], or behind the eye.
    pub too_near: u64,
    /// Number of vertices projected.
    pub vertices: u64,
    /// Meetings of faces with sweeps; each is two edges.
    pub spans: u64,
    /// Words that the ramps of these meetings take: none where light is flat.
    pub ramp_words: u64,
}

/// The generator: its table, kept from frame to frame.
#[derive(Debug, Clone, Default)]
pub struct PolyhedronGenerator {
    table: SpanTable,
}

/// The sweeps of a frame, as bodies are seen by them.
#[derive(Debug)]
pub struct Field<'a> {
    view: &'a ViewPlane,
    vectors: Level,
    sighting: Sighting,
    tangents: &'a [f64],
    /// About how many of them there are in an interval of length 1.
    density: f64,
    /// Left and right side of the picture, and half its height, each on the view-plane.
    sides: [Side; 2],
    half_height: Side,
}

/// A side of the picture.
#[derive(Debug, Clone, Copy)]
struct Side {
    /// Off the middle of the view-plane.
    edge: f64,
    /// By how much a sphere of radius 1 may lie beyond it and still reach into the picture.
    room: f64,
}

/// Buffers that are kept from body to body.
#[derive(Debug, Default)]
struct Pencil {
    likeness: Likeness,
    meetings: Meetings,
    outline: Outline,
}

impl PolyhedronGenerator {
    /// Spans of the last frame.
    pub fn table(&self) -> &SpanTable {
        &self.table
    }

    /// Draws those of `bodies` that `drawn` has. A body is drawn as soon as it is found to be in the picture, while it is in the
    /// cache.
    pub fn run<'b, B: Sync>(
        &mut self,
        field: &Field<'_>,
        light: &FaceLight,
        bodies: &[B],
        drawn: impl Fn(&B) -> Option<Drawn<'b>> + Sync,
    ) -> Census {
        let some = bodies.par_chunks(TOGETHER).enumerate();
        let draw = |pencil: &mut Pencil, (number, bodies): (usize, &[B])| {
            let numbered = ((number * TOGETHER) as u32..).zip(bodies);
            pencil.draw_all(field, light, numbered.filter_map(|(number, body)| Some((number, drawn(body)?))))
        };
        let found: Vec<(Census, Drawing)> = some.map_init(Pencil::default, draw).collect();
        let mut census = Census::default();
        found.iter().for_each(|(some, _)| census.add(some));
        self.table.fill(field.tangents.len(), found.iter().map(|(_, drawing)| drawing));
        census
    }
}

impl Census {
    fn add(&mut self, other: &Self) {
        self.drawn += other.drawn;
        self.too_near += other.too_near;
        self.vertices += other.vertices;
        self.spans += other.spans;
        self.ramp_words += other.ramp_words;
    }
}

impl Pencil {
    /// Draws bodies, each with its number.
    fn draw_all<'b>(
        &mut self,
        field: &Field<'_>,
        light: &FaceLight,
        bodies: impl Iterator<Item = (u32, Drawn<'b>)>,
    ) -> (Census, Drawing) {
        let (mut census, mut drawing) = (Census::default(), Drawing::default());
        for (number, drawn) in bodies {
            let Aspect { body, eye, foot_range, .. } = &drawn.aspect;
            let (sighting, vectors) = (&field.sighting, field.vectors);
            let half_height = field.view.tan_half_height;
            let eye = Eye { sighting, vectors, light, place: *eye, half_height };
            if !self.likeness.take(&eye, body, drawn.dark) {
                census.too_near += 1;
                continue;
            }
            census.drawn += 1;
            census.vertices += body.solid.vertices().len() as u64;
            let (object, foot_range) = (body.object, *foot_range as f32);
            let stamp = Span { body: number, object, foot_range, ..Span::default() };
            match light.shading {
                BodyShading::Smooth if body.solid.is_smooth() => {
                    self.draw_smooth(field, light, &drawn, stamp, &mut drawing);
                }
                _ => self.draw(field, &drawn.aspect, stamp, &mut drawing),
            }
        }
        census.spans = drawing.spans.len() as u64;
        if light.shading == BodyShading::Smooth {
            census.ramp_words = RAMP_WORDS * census.spans;
        }
        drawing.shrink_to_fit();
        (census, drawing)
    }

    /// Draws a body whose likeness has been taken.
    fn draw(&mut self, field: &Field<'_>, aspect: &Aspect<'_>, stamp: Span, drawing: &mut Drawing) {
        let Aspect { body, sweeps, .. } = aspect;
        let sweeps = (sweeps.start, &field.tangents[sweeps.clone()]);
        if self.likeness.is_inside && !body.solid.edge_words().is_empty() {
            let (meetings, seen) = (&mut self.meetings, (&*body.solid, &self.likeness));
            dispatch!(field.vectors, simd => meetings.find(simd, field, seen, sweeps, stamp, drawing));
        } else {
            self.draw_faces(field, &body.solid, sweeps, stamp, drawing);
        }
    }

    /// Draws it face by face, however many there are: what lies above or below the picture is cut off.
    fn draw_faces(
        &mut self,
        field: &Field<'_>,
        solid: &Solid,
        (first, tangents): (usize, &[f64]),
        stamp: Span,
        drawing: &mut Drawing,
    ) {
        let (likeness, half_height) = (&self.likeness, field.view.tan_half_height);
        let seen =
            solid.faces().iter().zip(&likeness.faces).filter(|(_, reflectivity)| **reflectivity != UNSEEN);
        for (face, &reflectivity) in seen {
            let corners = face.corners.iter().map(|&corner| likeness.corner(corner, tangents));
            let begin = self.outline.cross(corners, half_height, &field.sighting, tangents);
            let stamp = Span { reflectivity, ..stamp };
            for (sweep, ends) in (first as u32 + begin..).zip(&self.outline.crossings) {
                add(drawing, sweep, field.span(ends, stamp));
            }
        }
    }

    /// Draws a body with normals at its corners, triangle by triangle: over four corners a ramp along a sweep would have no light of its
    /// own in the middle. Triangles of a face begin at its first corner.
    fn draw_smooth(
        &mut self,
        field: &Field<'_>,
        light: &FaceLight,
        Drawn { aspect, dark }: &Drawn<'_>,
        stamp: Span,
        drawing: &mut Drawing,
    ) {
        let Aspect { body, eye, sweeps, .. } = aspect;
        let returned = Returned::new(body, *eye);
        let (first, tangents) = (sweeps.start as u32, &field.tangents[sweeps.clone()]);
        let (likeness, half_height) = (&self.likeness, field.view.tan_half_height);
        let (turn, _) = body.to_ground();
        for (number, face) in body.solid.faces().iter().enumerate() {
            let normals = body.solid.corner_normals(number).unwrap_or_default();
            if likeness.faces[number] == UNSEEN || normals.is_empty() {
                continue;
            }
            let corner = |at: usize| {
                let normal = (turn * normals[at]).to_array();
                let lit = match &returned {
                    None => light.diffuse(normal, face.albedo),
                    Some(returned) => light.reflectivity(normal, face.albedo, returned),
                };
                let light = if *dark { 0.0 } else { lit };
                Corner { light, ..likeness.corner(face.corners[at], tangents) }
            };
            for last in 2..face.corners.len() {
                let corners = [0, last - 1, last].into_iter().map(corner);
                let begin = self.outline.cross(corners, half_height, &field.sighting, tangents);
                for (sweep, ends) in (first + begin..).zip(&self.outline.crossings) {
                    add(drawing, sweep, field.ramp(ends, stamp));
                }
            }
        }
    }
}

/// Adds a span by itself on a sweep, if it has any height.
fn add(drawing: &mut Drawing, sweep: u32, span: Span) {
    if span.top < span.bottom {
        let mut stack = drawing.begin();
        drawing.add(&mut stack, span);
        drawing.end(sweep, stack);
    }
}

impl Side {
    fn new(edge: f64) -> Self {
        Self { edge, room: (1.0 + edge * edge).sqrt() }
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
            -spreads.map(|spread| left * spread).into_iter().fold(f64::INFINITY, f64::min),
            spreads.map(|spread| right * spread).into_iter().fold(f64::NEG_INFINITY, f64::max),
        ];
        let half_height = Side::new(view.tan_half_height);
        let density = tangents.len().saturating_sub(1) as f64 / (right - left);
        let vectors = Level::new();
        Self { view, vectors, sighting, tangents, density, sides: sides.map(Side::new), half_height }
    }

    /// How a body lies before the eye; nothing if it is outside the picture or between two sweeps.
    pub fn aspect<'b>(&self, body: &'b Body) -> Option<Aspect<'b>> {
        let (eye, foot_range) = self.sighting.eye_for(body.foot);
        let ahead = self.sighting.turn((body.centre - eye).to_array());
        let sweeps = self.is_in(ahead, body.radius).then(|| self.sweeps_around(ahead, body.radius))?;
        (!sweeps.is_empty()).then_some(Aspect { body, eye, foot_range, sweeps })
    }

    /// Whether a sphere reaches into the picture: nothing else is asked about most bodies.
    fn is_in(&self, [forward, starboard, down]: [f64; 3], radius: f64) -> bool {
        let reaches = |across: f64, side: Side| across - side.edge * forward <= radius * side.room;
        let [left, right] = self.sides;
        forward + radius > NEAREST
            && reaches(starboard, right)
            && reaches(-starboard, left)
            && reaches(down, self.half_height)
            && reaches(-down, self.half_height)
    }

    /// None for what passes between two sweeps: most small rocks far away.
    fn sweeps_around(&self, ahead: [f64; 3], radius: f64) -> Range<usize> {
        let forward = self.sighting.forward_of(ahead);
        let [nearest, farthest] = [forward - radius, forward + radius];
        if nearest <= 0.0 {
            return 0..self.tangents.len();
        }
        let [left, right] = [ahead[1] - radius, ahead[1] + radius];
        let sweep = |across: f64| self.first_sweep(across);
        sweep((left / nearest).min(left / farthest))..sweep((right / nearest).max(right / farthest))
    }

    /// First sweep at a tangent or to the right of it: guessed as if they stood evenly, which they do, and looked up from there.
    fn first_sweep(&self, across: f64) -> usize {
        let (tangents, first) = (self.tangents, self.tangents.first().copied().unwrap_or_default());
        let mut sweep = (((across - first) * self.density) as usize).min(tangents.len());
        while sweep > 0 && tangents[sweep - 1] >= across {
            sweep -= 1;
        }
        while sweep < tangents.len() && tangents[sweep] < across {
            sweep += 1;
        }
        sweep
    }

    /// Line position of a place at `y` on the view-plane.
    #[inline(always)]
    pub(crate) fn line<N: Number>(&self, y: N) -> N {
        let ViewPlane { lines, tan_half_height, .. } = *self.view;
        y.like(0.5 * lines) * (y / y.like(tan_half_height) + y.like(1.0))
    }

    /// Inverse horizontal range of a place (1/m).
    #[inline(always)]
    pub(crate) fn near<N: Number>(&self, place: &Place<N>) -> N {
        self.sighting.near(place)
    }

    fn span(&self, ends: &[Crossing; 2], stamp: Span) -> Span {
        let [top, bottom] = [0, 1].map(|end: usize| self.line(ends[end].place.y) as f32);
        let near = [0, 1].map(|end: usize| self.near(&ends[end].place) as f32);
        let depth = [0, 1].map(|end: usize| ends[end].place.depth as f32);
        Span { top, bottom, near, depth, ..stamp }
    }

    /// The same with a ramp between the light of both ends.
    fn ramp(&self, ends: &[Crossing; 2], stamp: Span) -> Span {
        let span = self.span(ends, stamp);
        let [above, below] = [0, 1].map(|end: usize| ends[end].light as f32);
        let ramp = (below - above) / (span.bottom - span.top);
        // Lower than numbers can tell apart, a span is dropped.
        Span { reflectivity: above, ramp: if ramp.is_finite() { ramp } else { 0.0 }, ..span }
    }
}

#[cfg(test)]
mod tests;
