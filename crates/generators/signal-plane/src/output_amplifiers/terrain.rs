//! Wires of the terrain generators.

use parts::Jumps;
use signal::{LANES, Real};
use terrain_generator::Profile;

use crate::output_amplifiers::{Ends, OutputAmplifiers, drop_beyond, hold_beyond};

impl<S: Real> OutputAmplifiers<S> {
    /// Height and slopes behind their amplifiers; sweeps run in `directions`.
    pub fn drive_terrain(&self, directions: &[[f64; 2]; LANES], ends: &Ends, profile: &mut Profile<S>) {
        let Profile { height, along, across, .. } = profile;
        if self.terrain.height.is_some() {
            hold_beyond(ends, height);
        }
        self.terrain.drive(directions, [height, along, across]);
        if self.terrain.height.is_some() {
            drop_beyond(ends, height);
        }
    }

    /// Reflectivity behind its amplifier.
    pub fn drive_terrain_light(&self, profile: &mut Profile<S>) {
        if let Some(driver) = &self.terrain.reflectivity {
            driver.pass(&mut profile.reflectivity, &mut Jumps::default());
        }
    }
}
