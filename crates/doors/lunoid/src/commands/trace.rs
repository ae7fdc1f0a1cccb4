//! `lunoid trace`: the digital side of a frame as a listing, and its registers at an instant.

use std::ops::Range;

use clap::Args;
use clap::builder::PossibleValuesParser;
use deadlines::Rehearsal;
use event_list::{At, DigitalFrame, Filter, Form, LEVELS, Order, Registers, list, unit};
use machine::EventWord;
use sweep_program::Colour;
use text::Span;

use crate::frame::FrameArgs;
use command_line::loading::of_models;
use command_line::output::{print, print_json, tell};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid trace scenarios/first-light.toml --frame 60 --sweep 500
  lunoid trace scenarios/nominal-drive.toml --frame 45 --event late,cancelled --csv
  lunoid trace scenarios/nominal-drive.toml --frame 45 --unit loader.red --from 30056000 \\
    --limit 40
  lunoid trace scenarios/first-light.toml --frame 60 --at 500:412
  lunoid trace runs/first-light --frame 60 --sweep 500

A run folder stands for the scenario and the options with which it was drawn. Ticks are those of
the master clock since the start of the mission.";

/// List the digital events of a frame in the order of their ticks, or show all registers at one of them.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct Trace {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Sweeps, from 0 at the left: S or S..T without T.
    #[arg(long, value_name = "S[..T]")]
    sweep: Option<Span>,
    #[command(flatten)]
    filter: FilterArgs,
    /// List no more than so many events, and those of the same tick as the last.
    #[arg(long, value_name = "N", value_parser = values::at_least(1_u64))]
    limit: Option<u64>,
    /// Show the registers of all colours at a tick, or at a sample of a sweep, and list nothing.
    #[arg(long, value_name = "TICK|S:SAMPLE",
          conflicts_with_all = ["sweep", "unit", "event", "colour", "level", "from", "to", "limit", "csv"])]
    at: Option<At>,
    /// Print the result as JSON.
    #[arg(long)]
    json: bool,
    /// Print as CSV, a row an event.
    #[arg(long, conflicts_with = "json")]
    csv: bool,
}

impl Trace {
    /// Lists the events, or shows the registers with `--at`.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let mut sweeps = 0..0;
        let number = self.chosen.frame;
        let filter = self.filter.filter()?;
        let opened = self.chosen.load(&self.chosen.stage()?)?;
        let rehearsal = self.chosen.rehearse(opened, |opened| {
            sweeps = self.sweeps(opened.settings.raster.sweeps)?;
            Ok(filter.expect_there(&opened.settings)?)
        })?;
        let pose = rehearsal.poses(&[number])?[0].pose;
        let gates = self.at.is_none() && filter.needs_gates();
        let Rehearsal { control, stage, pool, .. } = &rehearsal;
        let frame = pool.install(|| DigitalFrame::new(control, stage, (number, &pose), gates))?;
        match self.at {
            Some(at) => self.show(&Registers::new(&frame, at)?)?,
            None => {
                let order = Order {
                    sweeps,
                    is_whole: self.sweep.is_none(),
                    filter: &filter,
                    form: self.form(),
                    limit: self.limit,
                };
                let note = pool.install(|| list(&frame, &order, print))?;
                note.iter().for_each(|note| tell(&format!("{note}\n")));
            }
        }
        Ok(Verdict::Yes)
    }

    fn show(&self, registers: &Registers<'_>) -> Result<(), Failure> {
        if self.json { print_json(&registers.json()) } else { print(&registers.text()) }
    }

    fn sweeps(&self, count: u32) -> Result<Range<u32>, Failure> {
        let all = 0..u64::from(count);
        let Some(span) = self.sweep else { return Ok(0..count) };
        let found = span.within(&all).ok_or_else(|| {
            Failure::usage(format!("--sweep {span}: a frame has sweeps 0..{count}; expected a range inside"))
        })?;
        Ok(found.start as u32..found.end as u32)
    }

    fn form(&self) -> Form {
        match (self.json, self.csv) {
            (true, _) => Form::Json,
            (_, true) => Form::Csv,
            _ => Form::Text,
        }
    }
}

/// What an event must be to be listed.
#[derive(Debug, Args)]
struct FilterArgs {
    /// Units, separated by commas: dpu, loader (all colours) or loader.COLOUR, io-processor, cpu, registers, drum or
    /// drum.LEVEL or drum.LEVEL.NUMBER, feature-generator, shadow-controller.
    #[arg(long, value_name = "UNITS", value_delimiter = ',', value_parser = unit)]
    unit: Vec<String>,
    /// Events, separated by commas.
    #[arg(long, value_name = "EVENTS", value_delimiter = ',',
          value_parser = PossibleValuesParser::new(EventWord::ALL.iter().map(|word| word.name())))]
    event: Vec<String>,
    /// Colours, separated by commas.
    #[arg(long, value_name = "COLOURS", value_delimiter = ',',
          value_parser = PossibleValuesParser::new(Colour::ALL.map(Colour::name)))]
    colour: Vec<String>,
    /// Level of terrain of the events.
    #[arg(long, value_name = "LEVEL", value_parser = PossibleValuesParser::new(LEVELS))]
    level: Option<String>,
    /// First tick that is listed.
    #[arg(long, value_name = "TICK", value_parser = values::at_least(0_u64))]
    from: Option<u64>,
    /// The tick that ends the listing; it is not listed.
    #[arg(long, value_name = "TICK", value_parser = values::at_least(0_u64))]
    to: Option<u64>,
}

impl FilterArgs {
    fn filter(&self) -> Result<Filter, Failure> {
        let Self { unit, event, colour, level, from, to } = self;
        if let (Some(from), Some(to)) = (from, to)
            && to <= from
        {
            return Err(Failure::usage(format!(
                "--from {from} --to {to}: expected an end behind the first tick"
            )));
        }
        Ok(Filter {
            unit: unit.clone(),
            event: event.clone(),
            colour: colour.clone(),
            level: level.clone(),
            from: *from,
            to: *to,
        })
    }
}
