//! What a part's step is generic over: the value on one wire, or on the same wire of a group of sweeps.

use std::ops::{Add, Mul, Sub};

/// A scalar of the run, [`signal::Lanes`] of it, or a vector of them. Lane by lane the operations are the scalar's, so
/// the bits are too. `S` is what a part's figures are: scalars, or vectors of those of several parts.
pub trait Wire<S>:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Add<S, Output = Self>
    + Mul<S, Output = Self>
{
}

impl<S, V> Wire<S> for V where
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<Output = V> + Add<S, Output = V> + Mul<S, Output = V>
{
}
