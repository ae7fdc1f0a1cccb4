//! Borders of panels blended, as the thesis wished for: pixels on both sides have their mean.

use crate::picture::{NO_PANEL, Picture};
use crate::program::Panel;

/// Gives each pixel beside a border the mean of its light and of the light across the border. Two panels have a border where they share two posts, so
/// an outline before farther ground stays sharp.
pub(crate) fn blend(picture: &mut Picture, panels: &[Panel], columns: usize) {
    let lights = picture.light.clone();
    for (pixel, light) in picture.light.iter_mut().enumerate() {
        let panel = picture.panel[pixel];
        let beside = neighbours(pixel, columns, lights.len());
        let across = beside.filter(|next| have_a_border(panels, panel, picture.panel[*next]));
        let (sum, count) = across.fold((*light, 1.0), |(sum, count), next| (sum + lights[next], count + 1.0));
        *light = sum / count;
    }
}

/// Pixels on the left, on the right, above and below.
fn neighbours(pixel: usize, columns: usize, pixels: usize) -> impl Iterator<Item = usize> {
    let column = pixel % columns;
    let sides = [
        (column > 0).then(|| pixel - 1),
        (column + 1 < columns).then(|| pixel + 1),
        pixel.checked_sub(columns),
        Some(pixel + columns).filter(|below| *below < pixels),
    ];
    sides.into_iter().flatten()
}

/// Whether two panels, by their numbers, share two posts.
fn have_a_border(panels: &[Panel], a: u32, b: u32) -> bool {
    if a == b || a == NO_PANEL || b == NO_PANEL {
        return false;
    }
    let [a, b] = [a, b].map(|number| panels[number as usize].posts);
    a.iter().filter(|post| b.contains(post)).count() == 2
}
