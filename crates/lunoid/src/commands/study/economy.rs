//! `lunoid study economy`: what is left out, what that saves, what remains.

use std::path::Path;

use clap::Args;
use plots::{Bars, TraceLook, bar_picture};
use serde_json::{Value, json};
use study::Subject;
use study::economy::{EconomyOutcome, economy};

use super::error::{failure, frames, quarter};
use super::outputs::{Outputs, is_of, markdown, write};
use crate::cli::COMMIT;
use crate::loading::{StageArgs, Threads, expect_machine, machine_stage, of_models};
use crate::{Failure, Verdict, values};
use text::{named_frames, rate as two_digits, table as columns};

/// Repetitions that are timed.
const REPETITIONS: u32 = 5;
const QUICK_REPETITIONS: u32 = 3;

const AFTER: &str = "Examples:
  lunoid study economy scenarios/first-light.toml --quick
  lunoid study economy scenarios/showpiece.toml --frame 0 --frame 150 --out studies/economy

--out gets economy.json, economy.csv, economy.md, a plot, and shadows/, where boundaries are kept for the next
study. The exit status is 1 if a machine that claims to draw the same bits does not. docs/economy.md says how to read it.";

/// What the scenario does not need: left out, saved, and still wasted.
#[derive(Debug, Args)]
#[command(after_help = AFTER, mut_args(of_models))]
pub struct EconomyStudy {
    #[command(flatten)]
    stage: StageArgs,
    #[command(flatten)]
    threads: Threads,
    /// Frame to look at; up to three times. The middle of the mission if left out.
    #[arg(long, value_name = "F", value_parser = values::at_least(0_u64))]
    frame: Vec<u64>,
    /// Repetitions of each frame that are timed.
    #[arg(long, value_name = "N", value_parser = values::whole(1..=1000_u32))]
    repetitions: Option<u32>,
    /// A quarter of the sweeps, columns and lines.
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    outputs: Outputs,
}

/// What came of it.
struct Outcome {
    title: String,
    frames: Vec<u64>,
    threads: usize,
    found: EconomyOutcome,
}

impl EconomyStudy {
    /// Studies.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let options = &self.stage.options;
        if options.lossless || options.everything {
            let advice = "the study draws with both and without; leave them out";
            return Err(Failure::usage(format!("--lossless, --everything: {advice}")));
        }
        self.outputs.expect_apart(|file| is_of("economy", file), &self.stage.sources())?;
        let mut opened = self.stage.load()?;
        expect_machine(&opened, "it leaves nothing out")?;
        if self.quick {
            quarter(&mut opened)?;
        }
        let frames = frames(&self.frame, opened.frames())?;
        let pool = self.threads.pool()?;
        self.outputs.keep_shadows(&mut opened)?;
        let stage = machine_stage(&opened, &pool)?;
        let subject = Subject::new(opened.scenario, opened.model, stage, &frames).map_err(Failure::input)?;
        let usual = if self.quick { QUICK_REPETITIONS } else { REPETITIONS };
        let repetitions = self.repetitions.unwrap_or(usual);
        let mut hear = |what: &str| self.outputs.say(what);
        let found = pool.install(|| economy(&subject, repetitions, &mut hear)).map_err(failure)?;
        let threads = pool.current_num_threads();
        let outcome = Outcome { title: subject.scenario.title.clone(), frames, threads, found };
        if let Some(folder) = &self.outputs.out {
            write(folder, "economy", &outcome.json(), &outcome.csv(), &outcome.page())?;
            outcome.plot(folder)?;
        }
        self.outputs.print(&outcome.json(), &outcome.text())?;
        Ok(if outcome.found.holds() { Verdict::Yes } else { Verdict::No })
    }
}

fn percent(some: u64, all: u64) -> String {
    format!("{:.1} %", 100.0 * some as f64 / all.max(1) as f64)
}

impl Outcome {
    fn json(&self) -> Value {
        json!({
            "schema": "lunoid.study-economy/1",
            "commit": COMMIT,
            "title": self.title,
            "frames": self.frames,
            "threads": self.threads,
            "bits_are_equal": self.found.holds(),
            "economy": self.found,
        })
    }

    fn facts(&self) -> String {
        format!("{}, {}, {} threads, commit {COMMIT}", self.title, named_frames(&self.frames), self.threads)
    }

