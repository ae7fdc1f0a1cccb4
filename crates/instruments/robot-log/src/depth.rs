//! Depth: how far ahead along the axis of view something is.

use exact::View as Perspective;
use glam::DVec3;
use scenario::{Pose, View};

/// Depth of every pixel (m), row by row, from its distance along the ray (m). Sky, whose distance is infinite, has infinite depth.
///
/// The ray is that of the run's law of projection. Under `exact` it is the pinhole's, so that pixel and depth give back the place.
pub fn depth(view: &View, pose: &Pose, distance: &[f32]) -> Vec<f32> {
    let perspective = Perspective::new(view.laws.projection, &pose.attitude).with_yoke(pose.yoke);
    let (columns, lines) = (view.columns as usize, view.lines as usize);
    let place = |at: usize, count: usize, half: f64| half * (2 * at + 1) as f64 / count as f64 - half;
    let share = |index: usize| {
        let x = place(index % columns, columns, view.field.tan_half_width);
        let y = place(index / columns, lines, view.field.tan_half_height);
        let ray = perspective.ray(x, y);
        let to = DVec3::new(ray.direction[0], ray.direction[1], ray.rise);
        perspective.ahead(to) / to.length()
    };
    distance.iter().enumerate().map(|(index, &distance)| of(distance, || share(index))).collect()
}

fn of(distance: f32, share: impl FnOnce() -> f64) -> f32 {
    if distance.is_finite() { (f64::from(distance) * share()) as f32 } else { distance }
}

#[cfg(test)]
mod tests {
    use super::of;

    #[test]
    fn sky_stays_infinitely_far_and_ground_is_its_share_ahead() {
        assert_eq!(of(f32::INFINITY, || 0.5), f32::INFINITY);
        assert_eq!(of(4.0, || 0.5), 2.0);
    }
}
