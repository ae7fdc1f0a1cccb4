//! What lies over the sampling points of one sub-area: the nearest opaque feature, and translucent ones before it (EP-0611021).
//!
//! ```text
//!  coverage bits, distance plane, feature --> Stack::add --> nearest opaque of each sampling point
//!                                                       \--> shelf of K translucent, shelf of L lights --> lost: the nearest
//!  all features added --> layers, near to far --> colour of a sampling point or a pixel, surface, losses with their bound
//! ```
//!
//! # Law
//!
//! - **Order** (key): a larger q = 1/w is nearer. Features equally near are ordered by priority, the higher first, then by id, the
//!   lower first, then by what they look like. So a set of features has one order, whatever the order of arrival.
//! - **Stored**: the nearest opaque feature, the K nearest translucent ones before it, and the L nearest lights before it, in slots
//!   of their own or in one stack of K + L (the fault `shared-stack`). What is stored is a function of the set that was added.
//! - **Colour** (claim 4): the sum of each feature's light times the product of all nearer translucencies. What the last one lets
//!   through is the rest, and has the colour of the background. Weights and rest sum to 1.
//! - **Losses**: of what found no slot, each sampling point keeps the nearest feature of either kind. The bound on what the loss
//!   does to the colour follows from it ([`Loss`]). Counts and bound are functions of the set too, since nothing is counted that
//!   lies behind the nearest opaque feature. The number of lost features is no such function while memory is limited, and is not
//!   kept.
//!
//! Equal ids are no error here: triangles of one feature share its id. A list of features is the place to refuse two of one id.
//! Capacities are unsigned, and a sampling has one point at least: such errors cannot be written.
//!
//! # Storage
//!
//! One [`Stack`] serves sub-area after sub-area of a thread. Its buffers are made once. With unlimited capacity they grow with the
//! deepest sampling point, and stay. Pixels without translucent features cost nothing beside their nearest opaque one.
//!
//! # See also
//!
//! `tests/translucency`: check values in all orders of arrival, a second evaluator that sorts everything and knows no limit, the
//! bound on random sets. `examples/stack_cost.rs` measures what a sub-area costs.

mod brightest;
mod capacity;
mod entry;
mod feature;
mod layers;
mod loss;
mod nearest;
mod places;
mod shelf;
mod shown;
mod stack;

pub use capacity::Capacity;
pub use feature::{Feature, FeatureError, Kind};
pub use layers::Layer;
pub use loss::{Loss, Losses};
pub use stack::Stack;
