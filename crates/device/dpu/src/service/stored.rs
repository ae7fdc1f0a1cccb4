//! What is in the storage buffer when a register asks for it.

use quantities::{SweepTime, Tick};
use sweep_program::{Colour, NO_CORNER, PreloadRegister, RegisterCorners, SweepProgram};

use super::Service;
use crate::watch::{AskedCorner, Register, ServiceEvent, Watch};

/// Who asks for a corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asking {
    pub crossing: Option<u32>,
    pub colour: Colour,
    pub register: Register,
}

impl<W: Watch> Service<'_, '_, '_, W> {
    /// Index of a corner in the storage buffer at `tick`, or that of no corner; `of` is who asks for it, and `event` how
    /// that is told.
    pub(super) fn stored(
        &mut self,
        corner: u32,
        tick: Tick,
        of: Asking,
        event: fn(AskedCorner) -> ServiceEvent,
    ) -> u32 {
        if !W::LISTENS && self.unit.missing.is_empty() {
            return corner;
        }
        let arrival = self.unit.arrival_of(corner);
        let Asking { crossing, colour, register } = of;
        let at = self.instant_of(tick);
        let asked = AskedCorner { tick, at, crossing, colour, register, corner, arrival };
        self.watch.tell(tick, event(asked));
        if asked.is_there() {
            return corner;
        }
        self.watch.tell(tick, ServiceEvent::Absent(asked));
        NO_CORNER
    }

    /// Home registers are filled from the same buffer.
    pub fn look_up_home(&mut self, program: &mut SweepProgram) {
        if !W::LISTENS && self.unit.missing.is_empty() {
            return;
        }
        let tick = self.seen(SweepTime(0.0));
        let [x, y] = [PreloadRegister::XFirst, PreloadRegister::YFirst].map(Register::Preload);
        for (colour, set) in Colour::ALL.into_iter().zip(&mut program.registers) {
            for (register, corner) in
                [(Register::Hold, &mut set.hold), (x, &mut set.x_first), (y, &mut set.y_first)]
            {
                let asking = Asking { crossing: None, colour, register };
                *corner = self.stored(*corner, tick, asking, ServiceEvent::Home);
            }
        }
        self.held = W::LISTENS.then(|| RegisterCorners::at_start(&program.registers));
    }
}
