//! The folder of a run: whose files are in it, and who may write.

use std::io::Read;
use std::path::{Path, PathBuf};

use files::{Folder, Most};
use limits::Limit;
use serde_json::Value;

use crate::ReplayError;
use crate::held::{HeldRun, RUN_RECORD};
use crate::journal::JOURNAL;
use crate::truth_files::TRUTH_FILES;
use run_record::FrameRecord;

/// Frames of a run.
pub(crate) const FRAMES: &str = "frames";
/// Folder of the ground truth.
pub(crate) const TRUTH: &str = "truth";
/// File of the wall times.
pub(crate) const PERFORMANCE: &str = "performance.json";
/// Where the eye was.
pub(crate) const POSES: &str = "poses.csv";
/// From pixel to ray.
pub(crate) const CAMERA: &str = "camera.json";
/// Some frames side by side.
pub(crate) const CONTACT_SHEET: &str = "contact-sheet.png";
/// The film that a browser plays.
pub(crate) const ANIMATION: &str = "animation.png";
/// The page of the run, which whoever asked for the run writes.
pub const PAGE: &str = "index.html";
/// What the page shows beside the record.
pub const PAGE_DATA: &str = "page.json";
/// Plots of recorded sweeps.
pub const SCOPES: &str = "scopes";
/// Media type of a plot.
pub const SCOPE_KIND: &str = "image/svg+xml";

/// A film for other programs, put there by name.
const FILM: &str = "video.y4m";

/// Every file that a run writes beside its frames, and the film.
const OWN: [&str; 10] =
    [RUN_RECORD, JOURNAL, PERFORMANCE, POSES, CAMERA, CONTACT_SHEET, ANIMATION, PAGE, PAGE_DATA, FILM];

/// Folders that a run makes in its own.
const FOLDERS: [&str; 3] = [FRAMES, TRUTH, SCOPES];

/// A folder that this process, and no other, draws into. Nothing that a run writes into it is a link.
#[derive(Debug)]
pub struct RunFolder(Folder);

impl RunFolder {
    /// Makes the folder if need be, locks it, and clears what a killed run left half-written. `fresh` removes the
    /// files of an earlier run, and nothing else.
    ///
    /// # Errors
    /// If the folder cannot be made or written, another run is drawing into it, or it holds files that are not of
    /// a run.
    pub fn claim(path: &Path, fresh: bool) -> Result<Self, ReplayError> {
        let folder = Self(Folder::claim(path, &FOLDERS, is_own)?);
        match (folder.holds_run(), is_of_run(path)) {
            (false, false) => folder.check_foreign(fresh)?,
            // It has the words for what is wrong.
            (false, true) if !fresh => HeldRun::read(path).map(drop)?,
            _ => folder.clear_leftovers()?,
        }
        if fresh {
            folder.remove_run()?;
        }
        Ok(folder)
    }

