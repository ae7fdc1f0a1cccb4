//! Frames: the check value of the specification (7.2), and the turn by 180 degrees.

use photo_camera::FramePixel;

#[test]
fn a_pixel_lies_in_the_frame_of_the_specification() {
    let found = FramePixel::of([1176.290652934, 3708.585146854]).expect("inside");
    assert_eq!((found.frame_name('L'), found.at), ("L10241024".to_owned(), [152, 267]));
}

#[test]
fn frames_are_turned_and_not_mirrored() {
    let at = |pixel| FramePixel::of(pixel).expect("inside").at.map(|at| at as i64);
    let [middle, west, south] = [[700.5, 4000.5], [701.5, 4000.5], [700.5, 4001.5]].map(at);
    assert_eq!([west[0] - middle[0], west[1] - middle[1]], [1, 0]);
    assert_eq!([south[0] - middle[0], south[1] - middle[1]], [0, -1]);
}

#[test]
fn the_centre_of_a_pixel_lies_in_that_pixel() {
    for pixel in [[0.5, 0.5], [4999.5, 4999.5], [511.5, 4487.5], [512.5, 4488.5]] {
        assert_eq!(FramePixel::of(pixel).expect("inside").centre(), pixel);
    }
}

#[test]
fn nothing_outside_the_photograph_has_a_frame() {
    for pixel in [[-0.1, 10.0], [10.0, -0.1], [5000.0, 10.0], [10.0, 5000.0], [f64::NAN, 10.0]] {
        assert_eq!(FramePixel::of(pixel), None);
    }
}
