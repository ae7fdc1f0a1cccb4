//! The files of `scenarios/moffett` are those of the constants.

use std::path::Path;

use photograph::Photograph;

use crate::block::{FRAME, photograph};

#[test]
fn the_shipped_photographs_follow_from_the_constants() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../scenarios/moffett");
    // 29.55 lines a second, 30 seconds.
    let moved = [FRAME[0], FRAME[1] + 887.0];
    for (name, frame, shift) in [("frame", FRAME, 0.0), ("moved", moved, 30.0)] {
        let shipped =
            Photograph::read(&folder.join(format!("{name}.png")), &folder.join(format!("{name}.json")));
        let (shipped, made) = (shipped.unwrap(), photograph(frame, shift));
        assert_eq!(shipped.placement(), made.placement(), "{name}");
        assert!(shipped.picture() == made.picture(), "{name}");
    }
}
