//! What is in the storage buffer when a register asks for it.

use quantities::{SweepTime, Tick};
use sweep_program::{Colour, NO_CORNER, PreloadRegister, SweepProgram};

use super::Service;
use crate::watch::{AskedCorner, CornerArrival, Watch};

/// Who asks for a corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asking {
    pub crossing: Option<u32>,
    pub colour: Colour,
    pub register: Option<PreloadRegister>,
}

impl<W: Watch> Service<'_, '_, '_, W> {
    /// Index of a corner in the storage buffer at `tick`, or that of no corner; `of` is who asks for it.
    pub(super) fn stored(&mut self, corner: u32, tick: Tick, of: Asking) -> u32 {
        if !W::LISTENS && self.unit.missing.is_empty() {
            return corner;
        }
        let arrival = self.unit.arrival_of(corner);
        let Asking { crossing, colour, register } = of;
        let at = self.instant_of(tick);
        self.watch.corner(&AskedCorner { tick, at, crossing, colour, register, corner, arrival });
        let is_there = match arrival {
            CornerArrival::BeforeFrame => true,
            CornerArrival::At(arrival) => arrival <= tick,
            CornerArrival::NotInFrame => false,
        };
        if is_there { corner } else { NO_CORNER }
    }

    /// Home registers are filled from the same buffer.
    pub fn look_up_home(&mut self, program: &mut SweepProgram) {
        if !W::LISTENS && self.unit.missing.is_empty() {
            return;
        }
        let tick = self.seen(SweepTime(0.0));
        for (colour, set) in Colour::ALL.into_iter().zip(&mut program.registers) {
            let [x, y] = [PreloadRegister::XFirst, PreloadRegister::YFirst].map(Some);
            for (register, corner) in [(None, &mut set.hold), (x, &mut set.x_first), (y, &mut set.y_first)] {
                *corner = self.stored(*corner, tick, Asking { crossing: None, colour, register });
            }
        }
    }
}
