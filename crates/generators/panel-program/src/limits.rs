//! What the listing has room for.

use photograph::Photograph;

use crate::posts::Posts;
use crate::reference::Reference;
use crate::{ProgramError, View};
use glam::DVec3;

/// Posts along a side of the array of elevations.
pub const MOST_ROWS: usize = 50;
/// Records of the panel file (`MAXREC=512`), one a panel.
pub const MOST_PANELS: usize = 512;
/// Pixels along a side of screen and photograph.
pub const SIDE: usize = 512;

/// Refuses posts and photographs that the listing has no room for.
pub(crate) fn check(posts: &Posts, photograph: &Photograph) -> Result<(), ProgramError> {
    let [rows, columns] = posts.size;
    let picture = photograph.picture();
    for (what, found, most) in [
        ("rows of posts", rows, MOST_ROWS),
        ("columns of posts", columns, MOST_ROWS),
        ("panels", 2 * (rows - 1) * (columns - 1), MOST_PANELS),
        ("columns of the photograph", picture.columns(), SIDE),
        ("lines of the photograph", picture.lines(), SIDE),
    ] {
        at_most(what, found, most)?;
    }
    Ok(())
}

/// Refuses posts beside the frame of the photograph.
pub(crate) fn check_frame(reference: &Reference, points: &[DVec3]) -> Result<(), ProgramError> {
    let posts = points.iter().filter(|point| !reference.holds(reference.pixel(**point))).count();
    if posts == 0 { Ok(()) } else { Err(ProgramError::BesideFrame { posts }) }
}

/// Refuses a screen of another size.
pub(crate) fn check_view(view: &View) -> Result<(), ProgramError> {
    at_most("columns of the screen", view.size[0] as usize, SIDE)?;
    at_most("lines of the screen", view.size[1] as usize, SIDE)
}

fn at_most(what: &'static str, found: usize, most: usize) -> Result<(), ProgramError> {
    if found <= most { Ok(()) } else { Err(ProgramError::Limit { what, found, most }) }
}
