//! A folder with pictures of changed pixels, one a frame.

use std::path::Path;

use files::make_folder;
use picture::{ChangedPixels, encode_png};

use command_line::Failure;
use command_line::output::Place;

/// The folder as an output of `--pictures`.
pub fn place(folder: &Path) -> Place {
    let is_ours = |name: &str| name.starts_with("changed-") && name.ends_with(".png");
    Place::folder("--pictures", folder, is_ours)
}

/// Writes the picture of frame `frame` into `folder`, which is made if it is not there.
///
/// # Errors
/// If the folder cannot be made or the picture not be written.
pub fn write(folder: &Path, frame: u64, changed: &ChangedPixels) -> Result<(), Failure> {
    make_folder(folder)?;
    let title = format!("frame {frame}: {} changed pixels", changed.pixels().len());
    let png = encode_png(&changed.picture(), &[("Title", &title)]).map_err(Failure::input)?;
    files::write_atomic(folder.join(format!("changed-{frame:06}.png")), |out| out.write_all(&png))?;
    Ok(())
}
