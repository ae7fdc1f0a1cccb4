use crate::scene::{Scene, lunoid};

/// What `command --help` says.
fn help(command: &[String]) -> String {
    let output = lunoid().args(command).arg("--help").output().unwrap();
    assert!(output.status.success(), "{command:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The commands that a help lists, without `help` itself. Lines that go on with a description are further in.
fn listed(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let names = lines.take_while(|line| !line.is_empty()).filter_map(|line| {
        line.strip_prefix("  ").filter(|line| !line.starts_with(' '))?.split_whitespace().next()
    });
    names.filter(|name| *name != "help").map(str::to_owned).collect()
}

#[test]
fn every_command_has_help_with_an_example() {
    let mut commands = vec![Vec::new()];
    let mut seen = 0;
    while let Some(command) = commands.pop() {
        let text = help(&command);
        assert!(text.contains("Example") && text.contains("  lunoid "), "{command:?}:\n{text}");
        // Lines that are too long are broken, and cannot be pasted.
        let examples = text.lines().skip_while(|line| !line.starts_with("Example")).skip(1);
        let broken = examples.take_while(|line| !line.is_empty()).find(|line| !line.starts_with("  "));
        assert_eq!(broken, None, "{command:?}: an example goes on at the margin");
        let below = |name| command.iter().cloned().chain([name]).collect();
        commands.extend(listed(&text).into_iter().map(below));
        seen += 1;
    }
    // The program, its 35 commands, and what is below nine of them.
    assert_eq!(seen, 1 + 35 + 5 + 7 + 3 + 4 + 4 + 4 + 10 + 3 + 1, "a command more or less: count again");
}

#[test]
fn the_version_says_commit_and_result_family_and_no_time() {
    let output = lunoid().arg("--version").output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with(concat!("lunoid ", env!("CARGO_PKG_VERSION"), " (commit ")), "{text}");
    assert!(text.ends_with(", result family unfused)\n"), "{text}");
}

#[test]
fn misuse_ends_with_2() {
    let scene = Scene::new();
    for wrong in [
        &["replya"][..],
        &[],
        &["replay"],
        &["replay", "tiny.toml", "--frames", "3..1"],
        &["replay", "tiny.toml", "--frames", "0..99"],
        &["replay", "tiny.toml", "--frames", "4"],
        &["replay", "tiny.toml", "--sweeps", "0"],
        &["replay", "tiny.toml", "--jobs", "0"],
        &["replay", "tiny.toml", "--depth", "12"],
        &["replay", "tiny.toml", "--set", "sweeps"],
        &["replay", "tiny.toml", "--y4m", "-", "--json"],
        &["probe", "tiny.toml", "--frame", "0", "--sweep", "0", "--out", "a.txt"],
        &["probe", "tiny.toml", "--frame", "9", "--sweep", "0", "--out", "a.csv"],
        &["probe", "tiny.toml", "--frame", "0", "--sweep", "40", "--out", "a.csv"],
        &["probe", "tiny.toml", "--frame", "0", "--sweep", "0", "--out", "a.csv", "--signals", "tg.nothing"],
        &["compare", "a.png"],
        &["compare", "a.png", "b.png", "--share", "1"],
        &["bank", "import", "a.npy", "--region-size-m", "-1", "-o", "a.bank"],
        &["survey", "a.tif", "--centre", "1,2", "-o", "a.bank"],
    ] {
        let (out, err) = scene.expect(2, wrong);
        assert!(out.is_empty() && err.contains("error") | err.contains("Usage"), "{wrong:?}: {err}");
    }
    assert_eq!(scene.list("."), ["tiny.toml"]);
}

#[test]
fn lists_are_tables_or_documents() {
    let scene = Scene::new();
    std::fs::create_dir(scene.join("scenarios")).unwrap();
    std::fs::copy(scene.join("tiny.toml"), scene.join("scenarios/tiny.toml")).unwrap();
    scene.write("scenarios/broken.toml", "format = 1\n");
    let (out, _) = scene.expect(0, &["list", "scenarios"]);
    assert!(out.contains("scenarios/tiny.toml    Tiny   Nothing but a test."), "{out}");
    assert!(out.contains("faults: see lunoid check"), "{out}");
    let (out, _) = scene.expect(0, &["list", "models"]);
    assert!(out.contains("ideal") && out.contains("built in"), "{out}");
    for (arguments, schema, key) in [
        (&["list", "models", "--json"][..], "lunoid.list/1", "models"),
        (&["list", "limits", "--json"], "lunoid.list/1", "limits"),
        (&["list", "scenarios", "--json"], "lunoid.list/1", "scenarios"),
        (&["list", "signals", "--json"], "lunoid.signals/1", "signals"),
        (&["signals", "tg.*", "--json"], "lunoid.signals/1", "signals"),
        (&["model", "show", "ideal", "--json"], "lunoid.model/1", "values"),
        (&["info", "tiny.toml", "--json"], "lunoid.info.scenario/1", "title"),
    ] {
        let (out, _) = scene.expect(0, arguments);
        let document: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert_eq!(document["schema"], schema, "{arguments:?}");
        assert!(!document[key].is_null(), "{arguments:?}");
    }
}

/// The reader goes away after the first line, as `head` does.
#[test]
fn a_closed_pipe_is_quiet() {
    let mut command = std::process::Command::new(assert_cmd::cargo::cargo_bin("lunoid"));
    let command = command.args(["signals", "--json"]).stdout(std::process::Stdio::piped());
    let mut child = command.stderr(std::process::Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}

/// The help of a command offers the machines that it takes, and no others.
#[test]
fn a_help_offers_what_the_command_takes() {
    let of = |command: &str| help(&command.split(' ').map(str::to_owned).collect::<Vec<_>>());
    for command in ["trigger", "trace", "lockstep", "timing columns", "study error", "study economy"] {
        let text = of(command);
        assert!(text.contains("Hardware model by name or path"), "{command}: {text}");
        assert!(!text.contains("`exact`") && !text.contains("`lunsim`"), "{command}: {text}");
    }
    for command in ["timing show", "timing record", "timing check"] {
        let text = of(command);
        assert!(text.contains("or `lunsim`"), "{command}: {text}");
        assert!(!text.contains("`exact`"), "{command}: {text}");
    }
    let sizing = of("sizing");
    assert!(
        sizing.contains("a generator whose frames have deadlines") && !sizing.contains("`exact`"),
        "{sizing}"
    );
    assert!(of("probe").contains("`lunsim`") && of("replay").contains("`exact`"));
    assert!(of("explain").contains("`lunsim`") && of("explain").contains("`exact`"));
}
