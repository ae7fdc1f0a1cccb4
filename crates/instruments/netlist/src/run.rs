//! A circuit through ngspice.

use std::io;
use std::path::Path;
use std::process::Command;

use crate::Netlist;

/// Waveforms of the nodes that a circuit keeps, at the instants that ngspice chose.
#[derive(Debug, Clone)]
pub struct Curves {
    /// Instants of the points (s).
    pub times: Vec<f64>,
    /// Values of each node, in the order of [`Netlist::signals`].
    pub values: Vec<Vec<f64>>,
}

impl Curves {
    /// A node at an instant (s): straight between the instants beside it.
    pub fn at(&self, node: usize, time: f64) -> f64 {
        let (times, values) = (&self.times, &self.values[node]);
        let next = times.partition_point(|at| *at <= time).clamp(1, times.len() - 1);
        let [from, to] = [times[next - 1], times[next]];
        let share = if to > from { (time - from) / (to - from) } else { 1.0 };
        values[next - 1] + (values[next] - values[next - 1]) * share
    }
}

/// Why there are no waveforms.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// No program of this name can be started.
    #[error("ngspice is not installed; install it, or leave --check out")]
    NoNgspice,
    /// The program could not be started or its file not be read.
    #[error("ngspice: {0}")]
    Io(#[from] io::Error),
    /// The program ended without waveforms.
    #[error("ngspice gave no waveforms; it says: {0}")]
    Failed(String),
    /// The program ended before the sweep did.
    #[error("ngspice stopped at {reached:.3e} of {end:.3e} s; it says: {said}")]
    Stopped {
        /// Last instant of its waveforms (s).
        reached: f64,
        /// Last instant of the circuit (s).
        end: f64,
        /// What the program says first.
        said: String,
    },
}

/// Runs the circuit of `netlist`, which stands in the file `circuit`; its raw file is written to `raw`.
///
/// # Errors
/// If ngspice is not there, makes nothing of the circuit, or does not come to its end.
pub fn run(netlist: &Netlist, circuit: &Path, raw: &Path) -> Result<Curves, RunError> {
    let started = Command::new("ngspice").arg("-b").arg("-r").arg(raw).arg(circuit).output();
    let output = match started {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Err(RunError::NoNgspice),
        other => other?,
    };
    let said = || {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        said.lines().filter(|line| !line.trim().is_empty()).take(5).collect::<Vec<_>>().join("; ")
    };
    let bytes = std::fs::read(raw).map_err(|_| RunError::Failed(said()))?;
    let curves = parsed(&bytes, netlist.nodes.len()).ok_or_else(|| RunError::Failed(said()))?;
    let (reached, end) = (curves.times.last().copied().unwrap_or(0.0), netlist.end());
    if reached < end * (1.0 - 1e-9) {
        return Err(RunError::Stopped { reached, end, said: said() });
    }
    Ok(curves)
}

/// A raw file of real numbers: a header up to `Binary:`, then doubles, the time first. Of a file that ends within a point, that point is
/// left out.
fn parsed(bytes: &[u8], nodes: usize) -> Option<Curves> {
    const MARK: &[u8] = b"Binary:\n";
    let body = bytes.windows(MARK.len()).position(|window| window == MARK)? + MARK.len();
    let header = std::str::from_utf8(&bytes[..body]).ok()?;
    let variables: usize =
        header.lines().find_map(|line| line.strip_prefix("No. Variables:"))?.trim().parse().ok()?;
    let number = |bytes: &[u8]| bytes.try_into().map(f64::from_le_bytes).ok();
    let points = (bytes.len() - body) / (8 * variables.max(1));
    let numbers: Option<Vec<f64>> =
        bytes[body..].chunks_exact(8).take(points * variables).map(number).collect();
    let numbers = numbers?;
    let column = |k: usize| numbers.iter().skip(k).step_by(variables).copied().collect::<Vec<f64>>();
    (variables == nodes + 1 && numbers.len() > variables)
        .then(|| Curves { times: column(0), values: (1..variables).map(column).collect() })
}
