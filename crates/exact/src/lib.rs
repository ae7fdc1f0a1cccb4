//! stub
mod bernstein;
mod column;
mod outlook;
mod patch;
mod session;
mod view;
mod walk;

pub use column::{LINE_MEAN_TOLERANCE, RIDGE_SHARE};
pub use outlook::{Ceilings, Outlook, Ray, Sight, Spot};
pub use session::Exact;
pub use view::View;
