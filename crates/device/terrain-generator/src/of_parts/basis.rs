//! Function generators: the three basis functions and their slopes, fed with a ramp and with its complement.

use std::sync::Arc;

use fearless_simd::Simd;
use fearless_simd::prelude::{SimdBase, SimdFrom};
use hardware_model::AnalogParts;
use landscape::basis::{NEAR, derivatives, values};
use parts::{
    BankPlace, Ends, FunctionBank, FunctionGenerator, FunctionLaw, LagStep, Spread, Tolerance,
    relative_sigma, time_constant,
};
use signal::{Both, Double, Lanes, Real};

use super::scale::{PEAKS, SLOPE_PEAKS};
use crate::terms::{ENDS, one_of, side_by_side};

/// Function generators of one axis: values and slopes, at the near and at the far end, of the three orders.
pub const UNITS: usize = 12;

/// Curves: values and slopes of the three orders (`3 slope + order`), the same at both ends.
pub(super) const CURVES: usize = 6;

/// The function generators of one axis; unit `6 slope + 3 end + order`. Those of a curve at the near and at the far end go
/// side by side.
#[derive(Debug, Clone)]
pub struct AxisGenerators<S> {
    /// The same of both axes.
    curves: Arc<Curves<S>>,
    /// Deviation of each unit at the middle times four: bows are `4 z (1 - z)` (share).
    bows: [Both<S>; CURVES],
    lags: [LagStep<Both<S>>; CURVES],
    slowest: f64,
}

#[derive(Debug, Clone)]
enum Curves<S> {
    /// Ascending powers of values and of slopes.
    Exact([[S; 6]; 3], [[S; 5]; 3]),
    Broken(FunctionBank<S>),
}

/// A group's function generators.
#[derive(Debug, Clone)]
pub struct AxisState<S> {
    /// What the lags have left for the next sample.
    left: [Both<S>; CURVES],
    /// Outputs, shares of full scale.
    pub(super) out: [Both<S>; CURVES],
}

/// What the generators of an axis are fed with.
#[derive(Debug, Clone, Copy)]
pub struct Fed<S> {
    /// Values of the ramp and of its complement.
    ends: Both<S>,
    /// Where they fall in broken lines.
    places: [BankPlace<S>; 2],
}

impl<S: Real> Fed<S> {
    /// Returns the values of the ramp.
    pub fn ramp(&self) -> Lanes<S> {
        self.ends.wire(0)
    }
}

impl<S: Real> Default for Fed<S> {
    fn default() -> Self {
        Self { ends: Both::default(), places: [BankPlace::default(); 2] }
    }
}

impl<S: Real> Default for AxisState<S> {
    fn default() -> Self {
        Self { left: [Both::default(); CURVES], out: [Both::default(); CURVES] }
    }
}

impl<S: Real> AxisState<S> {
    /// Output of a unit.
    pub fn output(&self, unit: usize) -> Lanes<S> {
        let [curve, end] = side_by_side(unit);
        self.out[curve].wire(end)
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
        let lag = |unit: usize| LagStep::new(h, taus[unit]);
        Self {
            curves,
            bows: std::array::from_fn(|curve| Both::splat(ENDS.map(|end| bow(one_of(curve, end))))),
            lags: std::array::from_fn(|curve| {
                let [near, far] = ENDS.map(|end| lag(one_of(curve, end)));
                near.beside(&far, |near, far| Both::splat([near, far]))
            }),
            slowest: taus.into_iter().fold(0.0, f64::max),
        }
    }

    /// Largest time constant (s).
    pub fn slowest(&self) -> f64 {
        self.slowest
    }

    /// The generators at rest under what a ramp that stands feeds them with.
    #[inline(always)]
    pub fn at_rest<L: Simd>(&self, simd: L, fed: &Fed<S>) -> AxisState<S> {
        let (mut state, now) = (AxisState::default(), self.inputs::<L>(simd, fed));
        for curve in 0..CURVES {
            now[curve].store(&mut state.out[curve]);
            self.lag(simd, curve).leave(now[curve], now[curve]).store(&mut state.left[curve]);
        }
        state
    }

    /// What the generators are fed with by a ramp.
    #[inline(always)]
    pub fn feed<L: Simd>(&self, simd: L, ramp: Lanes<S>) -> Fed<S> {
        let near = S::Vector::<L>::from_slice(simd, &ramp.0);
        let far = S::Vector::<L>::simd_from(simd, S::ONE) - near;
        let mut fed = Fed::default();
        S::Double::<L>::of(near, far).store(&mut fed.ends);
        if let Curves::Broken(bank) = &*self.curves {
            fed.places = [bank.place::<L>(near), bank.place::<L>(far)];
        }
        fed
    }

