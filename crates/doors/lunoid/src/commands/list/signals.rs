//! `lunoid signals`: what can be probed.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use signal::{Signal, Wire};
use waveform::wire_record;

use command_line::loading::{StageArgs, StageOptions, Threads};
use command_line::output::{print, print_json};
use command_line::{Failure, Verdict};
use text::table;

const AFTER: &str = "Examples:
  lunoid signals 'tg.*'
  lunoid signals scenarios/first-light.toml --machine pra-nominal 'tg.*,dpp.*'

Without a scenario, all signals that a machine can have, and those of `lunoid augment` (vs.*).
With one (a file, or a name that ends in .toml), the wires of the machine that it is elaborated
to, with the value and the voltage at full scale, and what is not there because its block is
left out. Wires of one kind share a line; --json lists each.";

/// List the signals that can be probed.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Signals {
    /// Scenario file, then names, with * for any run of characters; all if left out.
    #[arg(value_name = "SCENARIO] [NAMES", value_delimiter = ',')]
    words: Vec<String>,
    /// Hardware model by name or path; the scenario's own if left out.
    #[arg(short, long, value_name = "MODEL")]
    machine: Option<String>,
    /// Leave nothing out of the machine.
    #[arg(long)]
    everything: bool,
    #[command(flatten)]
    threads: Threads,
    /// Print the list as JSON.
    #[arg(long)]
    json: bool,
}

impl Signals {
    /// Lists the signals that match the given names.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let (scenario, patterns) = self.scenario();
        let listing = match scenario {
            None if self.machine.is_some() || self.everything => {
                return Err(Failure::usage(
                    "--machine, --everything: a machine is elaborated for a scenario; name its file first",
                ));
            }
            None => SignalListing::of_table(),
            Some(path) => self.of_scenario(path)?,
        };
        listing.matching(&patterns)?.show(self.json)?;
        Ok(Verdict::Yes)
    }

    /// The first word is a scenario if it is a file or is called like one.
    fn scenario(&self) -> (Option<PathBuf>, Vec<String>) {
        let is_scenario = |word: &&String| word.ends_with(".toml") || Path::new(word).is_file();
        let scenario = self.words.first().filter(is_scenario).map(PathBuf::from);
        let patterns: Vec<String> =
            self.words.iter().skip(usize::from(scenario.is_some())).cloned().collect();
        (scenario, if patterns.is_empty() { vec!["*".into()] } else { patterns })
    }

    fn of_scenario(&self, scenario: PathBuf) -> Result<SignalListing, Failure> {
        let (machine, everything) = (self.machine.clone(), self.everything);
        let options = StageOptions { everything, ..StageOptions::default() };
        let stage = StageArgs { scenario, machine, options };
        let opened = stage.load()?;
        let pool = self.threads.pool()?;
        let built = pool.install(|| opened.stage())?;
        let wires = opened.generator.prepare(built).map_err(Failure::input)?.wires();
        if wires.is_empty() {
            let name = opened.generator.name();
            return Err(Failure::usage(format!("machine {name} has no signals; expected a hardware model")));
        }
        let there: HashSet<&str> = wires.iter().map(|wire| wire.signal.name).collect();
        let absent = opened
            .generator
            .signals()
            .iter()
            .filter(|signal| !there.contains(signal.name))
            .copied()
            .collect();
        let of_lines = opened.generator.line_signals().iter().copied().map(Wire::of_video);
        let rows = wires
            .into_iter()
            .chain(of_lines)
            .map(|wire| Row { signal: wire.signal, wire: Some(wire) })
            .collect();
        let of = Some((stage.scenario.display().to_string(), opened.drawn_by().to_owned()));
        Ok(SignalListing { rows, absent, of })
    }
}

/// Signals, and the machine whose they are.
pub struct SignalListing {
    rows: Vec<Row>,
    /// Signals that the machine does not have: their blocks are left out.
    absent: Vec<Signal>,
    /// Names of the scenario and the machine; `None` for the table of all signals.
    of: Option<(String, String)>,
}

/// A signal, with its wire in an elaborated machine.
struct Row {
    signal: Signal,
    wire: Option<Wire>,
}

impl SignalListing {
    /// All signals that a machine can have, and those of the vehicle's shadow in existing pictures.
    pub fn of_table() -> Self {
        let signals = machine::signals().iter().chain(machine::LINE_SIGNALS).chain(&vehicle_shadow::SIGNALS);
        let rows = signals.map(|signal| Row { signal: *signal, wire: None });
        Self { rows: rows.collect(), absent: Vec::new(), of: None }
    }

