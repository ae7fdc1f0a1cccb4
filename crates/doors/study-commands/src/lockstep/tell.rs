//! What a comparison came to, as tables and as JSON.

use lockstep::{Fault, Report, Tally};
use serde_json::{Value, json};

use command_line::Failure;
use command_line::output::{print, print_json};
use text::{named_frames, table};

/// A comparison, with a title.
pub struct Told {
    pub what: String,
    pub frames: Vec<u64>,
    pub report: Report,
    pub faults: Vec<Fault>,
}

impl Told {
    /// Whether no signal, no event and no random scene differs.
    pub fn agrees(&self) -> bool {
        self.report.first_difference().is_none() && self.faults.is_empty()
    }

    /// Prints the report as JSON or as text.
    pub fn print(&self, as_json: bool) -> Result<(), Failure> {
        if as_json { print_json(&self.json()) } else { print(&self.text()) }
    }

    fn text(&self) -> String {
        let Self { what, frames, report, faults } = self;
        let of_frames = if frames.is_empty() { String::new() } else { format!(", {}", named_frames(frames)) };
        let sweeps = if report.sweeps == 1 { "sweep" } else { "sweeps" };
        let mut text = format!("{what}{of_frames}: {} {sweeps} on both engines\n\n", report.sweeps);
        let head = ["signal", "compared", "doubtful", "worst (FS)", "not compared"];
        let rows = report.signals.iter().map(|(name, tally)| row(name, tally));
        text += &table(&[head.map(str::to_owned).to_vec()].into_iter().chain(rows).collect::<Vec<_>>());
        let events: Vec<_> = report.events.iter().map(|(word, count)| format!("{word} {count}")).collect();
        text += &format!("\nevents equal: {}; left out: {}\n", events.join(", "), report.events_left_out);
        text += &match report.first_difference() {
            None => format!(
                "no difference in {} samples; worst {:.1e} of full scale\n",
                report.samples(),
                report.worst()
            ),
            Some(difference) => format!("first difference: {difference}\n"),
        };
        faults.iter().for_each(|fault| text += &format!("{fault}\n"));
        text
    }

    fn json(&self) -> Value {
        let signal = |(name, tally): (&String, &Tally)| {
            let Tally { samples, doubtful, worst, not_compared } = tally;
            json!({
                "signal": name, "samples": samples, "doubtful": doubtful, "worst": worst, "not_compared": not_compared,
            })
        };
        let faults = self.faults.iter().map(|fault| {
            json!({
                "seed": fault.seed,
                "difference": fault.difference,
                "smallest": fault.smallest.describe(),
                "smallest_difference": fault.smallest.difference,
            })
        });
        json!({
            "schema": "lunoid.lockstep/1",
            "what": self.what,
            "frames": self.frames,
            "sweeps": self.report.sweeps,
            "signals": self.report.signals.iter().map(signal).collect::<Vec<_>>(),
            "events": self.report.events,
            "events_left_out": self.report.events_left_out,
            "samples": self.report.samples(),
            "worst": self.report.worst(),
            "first_difference": self.report.first_difference(),
            "faults": faults.collect::<Vec<_>>(),
        })
    }
}

fn row(name: &str, tally: &Tally) -> Vec<String> {
    let reasons: Vec<_> =
        tally.not_compared.iter().map(|(reason, count)| format!("{count}: {reason}")).collect();
    let worst = if tally.samples > 0 { format!("{:.1e}", tally.worst) } else { "-".to_owned() };
    vec![name.to_owned(), tally.samples.to_string(), tally.doubtful.to_string(), worst, reasons.join("; ")]
}
