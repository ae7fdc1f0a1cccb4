//! What a user should know of faces that are allowed all the same.

use std::fmt;

use quantities::degrees;

/// Something that is allowed, but may not show what was meant.
#[derive(Debug, Clone, PartialEq)]
pub enum Warning {
    /// A face was dropped when its list was loaded.
    Dropped {
        /// Name of the list.
        list: String,
        /// Number of the face, from 0.
        face: usize,
        /// Why it was dropped.
        why: Degenerate,
    },
    /// A sun steps more than a sixteenth of a turn a frame.
    Stepping {
        /// Turn of one frame (radians).
        step: f64,
    },
    /// The trough of the waves is clamped to black.
    Clipped {
        /// Elevation of the sun plus angle of the normals (radians), below a quarter turn.
        sum: f64,
    },
    /// All normals of a pattern are vertical, so no sun gives contrast.
    NoContrast,
    /// The sun of a group stands below the horizon, so flat patterns are black.
    SunBelow {
        /// Elevation of the sun (radians).
        elevation: f64,
    },
    /// A ship moves beyond the limits of the study for landing and take-off.
    Beyond {
        /// Name of the motion.
        motion: &'static str,
        /// Largest angle that it can reach (radians).
        reaches: f64,
        /// Limit of the study (radians).
        limit: f64,
    },
}

/// Why a face has nothing to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Degenerate {
    /// Two of its corners lie at one place.
    RepeatedVertex,
    /// All its corners lie on one line.
    NoArea,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dropped { list, face, why } => {
                let why = match why {
                    Degenerate::RepeatedVertex => "two corners at one place",
                    Degenerate::NoArea => "no area",
                };
                write!(f, "list `{list}`, face {face}: {why}; the face is left out")
            }
            Self::Stepping { step } => {
                write!(f, "the sun turns {:.1} deg a frame: above 22.5 deg the steps show", degrees(*step))
            }
            Self::Clipped { sum } => write!(
                f,
                "sun and normals stand {:.1} deg high together: below 90 deg the troughs are clamped to black",
                degrees(*sum)
            ),
            Self::NoContrast => {
                write!(f, "all normals are vertical: the pattern has no contrast under any sun")
            }
            Self::SunBelow { elevation } => write!(
                f,
                "the sun of the group stands {:.1} deg below the horizon: flat patterns are black",
                -degrees(*elevation)
            ),
            Self::Beyond { motion, reaches, limit } => write!(
                f,
                "{motion} reaches {:.2} deg: the study's limit for landing and take-off is {:.1} deg",
                degrees(*reaches),
                degrees(*limit)
            ),
        }
    }
}
