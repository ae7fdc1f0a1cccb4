//! `lunoid timing show`: a timing record as text, JSON or plots.

use std::ops::Range;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use deadlines::{
    Deadlines, Other, OverloadMap, Rehearsal, Rehearsed, TimelineOf, lines_of, routines_text, spread,
    write_slack, write_timeline, write_utilisation,
};
use front_door::Opened;
use generator::PlaneKind;
use picture::write_png;
use timing::TimingRecord;

use crate::rehearsing::{choose, expect_coarse, record, rehearse_timed};
use command_line::loading::{StageArgs, Threads, of_timed};
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::values::pair;
use command_line::{Failure, Verdict, values};
use text::Span;

/// Frames that are shown where none are named, spread over the mission.
const USUAL_FRAMES: u64 = 8;

const AFTER: &str = "Examples:
  lunoid timing show scenarios/first-light.toml --machine pra-nominal --frames 0..4
  lunoid timing show scenarios/first-light.toml --machine pra-nominal --frame 12 \\
    --sweep 500 --out timeline.png
  lunoid timing show scenarios/first-light.toml --machine pra-nominal --utilisation use.png \\
    --slack slack.png";

/// Show deadlines, use of units, misses and the critical path.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_timed))]
pub struct Show {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frames to show, counted at the update rate: A..B without B. Eight, spread over the mission, if left out.
    #[arg(long, value_name = "A..B", conflicts_with = "frame")]
    frames: Option<Span>,
    /// Show one frame, and its critical path. Without it the path is that of the frame with the least slack.
    #[arg(long, value_parser = values::at_least(0_u64))]
    frame: Option<u64>,
    /// Sweep of the timeline, from 0 at the left.
    #[arg(long, requires = "frame", requires = "out", value_parser = values::at_least(0_u32))]
    sweep: Option<u32>,
    /// Draw the timeline of the sweep: ramps, stops, sets asked for, on their way, ready, late.
    #[arg(short, long, value_name = "PNG|SVG", requires = "sweep")]
    out: Option<PathBuf>,
    /// Level of terrain of the timeline.
    #[arg(long, value_enum, default_value = "fine", requires = "sweep")]
    level: LevelWord,
    /// Ground ranges between which the timeline is drawn (m).
    #[arg(long, value_name = "NEAR,FAR", value_parser = pair_of_ranges, requires = "sweep")]
    range_m: Option<[f64; 2]>,
    /// Draw the use of every unit over the frames.
    #[arg(long, value_name = "PNG|SVG")]
    utilisation: Option<PathBuf>,
    /// Draw histograms of slack.
    #[arg(long, value_name = "PNG|SVG")]
    slack: Option<PathBuf>,
    /// List every miss of these sweeps as well: columns of the picture, from 0 at the left. Of a generator without sweeps, of these
    /// lines of its signals.
    #[arg(long, value_name = "S[..T]")]
    misses: Option<Span>,
    /// Draw what a frame lost to limits of memory and time over its dimmed picture, and count the pixels.
    #[arg(long, value_name = "PNG", requires = "frame")]
    overload: Option<PathBuf>,
    /// Do not show any progress.
    #[arg(long)]
    no_progress: bool,
    /// Print record, totals and critical path as JSON.
    #[arg(long)]
    json: bool,
}

/// Level of terrain whose timeline is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum LevelWord {
    /// The finest level of terrain.
    Fine,
    /// That of far mountains.
    Coarse,
}

/// Two ranges, the nearer first.
fn pair_of_ranges(text: &str) -> Result<[f64; 2], String> {
    let [near, far] = pair(text)?;
    match 0.0 <= near && near < far {
        true => Ok([near, far]),
        false => Err("expected two ranges in metres, the nearer first, as 0,500".into()),
    }
}

