//! What this program is, for records.

use run_record::Program;

/// Results of one family are equal to the bit: no fused multiply-add anywhere.
const RESULT_FAMILY: &str = "unfused";
/// Version, commit and result family, as `--version` says them.
pub const VERSION: &str =
    concat!(env!("CARGO_PKG_VERSION"), " (commit ", env!("LUNOID_COMMIT"), ", result family unfused)");
/// Commit of the build, or "unknown".
pub const COMMIT: &str = env!("LUNOID_COMMIT");

/// This program, for records.
pub fn program() -> Program {
    Program {
        name: "lunoid".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        commit: COMMIT.into(),
        result_family: RESULT_FAMILY.into(),
    }
}
