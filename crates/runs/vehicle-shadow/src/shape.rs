//! The vehicle that casts the shadow.

use std::sync::Arc;

use diagnostics::{Problem, ProblemList};
use scenario::VehicleShape;
use solids::shape_files::{self, Openness};
use solids::{Body, Solid, culture};

use crate::Shot;
use crate::function::CharacteristicFunction;

/// A vehicle of convex parts.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    shape: VehicleShape,
    function: CharacteristicFunction,
    notes: Vec<String>,
}

impl Shape {
    /// Convex parts in common body axes (forward, starboard, up; the foot point at the origin); the eye stands
    /// `eye_height` (m) above the foot point.
    pub fn new(parts: Vec<Solid>, eye_height: f64) -> Self {
        let function = CharacteristicFunction::of_parts(&parts, eye_height);
        let parts = parts.into_iter().map(Arc::new).collect();
        Self { shape: VehicleShape { parts, eye_height }, function, notes: Vec::new() }
    }

    /// The man-made thing of that name, or the shape file of that path.
    ///
    /// # Errors
    /// If it is neither, or the file has faults.
    pub fn find(name: &str, eye_height: f64) -> Result<Self, ProblemList> {
        let is_file = name.contains(['.', '/', '\\']);
        match culture::model(name) {
            Some(parts) => Ok(Self::new(parts, eye_height)),
            None if is_file => {
                let shape_files::Shape { solids, notes, .. } = shape_files::read(name, Openness::Closed)?;
                Ok(Self { notes, ..Self::new(solids, eye_height) })
            }
            None => {
                let problem = Problem::of_file(name, format!("no vehicle has the name `{name}`"));
                Err(problem.expected(format!("one of {}, or a shape file", culture::NAMES.join(", "))).into())
            }
        }
    }

    /// What the user should know of how its file was read.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The same as a string of points.
    pub fn function(&self) -> &CharacteristicFunction {
        &self.function
    }

    /// Height of the eye above the foot point (m).
    pub fn eye_height(&self) -> f64 {
        self.shape.eye_height
    }

    /// Height of the highest point above the foot point (m).
    pub fn top(&self) -> f64 {
        let heights = self.shape.parts.iter().flat_map(|part| part.vertices()).map(|vertex| vertex.z);
        heights.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The parts where they stand: north, east, up. The vehicle turns about the eye.
    pub fn bodies(&self, shot: &Shot) -> Vec<Body> {
        self.shape.bodies(shot.eye, shot.vehicle).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Shape;

    #[test]
    fn names_and_files() {
        assert!(Shape::find("rover", 1.6).unwrap().top() > 1.6);
        let said = |name: &str| Shape::find(name, 1.6).unwrap_err().to_string();
        assert!(said("rowboat").contains("rowboat") && said("rowboat").contains("lander, rover"));
        assert!(said("gone.obj").contains("gone.obj: no such file"), "{}", said("gone.obj"));
    }
}
