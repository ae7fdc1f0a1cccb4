//! The chain as a netlist, run by ngspice.

use std::io;
use std::process::Command;
use std::time::Instant;

use signal::Lanes;

use super::circuit::{RASTER, netlist};

/// The least time of so many runs counts.
const RUNS: usize = 7;

/// What the simulator made of the chains.
#[derive(Debug)]
pub struct Simulated {
    /// Outputs of the lags at every [`RASTER`]; 0 in lanes without a chain.
    pub m: Vec<Lanes<f64>>,
    /// Its analysis alone (s): what is left when a run of one time is taken off.
    pub seconds: f64,
}

/// Runs ngspice over `times` rasters of `chains` chains in one netlist with its default options, or with the relative
/// tolerance `reltol`; `None` where there is no ngspice.
///
/// # Errors
/// If it ends badly or writes what nobody expects.
pub fn simulate(chains: usize, times: usize, reltol: Option<f64>) -> Result<Option<Simulated>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let run = |times: usize| -> Result<Option<Simulated>, String> {
        let (circuit, out) = (folder.path().join("chain.cir"), folder.path().join("m.txt"));
        let text = netlist(chains) + &analysis(chains, times, reltol, &out.display().to_string());
        std::fs::write(&circuit, text).map_err(|error| error.to_string())?;
        let begin = Instant::now();
        match Command::new("ngspice").arg("-b").arg(&circuit).output() {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(format!("ngspice: {error}")),
            Ok(_) => {}
        }
        let seconds = begin.elapsed().as_secs_f64();
        let text =
            std::fs::read_to_string(&out).map_err(|error| format!("ngspice wrote nothing: {error}"))?;
        let lines = text.lines().filter(|line| !line.trim().is_empty());
        let m: Option<Vec<_>> = lines.map(|line| outputs(line, chains)).collect();
        Ok(Some(Simulated { m: m.ok_or("ngspice wrote no numbers")?, seconds }))
    };
    let mut least = [f64::INFINITY; 2];
    let mut found = Vec::new();
    for _ in 0..RUNS {
        let (Some(start), Some(whole)) = (run(2)?, run(times)?) else { return Ok(None) };
        (least, found) = ([least[0].min(start.seconds), least[1].min(whole.seconds)], whole.m);
    }
    Ok(Some(Simulated { m: found, seconds: least[1] - least[0] }))
}

/// A line of its table: the time, then each output.
fn outputs(line: &str, chains: usize) -> Option<Lanes<f64>> {
    let mut m = Lanes::default();
    for (chain, word) in (0..chains).zip(line.split_whitespace().skip(1)) {
        m[chain] = word.parse().ok()?;
    }
    Some(m)
}

fn analysis(chains: usize, times: usize, reltol: Option<f64>, out: &str) -> String {
    let options = reltol.map_or(String::new(), |reltol| format!(".options reltol={reltol:e}\n"));
    let outputs: String = (0..chains).map(|chain| format!(" v(m{chain})")).collect();
    format!(
        "{options}.control
tran {RASTER:e} {end:e} uic
linearize{outputs}
set wr_singlescale
wrdata {out}{outputs}
.endc
.end
",
        end = (times - 1) as f64 * RASTER,
    )
}
