//! A video switch of real parts, at the samples.

use hardware_model::CROSSTALK_FREQUENCY;
use parts::{Delay, HighPass, Spread, Switch, SwitchLaw, relative_sigma};
use signal::{Lanes, Real};

use crate::wired::mixer::{Figures, limited};

/// A switch with what its fade and its ways do; what is `None` is not there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FadingSwitch<S> {
    pub part: Switch<S>,
    /// Transition (steps).
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
        leaks.of_c.clear();
        leaks.of_s.clear();
        if let Some(part) = &self.crosstalk {
            through(part, c, &mut leaks.of_c);
            match s {
                Some(s) => through(part, s, &mut leaks.of_s),
                None => leaks.of_s.resize(c.len(), Lanes::default()),
            }
        }
    }

    /// The output at every sample, into `c`; `s` is `None` where S is black.
    pub fn run(&self, fades: &[Lanes<S>], s: Option<&[Lanes<S>]>, leaks: &Leaks<S>, c: &mut [Lanes<S>]) {
        let black = Lanes::default();
        for (sample, (value, &g)) in c.iter_mut().zip(fades).enumerate() {
            *value = self.part.output(g, *value, s.map_or(black, |s| s[sample]));
        }
        for (value, (&g, (&of_c, &of_s))) in
            c.iter_mut().zip(fades.iter().zip(leaks.of_c.iter().zip(&leaks.of_s)))
        {
            *value = *value + Switch::<S>::leak(g, of_c, of_s);
        }
    }

    /// One value of a lane within the step to `sample`.
    pub fn output(&self, [g, c, s]: [f64; 3], leaks: &Leaks<S>, sample: usize, lane: usize) -> f64 {
        let of = |leak: &[Lanes<S>]| leak.get(sample).map_or(S::ZERO, |leak| leak[lane]);
        let [g, c, s] = [g, c, s].map(S::from_f64);
        (self.part.output(g, c, s) + Switch::<S>::leak(g, of(&leaks.of_c), of(&leaks.of_s))).to_f64()
    }
}

fn through<S: Real>(part: &HighPass<S>, signal: &[Lanes<S>], leak: &mut Vec<Lanes<S>>) {
    let video = |value: &Lanes<S>| value.map(limited);
    let (mut before, mut y) = (signal.first().map(video).unwrap_or_default(), Lanes::default());
    leak.extend(signal.iter().map(video).map(|now| {
        y = part.step(y, before, now);
        before = now;
        y
    }));
}
