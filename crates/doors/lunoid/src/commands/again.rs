//! Commands that go on from what a command has found: the same stage and frame, as a shell reads them.

use command_line::loading::StageArgs;
use command_line::words::words;

/// `lunoid NAME` on frame `frame` of the same stage, with `rest` behind.
pub fn command(name: &str, stage: &StageArgs, frame: u64, rest: &str) -> String {
    let words: Vec<String> = words(stage).iter().map(|word| quoted(word)).collect();
    format!("lunoid {name} {} --frame {frame} {rest}", words.join(" "))
}

/// A word as a shell reads it.
pub fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-/=,:+".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::{command, quoted};
    use command_line::loading::{StageArgs, StageOptions};

    #[test]
    fn commands_can_be_typed_again() {
        let stage = StageArgs {
            scenario: "my scenes/it's.toml".into(),
            machine: None,
            options: StageOptions {
                set: vec![("a.b".into(), "\"x\"".into())],
                sweeps: Some(21),
                lossless: true,
                ..StageOptions::default()
            },
        };
        let expected = "lunoid trace 'my scenes/it'\\''s.toml' --set 'a.b=\"x\"' --sweeps 21 --lossless --frame 3 --at 1:2";
        assert_eq!(command("trace", &stage, 3, "--at 1:2"), expected);
        assert_eq!(quoted(""), "''");
    }
}