    /// Those that match a pattern; every pattern must match one.
    fn matching(mut self, patterns: &[String]) -> Result<Self, Failure> {
        let is_known = |pattern: &&String| {
            self.rows.iter().map(|row| &row.signal).chain(&self.absent).any(|signal| signal.matches(pattern))
        };
        if let Some(pattern) = patterns.iter().find(|pattern| !is_known(pattern)) {
            return Err(Failure::usage(format!(
                "{pattern}: no signal of this name; `lunoid signals` lists them"
            )));
        }
        let is_wanted = |signal: &Signal| patterns.iter().any(|pattern| signal.matches(pattern));
        self.rows.retain(|row| is_wanted(&row.signal));
        self.absent.retain(is_wanted);
        Ok(self)
    }

    /// Prints a table or a document.
    pub fn show(&self, json: bool) -> Result<(), Failure> {
        if json {
            let rows: Vec<Value> = self.rows.iter().map(Row::record).collect();
            let mut document = json!({ "schema": "lunoid.signals/1", "signals": rows });
            if let Some((scenario, machine)) = &self.of {
                document["scenario"] = scenario.as_str().into();
                document["machine"] = machine.as_str().into();
                document["left_out"] = self.absent.iter().map(|signal| signal.name).collect();
            }
            return print_json(&document);
        }
        print(&self.text())
    }

    /// The rows block by block, in the order in which blocks first come.
    fn by_block(&self) -> Vec<Vec<&Row>> {
        let mut blocks: Vec<Vec<&Row>> = Vec::new();
        for row in &self.rows {
            match blocks.iter_mut().find(|rows| rows[0].signal.block() == row.signal.block()) {
                Some(rows) => rows.push(row),
                None => blocks.push(vec![row]),
            }
        }
        blocks
    }

    /// A table for each block, in the order of the drawing; wires of a kind share a line.
    fn text(&self) -> String {
        let scale: &[&str] = if self.of.is_some() { &["full scale", "volts", "0 V at"] } else { &[] };
        let heading = [&["name", "wires", "unit"], scale, &["kind", "axis", "figure", "meaning"]].concat();
        let mut lines: Vec<Vec<String>> = vec![heading.into_iter().map(str::to_owned).collect()];
        for rows in self.by_block() {
            lines.extend([vec![], vec![format!("{}:", rows[0].signal.block())]]);
            lines.extend(rows.chunk_by(|a, b| a.is_like(b)).map(cells));
        }
        let mut text = table(&lines);
        if !self.absent.is_empty() {
            text += &format!(
                "\nnot there, because the block is left out: {}\n",
                families(&self.absent).join(", ")
            );
        }
        text
    }
}

/// One line for wires of a kind.
fn cells(alike: &[&Row]) -> Vec<String> {
    let Signal { unit, kind, axis, meaning, figure, .. } = alike[0].signal;
    let [first, last] = [alike[0], alike[alike.len() - 1]].map(|row| row.signal.name);
    let name = if alike.len() == 1 { first.to_owned() } else { format!("{first} … {last}") };
    let mut cells = vec![name, alike.len().to_string(), unit.to_string()];
    let of = |value: fn(&Wire) -> f64| {
        let mut values: Vec<String> =
            alike.iter().filter_map(|row| row.wire.as_ref()).map(|wire| short(value(wire))).collect();
        values.dedup();
        match values.as_slice() {
            [value] => value.clone(),
            _ => "each its own".to_owned(),
        }
    };
    if alike[0].wire.is_some() {
        cells.extend([of(|wire| wire.full_scale), of(|wire| wire.volts), of(|wire| wire.datum)]);
    }
    cells.extend([kind.name(), axis.name(), figure, meaning].map(str::to_owned));
    cells
}

/// Signals by what stands before their last dot, each with how many they are.
fn families(signals: &[Signal]) -> Vec<String> {
    let stem = |signal: &Signal| signal.name.rsplit_once('.').map_or(signal.name, |(stem, _)| stem);
    let named = |alike: &[Signal]| match alike {
        [only] => only.name.to_owned(),
        _ => format!("{}.* ({})", stem(&alike[0]), alike.len()),
    };
    signals.chunk_by(|a, b| stem(a) == stem(b)).map(named).collect()
}

impl Row {
    /// Whether two wires are of one kind: they differ in their names alone.
    fn is_like(&self, other: &Self) -> bool {
        let [own, others] = [self.signal, other.signal].map(|signal| Signal { name: "", ..signal });
        own == others && self.signal.block() == other.signal.block()
    }

    /// The wire as all files tell it; of a signal alone, without scales.
    fn record(&self) -> Value {
        let Self { signal, wire } = self;
        let nothing = Wire { signal: *signal, full_scale: 0.0, volts: 0.0, datum: 0.0 };
        let mut record = wire_record(wire.as_ref().unwrap_or(&nothing));
        if let (None, Some(record)) = (wire, record.as_object_mut()) {
            ["full_scale", "volts", "datum"].iter().for_each(|key| drop(record.remove(*key)));
        }
        record
    }
}

/// A number in a table, to six digits.
fn short(value: f64) -> String {
    let text = format!("{value}");
    if text.len() <= 9 { text } else { format!("{value:.3}") }
}
