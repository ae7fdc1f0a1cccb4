//! What a long command shows while it runs: a bar on a terminal, else a line every five seconds.

use std::fmt::Write;
use std::io::{self, IsTerminal};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use replay::Progress;

use crate::output::tell;

/// Time between two plain lines.
const EVERY: Duration = Duration::from_secs(5);

/// What a long command says while it runs, and how it tells what came of it.
#[derive(Debug, Args)]
pub struct Saying {
    /// Do not show any progress.
    #[arg(long)]
    pub no_progress: bool,
    /// Say nothing but errors.
    #[arg(short, long)]
    pub quiet: bool,
    /// Print what came of it as JSON.
    #[arg(long)]
    pub json: bool,
}

impl Saying {
    /// Shows progress, if that is wanted.
    pub fn display(&self) -> Display {
        Display::new(!self.no_progress && !self.quiet)
    }
}

/// Shows the frames of a replay.
pub enum Display {
    /// Shows no progress at all.
    Off,
    /// A bar with rate and remaining time.
    Bar(ProgressBar),
    /// Plain lines, for logs.
    Lines(Mutex<Lines>),
}

/// State of the plain lines.
pub struct Lines {
    what: &'static str,
    frames: u64,
    kept: u64,
    began: Instant,
    last: Instant,
}

impl Display {
    /// The right one for standard error, or none.
    pub fn new(wanted: bool) -> Self {
        match (wanted, io::stderr().is_terminal()) {
            (false, _) => Self::Off,
            (true, true) => Self::Bar(bar()),
            (true, false) => {
                let now = Instant::now();
                Self::Lines(Mutex::new(Lines { what: "frames", frames: 0, kept: 0, began: now, last: now }))
            }
        }
    }

    /// Hears of the run.
    pub fn hear(&self, progress: Progress) {
        match self {
            Self::Off => {}
            Self::Bar(bar) => hear_bar(bar, progress),
            Self::Lines(lines) => lines.lock().unwrap_or_else(PoisonError::into_inner).hear(progress),
        }
    }

    /// Takes the bar away.
    pub fn end(&self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    let template = "{msg} {bar:30} {pos}/{len}  {rate}  {eta} left";
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    bar.set_style(style.with_key("rate", |state: &ProgressState, out: &mut dyn Write| {
        // Nothing can be done about a terminal that takes no text.
        let _ = write!(out, "{} frames/s", text::rate(state.per_sec()));
    }));
    bar
}

fn hear_bar(bar: &ProgressBar, progress: Progress) {
    match progress {
        Progress::Verifying { frames } => {
            bar.set_length(frames);
            bar.set_message("verifying");
        }
        Progress::Begins { what, frames, kept } => {
            bar.set_length(frames);
            bar.set_position(kept);
            bar.reset_eta();
            bar.set_message(what);
        }
        Progress::Frame { done } => bar.set_position(done),
        Progress::Finishing => bar.set_message("finishing"),
    }
}

impl Lines {
    fn hear(&mut self, progress: Progress) {
        match progress {
            Progress::Begins { what, frames, kept } => {
                let now = Instant::now();
                *self = Self { what, frames, kept, began: now, last: now };
            }
            Progress::Frame { done } if self.last.elapsed() >= EVERY => {
                self.last = Instant::now();
                tell(&(self.line(done, self.began.elapsed().as_secs_f64()) + "\n"));
            }
            _ => {}
        }
    }

    fn line(&self, done: u64, seconds: f64) -> String {
        let rate = done.saturating_sub(self.kept) as f64 / seconds.max(1e-9);
        let (percent, left) = (100 * done / self.frames.max(1), (self.frames - done.min(self.frames)) as f64);
        let eta = if rate > 0.0 { format!("{:.0} s", left / rate) } else { "unknown".into() };
        let rate = text::rate(rate);
        format!("{} {done}/{}  {percent} %  {rate} frames/s  eta {eta}", self.what, self.frames)
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use super::Lines;

    #[test]
    fn a_line_tells_share_rate_and_remaining_time() {
        let now = Instant::now();
        let lines = Lines { what: "frames", frames: 600, kept: 20, began: now, last: now };
        assert_eq!(lines.line(120, 10.0), "frames 120/600  20 %  10.0 frames/s  eta 48 s");
        assert_eq!(lines.line(20, 1.0), "frames 20/600  3 %  0.0 frames/s  eta unknown");
    }
}
