//! The program of a thesis of the Naval Postgraduate School: a photograph over posts, seen from elsewhere. Each finding about its listing is a switch.
//!
//! ```text
//!  Posts --> voids filled --> georectangular --+--> pixels of the photograph --> greys of panels --+
//!                                              |                                                   v
//!  View --> axes --> projection ---------------+--> clip or discard --> fill --> depth buffer --> Picture
//!                                                                     five ways
//! ```
//!
//! # Law
//!
//! - **Repaired.** With no switch on: a camera of any attitude, greys over triangles of pixels, clipping before the division, 1/w, each pixel of a closed
//!   mesh once, by the top-left rule. The picture is that of the scene sampler with one sampling point a pixel and one light a panel, but for ground that
//!   hides from the photograph: the program paints through it.
//! - **As written.** [`Restrictions`] says what each switch does. Each works alone and with any other.
//! - **24 bits** are those of variables as they are stored: coordinates, axes, distances, columns of an edge. Sums between them have 53.
//! - **Fill.** The five ways of [`Fill`] find the same pixels. With both ends of a span the listing's own fill is the only one.
//! - **Order.** Panels are drawn one after the other; of equally near ones the first stays.
//!
//! Lengths are in metres, angles in radians. Places of a scenario are north, east, up; screens begin at the top left corner.
//!
//! # Not modelled
//!
//! The listing stores latitudes and longitudes in 24 bits too, which moves places by up to a metre: the panel counts of the specification are those
//! without. Arrays of the listing count from 1, and its photograph is read with numbers that count from 0: one pixel beside. A panel of one row of whole-number
//! corners makes the listing read before its edge list; here it has no pixel. Time: pieces of work are counted ([`Work`]); the crate `panels` gives them seconds.
//!
//! # See also
//!
//! `tests/panel_program`: check values of the specification, each switch alone, five ways to fill. `examples/fill_cost.rs` counts what they cost.

mod blend;
mod canvas;
mod depth;
mod error;
mod fill;
mod frame;
mod lie;
mod limits;
mod picture;
mod posts;
mod program;
mod real;
mod reference;
mod restrictions;
mod screen;
mod view;
mod work;

pub use canvas::Look;
pub use depth::{DepthPlane, NoDepth};
pub use error::ProgramError;
pub use fill::written::WrittenFill;
pub use fill::{Fill, FillWork, Filler};
pub use lie::Lie;
pub use limits::{MOST_PANELS, MOST_ROWS, SIDE};
pub use picture::{Counts, NO_PANEL, Picture};
pub use posts::Posts;
pub use program::{Panel, Program, Settings};
pub use reference::Grey;
pub use restrictions::{Restrictions, Switch};
pub use view::View;
pub use work::{FillPieces, Work};
