//! Lists of faces that are drawn, and the faces of them that show.

use faces::Group;
use generator::Stage;
use scenario::{DrawnBy, FaceKind, FaceList};

use crate::hardware::Hardware;
use crate::parameters::{Hull, Parameters};

/// Lists of faces of a stage that are drawn.
pub fn drawn<'a>(stage: &'a Stage, run: &Parameters) -> Vec<&'a FaceList> {
    let whole_hulls = run.hull == Hull::DeepHull;
    let is_drawn = |list: &&FaceList| match list.drawn_by {
        DrawnBy::All => true,
        DrawnBy::Exact => whole_hulls && list.kind == FaceKind::Ship,
        DrawnBy::Machines => !(whole_hulls && list.kind == FaceKind::Ship),
    };
    stage.scenery.face_lists().lists.iter().filter(is_drawn).collect()
}

/// Faces of a list that the pointers of its sequences show in `frame`.
pub fn shown_faces(list: &FaceList, group: &Group, frame: u64, hardware: &Hardware) -> Vec<usize> {
    group.shown_late(frame, hardware.rt.late_frames, |name| list.carrier.signal(name, frame))
}
