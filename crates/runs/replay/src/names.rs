//! Names of the files that a run writes, counted from its folder, with `/`.

use remote_shadow::is_tile_file;

use crate::held::RUN_RECORD;
use crate::journal::JOURNAL;
use crate::truth_files::TRUTH_FILES;

/// Frames of a run.
pub(crate) const FRAMES: &str = "frames";
/// Folder of the ground truth.
pub const TRUTH: &str = "truth";
/// File of the wall times.
pub(crate) const PERFORMANCE: &str = "performance.json";
/// Where the eye was.
pub const POSES: &str = "poses.csv";
/// From pixel to ray.
pub const CAMERA: &str = "camera.json";
/// Some frames side by side.
pub const CONTACT_SHEET: &str = "contact-sheet.png";
/// The film that a browser plays.
pub const ANIMATION: &str = "animation.png";
/// The page of the run, which whoever asked for the run writes.
pub const PAGE: &str = "index.html";
/// What the page shows beside the record.
pub const PAGE_DATA: &str = "page.json";
/// Plots of recorded sweeps.
pub const SCOPES: &str = "scopes";
/// OpenEXR files of the frames, which whoever asked for the run writes.
pub const EXR: &str = "exr";
/// Shadow boundaries, kept for the next frames of the run and for whoever asks of it. No record lists them.
pub const SHADOWS: &str = "shadows";
/// Media type of a plot.
pub const SCOPE_KIND: &str = "image/svg+xml";

/// A film for other programs, which its user may put there.
const FILM: &str = "video.y4m";

/// Every file that a run writes beside its folders. Files are removed from the last to the first, so that what a kill leaves is still
/// known as a run's.
pub(crate) const OWN: [&str; 9] =
    [RUN_RECORD, JOURNAL, PERFORMANCE, POSES, CAMERA, CONTACT_SHEET, ANIMATION, PAGE, PAGE_DATA];

/// Folders that a run makes in its own.
pub(crate) const FOLDERS: [&str; 5] = [FRAMES, TRUTH, SCOPES, EXR, SHADOWS];

/// Whether a run writes a file of this name, or its user may put the film there.
pub(crate) fn is_own(name: &str) -> bool {
    name == FILM || is_run_file(name)
}

/// Whether a run writes a file of this name, counted from its folder, with `/`.
pub fn is_run_file(name: &str) -> bool {
    match name.split_once('/') {
        None => OWN.contains(&name),
        Some((FRAMES, name)) => frame_index(name).is_some(),
        Some((SCOPES, name)) => scope_frame(name).is_some(),
        Some((EXR, name)) => exr_index(name).is_some(),
        Some((SHADOWS, name)) => is_tile_file(name),
        Some((TRUTH, name)) => truth_index(name).is_some() || TRUTH_FILES.contains(&name),
        Some(_) => false,
    }
}

/// Name of a picture from the run folder: the index goes on from 0 for the whole mission.
pub fn picture_name(index: u64) -> String {
    format!("{FRAMES}/frame-{index:06}.png")
}

pub(crate) fn frame_index(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("frame-")?.strip_suffix(".png")?;
    let index = digits.parse().ok()?;
    (picture_name(index).ends_with(name)).then_some(index)
}

/// Name of the plot of a sweep from the run folder.
pub fn scope_name(frame: u64, sweep: u32) -> String {
    format!("{SCOPES}/frame-{frame:06}-sweep-{sweep:04}.svg")
}

pub(crate) fn scope_frame(name: &str) -> Option<u64> {
    let (frame, sweep) = name.strip_prefix("frame-")?.strip_suffix(".svg")?.split_once("-sweep-")?;
    let (frame, sweep) = (frame.parse().ok()?, sweep.parse().ok()?);
    scope_name(frame, sweep).ends_with(&format!("/{name}")).then_some(frame)
}

/// Name of the truth of a frame, from the folder of the truth.
pub(crate) fn truth_name(frame: u64) -> String {
    format!("frame-{frame:06}.npz")
}

pub(crate) fn truth_index(name: &str) -> Option<u64> {
    let frame = name.strip_prefix("frame-")?.strip_suffix(".npz")?.parse().ok()?;
    (truth_name(frame) == name).then_some(frame)
}

/// Name of the OpenEXR file of a frame from the run folder.
pub fn exr_name(frame: u64) -> String {
    format!("{EXR}/frame-{frame:06}.exr")
}

fn exr_index(name: &str) -> Option<u64> {
    let frame = name.strip_prefix("frame-")?.strip_suffix(".exr")?.parse().ok()?;
    exr_name(frame).ends_with(&format!("/{name}")).then_some(frame)
}

#[cfg(test)]
mod tests {
    use super::{
        exr_index, exr_name, frame_index, is_run_file, picture_name, scope_frame, scope_name, truth_index,
        truth_name,
    };

    #[test]
    fn files_of_a_run_by_name() {
        for own in
            ["run.json", "frames/frame-000012.png", "truth/truth.json", "scopes/frame-000012-sweep-0500.svg"]
        {
            assert!(is_run_file(own), "{own}");
        }
        assert!(is_run_file("exr/frame-000012.exr") && !is_run_file("exr/frame-000012.png"));
        let tiles = format!("{}-{}.shadow", "0a".repeat(16), "f9".repeat(8));
        assert!(is_run_file(&format!("shadows/{tiles}")) && !is_run_file("shadows/x.shadow"), "{tiles}");
        for foreign in ["video.y4m", "x.json", "frames/run.json", "frames/x.png", "truth/x.npz", "a/run.json"]
        {
            assert!(!is_run_file(foreign), "{foreign}");
        }
    }

    #[test]
    fn only_names_that_a_run_writes_are_frames() {
        assert_eq!(picture_name(12), "frames/frame-000012.png");
        assert_eq!(picture_name(1_234_567), "frames/frame-1234567.png");
        assert_eq!(frame_index("frame-000012.png"), Some(12));
        for foreign in ["frame-12.png", "frame-000012.jpg", "frame--00012.png", "frame-+00012.png", "x.png"] {
            assert_eq!(frame_index(foreign), None, "{foreign}");
        }
        assert_eq!(scope_name(12, 500), "scopes/frame-000012-sweep-0500.svg");
        assert_eq!(scope_frame("frame-000012-sweep-0500.svg"), Some(12));
        for foreign in ["frame-12-sweep-500.svg", "frame-000012.svg", "frame-000012-sweep-0500.png", "x.svg"]
        {
            assert_eq!(scope_frame(foreign), None, "{foreign}");
        }
        assert_eq!(exr_name(12), "exr/frame-000012.exr");
        assert_eq!(exr_index("frame-000012.exr"), Some(12));
        for foreign in ["frame-12.exr", "frame-000012.png", "frame-+00012.exr", "x.exr"] {
            assert_eq!(exr_index(foreign), None, "{foreign}");
        }
        assert_eq!(truth_index(&truth_name(12)), Some(12));
        for foreign in ["frame-12.npz", "frame-000012.npy", "frame_000012.npz", "frame-+00012.npz"] {
            assert_eq!(truth_index(foreign), None, "{foreign}");
        }
    }
}
