//! The chain by a stiff integrator of a library, as a peer of the machine's parts.

use differential_equations::ivp::IVP;
use differential_equations::linalg::Matrix;
use differential_equations::methods::DiagonallyImplicitRungeKutta;
use differential_equations::ode::ODE;

use super::chain::{Chain, FOLDS, Record, SAMPLES};
use super::flow::Flow;
use super::method::SEEN;

/// Steps after which the library gives up.
const REJECTED: usize = 1_000_000;

/// The chain with time in samples: a library's first step and tolerances are not made for nanoseconds.
struct InSamples<'a>(&'a Chain);

impl ODE<f64, [f64; 7]> for InSamples<'_> {
    fn diff(&self, t: f64, y: &[f64; 7], rate: &mut [f64; 7]) {
        let Self(chain) = self;
        // The rates of the smoothers are a sample's.
        *rate = per_sample(chain, chain.rate(t * chain.sample, &in_seconds(chain, y)));
    }

    fn jacobian(&self, t: f64, y: &[f64; 7], out: &mut Matrix<f64>) {
        let Self(chain) = self;
        let matrix = chain.jacobian(t * chain.sample, &in_seconds(chain, y));
        for (i, row) in matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                out[(i, j)] = entry * chain.sample * unit(chain, i) / unit(chain, j);
            }
        }
    }
}

/// What a state is multiplied by: rates of the smoothers count samples.
fn unit(chain: &Chain, state: usize) -> f64 {
    if state == 1 || state == 3 { chain.sample } else { 1.0 }
}

fn in_seconds(chain: &Chain, y: &[f64; 7]) -> [f64; 7] {
    std::array::from_fn(|i| y[i] / unit(chain, i))
}

fn per_sample(chain: &Chain, rate: [f64; 7]) -> [f64; 7] {
    std::array::from_fn(|i| rate[i] * chain.sample * unit(chain, i))
}

/// The run in `1 / step` values a sample, with steps of the library's choice under `tolerance`; `None` if it gave up.
pub(super) fn run(chain: &Chain, step: f64, tolerance: f64) -> Option<Record> {
    let flow = InSamples(chain);
    let mut y: [f64; 7] = chain.at_rest();
    let mut record = Record::starting(SEEN.map(|index| y[index]), (SAMPLES as f64 / step) as usize);
    for begin in (0..SAMPLES).step_by(FOLDS[0]) {
        let values = (FOLDS[0] as f64 / step).round() as usize;
        let times: Vec<f64> = (1..=values).map(|k| begin as f64 + k as f64 * step).collect();
        // The library's count of steps rejected in a row never starts anew, so its usual limit ends a sound run.
        let method = DiagonallyImplicitRungeKutta::kvaerno745()
            .rtol(tolerance)
            .atol(tolerance)
            .max_rejects(REJECTED)
            .max_steps(REJECTED);
        let problem = IVP::ode(&flow, begin as f64, (begin + FOLDS[0]) as f64, y).t_eval(times);
        let found = problem.method(method).solve().ok()?;
        found.y.iter().for_each(|y| record.push(SEEN.map(|index| y[index])));
        y = *found.y.last()?;
    }
    Some(record)
}
