//! Photographs over ground: voids of their elevations against plain relaxation, the drape against Embree with the same texture, and memory.

mod drape;
mod voids;

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::row::Row;

/// All rows as a table in Markdown; `peak` tells the peak memory (MB) of a process that draws a scenario, named without its ending.
///
/// # Errors
/// If a side cannot be drawn, or a ray tracer that is here shows another picture.
pub fn table(peak: impl Fn(&str) -> Result<f64, String>) -> Result<String, String> {
    let threads =
        |count| ThreadPoolBuilder::new().num_threads(count).build().map_err(|error| error.to_string());
    let pools: [ThreadPool; 2] = [threads(1)?, threads(2)?];
    let mut text = Row::HEAD.to_owned();
    text.extend(voids::rows(&pools[1])?.iter().map(Row::line));
    text.push_str(&drape::lines(&pools, peak)?);
    Ok(text)
}
