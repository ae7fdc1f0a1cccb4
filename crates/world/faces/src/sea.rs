//! A flat sea: a board of false normals under a sun that turns.

use quantities::Rate;

use crate::board::Board;
use crate::cone::Cone;
use crate::error::{FaceError, within};
use crate::face::Vertex;
use crate::group::Group;
use crate::mesh::Mesh;
use crate::pattern::Pattern;
use crate::roads::{renumbered, steps_of};
use crate::states::{Mean, SeaState};
use crate::sun::{SunProgramme, Turn, TurningSun};
use crate::warning::Warning;

/// A pattern of false normals with the sun that moves it.
#[derive(Debug, Clone, PartialEq)]
pub struct Sea {
    /// Squares of the sea.
    pub board: Board,
    /// Rule of the normals.
    pub pattern: Pattern,
    /// Table of the normals.
    pub cone: Cone,
    /// The sun that turns over it.
    pub sun: TurningSun,
    /// Factor of the brightness.
    pub gain: f64,
    /// Linear red, green, blue of full brightness.
    pub colour: [f64; 3],
}

/// Elevation of the wake's sun: 50 deg (radians, chosen).
const WAKE_ELEVATION: f64 = 50.0 * std::f64::consts::PI / 180.0;

impl Sea {
    /// A sea in one of the states, its sun in the north in frame 0.
    ///
    /// # Errors
    /// If the pattern is out of range, or the mean cannot be held.
    pub fn of_state(
        state: SeaState,
        (board, pattern, cone): (Board, Pattern, Cone),
        (mean, colour): (Mean, [f64; 3]),
        frames: Rate,
    ) -> Result<Self, FaceError> {
        pattern.check()?;
        let elevation = state.elevation(&cone)?;
        let sun = TurningSun::new(elevation, 0.0, Turn::new(state.rate(), frames)?)?;
        Ok(Self { gain: mean.gain(&cone, elevation)?, board, pattern, cone, sun, colour })
    }

    /// A wake of the same kind: squares of half the side, its sun at 50 deg and 2 Hz, half the brightness (chosen).
    ///
    /// `board` gives the rows and columns in squares of the wake.
    ///
    /// # Errors
    /// If 2 Hz are above half of the frame rate.
    pub fn wake(&self, board: Board, colour: [f64; 3], frames: Rate) -> Result<Self, FaceError> {
        let side = board.side();
        within(
            "side of a wake's square (m)",
            side,
            side < self.board.side(),
            "below the side of the sea's squares",
        )?;
        let sun = TurningSun::new(WAKE_ELEVATION, 0.0, Turn::new([2, 1], frames)?)?;
        Ok(Self { board, sun, gain: 0.5, colour, ..self.clone() })
    }

    /// Numbers of all normals, row by row.
    pub fn numbers(&self) -> Vec<u32> {
        self.board.grid().map(|vertex| self.pattern.number(vertex, self.cone.count())).collect()
    }

    /// The list `name` of the sea, whose sun turns; at most `most` squares.
    ///
    /// # Errors
    /// If the sea has too many squares, or a colour is out of range.
    pub fn group(&self, name: &str, priority: i32, most: usize) -> Result<Group, FaceError> {
        let mesh = self.mesh(name, 0, most)?;
        Ok(Group::new(name, mesh, priority).under(SunProgramme::Turning(self.sun)).with_gain(self.gain))
    }

    /// The list in `frame` by the other road: normals renumbered to the nearest step of the table, the sun as in frame 0.
    ///
    /// # Errors
    /// As [`Sea::group`].
    pub fn renumbered(&self, name: &str, priority: i32, most: usize, frame: u64) -> Result<Group, FaceError> {
        let steps = steps_of(self.sun.turn().at(frame), self.cone.count());
        let fixed = SunProgramme::Turning(self.sun.still());
        Ok(Group::new(name, self.mesh(name, steps, most)?, priority).under(fixed).with_gain(self.gain))
    }

    /// Flat squares whose normals are renumbered by `steps`.
    fn mesh(&self, name: &str, steps: u32, most: usize) -> Result<Mesh, FaceError> {
        let count = self.cone.count();
        let squares = self.board.squares(name, self.colour, most, |vertex| {
            let number = renumbered(self.pattern.number(vertex, count), steps, count);
            let [north, east] = vertex.place;
            Vertex { place: [north, east, 0.0].into(), normal: Some(self.cone.normal(number)) }
        })?;
        Ok(squares.mesh)
    }

    /// What a user should know of the sea's sun and normals.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = self.sun.warnings();
        warnings.extend(self.cone.warnings(self.sun.elevation()));
        warnings
    }
}
