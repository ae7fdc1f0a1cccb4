//! One picture against another.

use std::path::PathBuf;

use compare::{Comparison, EdgeMask, LinearComparison, RidgeError};
use serde_json::{Value, json};

/// A pair of pictures and what they come to.
pub(crate) struct Pair {
    pub frame: Option<u64>,
    pub test: PathBuf,
    pub reference: PathBuf,
    pub comparison: Comparison,
    pub linear: Option<LinearComparison>,
    pub edges: Option<EdgeMask>,
    pub ridges: Option<RidgeError>,
}

impl Pair {
    pub fn document(&self) -> Value {
        let Comparison { compared, masked, differing, rmse, psnr_db, ssim, worst, beyond } = &self.comparison;
        let beyond: Vec<Value> = beyond
            .iter()
            .map(|beyond| json!({ "levels": beyond.levels, "count": beyond.count, "share": beyond.share }))
            .collect();
        json!({
            "frame": self.frame,
            "compared": compared,
            "masked": masked,
            "differing": differing,
            "rmse": rmse,
            "psnr_db": psnr_db,
            "linear": self.linear.map(|linear| json!({
                "rmse": linear.rmse, "psnr_db": linear.psnr_db, "bias": linear.bias, "maximum": linear.maximum,
            })),
            "ssim": ssim,
            "worst": {
                "column": worst.column, "line": worst.line, "test": worst.test, "reference": worst.reference,
            },
            "beyond": beyond,
            "edges": self.edges.as_ref().map(|edges| json!({
                "masked": edges.masked(), "share": edges.share(), "ridges": edges.ridges,
                "outlines": edges.outlines, "shadows": edges.shadows, "kinks": edges.kinks,
            })),
            "horizon_lines": self.ridges.map(|error| json!({
                "columns": error.compared, "only_one_sees_ground": error.only_one, "median": error.median,
                "percentile_99": error.percentile_99, "maximum": error.maximum,
            })),
        })
    }

    pub fn edge_line(&self) -> Option<String> {
        let RidgeError { compared, only_one, median, percentile_99, maximum } = self.ridges?;
        let frame = self.frame.unwrap_or_default();
        Some(format!(
            "frame {frame}: {} left out; horizon off by {median} lines (median), {percentile_99} (99 %), {maximum} \
             (most) in {compared} columns, {only_one} columns see ground in one only\n",
            self.left_out()
        ))
    }

    fn left_out(&self) -> String {
        let masked = self.comparison.masked;
        let Some(edges) = &self.edges else { return format!("{masked} pixels along ridges") };
        format!(
            "{masked} pixels ({:.2} %) along edges (ridges {}, outlines {}, shadows {}, kinks {})",
            100.0 * edges.share(),
            edges.ridges,
            edges.outlines,
            edges.shadows,
            edges.kinks
        )
    }

    pub fn row(&self) -> Vec<String> {
        let c = &self.comparison;
        let share = |levels: u32| {
            let beyond = c.beyond.iter().find(|beyond| beyond.levels == levels);
            beyond.map_or(String::new(), |beyond| format!("{:.3} %", beyond.share * 100.0))
        };
        vec![
            self.frame.map_or("-".into(), |frame| frame.to_string()),
            format!("{:.5}", c.rmse),
            self.linear.map_or("-".into(), |linear| format!("{:.5}", linear.rmse)),
            c.psnr_db.map_or("equal".into(), |psnr| format!("{psnr:.1} dB")),
            c.ssim.map_or("-".into(), |ssim| format!("{ssim:.4}")),
            share(0),
            share(1),
            share(2),
            format!("{}, {}: {:.3}, {:.3}", c.worst.column, c.worst.line, c.worst.test, c.worst.reference),
        ]
    }
}
