//! Function generators: the three basis functions and their slopes, fed with a ramp and with its complement.

use std::sync::Arc;

use fearless_simd::Simd;
use fearless_simd::prelude::{SimdBase, SimdFrom};
use hardware_model::AnalogParts;
use landscape::basis::{NEAR, derivatives, values};
use parts::{
    BANK, BankPlace, Ends, FunctionBank, FunctionGenerator, FunctionLaw, LagStep, Spread, Tolerance,
    relative_sigma, time_constant,
};
use signal::{Lanes, Real};

use super::scale::{PEAKS, SLOPE_PEAKS};

/// Function generators of one axis: values and slopes, at the near and at the far end, of the three orders.
pub const UNITS: usize = 12;

/// Curves: values and slopes of the three orders (`3 slope + order`), the same at both ends.
const CURVES: usize = 6;

/// The function generators of one axis; unit `6 slope + 3 end + order`.
#[derive(Debug, Clone)]
pub struct AxisGenerators<S> {
    /// The same of both axes.
    curves: Arc<Curves<S>>,
    /// Deviation of each unit at the middle times four: bows are `4 z (1 - z)` (share).
    bows: [S; UNITS],
    lags: [LagStep<S>; UNITS],
    slowest: f64,
}

#[derive(Debug, Clone)]
enum Curves<S> {
    /// Ascending powers.
    Exact([[S; 6]; CURVES]),
    Broken(FunctionBank<S>),
}

/// A group's function generators.
#[derive(Debug, Clone)]
pub struct AxisState<S> {
    /// What the lags have left for the next sample.
    left: [Lanes<S>; UNITS],
    /// Outputs, shares of full scale.
    pub out: [Lanes<S>; UNITS],
}

/// What the generators of an axis are fed with.
#[derive(Debug, Clone, Copy)]
pub struct Fed<S> {
    /// Ramp and complement.
    ends: [Lanes<S>; 2],
    /// Where they fall in broken lines.
    places: [BankPlace<S>; 2],
}

impl<S: Real> Default for Fed<S> {
    fn default() -> Self {
        Self { ends: [Lanes::default(); 2], places: [BankPlace::default(); 2] }
    }
}

impl<S: Real> Default for AxisState<S> {
    fn default() -> Self {
        Self { left: [Lanes::default(); UNITS], out: [Lanes::default(); UNITS] }
    }
}

impl<S: Real> AxisGenerators<S> {
    /// Those of X and of Y of the array called `name`, for steps of `h` seconds.
    pub fn of_both(h: f64, parts: &AnalogParts, spread: &Spread, name: &str) -> [Self; 2] {
        let knee = parts.function_generator.rounding / parts.full_scale;
        let curves = Arc::new(Curves::new(parts.function_generator.segments, knee));
        [0, 1].map(|axis| Self::new(h, parts, spread, name, (axis, curves.clone())))
    }

    fn new(
        h: f64,
        parts: &AnalogParts,
        spread: &Spread,
        name: &str,
        (axis, curves): (usize, Arc<Curves<S>>),
    ) -> Self {
        let figures = &parts.function_generator;
        let number = |unit: usize| (UNITS * axis + unit) as u64;
        let bow = |unit: usize| {
            let middle = S::from_f64(spread.error(&format!("{name}.fn"), number(unit), figures.error));
            S::from_f64(4.0) * middle
        };
        let sigma = if parts.spread { relative_sigma::BANDWIDTH } else { 0.0 };
        let tau = |unit: usize| {
            figures.bandwidth.map_or(0.0, |nominal| {
                let tolerance = Tolerance { nominal, sigma };
                time_constant(spread.figure(&format!("{name}.fn.bandwidth"), number(unit), &tolerance))
            })
        };
        let taus: [f64; UNITS] = std::array::from_fn(tau);
        Self {
            curves,
            bows: std::array::from_fn(bow),
            lags: taus.map(|tau| LagStep::new(h, tau)),
            slowest: taus.into_iter().fold(0.0, f64::max),
        }
    }

    /// Largest time constant (s).
    pub fn slowest(&self) -> f64 {
        self.slowest
    }