    /// Titles and tables, each with the names of its columns first.
    fn tables(&self) -> [(&'static str, Vec<Vec<String>>); 3] {
        [
            ("Time and bits", self.modes()),
            ("What is left out", self.left_out()),
            ("What is computed and touches no pixel", self.waste()),
        ]
    }

    fn modes(&self) -> Vec<Vec<String>> {
        let base = self.found.modes[1].cpu_s;
        let lossless = &self.found.modes[1].blake3;
        let head =
            ["machine", "ms a frame", "least", "most", "processor, ms", "against lossless", "bits", "pixels"];
        let row = |mode: &study::economy::ModeOutcome| {
            let [median, least, most] = mode.time_s.map(|time| two_digits(1e3 * time));
            let cpu = mode.cpu_s.map_or_else(|| "-".to_owned(), |cpu| two_digits(1e3 * cpu));
            let share = mode.cpu_s.zip(base).map(|(cpu, base)| 100.0 * (cpu / base - 1.0));
            let against = share.map_or_else(|| "-".to_owned(), |share| format!("{share:+.1} %"));
            let [rms, max] = mode.off;
            let bits = match (mode.blake3 == *lossless, mode.claims_equal) {
                (true, _) => "equal".to_owned(),
                (false, true) => format!("NOT EQUAL: RMS {rms:.1e}"),
                (false, false) => format!("RMS {rms:.1e}, at most {max:.2}"),
            };
            vec![mode.name.clone(), median, least, most, cpu, against, bits, mode.blake3[..12].to_owned()]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.found.modes.iter().map(row)).collect()
    }

    fn left_out(&self) -> Vec<Vec<String>> {
        let head = ["level", "block", "what", "left out", "of", "share", "weight", "why"];
        let row = |left: &study::economy::LeftOut| {
            let [some, all, share] = match left.count {
                Some([some, all]) => [some.to_string(), all.to_string(), percent(some, all)],
                None => ["all", "", ""].map(str::to_owned),
            };
            let [level, block] = [left.level.name(), left.block].map(str::to_owned);
            vec![level, block, left.what.clone(), some, all, share, left.weight.clone(), left.why.clone()]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.found.left_out.iter().map(row)).collect()
    }

    fn waste(&self) -> Vec<Vec<String>> {
        let head = ["block", "what", "wasted", "of", "share", "why it is done"];
        let row = |waste: &study::economy::Waste| {
            let [some, all] = [waste.wasted, waste.of];
            let [block, what, why] = [waste.block, waste.what, waste.why].map(str::to_owned);
            vec![block, what, some.to_string(), all.to_string(), percent(some, all), why]
        };
        [head.map(str::to_owned).into()].into_iter().chain(self.found.waste.iter().map(row)).collect()
    }

    fn text(&self) -> String {
        let tables = self.tables();
        let text = tables.iter().map(|(title, rows)| format!("\n{title}\n{}", columns(rows)));
        format!("{}\n{}", self.facts(), text.collect::<String>())
    }

    /// The same as a page of Markdown.
    fn page(&self) -> String {
        let mut text = format!("{}.\n", self.facts());
        for (title, rows) in self.tables() {
            text += &format!("\n### {title}\n\n{}", markdown(&rows));
        }
        text
    }

    /// All tables, each row with its table in front.
    fn csv(&self) -> String {
        let quoted = |cell: &String| format!("\"{}\"", cell.replace('"', "\"\""));
        let mut text = String::new();
        for (title, rows) in self.tables() {
            for row in rows {
                let cells: Vec<String> = [title.to_owned()].iter().chain(&row).map(quoted).collect();
                text += &format!("{}\n", cells.join(","));
            }
        }
        text
    }

    /// Samples by what becomes of them.
    fn plot(&self, folder: &Path) -> Result<(), Failure> {
        let fates = self
            .found
            .waste
            .iter()
            .filter(|waste| waste.block == "machine" && waste.what.starts_with("samples"));
        let panels: Vec<Bars> = fates
            .map(|waste| Bars {
                name: waste.what.to_owned(),
                counts: vec![waste.wasted as f64, (waste.of - waste.wasted) as f64],
                edges: vec!["these | others".to_owned()],
                wrong: 1,
                kinds: ["touch no pixel", "all others"],
            })
            .collect();
        let look = TraceLook {
            title: "What becomes of samples".into(),
            facts: vec![self.facts()],
            width: 600,
            height: 120,
        };
        let drawing =
            bar_picture("what becomes of them", "samples", &panels, &look).map_err(Failure::output)?;
        for end in ["svg", "png"] {
            drawing.write(folder.join(format!("waste.{end}"))).map_err(Failure::output)?;
        }
        Ok(())
    }
}
