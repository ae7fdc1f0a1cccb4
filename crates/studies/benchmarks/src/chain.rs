//! An analog chain as the machine steps it, eight side by side, and as a circuit simulator does.

mod ngspice;

// One circuit for what is timed here and what the tests of the parts hold against an integrator.
#[path = "../../../circuits/parts/tests/behaviour/chain/circuit.rs"]
mod circuit;

pub use circuit::{Outputs, RASTER, Stepped};
pub use ngspice::{Simulated, simulate};

use signal::{Lanes, Real};

/// Root mean square of the difference of outputs of the first `chains` chains, and its largest value.
pub fn difference<S: Real>(found: &[Lanes<S>], right: &[Lanes<f64>], chains: usize) -> [f64; 2] {
    let gaps = || {
        let pairs = found.iter().zip(right);
        pairs.flat_map(move |(a, b)| (0..chains).map(move |chain| (a[chain].to_f64() - b[chain]).abs()))
    };
    let count = (chains * found.len().min(right.len())).max(1) as f64;
    [(gaps().map(|gap| gap * gap).sum::<f64>() / count).sqrt(), gaps().fold(0.0, f64::max)]
}