    /// A step later, fed with `fed` at its end.
    #[inline(always)]
    pub fn step<L: Simd>(&self, simd: L, state: &mut AxisState<S>, fed: &Fed<S>) {
        let now = self.inputs::<L>(simd, fed);
        for curve in 0..CURVES {
            let lag = self.lag(simd, curve);
            let out = lag.end(S::Double::<L>::load(simd, &state.left[curve]), now[curve]);
            out.store(&mut state.out[curve]);
            lag.leave(out, now[curve]).store(&mut state.left[curve]);
        }
    }

    #[inline(always)]
    fn lag<L: Simd>(&self, simd: L, curve: usize) -> LagStep<S::Double<L>> {
        self.lags[curve].each(|figure| S::Double::<L>::load(simd, &figure))
    }

    #[inline(always)]
    fn inputs<L: Simd>(&self, simd: L, fed: &Fed<S>) -> [S::Double<L>; CURVES] {
        let ends = S::Double::<L>::load(simd, &fed.ends);
        let one = S::Double::<L>::splat(simd, S::ONE);
        let bow = ends * (one - ends);
        let mut out = self.curves.at::<L>(simd, ends, &fed.places);
        for curve in 0..CURVES {
            out[curve] = out[curve] + bow * S::Double::<L>::load(simd, &self.bows[curve]);
        }
        out
    }
}

impl<S: Real> Curves<S> {
    /// Each scaled to its peak.
    fn new(segments: Option<u32>, knee: f64) -> Self {
        let Some(segments) = segments else {
            let scaled = |order: usize| NEAR[order].map(|power| S::from_f64(power / PEAKS[order]));
            let slope =
                |order: usize| derivative(NEAR[order]).map(|power| S::from_f64(power / SLOPE_PEAKS[order]));
            return Self::Exact([0, 1, 2].map(scaled), [0, 1, 2].map(slope));
        };
        Self::Broken(FunctionBank::new(&broken(segments, knee)))
    }

    #[inline(always)]
    fn at<L: Simd>(&self, simd: L, fed: S::Double<L>, places: &[BankPlace<S>; 2]) -> [S::Double<L>; CURVES] {
        let mut out = [fed; CURVES];
        match self {
            Self::Broken(bank) => {
                let [near, far] = [bank.at::<L>(simd, &places[0]), bank.at::<L>(simd, &places[1])];
                for curve in 0..CURVES {
                    out[curve] = S::Double::<L>::of(near[curve], far[curve]);
                }
            }
            Self::Exact(values, slopes) => {
                for order in 0..3 {
                    out[order] = polynomial(simd, &values[order], fed);
                    out[3 + order] = polynomial(simd, &slopes[order], fed);
                }
            }
        }
        out
    }
}

/// The broken lines of values and of slopes, each scaled to its peak.
fn broken<S: Real>(segments: u32, knee: f64) -> [FunctionGenerator<S>; CURVES] {
    let law = FunctionLaw { segments: segments as usize, rounding: knee, ends: Ends::Trimmed([0.0; 2]) };
    std::array::from_fn(|curve| {
        let order = curve % 3;
        let share = |z| {
            if curve < 3 {
                values(z)[order] / PEAKS[order]
            } else {
                derivatives(z)[order] / SLOPE_PEAKS[order]
            }
        };
        FunctionGenerator::new(&law, share)
    })
}

/// Points of the broken lines of a model at equal distances over 0..=1, shares of their peaks: values of the three orders, then
/// slopes. None where function generators are exact.
pub fn broken_lines(parts: &AnalogParts) -> Vec<Vec<f64>> {
    let figures = &parts.function_generator;
    let Some(segments) = figures.segments else { return Vec::new() };
    broken::<f64>(segments, figures.rounding / parts.full_scale).map(|line| line.points()).into()
}

/// A polynomial of ascending `powers`, by Horner's scheme.
#[inline(always)]
fn polynomial<L: Simd, S: Real, const N: usize>(simd: L, powers: &[S; N], z: S::Double<L>) -> S::Double<L> {
    let mut sum = S::Double::<L>::splat(simd, powers[N - 1]);
    for &power in powers[..N - 1].iter().rev() {
        sum = sum * z + S::Double::<L>::splat(simd, power);
    }
    sum
}

fn derivative(powers: [f64; 6]) -> [f64; 5] {
    std::array::from_fn(|n| powers[n + 1] * (n + 1) as f64)
}
