//! Sweep space as a picture: one signal of the display over several sweeps.

use std::ops::Range;

use picture::{SOFTWARE, encode_png};
use scenario::Display;
use scope::{Choice, Looking, ScopeError, Written, sweep_space};
use signal::{Axis, Signal};

use super::{ProbeCommand, Target};
use command_line::Failure;

/// The signal of the display that `patterns` choose for a picture, if it is one alone.
pub fn of_display<'a>(target: Target, table: &'a [Signal], patterns: &[String]) -> Option<&'a Signal> {
    let is_chosen = |signal: &&Signal| patterns.iter().any(|pattern| signal.matches(pattern));
    let mut chosen = table.iter().filter(is_chosen);
    let first = chosen.next().filter(|signal| target == Target::Picture && signal.axis == Axis::Display)?;
    chosen.next().is_none().then_some(first)
}

impl ProbeCommand {
    /// A picture shows one sweep, or a signal of the display over several; the latter as PNG, without options of the scope.
    pub fn expect_one_sweep(
        &self,
        target: Target,
        sweeps: Range<u32>,
        is_of_display: bool,
    ) -> Result<(), Failure> {
        if target != Target::Picture || sweeps.len() == 1 {
            return Ok(());
        }
        let span = self.sweep;
        if !is_of_display {
            return Err(Failure::usage(format!(
                "--sweep {span}: a picture shows one sweep, or one signal of the display over several, as sm.write; expected one of these"
            )));
        }
        if let Some(option) = self.scope.given() {
            return Err(Failure::usage(format!(
                "{option}: a picture of several sweeps is no page of the scope; expected one sweep, or no such option"
            )));
        }
        let is_png = self.out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
        match is_png {
            true => Ok(()),
            false => Err(Failure::usage(format!(
                "--out {}: a picture of several sweeps is a PNG; expected a name that ends in .png",
                self.out.display()
            ))),
        }
    }

    /// Draws one signal of the display, a column a sweep.
    pub fn draw_raster(
        &self,
        look: &dyn Looking,
        choice: &Choice,
        sweeps: Range<u32>,
        display: &Display,
    ) -> Result<Written, Failure> {
        let names = choice.names().into_iter().map(str::to_owned).collect();
        let waveforms = look.at(names, sweeps)?;
        let picture = sweep_space(&waveforms, &choice.wires[0].signal, display)?;
        let text = format!("frame {}: {}, a column a sweep", self.chosen.frame, choice.names()[0]);
        let png = encode_png(&picture, &[SOFTWARE, ("Description", &text)]).map_err(ScopeError::Picture)?;
        files::write_atomic(&self.out, |out| out.write_all(&png))?;
        Ok(Written { estimate: 0, files: vec![self.out.clone()] })
    }
}
