//! The panels at a pixel: which was written, which lost to it.

use panel_program::{NO_PANEL, Program};

use crate::block::{block, lie, observer, usual};
use crate::counts::as_written;

#[test]
fn looks_at_a_pixel_tell_what_the_picture_shows() {
    let program = Program::new(&block(0.0), lie(), usual(), as_written()).unwrap();
    let view = observer(1);
    let picture = program.draw(&view).unwrap();
    let (mut empty, mut several) = (0, 0);
    for pixel in (0..512 * 512).step_by(1009).chain([60 * 512 + 240, 100 * 512 + 300]) {
        let looks = program.looks(&view, [pixel % 512, pixel / 512]).unwrap();
        let written: Vec<_> = looks.iter().filter(|look| look.is_written).collect();
        assert_eq!(written.len(), usize::from(picture.writes[pixel]));
        let last = written.last().map_or(NO_PANEL, |look| look.panel);
        assert_eq!(last, picture.panel[pixel]);
        // What stands there is the nearest of all.
        let nearest = looks.iter().map(|look| look.distance).fold(f64::INFINITY, f64::min);
        assert_eq!(nearest as f32, picture.distance[pixel]);
        empty += usize::from(looks.is_empty());
        several += usize::from(looks.len() > 1);
    }
    assert!(empty > 100 && several > 2, "{empty} {several}");
}
