//! One picture against another: what it comes to, as a document and in words.

use std::path::PathBuf;

use compare::{AnyComparison, Comparison, EdgeMask, LinearComparison, RidgeError};
use serde_json::{Value, json};

/// A pair of pictures and what they come to.
pub(crate) struct Pair {
    pub frame: Option<u64>,
    pub test: PathBuf,
    pub reference: PathBuf,
    pub comparison: AnyComparison,
    pub is_colour: bool,
    pub linear: Option<LinearComparison>,
    pub edges: Option<EdgeMask>,
    pub ridges: Option<RidgeError>,
}

impl Pair {
    /// Its part of the document.
    pub fn document(&self) -> Value {
        let mut document = json!({
            "frame": self.frame,
            "linear": self.linear.map(|linear| json!({
                "rmse": linear.rmse, "psnr_db": linear.psnr_db, "bias": linear.bias, "maximum": linear.maximum,
            })),
            "edges": self.edges.as_ref().map(|edges| json!({
                "masked": edges.masked(), "share": edges.share(), "ridges": edges.ridges,
                "outlines": edges.outlines, "shadows": edges.shadows, "kinks": edges.kinks,
            })),
            "horizon_lines": self.ridges.map(|error| json!({
                "columns": error.compared, "only_one_sees_ground": error.only_one, "median": error.median,
                "percentile_99": error.percentile_99, "maximum": error.maximum,
            })),
        });
        add(&mut document, figures(&self.comparison.luminance));
        if self.is_colour {
            add(&mut document, json!({ "compared_by": "luminance" }));
        }
        if let Some(channels) = &self.comparison.channels {
            let [red, green, blue] = channels.each_ref().map(figures);
            add(&mut document, json!({ "channels": { "red": red, "green": green, "blue": blue } }));
        }
        document
    }

    /// What the channels of two pictures in colour come to.
    pub fn colour_line(&self) -> Option<String> {
        let frame = self.frame.map_or(String::new(), |frame| format!("frame {frame}: "));
        match &self.comparison.channels {
            Some(channels) => {
                let [red, green, blue] = channels.each_ref().map(|channel| channel.rmse);
                Some(format!(
                    "{frame}rmse of red {red:.5}, green {green:.5}, blue {blue:.5}; above of luminance\n"
                ))
            }
            None if self.is_colour => {
                Some(format!("{frame}one in colour, one grey: compared by luminance\n"))
            }
            None => None,
        }
    }

    /// What is left out along edges, and how far the horizon is off.
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
        let masked = self.comparison.luminance.masked;
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

    /// Its row of the table.
    pub fn row(&self) -> Vec<String> {
        let c = &self.comparison.luminance;
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

/// Figures of one comparison.
fn figures(comparison: &Comparison) -> Value {
    let Comparison { compared, masked, differing, rmse, psnr_db, ssim, worst, beyond } = comparison;
    let beyond: Vec<Value> = beyond
        .iter()
        .map(|beyond| json!({ "levels": beyond.levels, "count": beyond.count, "share": beyond.share }))
        .collect();
    json!({
        "compared": compared,
        "masked": masked,
        "differing": differing,
        "rmse": rmse,
        "psnr_db": psnr_db,
        "ssim": ssim,
        "worst": {
            "column": worst.column, "line": worst.line, "test": worst.test, "reference": worst.reference,
        },
        "beyond": beyond,
    })
}

/// Adds the keys of `more` to `document`.
fn add(document: &mut Value, more: Value) {
    if let (Some(keys), Value::Object(more)) = (document.as_object_mut(), more) {
        keys.extend(more);
    }
}
