//! Sun and Earth in the sky of a place on the Moon, at a date. Pure functions: no files, no clock.
//!
//! ```text
//! Instant (UTC) ─▶ terrestrial time ─┬─▶ Earth around the Sun (VSOP87, truncated) ─┐
//!                                    ├─▶ Moon around the Earth (ELP 2000-82, Meeus) ┴─▶ directions in the ICRF ─┐
//!                                    └─▶ pole and prime meridian of the Moon (IAU) ──────────▶ axes of the Moon ┴─▶ Sky
//! ```
//!
//! - [`Instant`]: a date and time in UTC, read from ISO 8601; [`InstantError`] says what is wrong with a text.
//! - [`Place`]: selenographic longitude and latitude (mean-Earth, polar-axis system, planetocentric) and radius.
//! - [`Sky`]: azimuth, elevation, distance and angular diameter of Sun and Earth, the Earth's phase, the sub-solar and the
//!   sub-Earth point.
//! - [`sun_direction`]: the sun over a place, where another place is known that has it overhead.
//! - [`icrf_to_local`]: directions of star catalogues as they stand over a place.
//!
//! Errors against JPL's DE421 with its own librations, over 1960 to 2050: docs/sun.md.

mod axes;
mod earth_orbit;
mod ecliptic;
mod instant;
mod moon_orbit;
mod sky;
mod sub_solar;
mod terrestrial_time;

pub use instant::{FIRST, Instant, InstantError, LAST};
pub use sky::{MOON_RADIUS, Place, Seen, Sky, icrf_to_local};
pub use sub_solar::{elevation_and_azimuth, sun_direction};
