//! Why a path cannot be driven over a landscape.

use std::fmt;
use std::ops::Range;

use quantities::degrees;

use crate::Path;

/// What is wrong with a pose.
#[derive(Debug, Clone, PartialEq)]
pub enum PoseFault {
    /// The vehicle is not over the problem area.
    Outside {
        /// Its centre still is, but not all of its wheels.
        wheels: bool,
        /// South, west, north, east edge of the area (m).
        extent: [f64; 4],
    },
    /// A wheel stands where the survey had no data.
    NoData {
        /// The wheel: north, east (m).
        wheel: [f64; 2],
    },
    /// The path puts the eye into the ground.
    EyeUnderGround {
        /// Height of the eye (m).
        eye: f64,
        /// Height of the ground (m).
        ground: f64,
    },
    /// What a closed loop has driven has no pose at the time of the frame.
    NotDriven,
    /// Pitch or roll that no vehicle has.
    Tilt {
        /// Name of the angle: "pitch" or "roll".
        what: &'static str,
        /// Angle that the vehicle would have (rad).
        found: f64,
        /// Allowed, either way (rad).
        allowed: f64,
    },
}

/// One stretch of frames with one kind of fault; the numbers are those of its first frame.
#[derive(Debug, Clone, PartialEq)]
pub struct PathProblem {
    /// Fault that makes the path impossible to drive.
    pub fault: PoseFault,
    /// Frames of the whole stretch.
    pub frames: Range<u64>,
    /// Time of the first frame (s).
    pub time: f64,
    /// Where the vehicle is then: north, east (m).
    pub at: [f64; 2],
}

/// All stretches; never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct PathProblems {
    path: String,
    list: Vec<PathProblem>,
}

impl PathProblems {
    /// Joins faults of single frames of `path`, ascending, into stretches.
    pub(crate) fn of(path: &Path, faults: impl Iterator<Item = (u64, PathProblem)>) -> Result<(), Self> {
        let mut list: Vec<PathProblem> = Vec::new();
        for (frame, problem) in faults {
            match list.last_mut() {
                Some(last) if last.continues_with(frame, &problem) => last.frames.end = frame + 1,
                _ => list.push(problem),
            }
        }
        if list.is_empty() { Ok(()) } else { Err(Self { path: path.name().into(), list }) }
    }

    /// One problem of `path`.
    pub(crate) fn one(path: &Path, problem: PathProblem) -> Self {
        Self { path: path.name().into(), list: vec![problem] }
    }

    /// What the path is called: the file that says it.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// One after the other, in order of time.
    pub fn iter(&self) -> impl Iterator<Item = &PathProblem> {
        self.list.iter()
    }
}

impl PathProblem {
    fn continues_with(&self, frame: u64, next: &Self) -> bool {
        self.frames.end == frame && std::mem::discriminant(&self.fault) == std::mem::discriminant(&next.fault)
    }
}

impl fmt::Display for PathProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Range { start, end }, [x, y]) = (&self.frames, self.at);
        write!(f, "frame {start} (t = {:.3} s, x = {x:.2} m, y = {y:.2} m): ", self.time)?;
        match &self.fault {
            PoseFault::Outside { wheels, extent: [south, west, north, east] } => {
                let who = if *wheels { "a wheel" } else { "the vehicle" };
                write!(f, "{who} is outside the problem area, expected x {south}..{north} m, ")?;
                write!(f, "y {west}..{east} m; change the path or enlarge the landscape")?;
                if (*south..=*north).contains(&y) && (*west..=*east).contains(&x) {
                    write!(f, "; with x (north) and y (east) exchanged the place would be inside")?;
                }
            }
            PoseFault::NoData { wheel: [x, y] } => {
                write!(
                    f,
                    "no data under a wheel at x = {x:.2} m, y = {y:.2} m: the survey filled a hole there; "
                )?;
                write!(f, "lead the path around it")?;
            }
            PoseFault::NotDriven => {
                write!(
                    f,
                    "no row of this time, expected one pose a frame, at its number over the update rate; "
                )?;
                write!(
                    f,
                    "shorten the mission or update at the rate of the rows; poses that lie apart belong into path.file"
                )?;
            }
            PoseFault::EyeUnderGround { eye, ground } => {
                write!(f, "eye under ground, z = {eye:.3} m where the ground is at {ground:.3} m; ")?;
                write!(f, "raise z_m, or leave it empty to stand on the ground")?;
            }
            PoseFault::Tilt { what, found, allowed } => {
                let (found, allowed) = (degrees(*found), degrees(*allowed));
                write!(f, "{what} of {found:.1} deg, expected at most {allowed:.0} deg either way; ")?;
                write!(f, "choose gentler ground or check the {what}")?;
            }
        }
        if end - start > 1 { write!(f, " (frames {start}..{end})") } else { Ok(()) }
    }
}

impl fmt::Display for PathProblems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> =
            self.list.iter().map(|problem| format!("{}: {problem}", self.path)).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for PathProblems {}
