//! What a finished run comes to, in words and as JSON.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use replay::{HeldRun, TruthOutcome};
use serde_json::{Value, json};

use text::rate;

/// What a finished run comes to.
pub struct Summary<'a> {
    pub folder: &'a Path,
    pub frames: [u64; 2],
    pub drawn: u64,
    pub truth: Option<TruthOutcome>,
    /// Robot log and OpenEXR files: option, where they are, number of frames.
    pub logs: Vec<(&'static str, PathBuf, u64)>,
    /// As it stands in the record of the run, where one was asked for.
    pub check: Option<Value>,
    pub limits: Vec<String>,
    /// What the frames lack that the scene has, with its number: late words, dropped features.
    pub losses: Vec<(String, u64)>,
    /// The file to look at first, where this run has one of its own.
    pub open: Option<PathBuf>,
    pub performance: &'a Value,
}

/// Counters of faults begin with one of these words.
const LOSSES: [&str; 2] = ["late_", "dropped_"];

/// The counters of faults of a run that are not 0.
pub fn losses(run: &HeldRun) -> Vec<(String, u64)> {
    let is_loss = |name: &str| LOSSES.iter().any(|word| name.starts_with(word));
    let lost = run.totals.named().filter(|(name, count)| *count > 0 && is_loss(name));
    lost.map(|(name, count)| (name.to_owned(), count)).collect()
}

impl Summary<'_> {
    /// The summary as a document of schema `lunoid.replay/1`.
    pub fn document(&self) -> Value {
        json!({
            "schema": "lunoid.replay/1",
            "folder": self.folder.display().to_string(),
            "frames": self.frames,
            "drawn": self.drawn,
            "kept": self.frames[1] - self.frames[0] - self.drawn,
            "truth": self.truth.map(|truth| json!({ "frames": truth.frames, "made": truth.made })),
            "logs": self.logs.iter().map(|(option, path, frames)| json!({
                "option": option,
                "path": path.display().to_string(),
                "frames": frames,
            })).collect::<Vec<_>>(),
            "check": self.check,
            "limits": self.limits,
            "losses": self.losses.iter().cloned().collect::<BTreeMap<_, _>>(),
            "open": self.open.as_ref().map(|path| path.display().to_string()),
            "performance": self.performance,
        })
    }

    /// The summary as text for people.
    pub fn text(&self) -> String {
        let [start, end] = self.frames;
        let mut text = format!("{}: frames {start}..{end}", self.folder.display());
        if self.drawn == 0 {
            text += ", all there already";
        } else {
            text += &format!(", {} drawn now{}\n", self.drawn, self.rates());
        }
        let truth = self.truth.map(|TruthOutcome { frames, made, .. }| {
            format!("  ground truth of {frames} frames, {made} made now\n")
        });
        let logs = self.logs.iter().map(|(option, path, frames)| {
            format!("  {} of {frames} frames: {}\n", option.trim_start_matches('-'), path.display())
        });
        let limits = self.limits.iter().map(|limit| format!("  beyond the vehicle: {limit}\n"));
        let check = self.check.as_ref().map(checked);
        let losses: Vec<String> =
            self.losses.iter().map(|(name, count)| format!("{count} {}", name.replace('_', " "))).collect();
        let losses = (!losses.is_empty()).then(|| format!("  in all frames: {}\n", losses.join(", ")));
        let open = self.open.as_ref().map(|path| format!("open {}\n", path.display()));
        let lines = truth.into_iter().chain(logs).chain(check).chain(limits).chain(losses).chain(open);
        text.trim_end().to_owned() + "\n" + &lines.collect::<String>()
    }

    fn rates(&self) -> String {
        let number = |key: &str| self.performance[key].as_f64().unwrap_or(0.0);
        format!(
            " in {:.1} s: {} frames/s, {} million samples/s, {} of real time",
            number("drawing_s"),
            rate(number("frames_per_s")),
            rate(number("samples_per_s") / 1e6),
            rate(number("real_time_factor")),
        )
    }
}

/// The errors of a check, in a line.
fn checked(check: &Value) -> String {
    let word = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let error = |error: &Value| {
        let unit = Some(word(&error["unit"])).filter(|unit| unit != "1").map(|unit| format!(" {unit}"));
        let [rms, max] = ["rms", "max"].map(|key| error[key].as_f64().unwrap_or(f64::NAN));
        format!(
            "{} {rms:.2e}{unit} (at most {max:.2e})",
            word(&error["error"]),
            unit = unit.unwrap_or_default()
        )
    };
    let errors: Vec<String> = check["errors"].as_array().into_iter().flatten().map(error).collect();
    format!("  {} sweeps against {}, rms: {}\n", check["sweeps"], word(&check["against"]), errors.join(", "))
}