impl Show {
    /// Prints the timing of the frames and draws the plots asked for.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let plots = [("--out", &self.out), ("--utilisation", &self.utilisation), ("--slack", &self.slack)];
        let mut places: Vec<Place> = Place::pictures(plots);
        let maps = Place::given([("--overload", &self.overload)]);
        places.extend(maps.into_iter().map(|map| map.ending_in(&["png"])));
        expect_outputs(&places, &self.stage.sources())?;
        let (rehearsal, frames) = rehearse_timed(&self.stage, &self.threads, |opened| self.choose(opened))?;
        if let Rehearsed::Machine(rehearsal) = &rehearsal {
            self.draw_timeline(rehearsal)?;
        }
        let record = record(!self.no_progress, |hear| rehearsal.record(&frames, hear))?;
        if let Some(path) = &self.utilisation {
            write_utilisation(&record, path)?;
        }
        if let Some(path) = &self.slack {
            write_slack(&record, path)?;
        }
        match &rehearsal {
            Rehearsed::Machine(rehearsal) => self.tell(rehearsal, &record)?,
            Rehearsed::Other(other) => self.tell_other(other, &record)?,
        }
        Ok(Verdict::Yes)
    }

    /// Refuses what whoever draws does not have.
    fn expect_had(&self, opened: &Opened) -> Result<(), Failure> {
        let (name, generator) = (opened.drawn_by(), &opened.generator);
        let is_machine = opened.is_machine();
        let has_deadlines = is_machine || generator.has_deadlines();
        let has_map = generator.planes().contains(&PlaneKind::Overload);
        let asked = [
            (self.sweep.is_some(), is_machine, "--sweep", "sweeps", "a hardware model"),
            (self.misses.is_some(), has_deadlines, "--misses", "deadlines", "a hardware model"),
            (self.slack.is_some(), has_deadlines, "--slack", "deadlines", "a hardware model"),
            (self.overload.is_some(), has_map, "--overload", "overload map", "a generator that has one"),
        ];
        match asked.iter().find(|(is_given, is_there, ..)| *is_given && !is_there) {
            Some((_, _, option, lack, who)) => Err(Failure::usage(format!(
                "{option}: {name} has no {lack}; leave it out, or give --machine {who}"
            ))),
            None => Ok(()),
        }
    }

    /// A generator that is no hybrid machine has no critical path.
    fn tell_other(&self, other: &Other, record: &TimingRecord) -> Result<(), Failure> {
        let map = self.overload_map(other)?;
        if self.json {
            return print_json(&Deadlines::json_without(record, &other.routines(record)));
        }
        let lines = self.missed_lines(lines_of(other.opened()))?;
        let misses = lines.map(|lines| other.misses_text(record, &lines)).unwrap_or_default();
        let routines = routines_text(&other.routines(record));
        print(&(record.text() + &routines + &other.times_text(record) + &misses + &map))
    }

    /// Writes the overload map, and counts it in words.
    fn overload_map(&self, other: &Other) -> Result<String, Failure> {
        let (Some(path), Some(frame)) = (&self.overload, self.frame) else { return Ok(String::new()) };
        let map = OverloadMap::of(other, frame)?;
        write_png(path, &map.picture, &[])?;
        Ok(map.text())
    }

    /// Everything that can be wrong on the command line is found before any ground is made.
    fn choose(&self, opened: &Opened) -> Result<Vec<u64>, Failure> {
        self.expect_had(opened)?;
        let sweeps = opened.settings.raster.sweeps;
        self.missed_lines(lines_of(opened))?;
        if let Some(sweep) = self.sweep.filter(|&sweep| sweep >= sweeps) {
            return Err(Failure::usage(format!(
                "--sweep {sweep}: a frame has sweeps 0..{sweeps}; expected one of them"
            )));
        }
        if self.level == LevelWord::Coarse {
            expect_coarse("--level coarse", &opened.settings)?;
        }
        match self.frame {
            None => choose(opened, self.frames, spread(USUAL_FRAMES)),
            Some(frame) if frame < opened.frames() => Ok(vec![frame]),
            Some(frame) => Err(Failure::usage(format!(
                "--frame {frame}: the scenario has frames 0..{}; expected one of them",
                opened.frames()
            ))),
        }
    }

    fn draw_timeline(&self, rehearsal: &Rehearsal) -> Result<(), Failure> {
        let (Some(path), Some(frame), Some(sweep)) = (&self.out, self.frame, self.sweep) else {
            return Ok(());
        };
        let is_coarse = self.level == LevelWord::Coarse;
        Ok(write_timeline(rehearsal, TimelineOf { frame, sweep, is_coarse, range: self.range_m }, path)?)
    }

    fn tell(&self, rehearsal: &Rehearsal, record: &TimingRecord) -> Result<(), Failure> {
        let deadlines = Deadlines::of(rehearsal, record)?;
        if self.json {
            return print_json(&deadlines.json());
        }
        let sweeps = self.missed_lines((rehearsal.stage.settings.raster.sweeps, "sweep"))?;
        print(&deadlines.text(sweeps.as_ref()))
    }

    /// The sweeps, or other lines, whose misses are listed; a frame has so many of the name told.
    fn missed_lines(&self, (all, line): (u32, &str)) -> Result<Option<Range<u64>>, Failure> {
        let Some(span) = self.misses else { return Ok(None) };
        span.within(&(0..u64::from(all))).map(Some).ok_or_else(|| {
            Failure::usage(format!("--misses {span}: a frame has {line}s 0..{all}; expected a range inside"))
        })
    }
}
