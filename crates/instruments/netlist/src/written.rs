//! A circuit as it is written, and what its nodes are in the machine.

use std::fmt::Write;

/// Instants of a sample at which waveforms are asked for; ngspice takes twice as many and more.
const INSTANTS: f64 = 8.0;
/// Part of a current that ngspice may leave open (A). Amplifiers slew by up to 20 mA; where they rest, a smaller part is below what
/// their voltages leave open, and ngspice would cut its steps for nothing.
const CURRENT: f64 = 1e-9;

/// A circuit that ngspice runs as it stands.
#[derive(Debug, Clone)]
pub struct Netlist {
    /// File of the circuit.
    pub text: String,
    /// Nodes whose waveforms are kept.
    pub(crate) nodes: Vec<Node>,
    /// Instants at which words or polarity change, or a ramp folds (steps from the first sample), ascending.
    pub(crate) edges: Vec<f64>,
    /// Length of a sample (s).
    pub(crate) step: f64,
    /// Sample at which the circuit begins.
    pub(crate) begins: i64,
    /// Last sample that it has.
    pub(crate) last: usize,
}

/// A node whose waveform is kept.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    pub name: &'static str,
    /// Signal of the machine.
    pub signal: String,
    pub full_scale: f64,
}

impl Netlist {
    /// Signals of the machine that its kept nodes are, in the order in which ngspice keeps them.
    pub fn signals(&self) -> impl ExactSizeIterator<Item = &str> {
        self.nodes.iter().map(|node| node.signal.as_str())
    }

    /// Last instant of the circuit (s).
    pub(crate) fn end(&self) -> f64 {
        (self.last as i64 - self.begins) as f64 * self.step
    }

    /// The circuit with what ngspice is told to do.
    pub(crate) fn ended(mut self) -> Self {
        let (step, end) = (self.step / INSTANTS, self.end());
        let saved: String = self.nodes.iter().map(|node| format!(" v({})", node.name)).collect();
        let _ = write!(
            self.text,
            ".options reltol=1e-5 abstol={CURRENT:e} vntol=1e-9 chgtol=1e-18\n.save{saved}\n.tran {step:.15e} {end:.15e} 0 {:.3e}\n.end\n",
            step / 2.0
        );
        self
    }
}
