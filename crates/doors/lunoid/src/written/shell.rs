//! As much of a shell as the pages need.

/// A command with its words, without redirections and what is set for it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Command {
    /// Line of the script, from 0.
    pub line: usize,
    pub words: Vec<String>,
}

/// The commands of a script, those of a loop once for each of its values.
pub fn commands(script: &str) -> Result<Vec<Command>, String> {
    let mut loops: Vec<(String, Vec<String>)> = Vec::new();
    let mut unrolled = Vec::new();
    for Command { line, mut words } in split(script)? {
        if words[0] == "do" {
            words.remove(0);
        }
        match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
            [] => {}
            ["for", name, "in", values @ ..] => {
                loops.push((format!("${name}"), values.iter().map(|&value| value.to_owned()).collect()));
            }
            ["done"] => {
                loops.pop().ok_or_else(|| format!("line {line}: `done` without `for`"))?;
            }
            _ => {
                let each = |all: Vec<Vec<String>>, (name, values): &(String, Vec<String>)| {
                    let with = |words: &[String], value: &str| {
                        words.iter().map(|word| word.replace(name.as_str(), value)).collect::<Vec<_>>()
                    };
                    all.iter().flat_map(|words| values.iter().map(|value| with(words, value))).collect()
                };
                let all = loops.iter().fold(vec![without_settings(words)], each);
                unrolled.extend(all.into_iter().map(|words| Command { line, words }));
            }
        }
    }
    if loops.is_empty() { Ok(unrolled) } else { Err("`for` without `done`".into()) }
}

/// Without `env` and `NAME=VALUE` in front.
fn without_settings(words: Vec<String>) -> Vec<String> {
    let is_setting = |word: &String| {
        let name = word.split_once('=').map_or("", |(name, _)| name);
        word == "env" || !name.is_empty() && name.bytes().all(|c| c.is_ascii_uppercase() || c == b'_')
    };
    words.into_iter().skip_while(is_setting).collect()
}

/// Commands between the ends of lines, pipes, `;` and `&`.
fn split(script: &str) -> Result<Vec<Command>, String> {
    let (mut commands, mut words, mut word) = (Vec::new(), Vec::new(), None::<String>);
    let (mut line, mut first) = (0, 0);
    let mut characters = script.chars().chain(['\n']).peekable();
    while let Some(character) = characters.next() {
        match character {
            '\'' | '"' => {
                let quoted = word.get_or_insert_default();
                loop {
                    match characters.next() {
                        Some(end) if end == character => break,
                        Some(inside) => quoted.push(inside),
                        None => return Err(format!("line {first}: {character} is not closed")),
                    }
                }
            }
            '\\' if characters.peek() == Some(&'\n') => {
                characters.next();
                line += 1;
            }
            '#' if word.is_none() => while characters.next_if(|&c| c != '\n').is_some() {},
            '>' => {
                words.extend(word.take());
                while characters.next_if(|&c| c == '>' || c == ' ').is_some() {}
                while characters.next_if(|c| !c.is_whitespace()).is_some() {}
            }
            ';' | '|' | '&' | '\n' => {
                words.extend(word.take());
                if !words.is_empty() {
                    commands.push(Command { line: first, words: std::mem::take(&mut words) });
                }
                line += usize::from(character == '\n');
                first = line;
            }
            _ if character.is_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(character),
        }
    }
    Ok(commands)
}

#[test]
fn scripts_are_read_as_a_shell_reads_them() {
    let read = |script: &str| -> Vec<(usize, String)> {
        let commands = commands(script).unwrap();
        commands.into_iter().map(|Command { line, words }| (line, words.join("_"))).collect()
    };
    assert_eq!(read("a 'b c'  \"d\" # e\n\n f"), [(0, "a_b c_d".into()), (2, "f".into())]);
    assert_eq!(
        read("a \\\n  b > c | d; e && f#g"),
        [(0, "a_b".into()), (1, "d".into()), (1, "e".into()), (1, "f#g".into())]
    );
    assert_eq!(read("env A_B=1 a C=2"), [(0, "a_C=2".into())]);
    let two = "for a in 1 2; do\n  for b in 3 4; do\n    c $a.$b\n  done\ndone\nd";
    assert_eq!(
        read(two),
        [(2, "c_1.3".into()), (2, "c_1.4".into()), (2, "c_2.3".into()), (2, "c_2.4".into()), (5, "d".into())]
    );
    for wrong in ["a 'b", "for a in b; do c", "done"] {
        assert!(commands(wrong).is_err(), "{wrong}");
    }
}