    /// The generators at rest under a ramp that stands.
    #[inline(always)]
    pub fn at_rest<L: Simd>(&self, simd: L, ramp: Lanes<S>) -> AxisState<S> {
        let (mut state, now) = (AxisState::default(), self.inputs::<L>(simd, &self.feed(simd, ramp)));
        for unit in 0..UNITS {
            now[unit].store_slice(&mut state.out[unit].0);
            self.lags[unit].leave(now[unit], now[unit]).store_slice(&mut state.left[unit].0);
        }
        state
    }

    /// What the generators are fed with by a ramp.
    #[inline(always)]
    pub fn feed<L: Simd>(&self, simd: L, ramp: Lanes<S>) -> Fed<S> {
        let near = S::Vector::<L>::from_slice(simd, &ramp.0);
        let far = S::Vector::<L>::simd_from(simd, S::ONE) - near;
        let mut fed = Fed { ends: [ramp; 2], places: [BankPlace::default(); 2] };
        far.store_slice(&mut fed.ends[1].0);
        if let Curves::Broken(bank) = &*self.curves {
            fed.places = [bank.place::<L>(near), bank.place::<L>(far)];
        }
        fed
    }

    /// A step later, fed with `fed` at its end.
    #[inline(always)]
    pub fn step<L: Simd>(&self, simd: L, state: &mut AxisState<S>, fed: &Fed<S>) {
        let now = self.inputs::<L>(simd, fed);
        for unit in 0..UNITS {
            let left = S::Vector::<L>::from_slice(simd, &state.left[unit].0);
            let out = self.lags[unit].end(left, now[unit]);
            out.store_slice(&mut state.out[unit].0);
            self.lags[unit].leave(out, now[unit]).store_slice(&mut state.left[unit].0);
        }
    }

    #[inline(always)]
    fn inputs<L: Simd>(&self, simd: L, fed: &Fed<S>) -> [S::Vector<L>; UNITS] {
        let one = S::Vector::<L>::simd_from(simd, S::ONE);
        let mut out = [one; UNITS];
        for (end, (fed, place)) in fed.ends.iter().zip(&fed.places).enumerate() {
            let fed = S::Vector::<L>::from_slice(simd, &fed.0);
            let values = self.curves.at::<L>(simd, fed, place);
            let bow = fed * (one - fed);
            for curve in 0..CURVES {
                let unit = 6 * (curve / 3) + 3 * end + curve % 3;
                out[unit] = values[curve] + bow * self.bows[unit];
            }
        }
        out
    }
}

impl<S: Real> Curves<S> {
    /// Each scaled to its peak.
    fn new(segments: Option<u32>, knee: f64) -> Self {
        let peak = |curve: usize| if curve < 3 { PEAKS[curve] } else { SLOPE_PEAKS[curve - 3] };
        let Some(segments) = segments else {
            return Self::Exact(std::array::from_fn(|curve| {
                let powers = if curve < 3 { NEAR[curve] } else { derivative(NEAR[curve - 3]) };
                powers.map(|power| S::from_f64(power / peak(curve)))
            }));
        };
        let law = FunctionLaw { segments: segments as usize, rounding: knee, ends: Ends::Trimmed([0.0; 2]) };
        let broken = |curve: usize| {
            let value = |z| if curve < 3 { values(z)[curve] } else { derivatives(z)[curve - 3] };
            FunctionGenerator::new(&law, |z| value(z) / peak(curve))
        };
        Self::Broken(FunctionBank::new(&std::array::from_fn::<_, CURVES, _>(broken)))
    }

    #[inline(always)]
    fn at<L: Simd>(&self, simd: L, fed: S::Vector<L>, place: &BankPlace<S>) -> [S::Vector<L>; BANK] {
        match self {
            Self::Broken(bank) => bank.at::<L>(simd, place),
            Self::Exact(curves) => {
                let mut out = [fed; BANK];
                for (out, [rest @ .., top]) in out.iter_mut().zip(curves) {
                    let mut sum = S::Vector::<L>::simd_from(simd, *top);
                    for &power in rest.iter().rev() {
                        sum = sum * fed + power;
                    }
                    *out = sum;
                }
                out
            }
        }
    }
}

fn derivative(powers: [f64; 6]) -> [f64; 6] {
    std::array::from_fn(|n| powers.get(n + 1).map_or(0.0, |power| power * (n + 1) as f64))
}
