//! The sub-rays of a pixel that an edge crosses.

/// Sub-rays of a pixel that an edge crosses. Chosen: as many as a word has bits.
pub const SUB_RAYS: u32 = 64;

/// Step between the lines of two sub-rays in neighbouring columns (1/64 pixel). Chosen: every column and every line of 1/64
/// pixel has one sub-ray, and of all steps this one tells the area beside a straight edge best.
const LATTICE: u32 = 37;

/// Places of the sub-rays in a pixel, each 0 to 1.
pub fn sub_rays() -> impl Iterator<Item = [f64; 2]> {
    let place = |unit: u32| (f64::from(unit) + 0.5) / f64::from(SUB_RAYS);
    (0..SUB_RAYS).map(move |k| [place(k), place(k * LATTICE % SUB_RAYS)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half-planes at all angles and distances from the middle of the pixel.
    #[test]
    fn sub_rays_tell_the_area_beside_an_edge() {
        let (mut worst, mut squares): (f64, f64) = (0.0, 0.0);
        for step in 0..360 {
            let (sin, cos) = quantities::sin_cos(quantities::radians(f64::from(step)));
            for shift in -35..=35 {
                let shift = f64::from(shift) / 50.0;
                let beside = |[x, y]: [f64; 2]| (x - 0.5) * cos + (y - 0.5) * sin > shift;
                let far =
                    |along: f64, out: f64| [0.5 + out * cos - along * sin, 0.5 + out * sin + along * cos];
                let half = [far(-9.0, shift), far(9.0, shift), far(9.0, 9.0), far(-9.0, 9.0)];
                let area = raster::area_within(&half, [0.0; 2], [1.0; 2]);
                let found = sub_rays().filter(|at| beside(*at)).count() as f64 / f64::from(SUB_RAYS);
                worst = worst.max((found - area).abs());
                squares += (found - area) * (found - area) / (360.0 * 71.0);
            }
        }
        assert!(worst < 1.0 / 14.0 && squares.sqrt() < 0.013, "{worst} {}", squares.sqrt());
    }
}
