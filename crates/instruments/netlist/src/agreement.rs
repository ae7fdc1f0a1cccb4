//! How far the circuit's waveforms are from the machine's.

use crate::run::Curves;
use crate::written::Netlist;

/// Part of the value, and part of full scale, by which a waveform may be off (trust, section 4).
const ALLOWED: [f64; 2] = [1e-3, 1e-4];
/// Samples beside an edge that the norm skips.
const BESIDE: f64 = 2.0;
/// Instants of a sample at which both are compared.
pub const INSTANTS: u32 = 8;

/// One signal of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Number of the signal in [`Netlist::signals`].
    pub node: usize,
    /// Waveform norm: the root of the mean square of what each instant is off, as a part of what it may be.
    pub norm: f64,
    /// Largest difference (full scales).
    pub worst: f64,
    /// Instants that are compared.
    pub samples: usize,
    /// Instants beside edges, which are not.
    pub skipped: usize,
}

impl Agreement {
    /// Whether the norm is at most 1, over at least one instant.
    pub fn holds(&self) -> bool {
        self.norm <= 1.0 && self.samples > 0
    }
}

/// The circuit's waveforms against the machine's, which have [`INSTANTS`] values a sample: by signal, at every one.
pub fn compare<'a>(
    netlist: &Netlist,
    curves: &Curves,
    machine: impl Fn(&str) -> &'a [f64],
) -> Vec<Agreement> {
    let machine = netlist.signals().map(machine).enumerate();
    machine.map(|(node, machine)| of_node(netlist, (node, curves), machine)).collect()
}

fn of_node(netlist: &Netlist, (node, curves): (usize, &Curves), machine: &[f64]) -> Agreement {
    let (full_scale, edges) = (netlist.nodes[node].full_scale, &netlist.edges);
    let is_beside = |at: f64| {
        let next = edges.partition_point(|edge| *edge < at - BESIDE);
        edges.get(next).is_some_and(|edge| *edge < at + BESIDE)
    };
    let (mut sum, mut worst, mut count, mut skipped) = (0.0, 0.0_f64, 0, 0);
    for (instant, &right) in machine.iter().enumerate().take(INSTANTS as usize * netlist.last + 1) {
        let at = instant as f64 / f64::from(INSTANTS);
        if is_beside(at) {
            skipped += 1;
            continue;
        }
        let time = (at - netlist.begins as f64) * netlist.step;
        let off = (curves.at(node, time) - right).abs();
        let allowed = ALLOWED[0] * right.abs() + ALLOWED[1] * full_scale;
        sum += (off / allowed) * (off / allowed);
        (worst, count) = (worst.max(off / full_scale), count + 1);
    }
    Agreement { node, norm: (sum / f64::from(count.max(1))).sqrt(), worst, samples: count as usize, skipped }
}
