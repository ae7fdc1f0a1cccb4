//! Keys of `--set` that are LUNSIM's and not the hardware model's.

use lunsim::Hardware;

use crate::Failure;

/// Tables of what LUNSIM ran on.
pub const GEAR: [&str; 2] = ["computer", "recorder"];

/// The key of a run parameter, without its table.
pub fn run_key(key: &str) -> Option<&str> {
    key.strip_prefix("lunsim.")
}

/// Whether a key is of the computer or of the recorder.
pub fn is_of_gear(key: &str) -> bool {
    key.split_once('.').is_some_and(|(table, _)| GEAR.contains(&table))
}

/// Times of computer and recorder, with what `sets` say of them.
pub fn hardware(sets: &[(String, String)]) -> Result<Hardware, Failure> {
    let mut hardware = Hardware::shipped()?;
    for (key, value) in sets.iter().filter(|(key, _)| is_of_gear(key)) {
        hardware = hardware.with("--set", &format!("{key} = {value}"))?;
    }
    Ok(hardware)
}

#[cfg(test)]
mod tests {
    use super::{is_of_gear, run_key};

    #[test]
    fn keys_have_their_tables() {
        assert_eq!((run_key("lunsim.grid"), run_key("raster.sweeps")), (Some("grid"), None));
        assert!(is_of_gear("computer.add_us") && is_of_gear("recorder.points_s"));
        assert!(
            !is_of_gear("cpu.multiply_us") && !is_of_gear("computer") && !is_of_gear("recorders.points_s")
        );
    }
}
