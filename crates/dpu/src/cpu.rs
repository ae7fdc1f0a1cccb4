//! The processor's frame: set-up of the sweeps, tables and polyhedra, and what crossings leave of its time (hardware 4.6).

use hardware_model::Cpu;

/// What the processor has to do in one frame, in master ticks from the frame's start.
#[derive(Debug, Clone, Copy)]
pub struct CpuLoad<'a> {
    /// Start of each sweep, and the end of the frame.
    pub starts: &'a [u64],
    /// Ticks that crossings take of each sweep by interrupt; empty if others serve them.
    pub interrupts: &'a [u64],
    /// Vertices of polyhedra to transform and project.
    pub vertices: u64,
}

/// What came of it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CpuFrame {
    /// For each sweep, the sweep whose set-up it is drawn with: itself, or an earlier one if its own is not ready.
    pub drawn: Vec<u32>,
    /// Each set-up that was made, and the ticks from its end to its sweep; below 0 it is late.
    pub set_ups: Vec<(u32, i64)>,
    /// Ticks from the end of tables and polyhedra to that of the frame; below 0, so much work was left.
    pub frame_slack: i64,
    /// Vertices that are ready when the frame ends: tables come first.
    pub vertices: u64,
    /// Ticks of work, interrupts included.
    pub busy: u64,
}

/// A set-up in work.
#[derive(Debug, Clone, Copy)]
struct SetUp {
    sweep: u32,
    rest: u64,
}

/// The processor, walked from one sweep's time to the next.
struct Processor<'a> {
    cpu: &'a Cpu,
    load: CpuLoad<'a>,
    in_work: Option<SetUp>,
    /// Work on tables and polyhedra that is left.
    tables: u64,
    frame_slack: i64,
    set_ups: Vec<(u32, i64)>,
    busy: u64,
}

/// The processor's frame. During each sweep the next one is set up; a set-up that takes longer goes on, and then the
/// sweep after the present one is next. A sweep is drawn with the last set-up that is made when it begins. Crossings come
/// first in each sweep's time, set-ups next, tables and polyhedra fill the rest. The frame's interrupt clears what the frame
/// before left (our choices), so frames do not depend on one another.
pub fn cpu_frame(cpu: &Cpu, load: CpuLoad<'_>) -> CpuFrame {
    let tables = cpu.frame_tables + cpu.vertex * load.vertices;
    let end = load.end();
    let frame_slack = if tables == 0 { end as i64 } else { -(tables as i64) };
    let mut processor =
        Processor { cpu, load, in_work: None, tables, frame_slack, set_ups: Vec::new(), busy: 0 };
    // The first sweep is set up before the frame begins.
    for sweep in -1..load.sweeps() as i64 {
        processor.pass(sweep);
    }
    let Processor { set_ups, frame_slack, busy, tables, .. } = processor;
    let left = if cpu.vertex == 0 { 0 } else { tables.div_ceil(cpu.vertex) };
    let vertices = load.vertices.saturating_sub(left);
    CpuFrame { drawn: drawn_with(&set_ups, load.starts), set_ups, frame_slack, vertices, busy }
}

/// For each sweep the last set-up that is made when it begins, be it an earlier sweep's.
fn drawn_with(set_ups: &[(u32, i64)], starts: &[u64]) -> Vec<u32> {
    let mut made =
        set_ups.iter().map(|&(sweep, slack)| (sweep, starts[sweep as usize] as i64 - slack)).peekable();
    let mut last = 0;
    let last_made = |&start: &u64| {
        while let Some((sweep, _)) = made.next_if(|&(_, done)| done <= start as i64) {
            last = sweep;
        }
        last
    };
    starts[..starts.len() - 1].iter().map(last_made).collect()
}

impl CpuLoad<'_> {
    fn sweeps(&self) -> usize {
        self.starts.len() - 1
    }

    fn end(&self) -> u64 {
        self.starts[self.sweeps()]
    }

    /// Begin and end of a sweep's time; that before the frame is as long as the first.
    fn time_of(&self, sweep: i64) -> [i64; 2] {
        match usize::try_from(sweep) {
            Ok(sweep) => [self.starts[sweep] as i64, self.starts[sweep + 1] as i64],
            Err(_) => {
                [self.starts[0] as i64 - (self.starts[1] - self.starts[0]) as i64, self.starts[0] as i64]
            }
        }
    }

    fn interrupts_of(&self, sweep: i64) -> u64 {
        usize::try_from(sweep).ok().and_then(|sweep| self.interrupts.get(sweep)).copied().unwrap_or(0)
    }
}

