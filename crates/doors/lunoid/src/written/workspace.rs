//! What a line of cargo names.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use super::pages::root;

/// What `cargo metadata` says.
#[derive(Debug, Deserialize)]
pub struct Workspace {
    packages: Vec<Package>,
}

#[derive(Debug, Deserialize)]
struct Package {
    name: String,
    targets: Vec<Target>,
    features: BTreeMap<String, Vec<String>>,
}

#[derive(Debug, Deserialize)]
struct Target {
    name: String,
    kind: Vec<String>,
    src_path: PathBuf,
}

/// What cargo builds if no package is named: `default-members`.
const DEFAULT: &str = "lunoid";

impl Workspace {
    /// Asks cargo, from the lock file as it stands.
    pub fn read() -> Self {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let arguments = ["metadata", "--format-version", "1", "--locked", "--no-deps"];
        let output = Command::new(cargo).args(arguments).current_dir(root()).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice(&output.stdout).unwrap()
    }

    /// Arguments of cargo: the packages, targets and tests that they name are there. Returns the arguments for
    /// `lunoid`, if it is what runs.
    pub fn cargo<'a>(&self, arguments: &[&'a str]) -> Result<Option<Vec<&'a str>>, String> {
        let split = arguments.iter().position(|&word| word == "--").unwrap_or(arguments.len());
        let (of_cargo, of_program) = arguments.split_at(split);
        let Some((&verb, of_cargo)) = of_cargo.split_first() else { return Err("cargo does what?".into()) };
        match verb {
            "run" | "test" | "bench" | "build" => {}
            // Tools of others, with options of their own.
            "install" | "llvm-cov" | "mutants" | "audit" => return Ok(None),
            _ => return Err(format!("cargo {verb}: not known to this test")),
        }
        let (mut package, mut targets, mut features, mut handed_on) =
            (None, Vec::new(), Vec::new(), Vec::new());
        let of_all = of_cargo.contains(&"--workspace");
        let mut words = of_cargo.iter().copied();
        while let Some(word) = words.next() {
            let mut next = || words.next().ok_or_else(|| format!("{word}: expected a name"));
            match word {
                "-p" | "--package" => package = Some(next()?),
                "--bin" | "--example" | "--test" | "--bench" => targets.push((&word[2..], next()?)),
                "--features" => features.extend(next()?.split(',')),
                "--profile" => expect_profile(next()?)?,
                "--release" | "--quiet" | "--workspace" => {}
                _ if !word.starts_with('-') => handed_on.push(word),
                _ => return Err(format!("cargo {verb} {word}: not known to this test")),
            }
        }
        handed_on.extend(of_program.iter().skip(1));
        if of_all && package.is_some() {
            return Err("--workspace and a package; name one of both".into());
        }
        let package = package.unwrap_or(DEFAULT);
        let named = self.packages.iter().find(|candidate| candidate.name == package);
        let named = named.ok_or_else(|| format!("no package {package}"))?;
        if let Some(feature) = features.into_iter().find(|&feature| !named.features.contains_key(feature)) {
            return Err(format!("package {package} has no feature {feature}"));
        }
        let searched = if of_all { &self.packages[..] } else { std::slice::from_ref(named) };
        let found: Vec<&Target> =
            targets.iter().map(|(kind, name)| target(searched, kind, name)).collect::<Result<_, _>>()?;
        match verb {
            "run" if targets.is_empty() && named.count("bin") != 1 => {
                return Err(format!("package {package} has no bin of its own; name one"));
            }
            "bench" if named.count("bench") == 0 => return Err(format!("package {package} has no bench")),
            "test" => {
                let filters = handed_on.iter().filter(|word| !word.starts_with('-'));
                for (filter, target) in
                    filters.flat_map(|filter| found.iter().map(move |target| (filter, target)))
                {
                    target.expect_test(filter)?;
                }
            }
            _ => {}
        }
        Ok((verb == "run" && package == DEFAULT).then_some(handed_on))
    }
}

impl Package {
    fn count(&self, kind: &str) -> usize {
        self.targets.iter().filter(|target| target.kind.iter().any(|of| of == kind)).count()
    }
}

impl Target {
    /// Some function or module of the target has a name with `filter` in it.
    fn expect_test(&self, filter: &str) -> Result<(), String> {
        let of_folder = self.src_path.file_name().is_some_and(|name| name == "main.rs");
        let place = if of_folder { self.src_path.parent().unwrap() } else { &self.src_path };
        if names_in(place).iter().any(|name| name.contains(filter)) {
            return Ok(());
        }
        Err(format!("{} has no test {filter}", self.name))
    }
}

/// The target of this kind and name in one of `packages`.
fn target<'a>(packages: &'a [Package], kind: &str, name: &str) -> Result<&'a Target, String> {
    let is_it = |target: &&Target| target.name == name && target.kind.iter().any(|of| of == kind);
    packages.iter().flat_map(|package| &package.targets).find(is_it).ok_or_else(|| match packages {
        [package] => format!("package {} has no {kind} {name}", package.name),
        _ => format!("no package has a {kind} {name}"),
    })
}

/// The workspace has a profile of this name.
fn expect_profile(name: &str) -> Result<(), String> {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let has_it = manifest.lines().any(|line| line == format!("[profile.{name}]"));
    if has_it { Ok(()) } else { Err(format!("no profile {name}")) }
}

/// Names of functions and modules in a file, or in all below a folder.
fn names_in(path: &Path) -> Vec<String> {
    if path.is_dir() {
        let below = fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
        return below.flat_map(|path| names_in(&path)).collect();
    }
    if path.extension().is_none_or(|extension| extension != "rs") {
        return Vec::new();
    }
    let text = fs::read_to_string(path).unwrap();
    let named = |line: &str| {
        let line = line.trim_start();
        let rest = line.strip_prefix("fn ").or_else(|| line.strip_prefix("mod "))?;
        Some(rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()?.to_owned())
    };
    text.lines().filter_map(named).collect()
}
