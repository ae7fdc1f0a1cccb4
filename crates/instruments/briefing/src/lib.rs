//! A mission briefing: frames of a flight, each beside a map with the course, the eye's place and the angle of view.
//!
//! ```text
//!  stage --> map: photographs over the ground, or its light --+
//!  course --> line: flown, still to fly ----------------------+--> Briefing --> page: frame | map
//!  pose --> disc, two rays -----------------------------------+
//! ```
//!
//! # Law
//!
//! - **Map.** North is up. Its scale is the largest at which all the ground fits into the size of a frame. A pixel has the light that photographs show in its
//!   square of the ground; ground that none shows is black. A landscape without photographs has the light of the scenario's sun, without cast shadow, seen from above.
//! - **Course.** Straight lines between the eyes of all frames, dark where it is still to fly.
//! - **Angle of view.** Two rays to both sides of the heading, each as far from it as the edges of a level picture. Pitch and roll are not drawn.
//!
//! # See also
//!
//! `tests/briefing`: places on the map, north, course, rays. `lunoid photo brief` makes the film.

mod error;
mod map;
mod marks;
mod page;

pub use error::BriefingError;
pub use map::Place;
pub use page::Briefing;