impl Processor<'_> {
    /// One sweep's time.
    fn pass(&mut self, sweep: i64) {
        let [begin, end] = self.load.time_of(sweep);
        let interrupts = self.load.interrupts_of(sweep).min((end - begin) as u64);
        self.busy += interrupts;
        let mut now = begin + interrupts as i64;
        let next = (sweep + 1) as u32;
        let mut asked = (next as usize) < self.load.sweeps();
        while now < end {
            if self.in_work.is_none() && asked {
                self.in_work = Some(SetUp { sweep: next, rest: self.cpu.sweep_setup });
                asked = false;
            }
            let Some(set_up) = &mut self.in_work else { break };
            asked &= set_up.sweep != next;
            let done = set_up.rest.min((end - now) as u64);
            set_up.rest -= done;
            now += done as i64;
            self.busy += done;
            if set_up.rest == 0 {
                let start = self.load.starts[set_up.sweep as usize] as i64;
                self.set_ups.push((set_up.sweep, start - now));
                self.in_work = None;
            }
        }
        if sweep >= 0 && now < end {
            self.fill(now, end);
        }
    }

    /// Tables and polyhedra, in what is left of a sweep's time.
    fn fill(&mut self, now: i64, end: i64) {
        let done = self.tables.min((end - now) as u64);
        self.tables -= done;
        self.busy += done;
        if done > 0 {
            let frame_end = self.load.end() as i64;
            self.frame_slack =
                if self.tables == 0 { frame_end - (now + done as i64) } else { -(self.tables as i64) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{CpuLoad, cpu_frame};
    use hardware_model::Cpu;

    fn starts(period: u64, sweeps: u64) -> Vec<u64> {
        (0..=sweeps).map(|sweep| sweep * period).collect()
    }

    fn cpu(sweep_setup: u64, frame_tables: u64) -> Cpu {
        Cpu { sweep_setup, frame_tables, ..Cpu::default() }
    }

    #[test]
    fn quick_set_ups_are_ready_and_tables_fill_the_rest() {
        let starts = starts(100, 10);
        let load = CpuLoad { starts: &starts, interrupts: &[], vertices: 0 };
        let found = cpu_frame(&cpu(30, 140), load);
        assert_eq!(found.drawn, (0..10).collect::<Vec<u32>>());
        assert!(found.set_ups.iter().all(|&(_, slack)| slack == 70) && found.set_ups.len() == 10);
        // 70 ticks of each sweep are left: two sweeps.
        assert_eq!((found.frame_slack, found.busy), (800, 440));
    }

    #[test]
    fn vertices_that_are_left_are_not_ready() {
        let starts = starts(100, 10);
        let load = CpuLoad { starts: &starts, interrupts: &[], vertices: 50 };
        let found = cpu_frame(&Cpu { vertex: 40, ..cpu(30, 140) }, load);
        // 73 ticks of the ten sweeps are left for 140 + 2000 ticks of work: the last sweep has no set-up.
        assert_eq!((found.frame_slack, found.vertices), (-(2140 - 730), 14));
    }

    #[test]
    fn slow_set_ups_repeat_sweeps() {
        // 3.15 sweeps each: made at 215, 530, 845, for the sweeps after 0, 215 and 530.
        let starts = starts(100, 10);
        let found = cpu_frame(&cpu(315, 0), CpuLoad { starts: &starts, interrupts: &[], vertices: 0 });
        assert_eq!(found.set_ups[..3], [(0, -215), (3, -230), (6, -245)]);
        assert_eq!(found.drawn, [0, 0, 0, 0, 0, 0, 3, 3, 3, 6]);
    }

    #[test]
    fn crossings_come_first() {
        let starts = starts(100, 8);
        let load = CpuLoad { starts: &starts, interrupts: &[90, 90, 90, 90, 0, 0, 0, 0], vertices: 0 };
        let found = cpu_frame(&cpu(30, 0), load);
        // Sweep 1 is set up in sweeps 0 to 2, 10 ticks each; then sweep 4, in 3 and 4.
        assert_eq!(found.set_ups[..4], [(0, 70), (1, -200), (4, -20), (5, 50)]);
        assert_eq!(found.drawn, [0, 0, 0, 1, 1, 5, 6, 7]);
    }
}
