//! The words of a command line that choose a stage, for commands that a page shows.

use crate::loading::{ScalarWord, StageArgs};

/// The scenario, then the options that were given.
pub fn words(stage: &StageArgs) -> Vec<String> {
    let options = &stage.options;
    let path = |path: &std::path::PathBuf| path.display().to_string();
    let mut words = vec![path(&stage.scenario)];
    let mut option = |name: &str, value: String| words.extend([name.to_owned(), value]);
    stage.machine.iter().for_each(|machine| option("--machine", machine.clone()));
    options.overlay.iter().for_each(|file| option("--overlay", path(file)));
    options.set.iter().for_each(|(key, value)| option("--set", format!("{key}={value}")));
    options.channel.iter().for_each(|channel| option("--channel", channel.clone()));
    options.bank.iter().for_each(|bank| option("--bank", path(bank)));
    options.sweeps.iter().for_each(|sweeps| option("--sweeps", sweeps.to_string()));
    options.samples.iter().for_each(|samples| option("--samples", samples.to_string()));
    let scalar = |word: &ScalarWord| match word {
        ScalarWord::F32 => "f32",
        ScalarWord::F64 => "f64",
    };
    options.scalar.iter().for_each(|word| option("--scalar", scalar(word).to_owned()));
    options.quality.iter().for_each(|quality| option("--quality", quality.word().to_owned()));
    options.shadow_cache.iter().for_each(|folder| option("--shadow-cache", path(folder)));
    let flags = [(options.lossless, "--lossless"), (options.everything, "--everything")];
    words.extend(flags.into_iter().filter(|(is_given, _)| *is_given).map(|(_, word)| word.to_owned()));
    words
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::words;
    use crate::loading::{QualityWord, StageArgs};

    #[derive(Debug, Parser)]
    struct Line {
        #[command(flatten)]
        stage: StageArgs,
    }

    fn given(line: &[&str]) -> Vec<String> {
        words(&Line::parse_from([&["lunoid"], line].concat()).stage)
    }

    #[test]
    fn they_choose_the_same_stage() {
        assert_eq!(given(&["a.toml"]), ["a.toml"]);
        let all = "a.toml --machine m --overlay o.toml --set raster.sweeps=5 --set dpp.curvature=none --channel left --bank b \
                   --sweeps 40 --samples 80 --scalar f64 --shadow-cache shadows --everything";
        let all: Vec<&str> = all.split_whitespace().collect();
        assert_eq!(given(&all), all);
        let mut draft = Line::parse_from(["lunoid", "a.toml"]).stage;
        draft.options.quality = Some(QualityWord::Draft);
        assert_eq!(words(&draft), ["a.toml", "--quality", "draft"]);
        let again: Vec<String> = given(&all);
        assert_eq!(given(&again.iter().map(String::as_str).collect::<Vec<_>>()), all);
    }
}
