//! Signals along the lines that the read beam scans.

use std::ops::Range;
use std::time::Instant;

use generator::Session;
use rayon::ThreadPool;
use scenario::Pose;
use scope::{Choice, Looking, ScopeError, trace};
use signal::{Signal, Waveform, Wire};
use text::Span;

use super::{ProbeCommand, Target, say};
use command_line::output::expect_outputs;
use command_line::{Failure, Verdict};

/// Whoever looks at lines of the read beam in one frame.
struct LineLook<'a> {
    session: &'a dyn Session,
    pool: &'a ThreadPool,
    frame: u64,
    pose: &'a Pose,
}

impl Looking for LineLook<'_> {
    fn at(&self, _: Vec<String>, lines: Range<u32>) -> Result<Vec<Waveform>, ScopeError> {
        Ok(self.pool.install(|| self.session.lines(self.frame, self.pose, lines))?)
    }
}

impl ProbeCommand {
    /// Records what the read beam makes of `lines` and writes the file.
    pub fn run_lines(&self, target: Target, lines: Span) -> Result<Verdict, Failure> {
        let Target::Waveforms(format) = target else {
            return Err(Failure::usage(format!(
                "--line {lines}: lines of the read-out go into a file of waveforms, and {} is a picture; expected a name that ends in .csv, \
                 .vcd or another of the formats",
                self.out.display()
            )));
        };
        let stage = self.chosen.stage()?;
        expect_outputs(&target.places("--out", &self.out), &stage.sources())?;
        let opened = self.chosen.load(&stage)?;
        let generator = &opened.generator;
        let Some(scan) = generator.line_scan() else {
            let name = generator.name();
            return Err(Failure::usage(format!(
                "--line {lines}: {name} has no read beam; expected a hardware model"
            )));
        };
        let wires = self.line_wires(generator.line_signals(), lines)?;
        let all = scan.timebase.sweeps;
        let chosen = lines.within(&(0..u64::from(all))).ok_or_else(|| {
            Failure::usage(format!(
                "--line {lines}: the read beam scans lines 0..{all} in a frame; expected a range inside"
            ))
        })?;
        let chosen = chosen.start as u32..chosen.end as u32;
        self.chosen.expect_in(&opened)?;
        let pool = self.chosen.threads.pool()?;
        let stage = pool.install(|| opened.stage())?;
        let pose = self.pose(&opened, &stage)?;
        let session = generator.prepare(stage).map_err(Failure::input)?;
        let look = LineLook { session: &*session, pool: &pool, frame: self.chosen.frame, pose: &pose };
        let choice = Choice { wires, left_out: Vec::new() };
        let header = self.header(&opened, &choice, (scan, chosen.clone()));
        let (out, mut last) = (self.out.display(), Instant::now());
        let written = trace(&look, header, &self.order(format), &mut |heard| say(&out, &mut last, heard))?;
        self.tell(target, &choice, chosen, &written)?;
        Ok(Verdict::Yes)
    }

    /// The wires that the patterns choose; each pattern has to choose one.
    fn line_wires(&self, table: &[Signal], lines: Span) -> Result<Vec<Wire>, Failure> {
        let none = self.signals.iter().find(|pattern| !table.iter().any(|signal| signal.matches(pattern)));
        if let Some(pattern) = none {
            let names: Vec<&str> = table.iter().map(|signal| signal.name).collect();
            return Err(Failure::usage(format!(
                "--signals {pattern}: with --line {lines} expected {}; give --sweep for signals of the sweeps",
                names.join(", ")
            )));
        }
        let is_chosen = |signal: &&Signal| self.signals.iter().any(|pattern| signal.matches(pattern));
        Ok(table.iter().filter(is_chosen).copied().map(Wire::of_video).collect())
    }

    /// Signals of the read beam need lines.
    pub fn expect_sweeps(&self, of_lines: &[Signal]) -> Result<(), Failure> {
        let is_of_line = |pattern: &&String| of_lines.iter().any(|signal| signal.name == **pattern);
        match self.signals.iter().find(is_of_line) {
            None => Ok(()),
            Some(name) => Err(Failure::usage(format!(
                "--signals {name}: it runs along the lines that the read beam scans; expected --line L[..M] instead of --sweep"
            ))),
        }
    }
}
