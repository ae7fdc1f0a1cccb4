//! A solid in its place.

use std::num::NonZeroU16;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::Solid;

/// What a body is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A rock on the ground.
    Rock,
    /// A man-made object, or a part of one.
    Culture,
}

/// A convex solid on the ground, in terrain axes: x north, y east, h up (m). A mission has tens of thousands: vertices and normals
/// in terrain axes are worked out when they are asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Names the object that it is a part of; stable over a mission.
    pub object: u32,
    /// Kind of thing that the body is.
    pub kind: Kind,
    /// Where two bodies, or a body and the ground, are equally near, the higher priority is seen. The ground has priority 0.
    pub priority: i8,
    /// Number of its group, from 1: which light it has.
    pub group: Option<NonZeroU16>,
    /// Foot point of its object: decides whether it is seen and shadowed. The solid's own foot point stands there.
    pub foot: DVec3,
    /// Its shape: corners and albedo of the faces; its own vertices and normals are in body axes.
    pub solid: Arc<Solid>,
    /// From body axes (forward, starboard, up) to north, east, up.
    turn: Turn,
    /// How many times as large it is as its solid.
    scale: f64,
    /// Centre of the bounding sphere, in terrain axes.
    pub centre: DVec3,
    /// Radius of the bounding sphere (m).
    pub radius: f64,
}

/// A rotation from body axes to north, east, up: most bodies stand upright, and two numbers tell it.
#[derive(Debug, Clone, PartialEq)]
enum Turn {
    /// North and east of the unit vector forward.
    Upright([f64; 2]),
    Any(Box<DMat3>),
}

impl Turn {
    fn new(matrix: &DMat3) -> Self {
        let upright = Self::Upright([matrix.x_axis.x, matrix.x_axis.y]);
        if upright.matrix() == *matrix { upright } else { Self::Any(Box::new(*matrix)) }
    }

    fn matrix(&self) -> DMat3 {
        match self {
            Self::Upright([north, east]) => {
                let [forward, starboard] =
                    [[*north, *east, 0.0], [-*east, *north, 0.0]].map(DVec3::from_array);
                DMat3::from_cols(forward, starboard, DVec3::Z)
            }
            Self::Any(matrix) => **matrix,
        }
    }
}

/// Where a ray enters a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray, in lengths of its direction.
    pub distance: f64,
    /// Face of the solid.
    pub face: usize,
}

impl Body {
    /// Places `solid`, `scale` times as large, at `foot`; `to_ground` turns body axes (forward, starboard, up)
    /// into north, east, up (a rotation).
    pub fn place(
        object: u32,
        kind: Kind,
        solid: &Arc<Solid>,
        foot: DVec3,
        to_ground: &DMat3,
        scale: f64,
    ) -> Self {
        let (turn, centre, solid) = (Turn::new(to_ground), foot, solid.clone());
        let (priority, group) = (0, None);
        let body = Self { object, kind, priority, group, foot, solid, turn, scale, centre, radius: 0.0 };
        let (centre, radius) = bounding_sphere(body.vertices());
        Self { centre, radius, ..body }
    }

    /// The same body so far (m) higher up.
    pub fn lifted(&self, by: f64) -> Self {
        let up = DVec3::Z * by;
        Self { foot: self.foot + up, centre: self.centre + up, ..self.clone() }
    }

    /// The same body so many times as large, about its foot point.
    pub fn scaled(&self, by: f64) -> Self {
        let centre = self.foot + (self.centre - self.foot) * by;
        Self { scale: self.scale * by, radius: self.radius * by, centre, ..self.clone() }
    }

    /// The same body with normals at its corners: `solid` is its own, [rounded](Solid::rounded).
    pub fn rounded(&self, solid: &Arc<Solid>) -> Self {
        Self { solid: solid.clone(), ..self.clone() }
    }

    /// The same body in the shape of another solid.
    pub fn shaped(&self, solid: &Arc<Solid>) -> Self {
        let (turn, scale) = self.to_ground();
        let placed = Self::place(self.object, self.kind, solid, self.foot, &turn, scale);
        Self { priority: self.priority, group: self.group, ..placed }
    }

