//! A video switch of real parts, at the samples.

use fearless_simd::prelude::{Select, SimdBase, SimdFrom};
use fearless_simd::{Level, Simd, dispatch};
use hardware_model::CROSSTALK_FREQUENCY;
use parts::{Delay, HighPass, Spread, Switch, SwitchLaw, relative_sigma};
use signal::{Lanes, Number, Real};

use crate::of_parts::mixer::Figures;

/// A switch with what its fade and its ways do; what is `None` is not there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FadingSwitch<S> {
    pub part: Switch<S>,
    /// Length of the transition (steps).
    pub transition: f64,
    /// Delay of S against C.
    pub late: Option<Delay>,
    crosstalk: Option<HighPass<S>>,
}

/// What comes through of the two inputs while they are off: one value a sample; empty without crosstalk.
#[derive(Debug, Clone, Default)]
pub(crate) struct Leaks<S> {
    of_c: Vec<Lanes<S>>,
    of_s: Vec<Lanes<S>>,
}

impl<S: Real> FadingSwitch<S> {
    /// The switch called `name` for samples that are `h` seconds apart.
    pub fn new(h: f64, figures: &Figures<'_>, name: &str) -> Self {
        let parts = &figures.parts.video_switch;
        let draw = |figure: &str, nominal: f64| {
            figures.draw(&format!("{name}.{figure}"), nominal, relative_sigma::SWITCH_DELAY)
        };
        let error = |figure: &str, sigma: f64| {
            let spread: &Spread = &figures.spread;
            spread.error(&format!("{name}.{figure}"), 0, sigma)
        };
        let law = SwitchLaw {
            gain_mismatch: error("gain", parts.gain_mismatch),
            level_mismatch: error("level", parts.level_mismatch),
        };
        Self {
            part: Switch::new(&law),
            transition: draw("time", parts.time) / h,
            late: (parts.delay_mismatch > 0.0).then(|| Delay::new(h, draw("delay", parts.delay_mismatch))),
            crosstalk: parts.crosstalk.map(|share| HighPass::of_share(h, share, CROSSTALK_FREQUENCY)),
        }
    }

    /// Crosstalk of both inputs; `s` is `None` where S is black.
    pub fn leak(&self, c: &[Lanes<S>], s: Option<&[Lanes<S>]>, leaks: &mut Leaks<S>) {
        let Leaks { of_c, of_s } = leaks;
        of_c.clear();
        of_s.clear();
        if let Some(part) = &self.crosstalk {
            of_c.resize(c.len(), Lanes::default());
            of_s.resize(c.len(), Lanes::default());
            dispatch!(Level::new(), simd => through(simd, part, c, of_c));
            if let Some(s) = s {
                dispatch!(Level::new(), simd => through(simd, part, s, of_s));
            }
        }
    }

    /// The output at every sample, into `c`; `s` is `None` where S is black.
    pub fn run(&self, fades: &[Lanes<S>], s: Option<&[Lanes<S>]>, leaks: &Leaks<S>, c: &mut [Lanes<S>]) {
        dispatch!(Level::new(), simd => self.run_wide(simd, fades, s, leaks, c));
    }

    #[inline(always)]
    fn run_wide<L: Simd>(
        &self,
        simd: L,
        fades: &[Lanes<S>],
        s: Option<&[Lanes<S>]>,
        leaks: &Leaks<S>,
        c: &mut [Lanes<S>],
    ) {
        let black = Lanes::default();
        for (sample, (value, g)) in c.iter_mut().zip(fades).enumerate() {
            let s = s.map_or(&black, |s| &s[sample]);
            let [g, c, s] = [vector::<L, S>(simd, g), vector::<L, S>(simd, value), vector::<L, S>(simd, s)];
            self.part.output(g, c, s).store_slice(&mut value.0);
        }
        for (value, (g, (of_c, of_s))) in
            c.iter_mut().zip(fades.iter().zip(leaks.of_c.iter().zip(&leaks.of_s)))
        {
            let [g, of_c, of_s] =
                [vector::<L, S>(simd, g), vector::<L, S>(simd, of_c), vector::<L, S>(simd, of_s)];
            (vector::<L, S>(simd, value) + Switch::<S>::leak(g, of_c, of_s)).store_slice(&mut value.0);
        }
    }

    /// One value of a lane within the step to `sample`.
    pub fn output(&self, [g, c, s]: [f64; 3], leaks: &Leaks<S>, sample: usize, lane: usize) -> f64 {
        let of = |leak: &[Lanes<S>]| leak.get(sample).map_or(S::ZERO, |leak| leak[lane]);
        let [g, c, s] = [g, c, s].map(S::from_f64);
        (self.part.output(g, c, s) + Switch::<S>::leak(g, of(&leaks.of_c), of(&leaks.of_s))).to_f64()
    }
}

/// What a high pass lets through of the video of a signal.
#[inline(always)]
fn through<L: Simd, S: Real>(simd: L, part: &HighPass<S>, signal: &[Lanes<S>], leak: &mut [Lanes<S>]) {
    let Some(first) = signal.first() else { return };
    let (mut before, mut y) = (limited::<L, S>(simd, first), S::Vector::<L>::simd_from(simd, S::ZERO));
    for (now, leak) in signal.iter().zip(leak) {
        let now = limited::<L, S>(simd, now);
        y = part.step(y, before, now);
        before = now;
        y.store_slice(&mut leak.0);
    }
}

/// Holds a signal to black and white, the ends of the video; what is not a number is black.
pub(crate) fn limit<S: Real>(signal: &mut [Lanes<S>]) {
    dispatch!(Level::new(), simd => {
        for value in &mut *signal {
            limited::<_, S>(simd, value).store_slice(&mut value.0);
        }
    });
}

#[inline(always)]
fn limited<L: Simd, S: Real>(simd: L, value: &Lanes<S>) -> S::Vector<L> {
    let (black, white) = (S::Vector::<L>::simd_from(simd, S::ZERO), S::Vector::<L>::simd_from(simd, S::ONE));
    let value = vector::<L, S>(simd, value).at_least(black);
    value.simd_gt(white).select(white, value)
}

#[inline(always)]
fn vector<L: Simd, S: Real>(simd: L, lanes: &Lanes<S>) -> S::Vector<L> {
    S::Vector::from_slice(simd, &lanes.0)
}
