//! Pictures of more rows of sub-areas than are held at a time.

use generator::{Label, PlaneKind};

use crate::shots::Shot;

/// A sheet before the upper two thirds: nothing of it is left in what is drawn below, in the memory that it was drawn in.
#[test]
fn rows_of_sub_areas_leave_nothing_to_those_after_them() {
    let mut shot = Shot::new(27, 483, 200.0);
    let (end, lines) = (320.0, 483);
    let sheet = shot.sheet(0, &[[-2.0, -2.0], [30.0, -2.0], [30.0, end], [-2.0, end]], 1.0, [0.6; 3], 0.0);
    shot.effects.sheets = vec![sheet];
    let drawn = shot.draw();
    let [red, labels] = [PlaneKind::Red, PlaneKind::Label].map(|kind| drawn.plane(kind));
    let ground = f32::from(Label::Terrain.code());
    for line in 0..lines {
        for pixel in line * 27..(line + 1) * 27 {
            if (line as f64) < end - 2.0 {
                assert!(
                    (red[pixel] - 0.6).abs() < 1e-6 && labels[pixel] != ground,
                    "line {line}: {}",
                    red[pixel]
                );
            } else if line as f64 > end + 2.0 {
                assert_eq!((red[pixel], labels[pixel]), (0.0, ground), "line {line}");
            }
        }
    }
}
