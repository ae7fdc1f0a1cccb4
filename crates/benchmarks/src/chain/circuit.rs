//! The chain as a netlist, run by ngspice.

use std::io;
use std::process::Command;
use std::time::Instant;

use super::{B, DELAY, MULTIPLIER, RASTER, RISE, SMOOTHER, TAU_H, TAU_M, THRESHOLD};
use parts::{MultiplierLaw, SecondOrder};

/// The least time of so many runs counts.
const RUNS: usize = 3;

/// What the simulator made of the chain.
#[derive(Debug)]
pub struct Simulated {
    /// Output of the lag at every [`RASTER`].
    pub m: Vec<f64>,
    /// Its analysis alone (s): what is left when a run of one time is taken off.
    pub seconds: f64,
}

/// Runs ngspice over `times` rasters with its default options, or with the relative tolerance `reltol`; `None` where
/// there is no ngspice.
///
/// # Errors
/// If it ends badly or writes what nobody expects.
pub fn simulate(times: usize, reltol: Option<f64>) -> Result<Option<Simulated>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let run = |times: usize| -> Result<Option<(Vec<f64>, f64)>, String> {
        let (circuit, out) = (folder.path().join("chain.cir"), folder.path().join("m.txt"));
        let text = netlist(times, reltol, &out.display().to_string());
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
        let value = |line: &str| line.split_whitespace().nth(1)?.parse::<f64>().ok();
        let m: Option<Vec<f64>> = text.lines().filter(|line| !line.trim().is_empty()).map(value).collect();
        Ok(Some((m.ok_or("ngspice wrote no numbers")?, seconds)))
    };
    let mut least = [f64::INFINITY; 2];
    let mut found = Vec::new();
    for _ in 0..RUNS {
        let (Some((_, start)), Some((m, whole))) = (run(2)?, run(times)?) else { return Ok(None) };
        (least, found) = ([least[0].min(start), least[1].min(whole)], m);
    }
    Ok(Some(Simulated { m: found, seconds: least[1] - least[0] }))
}

/// An RLC smoother, a formula, RC lags, a delay line, a switch.
fn netlist(times: usize, reltol: Option<f64>, out: &str) -> String {
    let SecondOrder { natural, damping } = SMOOTHER;
    let MultiplierLaw { gain, feed_a, feed_b, offset, nonlinearity } = MULTIPLIER;
    // L = 1 uH: C = 1 / (w^2 L), R = 2 z w L.
    let (c, r) = (1e6 / (natural * natural), 2e-6 * damping * natural);
    let options = reltol.map_or(String::new(), |reltol| format!(".options reltol={reltol:e}\n"));
    format!(
        "smoother, multiplier, comparator, sample-and-hold
Vu u 0 PULSE(0 1 0 {RISE:e} {RISE:e} 1e-15 {period:e})
Rs u s1 {r:e}
Ls s1 a 1e-6
Cs a 0 {c:e}
Bp p 0 V = {scale:e}*V(a) + {feed_a:e}*V(a) + {of_b:e} + {offset:e} + {nonlinearity:e}*V(a)*(1 - V(a)*V(a))
Rm p m1 1000
Cm m1 0 {cm:e} IC=0
Em m 0 m1 0 1
Bc c 0 V = 0.5*(1 - tanh(2e4*(V(m) - {THRESHOLD})))
Rc c c1 50
Tc c1 0 c2 0 Z0=50 TD={DELAY:e}
Rt c2 0 50
Sh m held c2 0 track
Ch held 0 {ch:e} IC=0
.model track SW(vt=0.25 vh=0 ron=1000 roff=1e14)
{options}.control
tran {RASTER:e} {end:e} uic
linearize v(m)
set wr_singlescale
wrdata {out} v(m)
.endc
.end
",
        period = 2.0 * RISE,
        scale = (1.0 + gain) * B,
        of_b = feed_b * B,
        cm = TAU_M / 1e3,
        ch = TAU_H / 1e3,
        end = (times - 1) as f64 * RASTER,
    )
}
