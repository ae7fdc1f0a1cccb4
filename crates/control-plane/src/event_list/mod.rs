//! The digital side as a list of events: what the timing record counts, one by one.
//!
//! A listener of the service knows what was told; what was not told follows from it: which set a fold asks for, transfers,
//! overwrites or cancels is fixed by the wiring (section 6.3). Late words are those of the sweep program.

mod frame;
mod listener;
mod loads;

use quantities::{SweepTime, Tick};
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
        let levels = crossings.stage.landscape.bank().levels();
        let mut program = SweepProgram::idle();
        let loader = &crossings.stage.settings.loader;
        let mut fine = Listener::new(self, sweep, 0, &levels[0], loader);
        crossings.write_fine(sweeps, &mut program, &mut fine);
        let mut events = fine.finish(&program);
        let mut end = program.end_range;
        if let Some(coarse) = crossings.coarse {
            let mut listener = Listener::new(self, sweep, 1, &levels[1], &coarse.loader);
            crossings.write_coarse(coarse, sweeps, &mut program, &mut listener);
            events.extend(listener.finish(&program));
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

/// The tick that an instant of a sweep was made from: turned back half a tick earlier, rounding makes it no other.
fn tick_of(sweeps: &FrameSweeps<'_>, sweep: u32, time: SweepTime) -> Tick {
    let half = 0.5 / sweeps.crossings().stage.settings.timebase.ticks_per_sample();
    sweeps.clock(sweep).tick_at_or_after(SweepTime(time.0 - half))
}
