//! Pointers of the four colours, and what the home registers hold at sweep start.

use hardware_model::{Cpu, Loader};
use landscape::Level;
use quantities::Tick;
use sweep_program::{Colour, Fold, PreloadRegister, RegisterSet, SweepStart};

use crate::server::{Job, Server, Wanted};

/// The corner that each colour stands for, as lattice indices, and the way the sweep goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pointers {
    /// Lattice lines on which the colours stand: of each axis the even and the odd one.
    lines: [[i64; 2]; 2],
    heading: [i64; 2],
}

impl Pointers {
    /// Pointers at the corners of the start region (6.5, rule 4).
    pub fn at_start(start: &SweepStart) -> Self {
        let lines = start.region.map(|line| if line & 1 == 0 { [line, line + 1] } else { [line + 1, line] });
        let sign = |cosine: f64| if cosine < 0.0 { -1 } else { 1 };
        Self { lines, heading: start.direction.map(sign) }
    }

    /// The corner of a colour.
    pub fn corner(&self, colour: Colour) -> [i64; 2] {
        [self.lines[0][usize::from(colour.at_far_x())], self.lines[1][usize::from(colour.at_far_y())]]
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

    /// Moves the two colours that `fold` gives new words: the line that they stand on.
    #[inline]
    pub fn follow(&mut self, fold: Fold) {
        let [axis, line] = moved(fold);
        self.lines[axis][line] += 2 * self.heading[axis];
    }

    /// The even or the odd `line` of `axis` on which two colours stand.
    pub(crate) fn line(&self, axis: usize, line: usize) -> i64 {
        self.lines[axis][line]
    }

    /// The line to which two colours move with their next fold of `axis`; they stand on the even or the odd `line`.
    #[inline]
    pub(crate) fn line_ahead(&self, axis: usize, line: usize) -> i64 {
        self.lines[axis][line] + 2 * self.heading[axis]
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

/// Axis, and even or odd line, on which the colours stand that `fold` gives new words.
#[inline]
pub(crate) fn moved(fold: Fold) -> [usize; 2] {
    // By number, as in their declarations: what is compared becomes a branch, and nobody can guess which fold comes next.
    [fold.axis as usize, 1 - fold.stop as usize]
}

/// Sets of the home registers: hold and both preload registers of four colours.
pub const HOME_SETS: u32 = 12;

/// Ticks in which the server of the crossings fills the home registers before the mission, when it has nothing else to do:
/// as if one fold asked for all sets.
pub fn home_load(loader: &Loader, cpu: &Cpu) -> u64 {
    let idle = Cpu { longest_instruction: 0, ..*cpu };
    let mut server = Server::new(loader, &idle, 0, [0; 2], Tick(0));
    for number in 0..HOME_SETS {
        // A set takes its time whatever register it is for.
        server.ask(Job {
            number,
            colour: Colour::ALL[number as usize % 4],
            wanted: Wanted::Diagonal,
            corner: 0,
            asked: Tick(0),
            crossing: 0,
            urgent: false,
            late: false,
        });
    }
    let mut last = 0;
    while let Some(served) = server.lines().find_map(|line| server.next(line, None)) {
        last = last.max(server.last(&served).0);
    }
    last
}

#[cfg(test)]
mod tests {
    use super::home_load;
    use hardware_model::{Cpu, CrossingServer, HardwareModel, IoProcessor, Loader};

    /// Twelve sets in four banks, on one line behind one order, on one line behind one interrupt.
    #[test]
    fn home_registers_are_filled_by_the_server_of_the_crossings() {
        let io_processor = IoProcessor { order: 7, chain: 3, edit: 0 };
        let ideal = HardwareModel::ideal().loader;
        assert_eq!(home_load(&ideal, &Cpu::default()), 0);
        let cpu = Cpu { interrupt: 50, longest_instruction: 90, ..Cpu::default() };
        let load = |served_by| {
            let loader =
                Loader { served_by, pointer: 1, access: 5, strobe: 2, io_processor, ..ideal.clone() };
            home_load(&loader, &cpu)
        };
        assert_eq!(load(CrossingServer::WiredPointers), 3 * (1 + 5) + 2);
        assert_eq!(load(CrossingServer::IoProcessor), 7 + 12 * (3 + 1 + 5) + 2);
        assert_eq!(load(CrossingServer::CpuInterrupt), 50 + 12 * (1 + 5) + 2);
    }
}
