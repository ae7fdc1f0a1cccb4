//! The folder, written whole.

use std::fs;
use std::path::{Path, PathBuf};

use files::{make_folder, read_all, rename, write_atomic};
use limits::Limit;
use site::{LIST, list, page};

use crate::books;
use crate::error::SiteError;
use crate::module;
use crate::scenarios::{Shipped, shipped};

/// Name of the module in the site.
const MODULE: &str = "lunoid.wasm";

/// What stands in a site.
struct Written {
    /// Bytes of the module.
    module: u64,
    /// Whether MkDocs was there to make the books.
    has_books: bool,
}

/// Builds the site in `out`, with `module` or one that is built. Returns what was written, in words.
pub fn build(out: &Path, module: Option<&Path>) -> Result<String, SiteError> {
    expect_free(out)?;
    let workspace = module::workspace()?;
    let module = module.map_or_else(|| module::build(&workspace), |path| Ok(path.to_owned()))?;
    let shipped = shipped(&workspace)?;
    let half = beside(out, "half");
    remove(&half)?;
    let written =
        write(&half, &workspace, &module, &shipped).and_then(|written| put(&half, out).map(|()| written));
    if written.is_err() {
        remove(&half)?;
    }
    Ok(told(out, &written?, &shipped))
}

/// Only a site, or nothing, is replaced.
fn expect_free(out: &Path) -> Result<(), SiteError> {
    let is_free = !out.exists() || out.join(LIST).is_file();
    if is_free { Ok(()) } else { Err(SiteError::NoSite(out.to_owned())) }
}

/// Writes everything into `half`.
fn write(half: &Path, workspace: &Path, module: &Path, shipped: &Shipped) -> Result<Written, SiteError> {
    make_folder(half)?;
    for (name, bytes) in page() {
        write_atomic(half.join(name), |out| out.write_all(bytes))?;
    }
    for file in &shipped.files {
        let to = half.join(file);
        make_folder(to.parent().unwrap_or(half))?;
        copy(&workspace.join(file), &to)?;
    }
    let list = format!("{:#}\n", list(&shipped.rows));
    write_atomic(half.join(LIST), |out| out.write_all(list.as_bytes()))?;
    let module = copy(module, &half.join(MODULE))?;
    Ok(Written { module, has_books: books::write(workspace, half)? })
}

fn copy(from: &Path, to: &Path) -> Result<u64, SiteError> {
    let bytes = read_all(from, Limit::BankBytes)?;
    write_atomic(to, |out| out.write_all(&bytes))?;
    Ok(bytes.len() as u64)
}

/// Gives `half` the name `out`; what was there goes only then.
fn put(half: &Path, out: &Path) -> Result<(), SiteError> {
    let old = beside(out, "old");
    remove(&old)?;
    if out.exists() {
        rename(out, &old)?;
    }
    rename(half, out)?;
    remove(&old)
}

fn beside(out: &Path, ending: &str) -> PathBuf {
    out.with_added_extension(ending)
}

fn remove(folder: &Path) -> Result<(), SiteError> {
    if !folder.exists() {
        return Ok(());
    }
    let failed = |source| SiteError::System { path: folder.to_owned(), doing: "remove the folder", source };
    fs::remove_dir_all(folder).map_err(failed)
}

fn told(out: &Path, Written { module, has_books }: &Written, shipped: &Shipped) -> String {
    let mut told = format!(
        "{}: {} scenarios, module of {module} bytes. Serve the folder and open index.html, for example: python3 -m http.server --directory {}",
        out.display(),
        shipped.rows.len(),
        out.display()
    );
    if !has_books {
        told += &format!("\nleft out: the books: {}", books::MISSING);
    }
    for (name, why) in &shipped.left_out {
        told += &format!("\nleft out: {name}: {why}");
    }
    told
}
