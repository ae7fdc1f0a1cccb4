//! Run parameters of the program (section 20), as `[lunsim]` and `--set lunsim.KEY=VALUE` give them.

use diagnostics::Reader;

/// Run parameters that no other generator has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parameters {
    /// Points of the ground grid along the line of sight, and as many across it, 8..=4096.
    pub grid: u32,
    /// Intensity codes of the recorder, 0 being black, 2..=256.
    pub intensity_codes: u32,
    /// Whether what the program could not do is refused.
    pub restrictions: bool,
}

impl Default for Parameters {
    /// The largest grid that the report allows; 16 codes and restrictions as reported (the number of codes is our
    /// choice).
    fn default() -> Self {
        Self { grid: 1024, intensity_codes: 16, restrictions: true }
    }
}

impl Parameters {
    /// The parameters of a `[lunsim]` table; the default where the table has no key.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let grid = table.u32("grid").between(8, 4096).default(usual.grid);
        let codes = table.u32("intensity_codes").between(2, 256).default(usual.intensity_codes);
        let restrictions = table.bool("restrictions").default(usual.restrictions);
        Some(Self { grid: grid?, intensity_codes: codes?, restrictions: restrictions? })
    }
}
