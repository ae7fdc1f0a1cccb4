//! `[[photograph]]`: what cameras saw of the ground.

use std::path::Path;

use diagnostics::Reader;

use super::reference::reference;
use crate::PhotographWish;

/// Most photographs of a scenario. Chosen: each has a bit of its own where its camera is asked what it sees.
const MOST: usize = 32;

/// Photographs in the order of the file, each file once.
pub(super) fn photographs(tables: &[Reader], folder: &Path) -> Option<Vec<PhotographWish>> {
    let mut wishes: Vec<PhotographWish> = Vec::new();
    let mut are_all_right = true;
    for table in tables {
        let wish = photograph(table, folder).filter(|wish| is_new(table, wish, &wishes));
        are_all_right &= wish.is_some();
        wishes.extend(wish);
    }
    are_all_right.then_some(wishes)
}

fn photograph(table: &Reader, folder: &Path) -> Option<PhotographWish> {
    for key in ["file", "camera"].into_iter().filter(|key| !table.has(key)) {
        let title = format!("missing key `{}`", table.path(key));
        let expected = "a picture and its camera file, as `lunoid photo make` writes them";
        table.report(table.problem(key, title).expected(expected));
    }
    let (file, camera) = (reference(table, "file", folder), reference(table, "camera", folder));
    Some(PhotographWish { file: file?, camera: camera? })
}

/// Whether a photograph is not there yet, and may be one more.
fn is_new(table: &Reader, wish: &PhotographWish, wishes: &[PhotographWish]) -> bool {
    let fault = if wishes.iter().any(|other| other.file == wish.file) {
        Some((
            format!("the photograph {} is there twice", wish.file.display()),
            "each picture once".to_owned(),
        ))
    } else if wishes.len() == MOST {
        Some((format!("more than {MOST} photographs"), format!("at most {MOST}")))
    } else {
        None
    };
    let is_new = fault.is_none();
    if let Some((title, expected)) = fault {
        table.report(table.problem("file", title).expected(expected));
    }
    is_new
}
