//! The processor's frame: set-up of the sweeps, tables and polyhedra, and what crossings leave of its time (hardware 4.6).

use hardware_model::Cpu;

/// What the processor has to do in one frame, in master ticks from the frame's start.
#[derive(Debug, Clone, Copy)]
pub struct CpuLoad<'a> {
    /// Start of each sweep, and the end of the frame.
    pub starts: &'a [u64],
    /// What the crossings of each sweep take of it; empty if they take nothing.
    pub crossings: &'a [CrossingTime],
    /// Whether crossings wait until a set-up is done, having no level above it.
    pub unbroken: bool,
    /// Vertices of polyhedra to transform and project.
    pub vertices: u64,
}

/// What the crossings of one sweep take of the processor (ticks).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CrossingTime {
    /// Interrupts: recognition, save, restore, pointers.
    pub interrupts: u64,
    /// Words that its program moves, or memory cycles that others take from it for theirs.
    pub words: u64,
}

/// The processor's time, by what it was at (ticks).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CpuTime {
    /// Time for the interrupts of crossings.
    pub interrupts: u64,
    /// Time to move the words of crossings.
    pub words: u64,
    /// Time for the set-ups of sweeps.
    pub set_ups: u64,
    /// Visibility and tables of the next frame.
    pub tables: u64,
    /// Time for the vertices of polyhedra.
    pub vertices: u64,
}

impl CpuTime {
    /// All of it: never more than the frame.
    pub fn busy(&self) -> u64 {
        self.interrupts + self.words + self.set_ups + self.tables + self.vertices
    }
}

/// What came of it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CpuFrame {
    /// For each sweep, the sweep whose set-up it is drawn with: itself, or an earlier one if its own is not ready.
    pub drawn: Vec<u32>,
    /// Each set-up that was made, and the ticks from its end to its sweep; below 0 it is late.
    pub set_ups: Vec<(u32, i64)>,
    /// Each set-up that was begun, made or not, and the ticks from the frame's start to its beginning; below 0 it began in
    /// the frame before.
    pub begun: Vec<(u32, i64)>,
    /// Ticks from the end of tables and polyhedra to that of the frame; below 0, so much work was left.
    pub frame_slack: i64,
    /// Vertices that are ready when the frame ends: tables come first.
    pub vertices: u64,
    /// Its work within the frame.
    pub time: CpuTime,
}

/// A set-up in work; `None` for the first sweep of the frame that follows.
#[derive(Debug, Clone, Copy)]
struct SetUp {
    sweep: Option<u32>,
    rest: u64,
}

/// The processor, walked from one sweep's time to the next.
struct Processor<'a> {
    cpu: &'a Cpu,
    load: CpuLoad<'a>,
    in_work: Option<SetUp>,
    /// Work on tables and on vertices that is left.
    left: [u64; 2],
    frame_slack: i64,
    set_ups: Vec<(u32, i64)>,
    begun: Vec<(u32, i64)>,
    /// Ticks of set-up in the time of each sweep.
    held: Vec<u64>,
    time: CpuTime,
}

/// The processor's frame. During each sweep the next one is set up; a set-up that takes longer goes on, and then the
/// sweep after the present one is next. A sweep is drawn with the last set-up that is made when it begins. Crossings come
/// first in each sweep's time and set-ups next, or with one level the other way round; tables and polyhedra fill the rest.
/// With the last sweep begins the set-up of the next frame's first, whatever else is in work: no sweep could be drawn with
/// that any more. The frame's interrupt clears the tasks that the frame before left, so frames do not depend on one another
/// (our choices), and a set-up that runs over the end of a frame counts in both, part by part.
pub fn cpu_frame(cpu: &Cpu, load: CpuLoad<'_>) -> CpuFrame {
    let Processor { set_ups, begun, frame_slack, time, left, .. } = Processor::run(cpu, load);
    let not_ready = if cpu.vertex == 0 { 0 } else { left[1].div_ceil(cpu.vertex) };
    let vertices = load.vertices.saturating_sub(not_ready);
    CpuFrame { drawn: drawn_with(&set_ups, load.starts), set_ups, begun, frame_slack, vertices, time }
}

/// For each sweep, the ticks from its start in which a set-up runs that no interrupt breaks; `starts` as in [`CpuLoad`].
pub fn held_by_set_ups(cpu: &Cpu, starts: &[u64]) -> Vec<u64> {
    Processor::run(cpu, CpuLoad { starts, crossings: &[], unbroken: true, vertices: 0 }).held
}

