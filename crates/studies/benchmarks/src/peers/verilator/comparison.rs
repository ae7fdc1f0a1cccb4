//! Both control planes in turns.

use std::time::Instant;

use control_plane::ControlPlane;

use super::{Program, Stimuli, Work};
use crate::peers::median;
use crate::{Choice, TimedScene};

/// Frames of each side for each start.
const TURNS: usize = 21;
/// Times that the verilated program is started: where the system lays it makes it up to 1.6 times as slow, so its best start counts.
const STARTS: usize = 5;

/// What both do and how long it takes, as tables in Markdown; one line where a package is missing.
///
/// # Errors
/// If something cannot be run, or both do not do the same.
pub fn table() -> Result<String, String> {
    let choice = Choice { model: Some("pra-nominal"), ..Choice::default() };
    let scene = TimedScene::shipped("nominal-drive", &choice);
    let (pose, count) = (scene.pose, scene.stage.settings.raster.sweeps);
    let plane = ControlPlane::new(scene.stage.clone());
    let stimuli = Stimuli::new(&scene.stage, &plane, &pose)?;
    let program = match Program::compile(&stimuli)? {
        Ok(program) => program,
        Err(skipped) => return Ok(format!("| Verilator | {skipped} |\n")),
    };
    let ours = Work::ours(&scene.stage, &plane, &pose)?;
    let mut programs = Vec::new();
    let mut write = || {
        let begin = Instant::now();
        let sweeps = plane.sweeps(0, &pose).map_err(|error| error.to_string())?;
        (0..count).for_each(|sweep| sweeps.write_programs(sweep, &mut programs));
        Ok::<f64, String>(begin.elapsed().as_secs_f64())
    };
    write()?;
    let (mut written, mut ticked) = (Vec::new(), f64::INFINITY);
    for _ in 0..STARTS {
        let (mut verilated, mut times) = (program.start(&stimuli)?, Vec::new());
        let (_, theirs) = verilated.frame()?;
        if ours != theirs {
            return Err(format!(
                "both control planes must do the same work:\nours {ours:?}\nVerilator {theirs:?}"
            ));
        }
        for _ in 0..TURNS {
            written.push(write()?);
            times.push(verilated.frame()?.0);
        }
        ticked = ticked.min(median(times));
    }
    let written = median(written);
    let Work { folds, wanted, served, loads, late, longest, .. } = ours;
    let counts = format!("{folds} | {wanted} | {served} | {loads} | {late} | {longest}");
    Ok(format!(
        "| control plane, nominal-drive, pra-nominal, one thread | folds | sets asked for | sets fetched | loads | late sets | most before a bank | ms a frame | times as fast |\n\
         |---|---|---|---|---|---|---|---|---|\n\
         | ours | {counts} | {:.2} | {:.1} |\n| SystemVerilog by Verilator | {counts} | {:.2} | 1 |\n",
        written * 1e3,
        ticked / written,
        ticked * 1e3
    ))
}
