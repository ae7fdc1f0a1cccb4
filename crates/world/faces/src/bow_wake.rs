//! Bow wake of the study: 28 upright faces, of which one shows at a time on each side.

use glam::DVec3;

use crate::error::{FaceError, within};
use crate::face::{Face, Vertex};
use crate::group::Group;
use crate::mesh::Mesh;
use crate::sequence::{Mode, Sequence};

/// Faces of the sequence (reported).
pub const BOW_FACES: usize = 28;

/// Side of the ship on which a wake stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Left side of the ship.
    Port,
    /// Right side of the ship.
    Starboard,
}

/// Size and colours of a bow wake (shapes are chosen: the study does not give them).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BowWake {
    /// Greatest height of the crest (m).
    pub height: f64,
    /// Length of the base of the last face (m).
    pub length: f64,
    /// Outward shift of the crest as a part of the base; 0 stands upright.
    pub lean: f64,
    /// Linear red, green, blue of foam.
    pub foam: [f64; 3],
    /// Linear red, green, blue of the sea, to which the last quarter fades.
    pub sea: [f64; 3],
}

impl BowWake {
    /// The wake at `part` times the speed for which it was given: the height grows with the square, the length with the speed.
    pub fn at_speed(&self, part: f64) -> Self {
        Self { height: self.height * part * part, length: self.length * part, ..*self }
    }

    /// Length of the base of face `face` (m).
    pub fn base(&self, face: usize) -> f64 {
        self.length * (0.4 + 0.6 * phase(face))
    }

    /// Height of the crest of face `face` (m).
    pub fn crest(&self, face: usize) -> f64 {
        self.height * libm::sin(std::f64::consts::PI * phase(face))
    }

    /// Linear red, green, blue of face `face`.
    pub fn colour(&self, face: usize) -> [f64; 3] {
        let faded = ((phase(face) - 0.75) / 0.25).clamp(0.0, 1.0);
        [0, 1, 2].map(|k| self.foam[k] * (1.0 - faded) + self.sea[k] * faded)
    }

    /// Corners of face `face` on one side: bow, end of the base, crest; forward, starboard, up from the bow at the water (m).
    pub fn corners(&self, face: usize, side: Side) -> [DVec3; 3] {
        let (base, crest) = (self.base(face), self.crest(face));
        let out = match side {
            Side::Port => -self.lean * base,
            Side::Starboard => self.lean * base,
        };
        [DVec3::ZERO, DVec3::new(-base, 0.0, 0.0), DVec3::new(-0.35 * base, out, crest)]
    }

    /// The list `name` of one side, each face shown for `frames` frames; its origin is the bow at the water.
    ///
    /// # Errors
    /// If height or length are not above 0, lean is below 0, a colour is out of range, or `frames` is 0.
    pub fn group(&self, name: &str, side: Side, priority: i32, frames: u64) -> Result<Group, FaceError> {
        within("height of a bow wake (m)", self.height, self.height > 0.0, "above 0")?;
        within("length of a bow wake (m)", self.length, self.length > 0.0, "above 0")?;
        within("lean of a bow wake", self.lean, self.lean >= 0.0, "0 or more")?;
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        for face in 0..BOW_FACES {
            let first = vertices.len() as u32;
            vertices.extend(self.corners(face, side).map(Vertex::at));
            faces.push(Face::flat(vec![first, first + 1, first + 2], self.colour(face)).both_sides());
        }
        let mesh = Mesh::load(name, vertices, faces)?.mesh;
        let members = (0..mesh.faces().len()).map(|face| Some(vec![face])).collect();
        let turns = Sequence::new(members, frames, 0, Mode::Cycle)?;
        Group::new(name, mesh, priority).with_sequences(vec![turns])
    }
}

/// Part of its life in whose middle a face is drawn, 0 to 1.
fn phase(face: usize) -> f64 {
    (face as f64 + 0.5) / BOW_FACES as f64
}

/// Share of a level that a second one takes over at the eye's elevation `elevation` above it (radians): none up to 20 deg, all from
/// 40 deg (chosen). An upright face vanishes from above; a pattern on the water then stands in for it.
pub fn blend(elevation: f64) -> f64 {
    ((quantities::degrees(elevation) - 20.0) / 20.0).clamp(0.0, 1.0)
}
