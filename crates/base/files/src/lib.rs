//! Whole files or none: atomic writes, bounded reads, NPY and NPZ.
//!
//! - [`write_atomic`] writes beside the target and renames: a reader sees the old file or the new one.
//! - [`Temporary`] is what a file is called until it is whole; [`abandon_temporaries`] leaves none behind a process that ends.
//! - [`Folder`] is a folder that one process writes into; [`make_folder`] makes one, [`is_locked`] says whether a process writes there now.
//! - [`open()`], [`open_own`] and [`expect_output`] are the gate: whatever is opened is a file. Nothing is written through a link.
//! - [`remove_leftovers`] removes what killed commands have left.
//! - [`read_all`] reads a file up to a limit that the caller states, [`FilePieces`] piece by piece to where each stays.
//! - [`give`] holds a file in memory under a path that begins with `given:`. Readers find it there, and nothing is written there:
//!   a page has no disk. [`is_file`], [`is_there`] and [`names_in`] look on the disk and among what was given.
//! - [`Npy`], [`write_npz`] and [`parse_npz`] are numpy's formats; the bytes depend on the values alone. [`npy_layout`] tells where values stand.
//!
//! ```
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("heights.npy");
//! let heights = files::Npy::new(vec![2, 3], files::NpyData::F64(vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0]))?;
//! files::write_npy(&path, &heights)?;
//! assert_eq!(files::read_npy(&path, 1 << 20)?, heights);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod atomic;
mod error;
mod folder;
mod given;
mod kind;
mod leftovers;
mod lock;
mod npy;
mod npy_error;
mod npy_header;
mod npz;
mod open;
mod pieces;
mod read;
mod temporary;
mod there;

pub use atomic::write_atomic;
pub use error::{Action, FileError, folder_of};
pub use folder::{Folder, FolderError, make_folder, rename};
pub use given::{GIVEN, GIVEN_BYTES, GIVEN_FILES, GivenError, give, is_given, take_back, take_back_all};
pub use kind::{Kind, leads_outside};
pub use leftovers::{remove_leftovers, remove_leftovers_of};
pub use lock::{LOCK, Lock, is_locked};
pub use npy::{Npy, NpyData, NpyLayout, npy_layout, read_npy, write_npy};
pub use npy_error::{NpyError, NpyFileError};
pub use npz::{parse_npz, write_npz};
pub use open::{append_own, expect_output, open, open_own, open_stream};
pub use pieces::{FilePieces, Pieces, PiecesError};
pub use read::{Most, holds, read_all};
pub use temporary::{Temporary, abandon_temporaries};
pub use there::{is_file, is_there, names_in};
