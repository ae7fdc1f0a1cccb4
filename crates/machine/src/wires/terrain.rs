//! Wires of the terrain generators.

use parts::Jumps;
use signal::{LANES, Real};
use terrain_generator::Profile;

use crate::wires::{Axes, Ends, Wires, drop_beyond, hold_beyond};

impl<S: Real> Wires<S> {
    /// Height and slopes behind their amplifiers; sweeps run in `directions`.
    pub fn drive_terrain(&self, directions: &[[f64; 2]; LANES], ends: &Ends, profile: &mut Profile<S>) {
        let Profile { height, along, across, .. } = profile;
        let mut no_jumps = Jumps::default();
        if let Some(driver) = &self.terrain.height {
            hold_beyond(ends, height);
            driver.pass(height, &mut no_jumps);
            drop_beyond(ends, height);
        }
        if self.terrain.slopes.iter().any(Option::is_some) {
            let axes = Axes::new(directions);
            axes.to_map(along, across);
            for (driver, slope) in self.terrain.slopes.iter().zip([&mut *along, &mut *across]) {
                driver.iter().for_each(|driver| driver.pass(slope, &mut no_jumps));
            }
            axes.to_sweep(along, across);
        }
    }

    /// Reflectivity behind its amplifier.
    pub fn drive_terrain_light(&self, profile: &mut Profile<S>) {
        if let Some(driver) = &self.terrain.reflectivity {
            driver.pass(&mut profile.reflectivity, &mut Jumps::default());
        }
    }
}
