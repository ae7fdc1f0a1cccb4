//! Peak memory of guests, each in a process of its own.

use std::fmt::Write as _;

use rayon::ThreadPoolBuilder;

use super::list::MemoryRow;
use super::{Guests, Side, SideChoice};

/// Peak memory (MB) of this process after three frames of a side on two threads.
///
/// # Errors
/// If it cannot be drawn, or the system does not tell the peak.
pub fn peak(choice: &SideChoice) -> Result<f64, String> {
    let pool = ThreadPoolBuilder::new().num_threads(2).build().map_err(|error| error.to_string())?;
    let mut side = pool.install(|| Side::new(choice))?;
    for _ in 0..3 {
        side.draw(&pool)?;
    }
    let kib = replay::peak_memory().ok_or("this system does not tell the peak")?;
    Ok(kib as f64 * 1024.0 / 1e6)
}

/// Processes of each side, of which the least peak counts. Chosen: by how the system lays out memory a peak varies by 4 MB.
const PROCESSES: usize = 3;

/// All rows of memory as a table in Markdown; `apart` tells the peak (MB) of a side in a process of its own.
///
/// # Errors
/// If a side cannot be drawn.
pub fn memory_table(apart: impl Fn(&SideChoice) -> Result<f64, String>) -> Result<String, String> {
    let apart = |side: &SideChoice| -> Result<f64, String> {
        (0..PROCESSES).try_fold(f64::INFINITY, |least, _| Ok(least.min(apart(side)?)))
    };
    let mut text =
        "| issue | memory | must, MB | aim, MB | measured, MB | | |\n|---|---|---|---|---|---|---|\n"
            .to_owned();
    for MemoryRow { issue, quantity, must_mb, aim_mb, of, less } in &Guests::read()?.memory {
        let peaks = of.iter().map(|side| Ok((apart(side)?, side))).collect::<Result<Vec<_>, String>>()?;
        let largest =
            peaks.iter().max_by(|a, b| a.0.total_cmp(&b.0)).ok_or("a row of memory without sides")?;
        let base = less.as_ref().map_or(Ok(0.0), &apart)?;
        let measured = largest.0 - base;
        let met = if measured <= *must_mb { "met" } else { "**not met**" };
        let all: Vec<String> =
            peaks.iter().map(|(peak, side)| format!("{} {peak:.1}", side.scenario)).collect();
        let _ = writeln!(
            text,
            "| {issue} | {quantity} | {must_mb} | {aim_mb} | {measured:.1} | {met} | {} |",
            all.join(", ")
        );
    }
    Ok(text)
}
