//! A run as its page sees it: how far it is, its newest picture, and its own page when it is finished.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use files::{Kind, read_all};
use loop_server::{Bytes, PageFiles, Shelf};
use replay::{Job, PAGE, Progress, is_run_file, picture_name};
use report::live_page;
use run_page::Request;
use serde_json::json;

use command_line::Failure;

/// Where a page asks how far the run is.
const STATE: &str = "live.json";

/// Most bytes of a file that a page gets (chosen): a picture of the largest raster fits.
const MOST: u64 = 64 << 20;

/// Frames behind the newest count that may not be on the disk yet: threads finish them in any order (chosen).
const OUT_OF_ORDER: u64 = 64;

/// A run that a page follows.
pub struct LiveRun {
    folder: PathBuf,
    /// First frame of the run and the one behind its last, counted at the update rate.
    frames: [u64; 2],
    /// Pictures of one frame.
    showings: u64,
    /// Signals that a computed sweep shows.
    signals: Vec<String>,
    fixed: PageFiles,
    stand: Mutex<Stand>,
    /// The page of the finished run.
    page: OnceLock<Bytes>,
}

/// How far the run is.
#[derive(Debug, Clone, Copy, Default)]
struct Stand {
    /// What the run is at, in a word.
    what: &'static str,
    /// Of so many frames.
    frames: u64,
    /// So many are there.
    done: u64,
}

impl LiveRun {
    /// The run of `job` in `folder`, with the files of the page that do not change.
    pub fn new(folder: &Path, job: &Job, fixed: PageFiles) -> Self {
        let view = &job.stage.view;
        let showings = if job.pictures.refresh { view.refresh.whole_ratio(view.update) } else { None };
        let usual: Result<Request, _> = "0:0".parse();
        Self {
            folder: folder.to_owned(),
            frames: [job.frames.start, job.frames.end],
            showings: showings.unwrap_or(1),
            signals: usual.map_or_else(|_| Vec::new(), |usual| usual.patterns(&*job.generator)),
            fixed,
            stand: Mutex::new(Stand { what: "preparing", ..Stand::default() }),
            page: OnceLock::new(),
        }
    }

    /// Hears of the run.
    pub fn hear(&self, progress: Progress) {
        let mut stand = self.stand.lock().unwrap_or_else(PoisonError::into_inner);
        match progress {
            Progress::Verifying { frames } => *stand = Stand { what: "verifying", frames, done: 0 },
            Progress::Begins { what, frames, kept } => *stand = Stand { what, frames, done: kept },
            // Threads tell their numbers in any order.
            Progress::Frame { done } => stand.done = stand.done.max(done),
            Progress::Finishing => stand.what = "finishing",
        }
    }

    /// From here on the page of the run is served.
    ///
    /// # Errors
    /// If the folder does not hold the finished run any more.
    pub fn finish(&self) -> Result<(), Failure> {
        let page = Bytes::from(live_page(&self.folder)?.into_bytes());
        self.page.get_or_init(|| page);
        Ok(())
    }

    /// Whether the page of the run is served.
    pub fn is_finished(&self) -> bool {
        self.page.get().is_some()
    }

    fn state(&self) -> Bytes {
        let stand = *self.stand.lock().unwrap_or_else(PoisonError::into_inner);
        let picture = self.newest(stand).map(|index| json!({ "index": index, "file": picture_name(index) }));
        let told = json!({
            "what": stand.what,
            "frames": stand.frames,
            "done": stand.done,
            "picture": picture,
            "is_finished": self.is_finished(),
            "signals": self.signals,
        });
        Bytes::from(told.to_string().into_bytes())
    }

    /// Index of the newest picture. Frames are begun in order, so it is near the frame of that count.
    fn newest(&self, stand: Stand) -> Option<u64> {
        let [start, end] = self.frames;
        let count = if stand.what == "frames" { stand.done.min(end - start) } else { end - start };
        let newest = (start..start + count).rev().take(OUT_OF_ORDER as usize);
        let mut pictures = newest.map(|frame| frame * self.showings + self.showings - 1);
        pictures.find(|&index| self.is_there(&picture_name(index)))
    }

    /// Whether the folder has the file; a link is none.
    fn is_there(&self, name: &str) -> bool {
        Kind::of(&self.folder.join(name)).is_ok_and(|kind| kind == Kind::File)
    }

    /// A file of the run, read anew each time.
    fn of_folder(&self, name: &str) -> Option<Bytes> {
        if !is_run_file(name) || !self.is_there(name) {
            return None;
        }
        read_all(self.folder.join(name), MOST).ok().map(Bytes::from)
    }
}

impl Shelf for LiveRun {
    fn file(&self, name: &str) -> Option<Bytes> {
        match name {
            STATE => Some(self.state()),
            PAGE => self.page.get().cloned(),
            _ => self.fixed.file(name).or_else(|| self.of_folder(name)),
        }
    }
}
