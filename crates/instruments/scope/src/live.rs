//! The scope of a page: scripts that draw waveforms on a canvas, in the instrument and in the page of a run.

/// Name and text of a script of the folder `page`.
macro_rules! script {
    ($name:literal) => {
        ($name, include_str!(concat!("../page/", $name)))
    };
}

/// The scripts, each a module that names the others by their files.
pub const LIVE: [(&str, &str); 7] = [
    script!("curve.js"),
    script!("scope-hand.js"),
    script!("scope-lane.js"),
    script!("scope-ticks.js"),
    script!("scope-values.js"),
    script!("scope-xy.js"),
    script!("scope.js"),
];

/// All of [`LIVE`] as one script for a page without files beside it: it makes an object `live` with `Scope` and `showValues`.
pub fn live_script() -> String {
    let lines = LIVE.iter().flat_map(|(_, text)| text.lines()).filter(|line| !line.starts_with("import "));
    let own = lines.map(|line| line.strip_prefix("export ").unwrap_or(line));
    let body = own.collect::<Vec<_>>().join("\n");
    format!("const live = (() => {{\n\"use strict\";\n{body}\nreturn {{ Scope, showValues }};\n}})();\n")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{LIVE, live_script};

    /// The name that a line at the left edge declares, if it declares one.
    fn declared(line: &str) -> Option<&str> {
        if line.starts_with(char::is_whitespace) {
            return None;
        }
        let words: Vec<&str> = line.split([' ', '(', '=', ';']).filter(|word| !word.is_empty()).collect();
        let rest = words.strip_prefix(&["export"]).unwrap_or(&words);
        match rest {
            [kind, name, ..] if ["const", "let", "function", "class"].contains(kind) => Some(name),
            _ => None,
        }
    }

    #[test]
    fn one_script_has_no_name_twice_and_asks_for_no_file() {
        let names: Vec<&str> = LIVE.iter().flat_map(|(_, text)| text.lines()).filter_map(declared).collect();
        assert!(names.contains(&"Scope") && names.contains(&"showValues") && names.len() > 20, "{names:?}");
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "{names:?}");
        let script = live_script();
        assert!(!script.contains("import ") && !script.contains("\nexport "), "{script}");
        assert!(!script.contains("</script"), "nothing ends the element");
    }

    #[test]
    fn the_scripts_name_only_each_other() {
        let imports =
            LIVE.iter().flat_map(|(_, text)| text.lines()).filter(|line| line.starts_with("import "));
        for line in imports {
            assert!(LIVE.iter().any(|(name, _)| line.ends_with(&format!(" from \"./{name}\";"))), "{line}");
        }
    }
}
