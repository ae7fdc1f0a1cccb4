//! Run parameters of LUNSIM (section 20), as `[lunsim]` and `--set lunsim.KEY=VALUE` say them.

use diagnostics::{ProblemList, Problems, Reader, TomlFile};

/// Run parameters of LUNSIM that no other generator has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LunsimRun {
    /// Points of the ground grid along the line of sight, and as many across it.
    pub grid: u32,
    /// Intensity codes of the recorder, 0 being black.
    pub intensity_codes: u32,
    /// Whether what the program could not do is refused.
    pub restrictions: bool,
}

impl Default for LunsimRun {
    /// The largest grid that the report allows; 16 codes and restrictions as reported (the number of codes is our
    /// choice).
    fn default() -> Self {
        Self { grid: 1024, intensity_codes: 16, restrictions: true }
    }
}

impl LunsimRun {
    /// The parameters of a `[lunsim]` table, `usual` where it is silent.
    pub(crate) fn of_table(table: &Reader, usual: Self) -> Option<Self> {
        let grid = table.u32("grid").between(8, 4096).default(usual.grid);
        let codes = table.u32("intensity_codes").between(2, 256).default(usual.intensity_codes);
        let restrictions = table.bool("restrictions").default(usual.restrictions);
        Some(Self { grid: grid?, intensity_codes: codes?, restrictions: restrictions? })
    }

    /// These parameters with what `lines` of TOML say instead; `origin` names where they come from.
    ///
    /// # Errors
    /// Every fault of the lines.
    pub fn with(self, origin: &str, lines: &str) -> Result<Self, ProblemList> {
        let problems = Problems::new();
        let changed = TomlFile::parse(origin, lines, &problems).and_then(|file| {
            let root = file.root(&problems);
            let changed = Self::of_table(&root, self);
            root.finish();
            changed
        });
        problems.resolve(changed)
    }
}

#[cfg(test)]
mod tests {
    use super::LunsimRun;

    #[test]
    fn lines_change_what_they_name() {
        let run = LunsimRun::default().with("--set", "grid = 64\nrestrictions = false").unwrap();
        assert_eq!(run, LunsimRun { grid: 64, intensity_codes: 16, restrictions: false });
        let wrong = LunsimRun::default().with("--set", "grid = 4\ngird = 64").unwrap_err();
        assert_eq!(wrong.iter().count(), 2, "{wrong:?}");
    }
}
