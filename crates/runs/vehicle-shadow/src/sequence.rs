//! A picture sequence on disk: frames, poses, camera.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::poses::{FramePose, Poses, read_poses};
use crate::{AugmentError, Camera};

/// Frames of a second where a sequence of one picture does not say.
const USUAL_PERIOD_S: f64 = 1.0 / 30.0;

/// One frame of a sequence.
#[derive(Debug, Clone, PartialEq)]
pub struct SequenceFrame {
    /// Number of the frame.
    pub frame: u64,
    /// Path of the picture.
    pub path: PathBuf,
    /// Where the eye was.
    pub pose: FramePose,
}

impl SequenceFrame {
    /// The name of the new picture: that of the old one, ending in `.png`.
    pub fn made(&self) -> PathBuf {
        let name = PathBuf::from(self.path.file_name().unwrap_or_default());
        let is_png = name.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
        if is_png { name } else { name.with_extension("png") }
    }
}

/// Pictures of one camera, each with its pose, ascending.
#[derive(Debug, Clone, PartialEq)]
pub struct Sequence {
    folder: PathBuf,
    frames: Vec<SequenceFrame>,
    camera: Camera,
    notes: Vec<String>,
}

impl Sequence {
    /// The PNG, JPEG and TIFF files of a folder, whose names end in the number of their frame, with the poses of a file; `camera`, which
    /// may stand beside the poses, is asked for once those are there.
    ///
    /// # Errors
    /// If a picture has no pose or a pose no picture, or something cannot be read. The pictures themselves are not
    /// looked at.
    pub fn read<E: From<AugmentError>>(
        folder: &Path,
        poses: &Path,
        camera: impl FnOnce() -> Result<Camera, E>,
    ) -> Result<Self, E> {
        let (frames, notes) = matched(folder, poses)?;
        Ok(Self { folder: folder.to_owned(), frames, camera: camera()?, notes })
    }

    /// Returns the folder of the pictures.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the frames of the sequence, ascending.
    pub fn frames(&self) -> &[SequenceFrame] {
        &self.frames
    }

    /// Returns what the user should know of how the poses were read, in words.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Returns the camera that took the pictures.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Shortest time from one picture to the next (s); 1/30 s if there is one alone.
    pub fn period(&self) -> f64 {
        let steps = self.frames.windows(2).map(|pair| pair[1].pose.time - pair[0].pose.time);
        steps.reduce(f64::min).unwrap_or(USUAL_PERIOD_S)
    }
}

/// Every picture with its pose, ascending, and what is to be said of the poses.
fn matched(folder: &Path, poses: &Path) -> Result<(Vec<SequenceFrame>, Vec<String>), AugmentError> {
    let mut pictures = pictures(folder)?;
    let Poses { by_frame: rows, notes } = read_poses(poses)?;
    let (owned_folder, owned_poses) = (folder.to_owned(), poses.to_owned());
    let without_picture: Vec<u64> =
        rows.keys().filter(|frame| !pictures.contains_key(frame)).copied().collect();
    let without_pose: Vec<u64> = pictures.keys().filter(|frame| !rows.contains_key(frame)).copied().collect();
    if !without_picture.is_empty() {
        return Err(AugmentError::MissingFrames {
            folder: owned_folder,
            poses: owned_poses,
            frames: without_picture,
        });
    }
    if !without_pose.is_empty() {
        return Err(AugmentError::MissingPoses {
            folder: owned_folder,
            poses: owned_poses,
            frames: without_pose,
        });
    }
    let frame = |(frame, pose)| Some(SequenceFrame { frame, path: pictures.remove(&frame)?, pose });
    Ok((rows.into_iter().filter_map(frame).collect(), notes))
}

fn pictures(folder: &Path) -> Result<BTreeMap<u64, PathBuf>, AugmentError> {
    let failed = |source| AugmentError::Folder { path: folder.to_owned(), doing: "list this folder", source };
    let mut found: BTreeMap<u64, PathBuf> = BTreeMap::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let Some(frame) = frame_number(&path) else { continue };
        if let Some(first) = found.insert(frame, path.clone()) {
            let (first, second) = if first < path { (first, path) } else { (path, first) };
            return Err(AugmentError::TwoFrames { frame, first, second });
        }
    }
    if found.is_empty() { Err(AugmentError::NoFrames { path: folder.to_owned() }) } else { Ok(found) }
}

/// Ends of the names of picture files.
const ENDS: [&str; 5] = ["png", "jpg", "jpeg", "tif", "tiff"];

/// The number at the end of a picture file's name.
fn frame_number(path: &Path) -> Option<u64> {
    let end = path.extension()?;
    let is_picture = ENDS.iter().any(|known| end.eq_ignore_ascii_case(known));
    let stem = path.file_stem()?.to_str().filter(|stem| is_picture && !stem.starts_with('.'))?;
    let digits = stem.len() - stem.bytes().rev().take_while(u8::is_ascii_digit).count();
    stem[digits..].parse().ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::frame_number;

    #[test]
    fn the_number_is_at_the_end_of_the_name() {
        let of = |name: &str| frame_number(Path::new(name));
        assert_eq!(of("frames/frame-000012.png"), Some(12));
        assert_eq!(of("smk23_7.PNG"), Some(7));
        assert_eq!(of("0.png"), Some(0));
        assert_eq!(["a1.jpg", "a2.JPEG", "a3.tif", "a4.tiff"].map(of), [1, 2, 3, 4].map(Some));
        for other in
            ["sheet.png", "frame-3.gif", "frame-3", "frame-3.png.tmp", ".frame-3.png", "frame-3a.png"]
        {
            assert_eq!(of(other), None, "{other}");
        }
    }
}