    /// Returns the path of the run folder.
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// A file in it.
    pub(crate) fn join(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// Makes one of its folders, such as [`SCOPES`].
    ///
    /// # Errors
    /// If the folder cannot be made, or is a link.
    pub fn make(&self, name: &str) -> Result<(), ReplayError> {
        Ok(self.0.make(name)?)
    }

    fn clear_leftovers(&self) -> Result<(), ReplayError> {
        Ok(self.0.remove_leftovers(is_own)?)
    }

    /// Without a record and a journal nothing in the folder is a run's, but a journal that was never begun.
    fn check_foreign(&self, fresh: bool) -> Result<(), ReplayError> {
        self.0.remove_leftovers(|name| name == JOURNAL)?;
        let mut names = self.0.names("")?;
        let is_folder = |name: &str| FOLDERS.contains(&name);
        let mut empty = Vec::new();
        for name in FOLDERS {
            empty.extend(self.0.names(name)?.is_empty().then_some(name));
        }
        names.retain(|name| !empty.contains(&name.as_str()));
        let ours = |name: &&String| OWN.contains(&name.as_str()) || is_folder(name);
        let path = self.path().to_owned();
        match (names.iter().find(ours), names.first()) {
            (Some(found), _) => Err(ReplayError::WouldReplace { path, found: found.clone() }),
            (None, Some(found)) if !fresh => Err(ReplayError::Foreign { path, found: found.clone() }),
            _ => Ok(()),
        }
    }

    /// A run is known by its record or its journal.
    fn holds_run(&self) -> bool {
        let begins = |name: &str, schema: &str| {
            let head = head_of(&self.join(name)).unwrap_or_default();
            String::from_utf8_lossy(&head).contains(schema)
        };
        begins(RUN_RECORD, "\"lunoid.run/") || begins(JOURNAL, "\"lunoid.journal/")
    }

    /// Removes the files of a run; the journal and the record last, so that a kill in between leaves a folder that
    /// is still known as a run's.
    fn remove_run(&self) -> Result<(), ReplayError> {
        self.remove_strays(|_| false)?;
        self.remove_stray_truth(|_| false)?;
        self.remove_unknown(SCOPES, scope_frame, |_| false)?;
        let truth = TRUTH_FILES.map(|name| format!("{TRUTH}/{name}"));
        let own = truth.iter().map(String::as_str).chain(OWN.into_iter().rev());
        own.filter(|name| self.join(name).exists()).try_for_each(|name| self.remove(name))?;
        FOLDERS.iter().for_each(|name| self.0.remove_empty(name));
        Ok(())
    }

    /// Removes frames that are no part of a run whose pictures are `is_known`.
    pub(crate) fn remove_strays(&self, is_known: impl Fn(u64) -> bool) -> Result<(), ReplayError> {
        self.remove_unknown(FRAMES, frame_index, is_known)
    }

    /// Removes the truth of frames that are not `is_known`.
    pub(crate) fn remove_stray_truth(&self, is_known: impl Fn(u64) -> bool) -> Result<(), ReplayError> {
        self.remove_unknown(TRUTH, truth_index, is_known)
    }

    fn remove_unknown(
        &self,
        folder: &str,
        index: fn(&str) -> Option<u64>,
        is_known: impl Fn(u64) -> bool,
    ) -> Result<(), ReplayError> {
        let names = self.0.names(folder)?;
        let strays = names.iter().filter(|name| index(name).is_some_and(|index| !is_known(index)));
        strays.into_iter().try_for_each(|name| self.remove(&format!("{folder}/{name}")))
    }

    fn remove(&self, name: &str) -> Result<(), ReplayError> {
        Ok(self.0.remove(name)?)
    }
}

/// The first bytes of a file, as many as a record needs to say what it is.
fn head_of(path: &Path) -> Option<Vec<u8>> {
    let mut head = Vec::new();
    files::open(path).ok()?.take(200).read_to_end(&mut head).ok()?;
    Some(head)
}

/// Whether a run has written into `folder`, even where its record is gone: wall times as a run writes them, a camera
/// beside frames, or a journal with a frame.
pub(crate) fn is_of_run(folder: &Path) -> bool {
    let is_of = |name: &str, schema: &str| {
        let document: Option<Value> =
            read(folder, name).and_then(|bytes| serde_json::from_slice(&bytes).ok());
        document
            .is_some_and(|document| document["schema"].as_str().is_some_and(|word| word.starts_with(schema)))
    };
    let has_frames = || {
        let entries = folder.join(FRAMES).read_dir().into_iter().flatten().flatten();
        entries.into_iter().any(|entry| frame_index(&entry.file_name().to_string_lossy()).is_some())
    };
    let has_journal = || {
        let lines = read(folder, JOURNAL).unwrap_or_default();
        lines.split(|byte| *byte == b'\n').any(|line| serde_json::from_slice::<FrameRecord>(line).is_ok())
    };
    is_of(PERFORMANCE, "lunoid.performance/")
        || is_of(CAMERA, "lunoid.camera/") && has_frames()
        || has_journal()
}

fn read(folder: &Path, name: &str) -> Option<Vec<u8>> {
    files::read_all(folder.join(name), Most::from(Limit::RecordBytes)).ok()
}

/// Whether a run writes a file of this name, or puts a film there by name.
fn is_own(name: &str) -> bool {
    name == FILM || is_run_file(name)
}

/// Whether a run writes a file of this name, counted from its folder, with `/`.
pub fn is_run_file(name: &str) -> bool {
    match name.split_once('/') {
        None => OWN.contains(&name) && name != FILM,
        Some((FRAMES, name)) => frame_index(name).is_some(),
        Some((SCOPES, name)) => scope_frame(name).is_some(),
        Some((TRUTH, name)) => truth_index(name).is_some() || TRUTH_FILES.contains(&name),
        Some(_) => false,
    }
}

/// Name of a picture from the run folder: the index goes on from 0 for the whole mission.
pub fn picture_name(index: u64) -> String {
    format!("{FRAMES}/frame-{index:06}.png")
}

fn frame_index(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("frame-")?.strip_suffix(".png")?;
    let index = digits.parse().ok()?;
    (picture_name(index).ends_with(name)).then_some(index)
}

/// Name of the plot of a sweep from the run folder.
pub fn scope_name(frame: u64, sweep: u32) -> String {
    format!("{SCOPES}/frame-{frame:06}-sweep-{sweep:04}.svg")
}

fn scope_frame(name: &str) -> Option<u64> {
    let (frame, sweep) = name.strip_prefix("frame-")?.strip_suffix(".svg")?.split_once("-sweep-")?;
    let (frame, sweep) = (frame.parse().ok()?, sweep.parse().ok()?);
    scope_name(frame, sweep).ends_with(&format!("/{name}")).then_some(frame)
}

/// Name of the truth of a frame, from the folder of the truth.
pub(crate) fn truth_name(frame: u64) -> String {
    format!("frame-{frame:06}.npz")
}

fn truth_index(name: &str) -> Option<u64> {
    let frame = name.strip_prefix("frame-")?.strip_suffix(".npz")?.parse().ok()?;
    (truth_name(frame) == name).then_some(frame)
}

#[cfg(test)]
mod tests {
    use super::{frame_index, is_run_file, picture_name, scope_frame, scope_name, truth_index, truth_name};

    #[test]
    fn files_of_a_run_by_name() {
        for own in
            ["run.json", "frames/frame-000012.png", "truth/truth.json", "scopes/frame-000012-sweep-0500.svg"]
        {
            assert!(is_run_file(own), "{own}");
        }
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
        assert_eq!(truth_index(&truth_name(12)), Some(12));
        for foreign in ["frame-12.npz", "frame-000012.npy", "frame_000012.npz", "frame-+00012.npz"] {
            assert_eq!(truth_index(foreign), None, "{foreign}");
        }
    }
}
