//! What a study leaves: text or a document on standard output, tables in a folder.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use front_door::Opened;
use serde_json::Value;

use crate::Failure;
use crate::output::{Place, expect_outputs, print, print_json, tell};

/// Where results go.
#[derive(Debug, Args)]
pub struct Outputs {
    /// Folder for tables and plots.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// No progress.
    #[arg(long)]
    no_progress: bool,
    /// Print as JSON.
    #[arg(long)]
    json: bool,
}

impl Outputs {
    /// Tells of progress, to whoever wants to hear.
    pub fn say(&self, text: &str) {
        if !self.no_progress {
            tell(&format!("{text}\n"));
        }
    }

    /// Sees that nothing in the folder of which `writes` says that the study writes it is one of `inputs`.
    pub fn expect_apart(&self, writes: fn(&str) -> bool, inputs: &[Place]) -> Result<(), Failure> {
        let folder = self.out.iter().map(|out| Place::folder("--out", out, writes));
        expect_outputs(&folder.collect::<Vec<_>>(), inputs)
    }

    /// Every machine of a study wants the same shadow boundaries: they are found once if there is a place for them.
    pub fn keep_shadows(&self, opened: &mut Opened) -> Result<(), Failure> {
        if let (None, Some(out)) = (&opened.settings.shadow_cache, &self.out) {
            let folder = out.join("shadows");
            make(&folder)?;
            opened.settings.shadow_cache = Some(folder);
        }
        Ok(())
    }

    /// Prints a result.
    pub fn print(&self, document: &Value, text: &str) -> Result<(), Failure> {
        if self.json { print_json(document) } else { print(text) }
    }
}

/// Makes a folder for results, if it is not there.
pub fn make(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| {
        Failure::output(format!("--out {}: {error}; name a folder that can be written", folder.display()))
    })
}

/// Writes `name.json`, `name.csv` and `name.md` into `folder`.
pub fn write(folder: &Path, name: &str, document: &Value, csv: &str, page: &str) -> Result<(), Failure> {
    make(folder)?;
    for (end, text) in [("json", format!("{document:#}\n").as_str()), ("csv", csv), ("md", page)] {
        let path = folder.join(format!("{name}.{end}"));
        files::write_atomic(path, |out: &mut dyn Write| out.write_all(text.as_bytes()))?;
    }
    Ok(())
}

/// Whether the study of that name writes a file called `file`: a table of its own name, or a plot.
pub fn is_of(study: &str, file: &str) -> bool {
    match file.rsplit_once('.') {
        Some((stem, "json" | "csv" | "md")) => stem == study,
        Some((stem, "svg" | "png")) => !stem.contains('/'),
        _ => false,
    }
}

/// Rows as a table of Markdown, the first with the names of the columns. A bar within a cell is written so that it ends none.
pub fn markdown(rows: &[Vec<String>]) -> String {
    let mut text = String::new();
    for (number, row) in rows.iter().enumerate() {
        let cells: Vec<String> = row.iter().map(|cell| cell.replace('|', "\\|")).collect();
        text += &format!("| {} |\n", cells.join(" | "));
        if number == 0 {
            text += &format!("|{}\n", "---|".repeat(row.len()));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::markdown;

    #[test]
    fn a_bar_in_a_cell_ends_no_cell() {
        let rows = [["sun", "mean |z| (m)"], ["own", "1.5"]].map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(markdown(&rows), "| sun | mean \\|z\\| (m) |\n|---|---|\n| own | 1.5 |\n");
    }
}
