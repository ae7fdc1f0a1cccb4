//! Polyhedron generator (fig. 29; section 12): rocks and culture in display-plane position.
//!
//! ```text
//!              ┌──────────────── digital, once a frame ─────────────────┐   ┌── analog, sweep by sweep ──┐
//! bodies ────▶ rotate, project ─▶ faces seen ─▶ meet with the sweeps ─▶ SpanTable ─▶ pg.present ────▶ gate
//! sun ───────▶ n.s × albedo ─────────────────────────────────────────▶          ─▶ pg.reflectivity ─▶ VS3 ─▶ line
//!                                                    dpp.hold ─▶ cut by depth ─┘         terrain ───▶
//! ```
//!
//! **Law.** A vertex v goes to `v' = Theta^T Phi^T (v - E)`, `X = v'_2 / v'_1`, `Y = v'_3 / v'_1` (D = 1, Y
//! down); the yoke adds roll. A face is drawn if it looks at the eye; its reflectivity is `max(n.s, 0)` times
//! its albedo. A sweep is the straight line `X = tan b (cos theta + Y sin theta)` under
//! [`scenario::Projection::Exact`], else `X = tan b`; what it cuts out of a face is a [`Span`]. Polyhedra are
//! in true perspective under every projection law.
//! **Parameters.** [`ViewPlane`]: pose, field, laws. [`NEAREST`]: a body with a vertex nearer than this is
//! skipped.
//! **State and timing.** None between frames; buffers are kept. The digital side is taken to be ready in time:
//! what it would cost a 1970 processor (90 us a vertex, 25 us an edge and sweep) follows from [`Census`].
//! **VS3.** [`Overlay`] lays the spans of one sweep over its lines after read-out.
//! [`scenario::BodyVisibility`]: as reported, a body is seen as a whole and the nearer foot point lies on top;
//! by depth, a span ends where the ground hides it, and the nearest span shows. Parts of one object stand in
//! order of depth either way.
//! **Elaboration.** Without bodies there is no generator, and the switch has no second input.
//! **Parts.** [`PartsSwitch`]: delay, transition, gain and level of the switch.
//! **Not modelled.** Words of the digital side, specular light, a body's
//! shadow on the ground (that is the shadow controller's) and on other bodies.
//! **Our choices.** Spans keep real line positions, f32. A body is lowered by the lunoid's drop at its foot
//! point, as a whole. Ground range between the ends of a span is exact under `Exact`, and under the other laws
//! good to the second order of the span's height. The hold is taken to be linear in inverse range between two
//! samples, which is exact on level ground at zero pitch.

mod cover;
mod cut;
mod face;
mod generator;
mod hold;
mod layers;
mod light;
mod likeness;
mod meetings;
mod near_table;
mod of_parts;
mod order;
mod overlay;
mod sight;
mod span;
mod stack;
mod table;
mod view;

pub use generator::{Census, Drawn, Field, PolyhedronGenerator};
pub use hold::{Hold, NoHold};
pub use light::{FaceLight, RAMP_WORDS};
pub use near_table::NearTable;
pub use of_parts::{BodyFade, PartsSwitch};
pub use overlay::{Overlay, Run, SIGNALS};
pub use sight::{LeftOut, Sight};
pub use span::Span;
pub use table::{SpanTable, Sweep};
pub use view::{NEAREST, Place, ViewPlane};
