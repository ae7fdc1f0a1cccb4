//! Every package is free to use under the terms of the house, those of all features among them.

use std::process::Command;

use crate::metadata::metadata;

/// Licences that need nothing but a notice, or bind only their own files (MPL-2.0) or fonts (OFL, Ubuntu).
const ALLOWED: &[&str] = &[
    "MIT",
    "MIT-0",
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "0BSD",
    "ISC",
    "Zlib",
    "Unicode-3.0",
    "CC0-1.0",
    "BSL-1.0",
    "Unlicense",
    "MPL-2.0",
    "OFL-1.1",
    "Ubuntu-font-1.0",
];

const OURS: &str = "MIT OR Apache-2.0";

/// Whether an SPDX expression leaves a choice that is allowed. `/` is the old way to write `OR`; an exception after
/// `WITH` only ever permits more. What cannot be read is not allowed.
fn allowed(expression: &str) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<_> = spaced.split_whitespace().collect();
    let mut rest = words.as_slice();
    either(&mut rest) == Some(true) && rest.is_empty()
}

fn either(rest: &mut &[&str]) -> Option<bool> {
    let mut found = both(rest)?;
    while next_is(rest, "OR") {
        found |= both(rest)?;
    }
    Some(found)
}

fn both(rest: &mut &[&str]) -> Option<bool> {
    let mut found = one(rest)?;
    while next_is(rest, "AND") {
        found &= one(rest)?;
    }
    Some(found)
}

fn one(rest: &mut &[&str]) -> Option<bool> {
    let (&word, after) = rest.split_first()?;
    *rest = after;
    if word == "(" {
        let found = either(rest)?;
        return next_is(rest, ")").then_some(found);
    }
    if next_is(rest, "WITH") {
        *rest = rest.get(1..)?;
    }
    Some(ALLOWED.contains(&word))
}

fn next_is(rest: &mut &[&str], word: &str) -> bool {
    let next = rest.first() == Some(&word);
    if next {
        *rest = &rest[1..];
    }
    next
}

/// The system that the tests run on: packages for others need not be at hand.
fn host() -> String {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).arg("-vV").output().expect("rustc can be started");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().find_map(|line| line.strip_prefix("host: ")).expect("rustc -vV names its host").to_owned()
}

#[test]
fn every_package_has_an_allowed_licence() {
    let metadata = metadata(&["--all-features", "--filter-platform", &host()]);
    let mut refused = Vec::new();
    for package in &metadata.packages {
        let licence = package.license.as_deref().unwrap_or("none");
        let ours = metadata.workspace_members.contains(&package.id);
        if ours && licence != OURS || !ours && !allowed(licence) {
            refused.push(format!("{}: {licence}", package.name));
        }
    }
    println!(
        "{} packages, all under licences of the list in tests/house/licences.rs",
        metadata.packages.len()
    );
    assert!(refused.is_empty(), "licences not allowed:\n  {}", refused.join("\n  "));
}

#[test]
fn expressions_are_read_as_spdx_means_them() {
    for yes in [
        "MIT",
        "MIT/Apache-2.0",
        "GPL-3.0-only OR MIT",
        "Apache-2.0 WITH LLVM-exception OR GPL-2.0",
        "(MIT OR Apache-2.0) AND OFL-1.1 AND Ubuntu-font-1.0",
        "(GPL-2.0 OR (ISC AND Zlib))",
    ] {
        assert!(allowed(yes), "{yes}");
    }
    for no in [
        "",
        "none",
        "GPL-3.0-only",
        "MIT AND GPL-3.0",
        "LGPL-2.1 OR AGPL-3.0",
        "(MIT",
        "MIT)",
        "MIT OR",
        "MIT MIT",
    ] {
        assert!(!allowed(no), "{no}");
    }
}
