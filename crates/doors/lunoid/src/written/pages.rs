//! Where command lines are written.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Command;

use super::shell;

/// The folder of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// Pages for whoever uses or builds the program. CHANGELOG.md is history, and may name what is no more.
const PLACES: [&str; 4] = ["README.md", "docs", "scenarios", "tests"];

/// How a command is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// In a block of code, to be typed.
    Line,
    /// Between backticks in a sentence.
    Mention,
}

/// One command, as written.
#[derive(Debug)]
pub struct Written {
    /// File and line, or command whose help it is.
    pub place: String,
    pub kind: Kind,
    /// The first is the name of a program.
    pub words: Vec<String>,
}

/// A text with command lines in it.
pub struct Page {
    pub name: String,
    text: String,
}

/// A block of code: its first line, from 1, and what stands behind its fence.
struct Block {
    first: usize,
    language: String,
    script: String,
}

/// All pages, and the help of `command` and of everything below it.
pub fn all(command: &mut Command) -> Vec<Page> {
    let mut pages = Vec::new();
    for place in PLACES {
        markdown(&root().join(place), &mut pages);
    }
    help(command, &mut pages);
    pages
}

fn markdown(path: &Path, pages: &mut Vec<Page>) {
    if path.is_dir() {
        let mut below: Vec<_> = fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()).collect();
        below.sort();
        below.iter().for_each(|path| markdown(path, pages));
    } else if path.extension().is_some_and(|extension| extension == "md") {
        let name = path.strip_prefix(root()).unwrap().display().to_string();
        pages.push(Page { name, text: fs::read_to_string(path).unwrap() });
    }
}

/// What the help says is a page whose examples are a block.
fn help(command: &mut Command, pages: &mut Vec<Page>) {
    command.build();
    let of_arguments =
        command.get_arguments().flat_map(|argument| [argument.get_help(), argument.get_long_help()]);
    let sentences = [command.get_about(), command.get_long_about()].into_iter().chain(of_arguments).flatten();
    let mut text: String = sentences.map(|sentence| format!("{sentence}\n\n")).collect();
    if let Some(after) = command.get_after_help() {
        let (mut examples, mut prose) = (String::new(), String::new());
        for line in after.to_string().lines() {
            let part = if line.starts_with("  lunoid ") { &mut examples } else { &mut prose };
            *part += &format!("{line}\n");
        }
        text += &format!("{prose}\n```\n{examples}```\n");
    }
    let name = command.get_bin_name().unwrap_or_else(|| command.get_name());
    pages.push(Page { name: format!("{name} --help"), text });
    let ours = command.get_subcommands_mut().filter(|command| command.get_name() != "help");
    ours.for_each(|command| help(command, pages));
}

impl Page {
    /// What is written on the page, or what keeps it from being read.
    pub fn written(&self) -> Result<Vec<Written>, String> {
        let mut written = Vec::new();
        for Block { first, language, script } in self.parts()?.1 {
            written.extend(self.lines(first, &language, &script)?);
        }
        for span in self.spans().iter().filter(|span| is_command(span)) {
            written.extend(self.read(shell::commands(span), Kind::Mention, 1)?);
        }
        Ok(written)
    }

    /// What stands between backticks outside of blocks.
    pub fn spans(&self) -> Vec<String> {
        let (prose, _) = self.parts().unwrap_or_default();
        // Outside, inside, outside.
        let inside = |paragraph: &str| -> Vec<String> {
            paragraph.split('`').skip(1).step_by(2).map(|span| span.replace('\n', " ")).collect()
        };
        prose.split("\n\n").flat_map(inside).collect()
    }

    /// Sentences, and blocks of code.
    fn parts(&self) -> Result<(String, Vec<Block>), String> {
        let (mut prose, mut blocks, mut open) = (String::new(), Vec::new(), None::<Block>);
        for (number, line) in self.text.lines().enumerate() {
            match (&mut open, line.trim_start().strip_prefix("```")) {
                (None, Some(language)) => {
                    prose.push('\n');
                    let language = language.trim().to_owned();
                    open = Some(Block { first: number + 2, language, script: String::new() });
                }
                (None, None) => prose += &format!("{line}\n"),
                (Some(block), None) => block.script += &format!("{line}\n"),
                (Some(_), Some(_)) => blocks.extend(open.take()),
            }
        }
        match open {
            None => Ok((prose, blocks)),
            Some(_) => Err(format!("{}: a block of code is not closed", self.name)),
        }
    }

    /// Everything in a block of a shell is a command; elsewhere a line is one that begins with its name.
    fn lines(&self, first: usize, language: &str, script: &str) -> Result<Vec<Written>, String> {
        match language {
            "sh" => self.read(shell::commands(script), Kind::Line, first),
            _ => {
                let mut written = Vec::new();
                for (number, line) in script.lines().enumerate() {
                    let line = line.trim_start().trim_start_matches("$ ");
                    if is_command(line) {
                        written.extend(self.read(shell::commands(line), Kind::Line, first + number)?);
                    }
                }
                Ok(written)
            }
        }
    }

    fn read(
        &self,
        commands: Result<Vec<shell::Command>, String>,
        kind: Kind,
        first: usize,
    ) -> Result<Vec<Written>, String> {
        let place = |line: usize| match kind {
            Kind::Line => format!("{}:{}", self.name, first + line),
            Kind::Mention => self.name.clone(),
        };
        let commands = commands.map_err(|fault| format!("{}: {fault}", place(0)))?;
        let written = |shell::Command { line, words }| Written { place: place(line), kind, words };
        Ok(commands.into_iter().map(written).collect())
    }
}

fn is_command(text: &str) -> bool {
    matches!(text.split_whitespace().next(), Some("lunoid" | "cargo"))
}
