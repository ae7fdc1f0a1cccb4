//! Which sweeps of which frames a replay records.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use generator::Generator;

use text::Span;

use crate::RequestError;

/// Signals that are recorded where none are named: one of each block, those that are there; all of a generator that has
/// none of them.
const USUAL: [&str; 8] = [
    "mu.height",
    "tg.height",
    "mu.reflectivity",
    "dpp.elevation",
    "dpp.hold",
    "dpp.blank",
    "sc.gate",
    "dpp.y",
];

/// Plots that are drawn without being asked twice.
const MOST_PLOTS: u64 = 200;

/// Sweeps of a frame to record, read from `FRAME:SWEEP[..SWEEP][:SIGNALS]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Request {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Patterns of signals; empty for the usual ones.
    patterns: Vec<String>,
    sweeps: Span,
}

impl FromStr for Request {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "expected FRAME:SWEEP, FRAME:SWEEP..SWEEP or FRAME:SWEEP:SIGNALS, as 12:500 or '12:500:tg.*,dpp.y', not `{text}`"
            )
        };
        let mut parts = text.splitn(3, ':');
        let frame = parts.next().and_then(|frame| frame.trim().parse().ok()).ok_or_else(wrong)?;
        let sweeps: Span = parts.next().ok_or_else(wrong)?.trim().parse().map_err(|_| wrong())?;
        let patterns = match parts.next() {
            None => Vec::new(),
            Some(list) => list.split(',').map(|pattern| pattern.trim().to_owned()).collect(),
        };
        Ok(Self { frame, patterns, sweeps })
    }
}

impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "--probe {}:{}", self.frame, self.sweeps)
    }
}

impl Request {
    /// Patterns of signals that are named; none are where the usual ones are meant.
    pub fn named(&self) -> &[String] {
        &self.patterns
    }

    /// Patterns of the signals to record of `generator`.
    pub fn patterns(&self, generator: &dyn Generator) -> Vec<String> {
        let is_there = |name: &&str| generator.signals().iter().any(|signal| signal.name == *name);
        let usual: Vec<String> =
            USUAL.iter().filter(|name| is_there(name)).map(|name| (*name).into()).collect();
        match (self.patterns.is_empty(), usual.is_empty()) {
            (false, _) => self.patterns.clone(),
            (true, false) => usual,
            (true, true) => vec!["*".into()],
        }
    }

    /// The sweeps, of a frame of `all`.
    pub fn sweeps(&self, all: u32) -> Option<Range<u64>> {
        self.sweeps.within(&(0..u64::from(all)))
    }
}

/// Sees that `requests` can be met by a run of `frames`, `sweeps` a frame, by `generator`, before anything is drawn.
///
/// # Errors
/// The first thing that is wrong with them.
pub fn check(
    requests: &[Request],
    frames: &Range<u64>,
    sweeps: u32,
    generator: &dyn Generator,
) -> Result<(), RequestError> {
    let signals = generator.signals();
    let mut plots = 0;
    for request in requests {
        if signals.is_empty() {
            let (request, generator) = (request.to_string(), generator.name());
            return Err(RequestError::NoSignals { request, generator });
        }
        if !frames.contains(&request.frame) {
            return Err(RequestError::NoFrame { request: request.to_string(), frames: frames.clone() });
        }
        let range = request.sweeps(sweeps);
        let range = range.ok_or_else(|| RequestError::NoSweeps { request: request.to_string(), sweeps })?;
        let is_known = |pattern: &&String| !signals.iter().any(|signal| signal.matches(pattern));
        if let Some(pattern) = request.patterns.iter().find(is_known) {
            let (request, pattern) = (request.to_string(), pattern.clone());
            return Err(RequestError::Unknown { request, pattern });
        }
        plots += range.end - range.start;
    }
    match plots > MOST_PLOTS {
        true => Err(RequestError::TooMany { found: plots, most: MOST_PLOTS }),
        false => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use generator::Generator;
    use hardware_model::HardwareModel;
    use machine::HybridMachine;
    use scenario::Scenario;

    use super::{Request, check};

    /// Returns the machine of the ideal model over a small generated ground.
    fn machine() -> HybridMachine {
        let text = "format = 1\ntitle = 't'\nshows = 's'\nframes = 1\n[landscape.generated]\nseed = 1\n\
                    extent_m = [600, 640]\nregion_size_m = 40\n[sun]\nazimuth_deg = 10\nelevation_deg = 12\n\
                    [path]\nkeyframes = [{ t_s = 0, x_m = 100, y_m = 300 }]\n";
        let scenario = Scenario::parse("t.toml", text).unwrap_or_else(|problems| panic!("{problems}"));
        HybridMachine::new(front_door::settings(&scenario, &HardwareModel::ideal()).unwrap())
    }

    /// A generator of the registry as it ships.
    fn guest(name: &str) -> Arc<dyn Generator> {
        registry::configure_with(registry::find(name).unwrap(), &[]).unwrap()
    }

    fn request(text: &str) -> Request {
        text.parse().expect(text)
    }

    #[test]
    fn spellings() {
        let one = request("12:500");
        assert_eq!((one.frame, one.sweeps(525)), (12, Some(500..501)));
        assert_eq!(one.patterns(&machine()).len(), 8);
        assert_eq!(one.patterns(&*guest("lunsim")), ["*"]);
        assert_eq!(request("0:3..5").sweeps(40), Some(3..5));
        assert_eq!(request("0:39..").sweeps(40), Some(39..40));
        assert_eq!(request("0:40").sweeps(40), None);
        assert_eq!(request("1:2:tg.*, dpp.y").patterns(&machine()), ["tg.*", "dpp.y"]);
        for wrong in ["", "12", "12:", ":500", "a:1", "1:b", "-1:2", "1:3..3"] {
            assert!(wrong.parse::<Request>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn what_cannot_be_recorded_is_refused() {
        let checked = |text: &str| check(&[request(text)], &(10..20), 525, &machine()).is_ok();
        assert!(checked("10:0") && checked("19:524") && checked("12:0..200"));
        for wrong in ["9:0", "20:0", "10:525", "10:524..526", "10:0:nothing", "10:0:", "10:0..201"] {
            assert!(!checked(wrong), "{wrong}");
        }
        assert!(check(&[request("10:0")], &(10..20), 525, &*guest("exact")).is_err());
        let of_lunsim = |text: &str| check(&[request(text)], &(10..20), 64, &*guest("lunsim")).is_ok();
        assert!(of_lunsim("10:0") && of_lunsim("10:63:lunsim.height"));
        assert!(!of_lunsim("10:64") && !of_lunsim("10:0:tg.height"));
        assert!(check(&[], &(10..20), 525, &*guest("exact")).is_ok());
    }
}
