//! What a finished run comes to, in words and as JSON.

use std::path::Path;

use replay::TruthOutcome;
use serde_json::{Value, json};

use crate::output::rate;

/// What a finished run comes to.
pub struct Summary<'a> {
    pub folder: &'a Path,
    pub frames: [u64; 2],
    pub drawn: u64,
    pub truth: Option<TruthOutcome>,
    pub limits: Vec<String>,
    pub performance: &'a Value,
}

impl Summary<'_> {
    /// As JSON.
    pub fn document(&self) -> Value {
        json!({
            "schema": "lunoid.replay/1",
            "folder": self.folder.display().to_string(),
            "frames": self.frames,
            "drawn": self.drawn,
            "kept": self.frames[1] - self.frames[0] - self.drawn,
            "truth": self.truth.map(|truth| json!({ "frames": truth.frames, "made": truth.made })),
            "limits": self.limits,
            "performance": self.performance,
        })
    }

    /// As text.
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
        let limits = self.limits.iter().map(|limit| format!("  beyond the vehicle: {limit}\n"));
        text.trim_end().to_owned() + "\n" + &truth.into_iter().chain(limits).collect::<String>()
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
