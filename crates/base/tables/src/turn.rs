//! Angles that go further than once around: often in another unit than their column says.

use std::f64::consts::TAU;

/// Says so if the largest angle of a column, either way and in the column's own unit, is more than a turn. The name of the
/// column ends with the unit.
pub(crate) fn beyond_a_turn(name: &str, largest: f64) -> Option<String> {
    // Numbers of a file are rounded.
    let is_beyond = |turn: f64| largest > turn * (1.0 + 1e-6);
    if let Some(angle) = name.strip_suffix("_rad").filter(|_| is_beyond(TAU)) {
        return Some(format!(
            "{name} goes up to {largest}, more than 2 pi: if these are degrees, name the column {angle}_deg"
        ));
    }
    name.strip_suffix("_deg").filter(|_| is_beyond(360.0)).map(|angle| {
        format!(
            "{name} goes up to {largest}, more than a turn of 360 degrees: check that {angle} is in degrees"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::beyond_a_turn;

    #[test]
    fn more_than_a_turn_is_told() {
        let told = |name, largest| beyond_a_turn(name, largest).is_some();
        assert!(told("heading_rad", 6.3) && told("pitch_rad", 45.0) && told("roll_deg", 361.0));
        assert!(!told("heading_rad", 6.283_186) && !told("heading_deg", 360.0) && !told("turn_deg_s", 400.0));
        assert!(beyond_a_turn("yaw_rad", 45.0).unwrap().contains("name the column yaw_deg"));
    }
}
