//! Parts against closed forms, against an independent integrator, at their extremes, and in a chain.

mod amplifier;
mod chain;
mod comparator;
mod differentiator;
mod driver;
mod lag;
mod runge_kutta;
mod second_order;
mod stiffness;

/// Absolute difference within `tolerance`, with both values in the message.
#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "found {found}, expected {expected}: off by {off:e}, allowed {tolerance:e}");
}
