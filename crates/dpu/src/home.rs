//! Pointers of the four colours, and what the home registers hold at sweep start.

use landscape::Level;
use sweep_program::{Colour, Fold, PreloadRegister, RampAxis, RegisterSet, SweepStart};

/// The corner that each colour stands for, as lattice indices, and the way the sweep goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pointers {
    corners: [[i64; 2]; 4],
    heading: [i64; 2],
}

impl Pointers {
    /// Pointers at the corners of the start region (6.5, rule 4).
    pub fn at_start(start: &SweepStart) -> Self {
        let mut corners = [[0; 2]; 4];
        for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let corner = [start.region[0] + i, start.region[1] + j];
            corners[Colour::of_corner(corner[0], corner[1]) as usize] = corner;
        }
        let sign = |cosine: f64| if cosine < 0.0 { -1 } else { 1 };
        Self { corners, heading: start.direction.map(sign) }
    }

    /// The corner of a colour.
    pub fn corner(&self, colour: Colour) -> [i64; 2] {
        self.corners[colour as usize]
    }

    /// The corner that a preload register of a colour must hold: one array step, that is two corners, ahead.
    pub fn ahead(&self, colour: Colour, register: PreloadRegister) -> [i64; 2] {
        let [m, n] = self.corner(colour);
        match register {
            PreloadRegister::XFirst => [m + 2 * self.heading[0], n],
            PreloadRegister::YFirst => [m, n + 2 * self.heading[1]],
        }
    }

    /// The corner beyond both stops.
    pub fn diagonal(&self, colour: Colour) -> [i64; 2] {
        let [m, n] = self.corner(colour);
        [m + 2 * self.heading[0], n + 2 * self.heading[1]]
    }

    /// Moves the two colours that `fold` gives new words.
    pub fn follow(&mut self, fold: Fold) {
        let axis = usize::from(fold.axis == RampAxis::Y);
        for colour in Colour::ALL {
            if fold.axis.takes(fold.stop, colour) {
                self.corners[colour as usize][axis] += 2 * self.heading[axis];
            }
        }
    }

    /// Full registers for these pointers, as indices into the storage buffer of `level`.
    pub fn home_registers(&self, level: &Level) -> [RegisterSet; 4] {
        let index = |[m, n]: [i64; 2]| level.clamped_index(m, n) as u32;
        Colour::ALL.map(|colour| RegisterSet {
            hold: index(self.corner(colour)),
            x_first: index(self.ahead(colour, PreloadRegister::XFirst)),
            y_first: index(self.ahead(colour, PreloadRegister::YFirst)),
        })
    }
}
