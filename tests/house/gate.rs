//! Files are opened in one place (`crates/base/files`), which follows no link where something is written and waits for no pipe.

use std::fs;
use std::path::PathBuf;

use crate::metadata::root;
use crate::sources::sources;

/// Ways to open, make or rename a file that go round the gate. In halves, so that this file does not accuse itself.
const ROUND: [(&str, &str); 10] = [
    ("File::", "open("),
    ("File::", "create"),
    ("Open", "Options"),
    ("fs::", "read("),
    ("fs::", "read_to_string("),
    ("fs::", "write("),
    ("fs::", "rename("),
    ("fs::", "copy("),
    ("fs::", "create_dir"),
    ("fs::", "hard_link("),
];

/// Who may: the gate, tools that measure and are no part of the program, a study that asks the system about its threads, and a
/// reader of what a simulator left in a folder of its own.
const MAY: [&str; 4] = [
    "crates/base/files/src/",
    "crates/studies/benchmarks/src/",
    "crates/studies/study/src/economy/mod.rs",
    "crates/instruments/netlist/src/run.rs",
];

/// Lines of a source file that go round the gate, tests aside.
fn accusations(text: &str) -> Vec<String> {
    let is_test = |line: &&str| line.trim_start().starts_with("#[cfg(test)]");
    let code = text.lines().take_while(|line| !is_test(line)).enumerate();
    let code = code.map(|(number, line)| (number + 1, line.split("//").next().unwrap_or_default()));
    // What the system says of this process is no file of a user's.
    let code = code.filter(|(_, line)| !line.contains("/proc/self/"));
    let found = |line: &str| ROUND.iter().any(|(head, tail)| line.contains(&format!("{head}{tail}")));
    code.filter(|(_, line)| found(line)).map(|(number, line)| format!("{number}: {}", line.trim())).collect()
}

#[test]
fn nobody_goes_round_the_gate() {
    let mut files = Vec::new();
    sources(&root().join("crates"), &mut files);
    let name = |file: &PathBuf| file.strip_prefix(root()).expect("below the root").display().to_string();
    let is_program = |name: &String| {
        name.contains("/src/")
            && !name.contains("tests")
            && !name.contains("src/written/")
            && !MAY.iter().any(|may| name.starts_with(may))
    };
    let mut found = Vec::new();
    for file in files.iter().filter(|file| is_program(&name(file))) {
        let text = fs::read_to_string(file).expect("a source file in UTF-8");
        found.extend(accusations(&text).into_iter().map(|line| format!("{}:{line}", name(file))));
    }
    assert!(found.is_empty(), "files opened outside crates/base/files:\n  {}", found.join("\n  "));
}

#[test]
fn the_gate_is_seen() {
    let call = |(head, tail): (&str, &str)| format!("let x = {head}{tail}path);");
    for round in ROUND {
        assert_eq!(accusations(&call(round)).len(), 1, "{round:?}");
    }
    assert_eq!(
        accusations("let x = files::read_all(path, 3); // by no other way\nlet y = files::open(path);"),
        [""; 0]
    );
    assert_eq!(accusations(&format!("#[cfg(test)]\nmod tests {{ {} }}", call(ROUND[0]))), [""; 0]);
}
