//! Response times of tasks, by the recurrence of fixed priorities.

use serde::Deserialize;

use crate::scene::machine::MachineCase;

/// A task of the processor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Task {
    /// Set-up of a sweep, in the time of the sweep before.
    SweepSetUp,
    /// Tables of a frame, asked for as the frame begins; set-ups and crossings go before.
    FrameTables,
}

/// Worst response time (ticks) of a task: the least R with `R = C + sum of the work above it in R`. Crossings interrupt
/// set-ups, both interrupt tables; each sweep's time brings its crossings and one set-up.
pub fn response_ticks(of: &MachineCase, task: Task) -> Result<f64, String> {
    let cpu = &of.settings.cpu;
    let sweeps: Result<Vec<f64>, String> =
        of.sweeps().map(|sweep| Ok(folds(of, sweep)? * cpu.crossing() as f64)).collect();
    let (crossings, set_up) = (sweeps?, cpu.sweep_setup as f64);
    let timebase = &of.settings.timebase;
    let period = timebase.master.hertz() / (timebase.update.hertz() * crossings.len() as f64);
    match task {
        // The worst of the sweeps in whose time one is set up.
        Task::SweepSetUp => {
            Ok(crossings.iter().fold(0.0, |most: f64, &crossing| most.max(crossing)) + set_up)
        }
        Task::FrameTables => {
            let mut response = cpu.frame_tables as f64;
            loop {
                let begun = (response / period).ceil() as usize;
                let above = crossings.iter().take(begun).map(|crossing| crossing + set_up);
                let next = cpu.frame_tables as f64 + above.sum::<f64>();
                if next == response || begun > crossings.len() {
                    return Ok(next);
                }
                response = next;
            }
        }
    }
}

/// Lines of the lattice that a sweep crosses out to its end.
fn folds(of: &MachineCase, sweep: u32) -> Result<f64, String> {
    let direction = of.direction(sweep).ok_or("no fan covers the pitch")?;
    let end = of.place(direction, of.settings.range.end);
    let lines = |axis: usize| {
        let [from, to] =
            [of.scene.eye_m[axis], end[axis]].map(|along| (along / of.scene.region_size_m).floor());
        (to - from).abs()
    };
    Ok(lines(0) + lines(1))
}
