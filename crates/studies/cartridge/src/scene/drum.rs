//! One drum that is asked for one corner at a time.

use data_bank::{Contents, DataBank, Demand, Piece, StoreDesign};
use hardware_model::HardwareModel;
use quantities::Tick;
use serde::Deserialize;

use super::within;
use crate::hardware::Hardware;

/// A drum of the hardware model, and requests at regular times for corners all over it, each when the one before has come.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DrumScene {
    /// Corners of the level, to the north and to the east.
    pub corners: [usize; 2],
    /// Number of requests to the drum.
    pub requests: u64,
    /// From one request to the next.
    pub every_ms: f64,
    /// Hardware model that has the drum.
    pub hardware: Hardware,
}

/// A drum under one hardware model.
#[derive(Debug, Clone)]
pub struct DrumCase {
    pub scene: DrumScene,
    pub model: HardwareModel,
}

/// Waits (s) of the requests that were met, each from the request to the begin of its record.
#[derive(Debug, Clone, Default)]
pub struct Waits {
    pub seconds: Vec<f64>,
}

/// Golden section of the number of corners: requests fall all over the drum.
const STRIDE: f64 = 0.618_033_988_749_894_9;

impl DrumScene {
    pub(super) fn cases(&self) -> Result<Vec<DrumCase>, String> {
        within("requests", self.requests as f64, 1.0, 1e6)?;
        within("every_ms", self.every_ms, 1e-3, 1e6)?;
        self.corners.iter().try_for_each(|&count| within("corners", count as f64, 2.0, 1024.0))?;
        let models = self.hardware.load()?;
        if models.iter().any(|model| model.data_banks.drum.is_none()) {
            return Err("hardware: drum.rotation_ms = 0: expected a drum".into());
        }
        let case = |model| DrumCase { scene: self.clone(), model };
        Ok(models.into_iter().map(case).collect())
    }
}

impl DrumCase {
    /// One nominal turn (s).
    pub fn turn(&self) -> f64 {
        let rotation = self.model.data_banks.drum.map_or(0, |drum| drum.rotation);
        rotation as f64 / self.model.master_clock.hertz()
    }

    pub(super) fn run(&self) -> Waits {
        let banks = self.model.data_banks;
        let Some(drum) = banks.drum else { return Waits::default() };
        let corners = self.scene.corners;
        // Room for one record, so that each is fetched anew.
        let store = StoreDesign {
            contents: Contents::Corners(corners),
            record_words: drum.record_words,
            buffer_words: Some(drum.record_words),
            edit: 0.0,
        };
        let mut bank = DataBank::new(drum, banks.channels, &[store], self.model.seed);
        let units: Vec<_> = bank.drums(0).collect();
        let every = (1e-3 * self.scene.every_ms * self.model.master_clock.hertz()).round().max(1.0) as u64;
        let total = (corners[0] * corners[1]) as f64;
        let mut waits = Waits::default();
        for frame in 0..=self.scene.requests {
            let corner = ((frame as f64 * STRIDE).fract() * total) as u32;
            let (start, end) = (Tick(frame * every), Tick((frame + 1) * every));
            let wants = vec![vec![Piece::one(corner)]];
            let supplies = bank.frame(&Demand { frame, start, end, wants });
            for missing in supplies.iter().flat_map(|supply| &supply.missing) {
                let unit = units[missing.drum as usize];
                if let Some(arrival) = missing.arrival {
                    let wait = arrival.0 as f64 - start.0 as f64 - unit.transfer as f64;
                    waits.seconds.push(wait / self.model.master_clock.hertz());
                }
            }
        }
        waits
    }
}
