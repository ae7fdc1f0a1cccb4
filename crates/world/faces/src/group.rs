//! A list of faces with its priority, its sun, its detail rule, and the faces that take turns in it.

use glam::DVec3;

use crate::error::FaceError;
use crate::face::Shading;
use crate::mesh::Mesh;
use crate::normals::{CornerNormals, Weights};
use crate::sequence::Sequence;
use crate::shade::brightness;
use crate::sun::SunProgramme;

/// How a second level of detail meets the level below it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    /// It stands in place of the level below (reported: the hardware before the change).
    Replace,
    /// The sum, clamped at full scale (reported: the changed hardware).
    Add,
    /// The sum that never exceeds full scale (chosen).
    AddSoft,
}

/// An object list of the generator.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Name of the list in messages and records.
    pub name: String,
    /// Its faces, in order: the earlier face wins.
    pub mesh: Mesh,
    /// Normals at the corners of the faces.
    pub normals: CornerNormals,
    /// Priority: the lower number wins (reported).
    pub priority: i32,
    /// Which sun lights it.
    pub sun: SunProgramme,
    /// Factor of the brightness of its faces, above 0.
    pub gain: f64,
    /// How it meets a list below it.
    pub detail: Detail,
    sequences: Vec<Sequence<Vec<usize>>>,
}

impl Group {
    /// A list under the scenario's sun, whose faces all show, with normals of equal weights.
    pub fn new(name: impl Into<String>, mesh: Mesh, priority: i32) -> Self {
        let normals = CornerNormals::new(&mesh, Weights::Equal);
        let (sun, detail) = (SunProgramme::Scenario, Detail::Replace);
        Self { name: name.into(), mesh, normals, priority, sun, gain: 1.0, detail, sequences: Vec::new() }
    }

    /// The same with normals averaged by `weights`.
    pub fn weighted(self, weights: Weights) -> Self {
        Self { normals: CornerNormals::new(&self.mesh, weights), ..self }
    }

    /// The same under another sun.
    pub fn under(self, sun: SunProgramme) -> Self {
        Self { sun, ..self }
    }

    /// The same with the brightness of its faces multiplied by `gain`, above 0.
    pub fn with_gain(self, gain: f64) -> Self {
        Self { gain, ..self }
    }

    /// The same with another detail rule.
    pub fn detailed(self, detail: Detail) -> Self {
        Self { detail, ..self }
    }

    /// The same with sequences: each member is a set of faces, by number, that show together.
    ///
    /// # Errors
    /// If a member names a face that the list lacks, or a face stands in two places.
    pub fn with_sequences(self, sequences: Vec<Sequence<Vec<usize>>>) -> Result<Self, FaceError> {
        let faces = self.mesh.faces().len();
        let mut taken = vec![false; faces];
        for (member, of) in sequences.iter().flat_map(|sequence| sequence.members().iter().enumerate()) {
            for &face in of {
                let list = || self.name.clone();
                match taken.get_mut(face) {
                    None => return Err(FaceError::NoFace { list: list(), member, face, faces }),
                    Some(true) => return Err(FaceError::SharedFace { list: list(), face }),
                    Some(taken) => *taken = true,
                }
            }
        }
        Ok(Self { sequences, ..self })
    }

    /// Sequences of faces that take turns.
    pub fn sequences(&self) -> &[Sequence<Vec<usize>>] {
        &self.sequences
    }

    /// Faces that show in `frame`, by number, in the order of the list; `signal` gives the value of each signal by name.
    ///
    /// A face of no sequence always shows.
    pub fn shown(&self, frame: u64, signal: impl Fn(&str) -> f64) -> Vec<usize> {
        self.shown_late(frame, 0, signal)
    }

    /// The same with every step of a sequence `late` frames too late.
    pub fn shown_late(&self, frame: u64, late: u32, signal: impl Fn(&str) -> f64) -> Vec<usize> {
        let mut shows = vec![true; self.mesh.faces().len()];
        for sequence in &self.sequences {
            sequence.members().iter().flatten().for_each(|&face| shows[face] = false);
            let value = sequence.signal().map_or(0.0, &signal);
            let member = sequence.index_late(frame, late, value);
            sequence.members()[member].iter().for_each(|&face| shows[face] = true);
        }
        (0..shows.len()).filter(|&face| shows[face]).collect()
    }

    /// Brightness at corner `corner` of a face, gain included; from `behind`, the normal is reversed.
    ///
    /// `sun` is a unit vector in the list's own axes: of a list that is turned, turn the sun back.
    pub fn corner_brightness(&self, face: usize, corner: usize, sun: DVec3, behind: bool) -> f64 {
        let normal = self.normals.of_face(face)[corner];
        match (self.mesh.faces()[face].shading, behind) {
            (Shading::Glow, _) => self.gain,
            (_, false) => self.gain * brightness(normal, sun),
            (_, true) => self.gain * brightness(-normal, sun),
        }
    }

    /// Brightness at all corners of a face; see [`Self::corner_brightness`].
    pub fn brightness(&self, face: usize, sun: DVec3, behind: bool) -> Vec<f64> {
        let corners = 0..self.mesh.faces()[face].corners.len();
        corners.map(|corner| self.corner_brightness(face, corner, sun, behind)).collect()
    }
}
