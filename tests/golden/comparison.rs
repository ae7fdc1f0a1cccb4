//! The comparison is awake: it sees one level of one pixel, and it never passes on what it wrote itself.

use picture::{Depth, GreyPicture};
use tempfile::TempDir;

use crate::reference::{Differs, Shelf};

fn ramp(columns: usize, lines: usize) -> GreyPicture {
    let codes = (0..columns * lines).map(|at| (at % 251) as u16).collect();
    GreyPicture::new(columns, lines, Depth::Eight, codes).unwrap()
}

/// A shelf with a reference, and the same shelf without permission to write.
fn shelf() -> (TempDir, Shelf) {
    let folder = tempfile::tempdir().unwrap();
    let blessed = Shelf::in_folder(folder.path(), true).hold("ramp", &ramp(40, 30));
    assert!(matches!(blessed, Err(Differs::Blessed(_))));
    let shelf = Shelf::in_folder(folder.path(), false);
    (folder, shelf)
}

#[test]
fn equal_pictures_pass_and_leave_nothing() {
    let (folder, shelf) = shelf();
    assert_eq!(shelf.hold("ramp", &ramp(40, 30)), Ok(()));
    assert!(!folder.path().join("failures").exists());
}

#[test]
fn one_level_of_one_pixel_is_seen_and_shown() {
    let (folder, shelf) = shelf();
    for (column, line) in [(0, 0), (39, 0), (17, 22), (0, 29), (39, 29)] {
        let mut codes = ramp(40, 30).codes().to_vec();
        codes[line * 40 + column] += 1;
        let found = GreyPicture::new(40, 30, Depth::Eight, codes).unwrap();
        let shown = folder.path().join("failures/ramp.png");
        let expected = Differs::Pixels { differing: 1, most: 1, worst: [column, line], shown };
        assert_eq!(shelf.hold("ramp", &found), Err(expected));
    }
    let shown =
        picture::read_png(folder.path().join("failures/ramp.png"), &picture::Limits::default()).unwrap();
    assert!(shown.columns() >= 3 * 40 && shown.lines() >= 30);
}

#[test]
fn a_shift_by_a_line_and_another_size_are_seen() {
    let (_folder, shelf) = shelf();
    let mut codes = ramp(40, 30).codes().to_vec();
    codes.rotate_left(40);
    let shifted = GreyPicture::new(40, 30, Depth::Eight, codes).unwrap();
    assert!(
        matches!(shelf.hold("ramp", &shifted), Err(Differs::Pixels { differing, .. }) if differing > 1000)
    );
    let expected = Err(Differs::Size { found: [30, 40], expected: [40, 30] });
    assert_eq!(shelf.hold("ramp", &ramp(30, 40)), expected);
}

#[test]
fn a_missing_reference_fails_and_is_not_made() {
    let (_folder, shelf) = shelf();
    assert_eq!(shelf.hold("gone", &ramp(4, 3)), Err(Differs::Missing(shelf.path("gone"))));
    assert!(!shelf.path("gone").exists());
}

#[test]
fn a_blessed_reference_passes_on_the_next_run_only() {
    let (folder, shelf) = shelf();
    let other = ramp(20, 20);
    assert!(shelf.hold("ramp", &other).is_err(), "without blessing the reference stays");
    assert_eq!(shelf.hold("ramp", &ramp(40, 30)), Ok(()));
    let blessing = Shelf::in_folder(folder.path(), true);
    assert_eq!(blessing.hold("ramp", &other), Err(Differs::Blessed(blessing.path("ramp"))));
    assert_eq!(shelf.hold("ramp", &other), Ok(()));
}
