//! The vehicle's shadow, and its tracks, in an existing picture sequence: section IV of the report (section 19).
//!
//! The report's first goal was to complement the picture of a simulator that has a camera over a relief map. What such a
//! camera cannot see is the vehicle itself; its shadow is worked out from the vehicle's shape, the pose and the sun, and
//! taken out of the video.
//!
//! ```text
//!  shape --> string --> T F' + C --> four line types --> figures --> outlines --+   flat ground
//!               pose, sun --^             (clipped at D)                        v
//!                                                                     gates of each line --> method --> share of
//!  pose --> rays --> first meeting --> prisms behind the parts ----------------^           dark --> video
//!           ground data ---^           patches of track                             true ground
//! ```
//!
//! # Law
//!
//! - **String** (`CharacteristicFunction`, 19.2): ordered points in vehicle axes, each with a flag whether the line to
//!   the next is displayed. Each convex part contributes every edge once, joined by trace lines.
//! - **Chain** ([`Chain`], 19.3): `S'_i = T F'_i + C`, `T = R^T S R`, `C = R^T (S E - E)`, S along the sun's rays onto the
//!   plane W = 0. A picture without the vehicle's roll has its own `R^T` in front.
//! - **Line types** (`LineType`, 19.4): both ends beyond the view-plane, one, none, trace; clipped at U' = D.
//! - **Outlines** (19.5): the convex hull of each figure, every one by itself or walked around as a whole ([`outlines`]).
//! - **Gates** ([`Gate`]): stretches of a television line between its intersections with outlines, at its middle.
//! - **Error of flat ground** ([`flat_error`], 19.7): the angle between the edge that flat ground has and the true one; a
//!   [`Mast`] measures it.
//! - **True ground** ([`TrueGround`]): the first thing that each ray meets, `exact`'s way, and the regions behind the
//!   vehicle's convex parts, bounded by the faces that the sun lights and the outline that it sees.
//! - **Tracks**: patches of remote shadow on true ground, hidden where nearer ground or a body hides them.
//! - **Penumbra** ([`suns()`]): the mean of the shadows of [`SUN_POINTS`] points of the sun's disc.
//! - **Insertion** ([`Method`], 19.6): blanking at intersections, rounded to the places of a D/A converter; or an area
//!   written into a scan converter, which has a spot, an offset and a gain. A pixel keeps the share that is not dark.
//!
//! # Signals
//!
//! Television lines as waveforms ([`SIGNALS`]): video that comes, gates before and behind the converters, what is taken out, video
//! that goes. A line stands where a machine has a sweep, a column where it has a sample ([`Look`]).
//!
//! # Timing
//!
//! Nothing here is late: set-up and writing times of gear of 1969 are told ([`Work`]), not drawn. Lines of true ground are
//! worked out by the threads of the current rayon pool, each by itself: the bits do not depend on their number.
//!
//! # Not modelled
//!
//! Delay of the shadow by a computer that does not keep pace, comparators' and switches' errors, the camera's own lens
//! and gamma: shares are taken off the codes. The vehicle's parts that the camera sees. Light that others reflect into
//! the shadow. Ground with objects that move, open surfaces or suns of groups is refused by name.
//!
//! # Our choices
//!
//! - D is half as far as the nearest flat ground that the field could show.
//! - What lies under the ground casts nothing: lines begin where they come out of it.
//! - The vehicle turns about its eye, and the ground is level `eye_height` under it unless the poses tell a height.
//! - The walk inserts crossings as nodes, and walks around every group of figures that touch.
//! - The sun has 64 points.

mod augmentation;
mod blanking;
mod camera;
mod casters;
mod cells;
mod chain;
mod error;
mod flat_error;
mod flat_ground;
mod folder;
mod frame_work;
mod function;
mod gate;
mod hull;
mod insertion;
mod kept;
mod mast;
mod node_table;
mod outline;
mod poses;
mod prism;
mod probed;
mod sequence;
mod shadow;
mod shape;
mod shot;
mod stretch;
mod suns;
mod timing_record;
mod tracks;
mod true_ground;
mod view_lines;
mod work;

pub use augmentation::{Augmentation, GroundLaw};
pub use camera::Camera;
pub use chain::Chain;
pub use error::AugmentError;
pub use flat_error::{flat_error, small_flat_error};
pub use flat_ground::{OutlineRule, flat_gates, shadow_outlines};
pub use folder::{MadeFrom, ShadowFolder};
pub use frame_work::FrameWork;
pub use gate::Gate;
pub use insertion::{DAC_BITS, Method, ScanConverter, Shade};
pub use mast::{Mast, MastEdge};
pub use outline::outlines;
pub use poses::{FramePose, Poses, read_poses};
pub use probed::{Look, SIGNALS, line_timebase};
pub use sequence::Sequence;
pub use shadow::Shadow;
pub use shape::Shape;
pub use shot::Shot;
pub use suns::{SUN_HALF_ANGLE_DEG, SUN_POINTS, suns};
pub use timing_record::timing_record;
pub use tracks::{USUAL_TRACKS, tracks_along};
pub use true_ground::TrueGround;
pub use work::Work;
