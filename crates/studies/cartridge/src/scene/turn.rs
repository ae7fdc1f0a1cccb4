//! A view that turns on the spot over regions whose data lie on one drum (hardware section 4.7).

use control_plane::SquareGrid;
use data_bank::{Contents, DataBank, Demand, FrameSupply, Piece, StoreDesign, corners_of, nearest_first};
use dpu::Sector;
use hardware_model::{BankPlace, Drum, HardwareModel, KindBank};
use landscape::Level;
use quantities::{Tick, radians, sin_cos};
use serde::Deserialize;

use super::within;
use crate::hardware::Hardware;

/// A sector of ground that turns, and the drums that bring what it comes to show: corners of terrain, and as many further kinds of
/// data with one record for each region, or for each square of as many regions as a record of terrain has corners.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TurnScene {
    /// Side of a region.
    pub region_m: f64,
    /// Ground range up to which the sector reaches.
    pub range_m: f64,
    /// Width of the sector.
    pub width_deg: f64,
    /// Angle by which the sector turns in a second.
    pub turn_deg_s: f64,
    /// How long it turns; less than once around.
    pub seconds: f64,
    /// Kinds of data on the drums, terrain among them.
    pub kinds: usize,
    /// Hardware model that has the drums.
    pub hardware: Hardware,
}

/// A turn under one hardware model.
#[derive(Debug, Clone)]
pub struct TurnCase {
    pub scene: TurnScene,
    pub model: HardwareModel,
}

/// What the drums did in the turn.
#[derive(Debug, Clone, Copy, Default)]
pub struct Turned {
    /// Records that were asked for anew, a second.
    pub requests: f64,
    /// The same of terrain alone.
    pub terrain_requests: f64,
    /// Share of the time in which a drum was at work, mean of all drums.
    pub busy: f64,
    /// Share of the requests that were given up before they were met.
    pub given_up: f64,
}

/// Regions of the ground beyond the sector on every side.
const BESIDE: usize = 2;

impl TurnScene {
    pub(super) fn cases(&self) -> Result<Vec<TurnCase>, String> {
        within("region_m", self.region_m, 1.0, 1e5)?;
        within("range_m / region_m", self.range_m / self.region_m, 1.0, 200.0)?;
        within("width_deg", self.width_deg, 1.0, 170.0)?;
        within("turn_deg_s", self.turn_deg_s, 0.0, 360.0)?;
        within("seconds", self.seconds, 0.1, 1e4)?;
        within("turn_deg_s seconds", self.turn_deg_s * self.seconds, 0.0, 300.0)?;
        within("kinds", self.kinds as f64, 1.0, 4.0)?;
        let models = self.hardware.load()?;
        if models.iter().any(|model| model.data_banks.drum.is_none()) {
            return Err("hardware: drum.rotation_ms = 0: expected a drum".into());
        }
        let case = |model| TurnCase { scene: self.clone(), model };
        Ok(models.into_iter().map(case).collect())
    }
}

impl TurnCase {
    /// One nominal turn of a drum (s).
    pub fn turn(&self) -> f64 {
        let rotation = self.model.data_banks.drum.map_or(0, |drum| drum.rotation);
        rotation as f64 / self.model.master_clock.hertz()
    }

    pub(super) fn run(&self) -> Result<Turned, String> {
        let Some(drum) = self.model.data_banks.drum else { return Ok(Turned::default()) };
        let ground = Ground::new(&self.scene, &drum)?;
        let mut bank = self.bank(&ground, drum);
        let (update, master) = (self.model.raster.update.hertz(), self.model.master_clock.hertz());
        let frames = (self.scene.seconds * update) as u64;
        let tick = |frame: u64| Tick((frame as f64 * master / update) as u64);
        let [mut busy, mut requests, mut terrain, mut given_up] = [0; 4];
        for frame in 0..frames {
            let from = self.scene.turn_deg_s * frame as f64 / update;
            let wants = ground.wants(&self.scene, from);
            let (start, end) = (tick(frame), tick(frame + 1));
            let supplies = bank.frame(&Demand { frame, start, end, wants });
            let sum = |of: fn(&FrameSupply) -> u64| supplies.iter().map(of).sum::<u64>();
            busy += sum(|supply| supply.busy.iter().sum());
            requests += sum(|supply| supply.requests);
            given_up += sum(|supply| supply.cancelled);
            terrain += supplies[0].requests;
        }
        let seconds = tick(frames).0 as f64 / master;
        Ok(Turned {
            requests: requests as f64 / seconds,
            terrain_requests: terrain as f64 / seconds,
            busy: busy as f64 / (tick(frames).0 * u64::from(drum.count)) as f64,
            given_up: given_up as f64 / requests.max(1) as f64,
        })
    }

    fn bank(&self, ground: &Ground, drum: Drum) -> DataBank {
        let store = |contents| StoreDesign {
            contents,
            record_words: drum.record_words,
            buffer_words: None,
            edit: 0.0,
        };
        let terrain = store(Contents::Corners(ground.level.corners()));
        let further = store(Contents::Chains(ground.grid.count()));
        let mut stores = vec![further; self.scene.kinds];
        stores[0] = terrain;
        DataBank::new(drum, self.model.data_banks.channels, &stores, self.model.seed)
    }
}

/// The ground around the vehicle, which stands near its middle.
struct Ground {
    level: Level,
    grid: SquareGrid,
    /// Where the vehicle stands, in regions.
    foot: [f64; 2],
}

impl Ground {
    fn new(scene: &TurnScene, drum: &Drum) -> Result<Self, String> {
        let reach = (scene.range_m / scene.region_m).ceil() as usize + BESIDE;
        let side = 2 * reach + 1;
        let level = Level::new(scene.region_m, [0.0; 2], [side; 2], vec![[0.0; 9]; side * side]);
        let level = level.map_err(|error| error.to_string())?;
        let bank = KindBank {
            place: BankPlace::Together,
            record_words: drum.record_words,
            record_regions: (drum.record_words / 9).isqrt().max(1),
            buffer_words: None,
            edit: 0.0,
        };
        let grid = SquareGrid::new(&level, &bank);
        // Off the lattice, so that no corner lies on the edges of a sector along an axis.
        Ok(Self { grid, foot: [reach as f64 + 0.3, reach as f64 + 0.6], level })
    }

    /// What the sector asks of each kind as it begins at azimuth `from` (degrees), the nearest first.
    fn wants(&self, scene: &TurnScene, from: f64) -> Vec<Vec<Piece>> {
        let edges = [from, from + scene.width_deg].map(|azimuth| {
            let (sin, cos) = sin_cos(radians(azimuth));
            [cos, sin]
        });
        let range = scene.range_m / scene.region_m;
        let regions: Vec<_> =
            Sector { foot: self.foot, edges: Some(edges), range }.regions(&self.level).collect();
        let mut corners = corners_of(regions.iter().copied(), self.level.corners());
        nearest_first(&mut corners, self.level.corners()[1], self.foot);
        let middle = |[m, n]: [usize; 2]| [m, n].map(|along| scene.region_m * (along as f64 + 0.5));
        let mut squares: Vec<Piece> =
            regions.into_iter().map(|region| Piece::one(self.grid.square_of(middle(region)))).collect();
        squares.sort_by_key(|piece| piece.item);
        squares.dedup();
        self.grid.nearest_first(&mut squares, self.foot.map(|along| along * scene.region_m));
        let mut wants = vec![squares; scene.kinds];
        wants[0] = corners.into_iter().map(Piece::one).collect();
        wants
    }
}
