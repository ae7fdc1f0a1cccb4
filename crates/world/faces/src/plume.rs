//! A dust plume by substitution: one face of a flight at a time, in several copies that start staggered.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use quantities::sin_cos;

use crate::clip::Half;
use crate::error::{FaceError, within};
use crate::face::{Face, Vertex};
use crate::flight::Flight;
use crate::group::Group;
use crate::mesh::Mesh;
use crate::sequence::{Mode, Sequence};

/// A plume from one place on the ground (shape chosen).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plume {
    /// Flight of its middle.
    pub flight: Flight,
    /// Flights on both sides of the middle (radians, 0 to a quarter turn).
    pub spread: f64,
    /// Azimuth along which it flies (radians, from forward to starboard).
    pub azimuth: f64,
    /// Faces of one flight.
    pub faces: usize,
    /// Linear red, green, blue of the dust.
    pub colour: [f64; 3],
}

/// Part of the time so far over which the dust of one face was launched (chosen).
const PART: f64 = 0.4;

impl Plume {
    /// Corners of face `face` in the plume's axes: forward, starboard, up from its source (m). No corner is below the ground.
    pub fn corners(&self, face: usize) -> Vec<DVec3> {
        let (sin, cos) = sin_cos(self.azimuth);
        let sheet = self.flight.sheet(self.flight.time_of(face, self.faces), self.spread, PART);
        let outline = sheet.map(|[x, z]| DVec3::new(x * cos, x * sin, z));
        Half::above(0.0).clip(&outline)
    }

    /// Copy `copy` of `copies` as list `name`, each face shown for `frames` frames. Its origin is the source.
    ///
    /// # Errors
    /// If a figure is out of range.
    pub fn group(
        &self,
        name: &str,
        priority: i32,
        frames: u64,
        (copy, copies): (u64, u64),
    ) -> Result<Group, FaceError> {
        let allowed = self.spread > 0.0 && self.spread <= FRAC_PI_2;
        within("spread of a plume (rad)", self.spread, allowed, "above 0, pi / 2 at most")?;
        within("azimuth of a plume (rad)", self.azimuth, true, "a finite number")?;
        within("faces of a plume", self.faces as f64, self.faces > 0, "1 or more")?;
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        for face in 0..self.faces {
            let first = vertices.len() as u32;
            vertices.extend(self.corners(face).into_iter().map(Vertex::at));
            let corners = (first..vertices.len() as u32).collect();
            faces.push(Face::flat(corners, self.colour).both_sides());
        }
        let loaded = Mesh::load(name, vertices, faces)?;
        let members = loaded.kept.into_iter().map(|kept| Some(kept.into_iter().collect())).collect();
        let turns = Sequence::new(members, frames, 0, Mode::Cycle)?.staggered(copy, copies);
        Group::new(name, loaded.mesh, priority).with_sequences(vec![turns])
    }
}
