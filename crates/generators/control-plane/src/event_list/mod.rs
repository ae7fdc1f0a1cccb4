//! The digital side as a list of events: what the timing record counts, one by one.
//!
//! The service of the crossings tells its events ([`dpu::ServiceEvent`]), and a listener writes them down. Set-ups, records from
//! drums, craters and shadow boundaries are listed from what the processor, the drums and the loads came to.

mod frame;
mod listener;
mod loads;

use sweep_program::SweepProgram;

use crate::digital_event::DigitalEvent;
use crate::frame_sweeps::FrameSweeps;

use listener::Listener;
use loads::Loads;

impl FrameSweeps<'_> {
    /// Digital events of one sweep, both levels, in order of ticks; at one tick in order of cause, the fine level first, then
    /// craters and shadow boundaries; these if the frame has its gates ([`sweeps_with_gates`](crate::ControlPlane::sweeps_with_gates)).
    pub fn events(&self, sweep: u32) -> Vec<DigitalEvent> {
        let (crossings, sweeps) = (self.crossings(), [self.set_up_of(sweep), sweep]);
        let mut program = SweepProgram::idle();
        let mut fine = Listener::new(self, sweep, 0);
        crossings.write_fine(sweeps, &mut program, &mut fine);
        let (mut events, mut end) = (fine.events, program.end_range);
        if let Some(coarse) = crossings.coarse {
            let mut listener = Listener::new(self, sweep, 1);
            crossings.write_coarse(coarse, sweeps, &mut program, &mut listener);
            events.extend(listener.events);
            end = end.max(program.end_range);
        }
        let loads = Loads { sweeps: self, sweep };
        events.extend(loads.craters(end));
        events.extend(loads.segments());
        events.sort_by_key(|event| event.tick);
        events
    }

    /// Events of the frame that belong to no fold: set-ups, tables, records from the drums; in order of ticks.
    pub fn frame_events(&self) -> Vec<DigitalEvent> {
        let mut events = [frame::processor(self), frame::records(self)].concat();
        events.sort_by_key(|event| event.tick);
        events
    }
}
