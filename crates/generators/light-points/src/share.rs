//! Aperture and attenuation of calligraphic points, and their sums over sub-areas.

/// What the sampling points of one sub-area, or of all, say of a calligraphic point (claims 14, 16).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Share {
    /// Aperture: sampling points under the disc, hidden or not.
    pub aperture: u32,
    /// Attenuation factor: sum over them of the share of light that reaches the eye.
    pub attenuation: f64,
}

impl Share {
    /// Intensity (at least 0) to display of a point of intrinsic `intensity`; `None` if its disc covers no sampling point, so that it lies
    /// outside the screen.
    pub fn display(&self, intensity: f64) -> Option<f64> {
        (self.aperture > 0).then(|| intensity * self.attenuation / f64::from(self.aperture))
    }
}

/// Adds the shares `(sub-area, point, share)` of each of `points` points. They are added by sub-area, so the bits do not depend on the order
/// in which threads deliver them.
///
/// # Panics If the number of a point is not below `points`.
pub fn add_up(mut shares: Vec<(u32, u32, Share)>, points: usize) -> Vec<Share> {
    shares.sort_unstable_by_key(|&(sub_area, point, _)| (sub_area, point));
    let mut sums = vec![Share::default(); points];
    for (_, point, share) in shares {
        let sum = &mut sums[point as usize];
        sum.aperture += share.aperture;
        sum.attenuation += share.attenuation;
    }
    sums
}
