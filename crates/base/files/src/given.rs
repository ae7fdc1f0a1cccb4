//! Files in memory, under paths that begin with `given:`.
//!
//! A page has no disk: it gives the files that a scenario names. The store is the process's, as the disk is.

use std::collections::BTreeMap;
use std::path::{Component, Path};
use std::sync::{Arc, RwLock, RwLockReadGuard, RwLockWriteGuard};

use crate::error::{Action, FileError};
use crate::read::Most;

/// What the path of every given file begins with.
pub const GIVEN: &str = "given:";

/// Most files that are held at once.
pub const GIVEN_FILES: usize = 4096;

/// Most bytes that all given files have together.
pub const GIVEN_BYTES: u64 = 1 << 28;

/// Why a file is not taken into the store.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GivenError {
    /// The path is no path of the store.
    #[error("{path}: no path of a given file; expected given:FOLDER/NAME, which stays below given:")]
    Path {
        /// The path as given.
        path: String,
    },
    /// A file is a folder of another.
    #[error(
        "{path}: {other} is given too, and one would be a folder of the other; give one of them another name"
    )]
    Folder {
        /// The path as given.
        path: String,
        /// The file in the way, from `given:` on.
        other: String,
    },
    /// There are too many files.
    #[error("{path}: {GIVEN_FILES} files are given already, which is the most; take some back")]
    Files {
        /// The path as given.
        path: String,
    },
    /// The files are too large together.
    #[error(
        "{path}: all given files would have {bytes} bytes, expected at most {GIVEN_BYTES}; take some back"
    )]
    Bytes {
        /// The path as given.
        path: String,
        /// Bytes of all files with this one.
        bytes: u64,
    },
}

#[derive(Debug, Default)]
struct Store {
    /// By the names from the root of the store on, joined by `/`.
    files: BTreeMap<String, Arc<[u8]>>,
    bytes: u64,
}

static STORE: RwLock<Store> = RwLock::new(Store { files: BTreeMap::new(), bytes: 0 });

fn store() -> RwLockReadGuard<'static, Store> {
    STORE.read().unwrap_or_else(|poisoned| poisoned.into_inner())
}

fn store_to_change() -> RwLockWriteGuard<'static, Store> {
    STORE.write().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// Holds `bytes` as the file `path`, which is `given:FOLDER/NAME` with any number of folders. A file of this path is replaced.
///
/// # Errors
/// A path outside the store, a file where another has its folder, and more than [`GIVEN_FILES`] or [`GIVEN_BYTES`].
pub fn give(path: impl AsRef<Path>, bytes: impl Into<Arc<[u8]>>) -> Result<(), GivenError> {
    let (path, bytes) = (path.as_ref(), bytes.into());
    let told = || path.display().to_string();
    // Without a folder, the files beside this one would be looked for on the disk.
    let key = key(path).filter(|key| key.contains('/')).ok_or_else(|| GivenError::Path { path: told() })?;
    let mut store = store_to_change();
    if let Some(other) = store.in_the_way(&key) {
        return Err(GivenError::Folder { path: told(), other });
    }
    let replaced = store.files.get(&key).map(|old| old.len() as u64);
    if replaced.is_none() && store.files.len() >= GIVEN_FILES {
        return Err(GivenError::Files { path: told() });
    }
    let total = store.bytes - replaced.unwrap_or(0) + bytes.len() as u64;
    if total > GIVEN_BYTES {
        return Err(GivenError::Bytes { path: told(), bytes: total });
    }
    store.bytes = total;
    store.files.insert(key, bytes);
    Ok(())
}

/// Lets go of the given file `path`; whether there was one.
pub fn take_back(path: impl AsRef<Path>) -> bool {
    let Some(key) = key(path.as_ref()) else { return false };
    let mut store = store_to_change();
    let Some(bytes) = store.files.remove(&key) else { return false };
    store.bytes -= bytes.len() as u64;
    true
}

/// Lets go of all given files.
pub fn take_back_all() {
    *store_to_change() = Store::default();
}

/// Whether a path is one of the store, be there a file or not.
pub fn is_given(path: impl AsRef<Path>) -> bool {
    first_name(path.as_ref()).is_some_and(|first| first.starts_with(GIVEN))
}

fn first_name(path: &Path) -> Option<&str> {
    path.components().next()?.as_os_str().to_str()
}

/// The names of a path from the root of the store on; `None` if it leads out of the store, or is not of it.
fn key(path: &Path) -> Option<String> {
    let mut names: Vec<&str> = vec![first_name(path)?.strip_prefix(GIVEN)?];
    names.retain(|first| !first.is_empty() && *first != ".");
    for component in path.components().skip(1) {
        match component {
            Component::Normal(name) => names.push(name.to_str()?),
            Component::CurDir => {}
            Component::ParentDir => drop(names.pop()?),
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(names.join("/")).filter(|key| !key.split('/').any(|name| name == "..") && !key.contains('\\'))
}

/// What the store has at a path.
#[derive(Debug)]
pub(crate) enum Found {
    File(Arc<[u8]>),
    Folder,
    Nothing,
}

/// What the store has at `path`; `None` if the path is one of the disk.
pub(crate) fn find(path: &Path) -> Option<Found> {
    if !is_given(path) {
        return None;
    }
    let Some(key) = key(path) else { return Some(Found::Nothing) };
    let store = store();
    let found = store.files.get(&key).map(|bytes| Found::File(Arc::clone(bytes)));
    let is_folder = || key.is_empty() || store.first_below(&key).is_some();
    Some(found.unwrap_or_else(|| if is_folder() { Found::Folder } else { Found::Nothing }))
}

/// The bytes of the given file `path`, of at most so many; `None` if the path is one of the disk.
pub(crate) fn read(path: &Path, most: Most) -> Option<Result<Arc<[u8]>, FileError>> {
    let owned = path.to_owned();
    Some(match find(path)? {
        Found::File(bytes) => most.allows(path, bytes.len() as u64).map(|()| bytes),
        Found::Folder => Err(FileError::IsFolder { path: owned, action: Action::Read }),
        Found::Nothing => Err(FileError::Missing { path: owned }),
    })
}

/// The names of what lies in the given folder `path`, in alphabetical order; `None` if the path is one of the disk.
pub(crate) fn names(path: &Path) -> Option<Vec<String>> {
    if !is_given(path) {
        return None;
    }
    let Some(key) = key(path) else { return Some(Vec::new()) };
    let folder = if key.is_empty() { key } else { key + "/" };
    let store = store();
    let below = store.files.keys().filter_map(|file| file.strip_prefix(&folder));
    let mut names: Vec<String> = below.filter_map(|rest| rest.split('/').next()).map(str::to_owned).collect();
    names.dedup();
    Some(names)
}

impl Store {
    /// A file in the folder `key`.
    fn first_below(&self, key: &str) -> Option<&String> {
        let folder = format!("{key}/");
        self.files
            .range(folder.clone()..)
            .next()
            .map(|(file, _)| file)
            .filter(|file| file.starts_with(&folder))
    }

    /// A file that `key` would be in, or that would be in `key`.
    fn in_the_way(&self, key: &str) -> Option<String> {
        let above = key.match_indices('/').map(|(end, _)| &key[..end]);
        let above = above.filter(|folder| self.files.contains_key(*folder)).map(str::to_owned).next();
        above.or_else(|| self.first_below(key).cloned()).map(|other| format!("{GIVEN}{other}"))
    }
}