    /// Vertices of the solid in terrain axes.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = DVec3> + Clone {
        let place = self.place_of();
        self.solid.vertices().iter().map(move |&vertex| place(vertex))
    }

    /// Normal of each face of the solid in terrain axes.
    pub fn normals(&self) -> impl ExactSizeIterator<Item = DVec3> + Clone {
        let turn = self.turn.matrix();
        self.solid.faces().iter().map(move |face| turn * face.normal)
    }

    /// Normal of one face in terrain axes.
    pub fn normal(&self, face: usize) -> DVec3 {
        self.turn.matrix() * self.solid.faces()[face].normal
    }

    /// Unit normal at a place of a face, both in terrain axes; see [`Solid::normal_at`].
    pub fn normal_at(&self, face: usize, place: DVec3) -> DVec3 {
        match self.solid.is_smooth() {
            true => self.turn.matrix() * self.solid.normal_at(face, self.in_body_axes(place - self.foot)),
            false => self.normal(face),
        }
    }

    /// A vector of terrain axes in those of the solid, by its scale.
    fn in_body_axes(&self, vector: DVec3) -> DVec3 {
        self.turn.matrix().transpose() * vector / self.scale
    }

    /// What turns body axes (forward, starboard, up) into north, east, up, and how many times as large as its solid it is: a vertex
    /// of the solid is at `foot + turn * (vertex * scale)`.
    pub fn to_ground(&self) -> (DMat3, f64) {
        (self.turn.matrix(), self.scale)
    }

    /// From body axes to terrain axes.
    fn place_of(&self) -> impl Fn(DVec3) -> DVec3 + Clone + use<> {
        let (foot, turn, scale) = (self.foot, self.turn.matrix(), self.scale);
        move |vertex| foot + turn * (vertex * scale)
    }

    /// A corner of a face, in terrain axes: a point of its plane.
    pub fn on_face(&self, face: usize) -> DVec3 {
        self.place_of()(self.solid.vertices()[self.solid.faces()[face].corners[0] as usize])
    }

    /// Diffuse reflectivity of each face, `max(n.s, 0)` times its albedo, under the unit vector to the sun.
    pub fn reflectivities(&self, sun_direction: DVec3) -> impl Iterator<Item = f64> {
        let lit = self.normals().map(move |normal| normal.dot(sun_direction).max(0.0));
        lit.zip(self.solid.faces()).map(|(cosine, face)| cosine * face.albedo)
    }

    /// Where the ray from `origin` along `direction` first comes into the body from outside, at a distance of
    /// `from` or more. A ray that is within the body there enters nothing: faces are met from outside only.
    pub fn first_hit(&self, origin: DVec3, direction: DVec3, from: f64) -> Option<Hit> {
        if !self.is_near(origin, direction) {
            return None;
        }
        if self.solid.is_open() {
            return self.first_side(origin, direction, from);
        }
        let mut entry = Hit { distance: f64::NEG_INFINITY, face: 0 };
        let mut exit = f64::INFINITY;
        for (face, normal) in self.normals().enumerate() {
            let height = normal.dot(origin - self.on_face(face));
            let rate = normal.dot(direction);
            if rate < 0.0 {
                let distance = height / -rate;
                if distance > entry.distance {
                    entry = Hit { distance, face };
                }
            } else if rate > 0.0 {
                exit = exit.min(height / -rate);
            } else if height > 0.0 {
                return None;
            }
        }
        (entry.distance >= from && entry.distance <= exit).then_some(entry)
    }

    /// Where a ray first meets a face of an open solid, from either side.
    fn first_side(&self, origin: DVec3, direction: DVec3, from: f64) -> Option<Hit> {
        let (origin, direction) = (self.in_body_axes(origin - self.foot), self.in_body_axes(direction));
        let meets = |face: usize| {
            let normal = self.solid.faces()[face].normal;
            let on_face = self.solid.vertices()[self.solid.faces()[face].corners[0] as usize];
            let distance = normal.dot(on_face - origin) / normal.dot(direction);
            // A ray along the face meets nothing: its distance is no number, or infinite.
            let is_met = distance >= from && distance < f64::INFINITY;
            (is_met && self.solid.holds(face, origin + distance * direction))
                .then_some(Hit { distance, face })
        };
        let hits = (0..self.solid.faces().len()).filter_map(meets);
        hits.min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// Whether a ray comes near the bounding sphere, with room for rounding: nearly all pass by.
    fn is_near(&self, origin: DVec3, direction: DVec3) -> bool {
        let beside = (self.centre - origin).cross(direction).length_squared();
        beside <= self.radius * self.radius * direction.length_squared() * (1.0 + NEAR) + NEAR
    }
}

/// Room for rounding around a bounding sphere (part of its radius squared, and m2 for a unit vector).
const NEAR: f64 = 1e-6;

/// A sphere about the middle of the box around all vertices.
fn bounding_sphere(vertices: impl Iterator<Item = DVec3> + Clone) -> (DVec3, f64) {
    let low = vertices.clone().fold(DVec3::INFINITY, DVec3::min);
    let high = vertices.clone().fold(DVec3::NEG_INFINITY, DVec3::max);
    let centre = (low + high) * 0.5;
    let radius = vertices.map(|vertex| vertex.distance(centre)).fold(0.0, f64::max);
    (centre, radius)
}
