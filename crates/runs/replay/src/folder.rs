//! The folder of a run: whose files are in it, and who may write.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::ReplayError;
use crate::held::{HeldRun, RUN_RECORD};
use crate::journal::JOURNAL;
use crate::lock::{LOCK, Lock};
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

/// A folder that this process, and no other, draws into.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    /// Folders that did not exist, the deepest first: they go again if nothing comes into them.
    made: Vec<PathBuf>,
    lock: Option<Lock>,
}

impl RunFolder {
    /// Makes the folder if need be, locks it, and clears what a killed run left half-written. `fresh` removes the
    /// files of an earlier run, and nothing else.
    ///
    /// # Errors
    /// If the folder cannot be made or written, another run is drawing into it, or it holds files that are not of
    /// a run.
    pub fn claim(path: &Path, fresh: bool) -> Result<Self, ReplayError> {
        if path.exists() && !path.is_dir() {
            return Err(ReplayError::NotFolder { path: path.to_owned() });
        }
        let missing =
            path.ancestors().take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        let made = missing.map(Path::to_owned).collect();
        let failed =
            |source| ReplayError::Folder { path: path.to_owned(), doing: "make the run folder", source };
        fs::create_dir_all(path).map_err(failed)?;
        let mut folder = Self { path: path.to_owned(), made, lock: None };
        folder.lock = Some(Lock::take(path)?);
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
        &self.path
    }

    /// A file in it.
    pub(crate) fn join(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Makes a folder in it.
    pub(crate) fn make(&self, name: &str) -> Result<(), ReplayError> {
        let path = self.join(name);
        let failed = |source| ReplayError::Folder { path: path.clone(), doing: "make the folder", source };
        fs::create_dir_all(&path).map_err(failed)
    }

    fn clear_leftovers(&self) -> Result<(), ReplayError> {
        files::remove_leftovers(&self.path)?;
        for path in FOLDERS.map(|name| self.join(name)).iter().filter(|path| path.is_dir()) {
            files::remove_leftovers(path)?;
        }
        Ok(())
    }

    /// Without a record and a journal nothing in the folder is a run's, but a journal that was never begun.
    fn check_foreign(&self, fresh: bool) -> Result<(), ReplayError> {
        let (begun, mut names): (Vec<_>, Vec<_>) =
            list(&self.path)?.into_iter().partition(|name| name.starts_with(&format!(".{JOURNAL}.")));
        begun.iter().try_for_each(|name| self.remove(name))?;
        let is_folder = |name: &str| FOLDERS.contains(&name);
        names.retain(|name| name != LOCK && !(is_folder(name) && is_empty(&self.join(name))));
        let ours = |name: &&String| OWN.contains(&name.as_str()) || is_folder(name);
        let path = self.path.clone();
        match (names.iter().find(ours), names.first()) {
            (Some(found), _) => Err(ReplayError::WouldReplace { path, found: found.clone() }),
            (None, Some(found)) if !fresh => Err(ReplayError::Foreign { path, found: found.clone() }),
            _ => Ok(()),
        }
    }

    /// A run is known by its record or its journal.
    fn holds_run(&self) -> bool {
        let begins = |name: &str, schema: &str| {
            let head = fs::read(self.join(name)).unwrap_or_default();
            let head = String::from_utf8_lossy(&head[..head.len().min(200)]).into_owned();
            head.contains(schema)
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
        for name in FOLDERS {
            // Files of somebody else keep it.
            let _ = fs::remove_dir(self.join(name));
        }
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
        let path = self.join(folder);
        if !path.is_dir() {
            return Ok(());
        }
        let names = list(&path)?;
        let strays = names.iter().filter(|name| index(name).is_some_and(|index| !is_known(index)));
        strays.into_iter().try_for_each(|name| self.remove(&format!("{folder}/{name}")))
    }

    fn remove(&self, name: &str) -> Result<(), ReplayError> {
        let path = self.join(name);
        fs::remove_file(&path).map_err(|source| ReplayError::Folder { path, doing: "remove", source })
    }
}

impl Drop for RunFolder {
    fn drop(&mut self) {
        self.lock = None;
        // A folder with anything in it stays.
        for name in FOLDERS {
            let _ = fs::remove_dir(self.join(name));
        }
        for folder in &self.made {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Whether a run has written into `folder`, even where its record is gone: wall times as a run writes them, a camera
/// beside frames, or a journal with a frame.
pub(crate) fn is_of_run(folder: &Path) -> bool {
    let is_of = |name: &str, schema: &str| {
        let document: Option<Value> =
            fs::read(folder.join(name)).ok().and_then(|bytes| serde_json::from_slice(&bytes).ok());
        document
            .is_some_and(|document| document["schema"].as_str().is_some_and(|word| word.starts_with(schema)))
    };
    let has_frames = || {
        let names = list(&folder.join(FRAMES)).unwrap_or_default();
        names.iter().any(|name| frame_index(name).is_some())
    };
    let has_journal = || {
        let lines = fs::read(folder.join(JOURNAL)).unwrap_or_default();
        lines.split(|byte| *byte == b'\n').any(|line| serde_json::from_slice::<FrameRecord>(line).is_ok())
    };
    is_of(PERFORMANCE, "lunoid.performance/")
        || is_of(CAMERA, "lunoid.camera/") && has_frames()
        || has_journal()
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

/// Names in a folder, in alphabetical order.
fn list(path: &Path) -> Result<Vec<String>, ReplayError> {
    let failed = |source| ReplayError::Folder { path: path.to_owned(), doing: "list", source };
    let entries: Result<Vec<_>, _> = fs::read_dir(path).map_err(failed)?.collect();
    let entries = entries.map_err(failed)?;
    let mut names: Vec<String> =
        entries.iter().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    Ok(names)
}

fn is_empty(path: &Path) -> bool {
    fs::read_dir(path).is_ok_and(|mut entries| entries.next().is_none())
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