/// For each sweep the last set-up that is made when it begins, be it an earlier sweep's; not the next one's, which is begun at
/// that instant and may take no time.
fn drawn_with(set_ups: &[(u32, i64)], starts: &[u64]) -> Vec<u32> {
    let mut made =
        set_ups.iter().map(|&(sweep, slack)| (sweep, starts[sweep as usize] as i64 - slack)).peekable();
    let mut last = 0;
    let last_made = |(sweep, &start): (u32, &u64)| {
        while let Some((made, _)) = made.next_if(|&(made, done)| made <= sweep && done <= start as i64) {
            last = made;
        }
        last
    };
    (0..).zip(&starts[..starts.len() - 1]).map(last_made).collect()
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

    /// Crossings of a sweep; those before the frame are as in its last sweep, whose place they are in.
    fn crossings_of(&self, sweep: i64) -> CrossingTime {
        let found = usize::try_from(sweep).map_or(self.crossings.last(), |sweep| self.crossings.get(sweep));
        found.copied().unwrap_or_default()
    }
}

/// One sweep's time as it is spent.
struct Span {
    now: i64,
    end: i64,
}

impl Span {
    /// Spends up to `work` ticks; how many.
    fn spend(&mut self, work: u64) -> u64 {
        let done = work.min((self.end - self.now) as u64);
        self.now += done as i64;
        done
    }
}

impl<'a> Processor<'a> {
    fn run(cpu: &'a Cpu, load: CpuLoad<'a>) -> Self {
        let left = [cpu.frame_tables, cpu.vertex * load.vertices];
        let all = left[0] + left[1];
        let frame_slack = if all == 0 { load.end() as i64 } else { -(all as i64) };
        let (in_work, set_ups, begun) = (None, Vec::new(), Vec::new());
        let (held, time) = (Vec::new(), CpuTime::default());
        let mut processor = Self { cpu, load, in_work, left, frame_slack, set_ups, begun, held, time };
        // The first sweep is set up before the frame begins.
        for sweep in -1..load.sweeps() as i64 {
            processor.pass(sweep);
        }
        processor
    }

    /// One sweep's time. What is done before the frame counts in the frame before.
    fn pass(&mut self, sweep: i64) {
        let [now, end] = self.load.time_of(sweep);
        let mut span = Span { now, end };
        let mut time = CpuTime::default();
        if self.load.unbroken {
            time.set_ups = self.set_up(sweep, &mut span);
            self.cross(sweep, &mut span, &mut time);
        } else {
            self.cross(sweep, &mut span, &mut time);
            time.set_ups = self.set_up(sweep, &mut span);
        }
        if sweep >= 0 {
            self.fill(&mut span, &mut time);
            self.held.push(time.set_ups);
            self.count(time);
        }
    }

    fn count(&mut self, more: CpuTime) {
        let sum = &mut self.time;
        sum.interrupts += more.interrupts;
        sum.words += more.words;
        sum.set_ups += more.set_ups;
        sum.tables += more.tables;
        sum.vertices += more.vertices;
    }

    /// Crossings of one sweep; retrace clears those for which no time is left.
    fn cross(&self, sweep: i64, span: &mut Span, time: &mut CpuTime) {
        let CrossingTime { interrupts, words } = self.load.crossings_of(sweep);
        time.interrupts = span.spend(interrupts);
        time.words = span.spend(words);
    }

    /// Set-ups in what is left of a sweep's time; the ticks that they took. One that no interrupt breaks begins with a
    /// sweep or not in it.
    fn set_up(&mut self, sweep: i64, span: &mut Span) -> u64 {
        let begin = span.now;
        let next = u32::try_from(sweep + 1).ok().filter(|&next| (next as usize) < self.load.sweeps());
        if next.is_none() {
            self.in_work = None;
        }
        let mut is_asked = true;
        while span.now < span.end {
            if self.in_work.is_none() && is_asked {
                self.in_work = Some(SetUp { sweep: next, rest: self.cpu.sweep_setup });
                self.begun.extend(next.map(|sweep| (sweep, span.now)));
            }
            let Some(mut work) = self.in_work.take() else { break };
            is_asked &= work.sweep != next && !self.load.unbroken;
            work.rest -= span.spend(work.rest);
            if work.rest > 0 {
                self.in_work = Some(work);
            } else if let Some(made) = work.sweep {
                let start = self.load.starts[made as usize] as i64;
                self.set_ups.push((made, start - span.now));
            }
        }
        (span.now - begin) as u64
    }

