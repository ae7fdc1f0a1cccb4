//! References from a scenario to other files.

use std::path::{Component, Path, PathBuf};

use diagnostics::Reader;
use files::leads_outside;

/// The file that `key` names, seen from `folder`; it must lie in that folder or below, so that a scenario that
/// came from elsewhere reads nothing but what came with it, through links neither.
pub(super) fn reference(table: &Reader, key: &str, folder: &Path) -> Option<PathBuf> {
    let field = table.string(key).must("a relative path that stays in the scenario's folder", stays_inside);
    let path = field.help(HELP).optional().map(|path| folder.join(path))?;
    if let Some(found) = leads_outside(folder, &path) {
        let title =
            format!("`{}` leads out of the scenario's folder, to {}", table.path(key), found.display());
        let expected = "a file of the folder, or a link that stays in it";
        table.report(table.problem(key, title).expected(expected).help(HELP));
        return None;
    }
    Some(path)
}

const HELP: &str = "copy the file into the folder, or name it on the command line";

fn stays_inside(path: &String) -> bool {
    let depths = Path::new(path).components().scan(0i64, |depth, component| {
        *depth += match component {
            Component::Normal(_) => 1,
            Component::CurDir => 0,
            Component::ParentDir => -1,
            // An absolute path.
            Component::RootDir | Component::Prefix(_) => i64::MIN / 2,
        };
        Some(*depth)
    });
    let depths: Vec<i64> = depths.collect();
    depths.iter().all(|&depth| depth >= 0) && depths.last().is_some_and(|&depth| depth > 0)
}

#[cfg(test)]
mod tests {
    use super::stays_inside;

    #[test]
    fn paths_in_the_folder_and_out_of_it() {
        for inside in ["a.bank", "./a.bank", "banks/a.bank", "banks/../a.bank"] {
            assert!(stays_inside(&inside.into()), "{inside}");
        }
        for outside in ["../a.bank", "/a.bank", "banks/../../scenarios/a.bank", ".", "banks/.."] {
            assert!(!stays_inside(&outside.into()), "{outside}");
        }
    }
}
