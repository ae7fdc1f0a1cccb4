//! What came of a comparison.

use std::path::PathBuf;

use compare::triptych_any;
use picture::AnyPicture;
use serde_json::{Value, json};
use text::table;

use crate::RunCompareError;
use crate::pair::Pair;
use crate::pictures::read;

/// What may be off.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tolerances {
    /// Largest RMSE (1 = white).
    pub rmse: Option<f64>,
    /// Levels of 255 by which a pixel may be off, and the percentage of pixels that may be off by more.
    pub levels: Option<(u32, f64)>,
    /// Lines by which the horizon may be off in any column.
    pub ridge: Option<usize>,
}

/// Pairs of pictures, each with how far one is from the other.
pub struct Compared {
    /// What is under test, and what it is compared with.
    pub(crate) sides: [PathBuf; 2],
    pub(crate) pairs: Vec<Pair>,
}

impl Compared {
    /// The worst pair and its difference, `factor` times enlarged, side by side.
    ///
    /// # Errors
    /// If a picture cannot be read any more.
    pub fn worst_picture(&self, factor: u32) -> Result<AnyPicture, RunCompareError> {
        let pair = worst(&self.pairs);
        let is_of_run = pair.frame.is_some();
        Ok(triptych_any(&read(&pair.test, is_of_run)?, &read(&pair.reference, is_of_run)?, factor)?)
    }

    /// Whether `tolerances` are met, if there are any.
    pub fn pass(&self, tolerances: &Tolerances) -> Option<bool> {
        let Tolerances { rmse, levels, ridge } = *tolerances;
        if rmse.is_none() && levels.is_none() && ridge.is_none() {
            return None;
        }
        Some(self.pairs.iter().all(|pair| {
            let rmse_is_met = rmse.is_none_or(|most| pair.comparison.all().all(|found| found.rmse <= most));
            let share_is_met = levels.is_none_or(|(levels, percent)| {
                pair.comparison.all().all(|found| {
                    let beyond = found.beyond.iter().find(|beyond| beyond.levels == levels);
                    beyond.is_some_and(|beyond| beyond.share * 100.0 <= percent)
                })
            });
            let ridge_is_met =
                ridge.is_none_or(|most| pair.ridges.is_some_and(|error| error.maximum <= most));
            rmse_is_met && share_is_met && ridge_is_met
        }))
    }

    /// A document of schema `lunoid.compare/1`; `pass` says whether tolerances are met.
    pub fn json(&self, pass: Option<bool>) -> Value {
        let Self { sides: [test, reference], pairs } = self;
        json!({
            "schema": "lunoid.compare/1",
            "test": test.display().to_string(),
            "reference": reference.display().to_string(),
            "pass": pass,
            "pictures": pairs.iter().map(Pair::document).collect::<Vec<_>>(),
        })
    }

    /// A table, a row a pair.
    pub fn text(&self, pass: Option<bool>) -> String {
        let pairs = &self.pairs;
        let heading = [
            "frame",
            "rmse",
            "linear",
            "psnr",
            "ssim",
            "differ",
            ">1/255",
            ">2/255",
            "worst pixel (column, line: test, reference)",
        ];
        let heading = heading.map(str::to_owned).to_vec();
        let rows: Vec<Vec<String>> = [heading].into_iter().chain(pairs.iter().map(Pair::row)).collect();
        let mut text = table(&rows);
        if pairs.len() > 1 {
            let worst = worst(pairs);
            text += &format!(
                "worst of {}: frame {}\n",
                pairs.len(),
                worst.frame.map(|frame| frame.to_string()).unwrap_or_default()
            );
        }
        text.extend(pairs.iter().filter_map(Pair::colour_line));
        text.extend(pairs.iter().filter_map(Pair::edge_line));
        match pass {
            Some(true) => text += "within the tolerance\n",
            Some(false) => text += "beyond the tolerance\n",
            None => {}
        }
        text
    }
}

/// The pair of the largest RMSE, the first of several.
fn worst(pairs: &[Pair]) -> &Pair {
    let worse = |a: &&Pair, b: &&Pair| b.comparison.luminance.rmse > a.comparison.luminance.rmse;
    pairs.iter().reduce(|a, b| if worse(&a, &b) { b } else { a }).expect("there is a pair")
}