    /// Tables and polyhedra, in what is left of a sweep's time.
    fn fill(&mut self, span: &mut Span, time: &mut CpuTime) {
        time.tables = span.spend(self.left[0]);
        self.left[0] -= time.tables;
        time.vertices = span.spend(self.left[1]);
        self.left[1] -= time.vertices;
        if time.tables + time.vertices > 0 {
            let left = self.left[0] + self.left[1];
            self.frame_slack = if left == 0 { self.load.end() as i64 - span.now } else { -(left as i64) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{CpuFrame, CpuLoad, CrossingTime, cpu_frame, held_by_set_ups};
    use hardware_model::Cpu;

    fn starts(period: u64, sweeps: u64) -> Vec<u64> {
        (0..=sweeps).map(|sweep| sweep * period).collect()
    }

    /// `interrupts` by sweep; `unbroken` with one level.
    fn made(cpu: &Cpu, starts: &[u64], interrupts: &[u64], unbroken: bool, vertices: u64) -> CpuFrame {
        let crossing = |&interrupts| CrossingTime { interrupts, words: 0 };
        let crossings: Vec<CrossingTime> = interrupts.iter().map(crossing).collect();
        cpu_frame(cpu, CpuLoad { starts, crossings: &crossings, unbroken, vertices })
    }

    fn cpu(sweep_setup: u64, frame_tables: u64) -> Cpu {
        Cpu { sweep_setup, frame_tables, ..Cpu::default() }
    }

    #[test]
    fn quick_set_ups_are_ready_and_tables_fill_the_rest() {
        let starts = starts(100, 10);
        let found = made(&cpu(30, 140), &starts, &[], false, 0);
        assert_eq!(found.drawn, (0..10).collect::<Vec<u32>>());
        assert!(found.set_ups.iter().all(|&(_, slack)| slack == 70) && found.set_ups.len() == 10);
        // 70 ticks of each sweep are left: two sweeps.
        assert_eq!((found.frame_slack, found.time.busy()), (800, 440));
        // Each is begun as the sweep before it begins, the first before the frame.
        assert_eq!(
            found.begun,
            (0..10).map(|sweep| (sweep, 100 * i64::from(sweep) - 100)).collect::<Vec<_>>()
        );
    }

    /// The next sweep's is made as a sweep begins, and is not its own.
    #[test]
    fn set_ups_that_take_no_time_are_each_sweeps_own() {
        let found = made(&Cpu { vertex: 40, ..cpu(0, 140) }, &starts(100, 10), &[], false, 50);
        assert_eq!(found.drawn, (0..10).collect::<Vec<u32>>());
    }

    #[test]
    fn vertices_that_are_left_are_not_ready() {
        let starts = starts(100, 10);
        let found = made(&Cpu { vertex: 40, ..cpu(30, 140) }, &starts, &[], false, 50);
        // 70 ticks of each of ten sweeps are left for 140 + 2000 ticks of work.
        assert_eq!((found.frame_slack, found.vertices), (-(2140 - 700), 14));
        assert_eq!((found.time.tables, found.time.vertices, found.time.busy()), (140, 560, 1000));
    }

    #[test]
    fn slow_set_ups_repeat_sweeps() {
        // 3.15 sweeps each: made at 215, 530, 845, for the sweeps after 0, 215 and 530.
        let starts = starts(100, 10);
        let found = made(&cpu(315, 0), &starts, &[], false, 0);
        assert_eq!(found.set_ups[..3], [(0, -215), (3, -230), (6, -245)]);
        assert_eq!(found.drawn, [0, 0, 0, 0, 0, 0, 3, 3, 3, 6]);
        // It is at set-ups all the time, with the last sweep at that of the next frame's first.
        assert_eq!((found.time.busy(), found.set_ups.len()), (1000, 3));
    }

    #[test]
    fn crossings_come_first() {
        let starts = starts(100, 8);
        let found = made(&cpu(30, 0), &starts, &[90, 90, 90, 90, 0, 0, 0, 0], false, 0);
        // Sweep 1 is set up in sweeps 0 to 2, 10 ticks each; then sweep 4, in 3 and 4.
        assert_eq!(found.set_ups[..4], [(0, 70), (1, -200), (4, -20), (5, 50)]);
        assert_eq!(found.begun[..4], [(0, -100), (1, 90), (4, 390), (5, 420)]);
        assert_eq!(found.drawn, [0, 0, 0, 1, 1, 5, 6, 7]);
    }

    #[test]
    fn with_one_level_set_ups_come_first() {
        let starts = starts(100, 8);
        let found = made(&cpu(30, 0), &starts, &[90; 8], true, 0);
        assert!(found.set_ups.iter().all(|&(_, slack)| slack == 70), "{found:?}");
        assert_eq!(found.drawn, (0..8).collect::<Vec<u32>>());
        // Of each sweep crossings get what the set-up leaves.
        assert_eq!((found.time.set_ups, found.time.interrupts), (240, 560));
        assert_eq!(held_by_set_ups(&cpu(30, 0), &starts), [30; 8]);
        // Each runs over into the next sweep, and none begins in that.
        assert_eq!(held_by_set_ups(&cpu(130, 0), &starts), [30, 100, 30, 100, 30, 100, 30, 100]);
    }
}
