//! `exact`: the same picture by closed form and root finding in f64, independent of ramps, registers, sweeps and
//! sampling. The error of a machine is its difference from this.
//!
//! ```text
//!  landscape, finest level ---> Ceilings (once a stage) --+
//!  eye, curvature, near, far ----------------------------+--> Outlook --> first meeting --> slopes --> Lambert
//!  pixel place x, y --> View (projection law) --> Ray ----+                (range)                  |
//!                                                                                    pixel rule --> planes
//! ```
//!
//! # Law
//!
//! - **Pixels.** View-plane at distance 1. The centre of column i lies at `x = tan_half_width (2i + 1 - columns) /
//!   columns`; line j covers y, positive down, from `tan_half_height (2j / lines - 1)` to the same of `j + 1`.
//! - **Rays** (15.3, inverted), theta the pitch:
//!   `Exact`: forward `cos theta + y sin theta`, starboard `x`, down `y cos theta - sin theta`;
//!   `AsReported`: azimuth `heading + atan x`, elevation `theta - atan y`;
//!   `Corrected`: the same azimuth, `tan eta = -y cos(atan x)`.
//! - **Ground.** At arc s along the azimuth: h of the finest level, less `s^2 / 2R` if the lunoid curves (15.4).
//!   The ray with `t = tan eta` meets it at the first root of `G(s) = h(s) - s^2 / 2R - H - t s` from the near range
//!   to the far range or the edge of the problem area: the highest elevation so far, that is the ideal form of
//!   both occultation laws (15.2).
//! - **Intensity.** `albedo max(n.s, 0)` from the exact slopes there (7); 0 in the sky.
//! - **Pixel rule.** `Centre`: one ray. `LineMean`: the mean over the line's height at the column's centre, by
//!   adaptive quadrature to [`LINE_MEAN_TOLERANCE`].
//! - **Planes.** `intensity`; `range` (m) at the pixel's centre, infinite where no ground is drawn.
//!
//! # Method
//!
//! Within a region G is a polynomial of degree 10. A plane above each region, from the patch's Bernstein control
//! heights, tells most regions that the ray stays above them. Else G is taken in Bernstein form: coefficients of
//! one sign prove that there is no root, one change of sign proves one root (Newton within its bracket), and
//! anything else is halved. A touch that 50 halvings cannot tell from a root counts as one. Nothing is sampled, so
//! no ridge is stepped over; roots are good to rounding, 1e-12 of the range but where the ray only grazes.
//! Where a column has one azimuth, a ray starts where the one below it ended.
//!
//! # Timing
//!
//! No clocks, no state between frames. Columns are drawn by the threads of the current rayon pool, each column
//! by itself: the bits do not depend on the number of threads. `samples` of the frame's counts are rays.
//!
//! # Not modelled
//!
//! Parts, words, scalar type, loader, sweeps, sweep memory: whatever makes a machine a machine. Roll: the yoke is
//! upright. Coarser levels. Nothing can be probed.
//!
//! # Our choices
//!
//! - Ground nearer than the machine's first sample is not drawn: a ray that is under the ground there shows 0 and
//!   range infinity, and such ground hides nothing.
//! - Beyond the edge of the problem area there is nothing: sky.
//! - An eye outside the area or not above its ground is refused; so is |pitch| + half the vertical field of view of
//!   80 degrees or more, under every projection law.
//! - A raster is what the planes hold.
//!
//! # See also
//!
//! `tests/pictures`: planes, the lunoid's horizon and a hidden valley in closed form; every pixel of random scenes
//! against marching along its ray.

mod bernstein;
mod buckets;
mod ceilings;
mod column;
mod craters;
mod ground;
mod light;
mod line;
mod outlook;
mod patch;
mod profile;
mod relief;
mod rings;
mod scene;
mod seen;
mod session;
mod shadow;
mod standing;
mod view;
mod walk;

pub use ceilings::Ceilings;
pub use column::{LINE_MEAN_TOLERANCE, RIDGE_SHARE};
pub use outlook::{Outlook, Ray, Sight, Spot};
pub use session::Exact;
pub use shadow::LIFT;
pub use standing::FOOT_TOLERANCE;
pub use view::View;
