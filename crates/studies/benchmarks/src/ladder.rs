//! A scene of its own whose parts grow one at a time: what a frame costs against what is in it.

use std::path::Path;
use std::{fs, io};

use crate::{Choice, TimedScene};

/// What the scene holds; all but one stay as they are.
#[derive(Debug, Clone, Copy)]
pub struct Size {
    /// Number of sweeps per frame.
    pub sweeps: u32,
    /// Number of samples per sweep.
    pub samples: u32,
    /// Side of the stored ground (m).
    pub extent: u32,
    /// Side of a region (m).
    pub region: u32,
    /// Craters on the stored ground, on average; none at 0.
    pub craters: f64,
    /// Rocks as far as the sweeps reach to either side of the eye, on average; none at 0.
    pub rocks: f64,
    /// Distance between the profiles that shadow boundaries are found on (m); no shadow at 0.
    pub shadow: f64,
    /// Frames that are drawn one after the other.
    pub frames: u64,
    /// Number of threads that draw.
    pub threads: usize,
}

/// The scene that every ladder begins with.
pub const BASE: Size = Size {
    sweeps: 525,
    samples: 1000,
    extent: 2000,
    region: 40,
    craters: 0.0,
    rocks: 0.0,
    shadow: 0.0,
    frames: 1,
    threads: 1,
};

/// Ground range that sweeps end at (m).
const REACH: f64 = 500.0;
/// Ground range beyond which there is no shadow (m).
const SHADOWED: f64 = 300.0;
/// Update rate of the scenes (Hz).
const RATE: f64 = 30.0;

/// One quantity that grows.
#[derive(Debug, Clone, Copy)]
pub struct Ladder {
    /// Name of what grows.
    pub name: &'static str,
    /// Why the cost should grow with the power that stands here.
    pub expected: (f64, &'static str),
    /// Its values, or what makes them.
    pub values: &'static [f64],
    /// The scene at a value.
    pub at: fn(f64) -> Size,
    /// How much of it a scene has, where that is another number than the value.
    pub count: Option<fn(&TimedScene) -> f64>,
    /// The scene with nothing of it, where there is one: what the cost grows from.
    pub without: Option<Size>,
}

/// All ladders that `scaling` climbs.
pub const LADDERS: &[Ladder] = &[
    Ladder {
        name: "sweeps",
        expected: (1.0, "each sweep is drawn by itself"),
        values: &[131.0, 262.0, 525.0, 1050.0, 2100.0],
        at: |value| Size { sweeps: value as u32, ..BASE },
        count: None,
        without: None,
    },
    Ladder {
        name: "samples",
        expected: (1.0, "beside the crossings, which stay"),
        values: &[250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0],
        at: |value| Size { samples: value as u32, ..BASE },
        count: None,
        without: None,
    },
    Ladder {
        name: "regions across",
        expected: (1.0, "crossings grow with them"),
        values: &[25.0, 50.0, 100.0, 200.0],
        at: |value| Size { region: (2000.0 / value) as u32, ..BASE },
        count: None,
        without: None,
    },
    Ladder {
        name: "side of the bank (m)",
        expected: (0.0, "sweeps end after 500 m: what they do not meet costs nothing"),
        values: &[1200.0, 2000.0, 4000.0, 8000.0],
        at: |value| Size { extent: value as u32, ..BASE },
        count: None,
        without: None,
    },
    Ladder {
        name: "craters",
        expected: (1.0, "as many more are met"),
        values: &[1e3, 1e4, 1e5, 1e6],
        at: |value| Size { craters: value, sweeps: 131, ..BASE },
        count: None,
        without: Some(Size { sweeps: 131, ..BASE }),
    },
    Ladder {
        name: "rocks",
        expected: (1.0, "as many more are drawn, until they hide one another or look smaller than a line"),
        values: &[1e2, 1e3, 1e4, 1e5],
        at: |value| Size { rocks: value, ..BASE },
        count: None,
        without: Some(BASE),
    },
    Ladder {
        name: "shadow segments",
        expected: (1.0, "as many more are crossed, but for those that lie between two sweeps"),
        values: &[3.2, 0.8, 0.2, 0.05],
        at: |value| Size { shadow: value, craters: 3e4, ..BASE },
        count: Some(shadow_segments),
        without: Some(Size { craters: 3e4, ..BASE }),
    },
    Ladder {
        name: "frames",
        expected: (1.0, "nothing is left of a frame that the next must carry"),
        values: &[1.0, 10.0, 100.0, 1000.0],
        at: |value| Size { frames: value as u64, sweeps: 131, ..BASE },
        count: None,
        without: None,
    },
    Ladder {
        name: "threads",
        expected: (-1.0, "groups of sweeps share nothing"),
        values: &[1.0, 2.0],
        at: |value| Size { threads: value as usize, craters: 1e4, ..BASE },
        count: None,
        without: None,
    },
];

/// Segments of shadow that lie around the eye of the first frame, within [`SHADOWED`].
fn shadow_segments(scene: &TimedScene) -> f64 {
    let bank = scene.shadow_bank();
    let [north, east, _] = scene.pose.eye;
    let tiles = bank.around(&scene.stage.scenery.sun(0.0), [north, east], SHADOWED, None);
    tiles.iter().map(|tile| tile.outlines.segments().count()).sum::<usize>() as f64
}

impl Size {
    /// The scene, of a scenario that is written into `folder`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn scene(&self, folder: &Path) -> io::Result<TimedScene> {
        // So many are an average: there may be more.
        limits::raise("rocks=200000").expect("it is a limit that can be raised");
        let path = folder.join("ladder.toml");
        fs::write(&path, self.text())?;
        Ok(TimedScene::read(&path, &Choice::default()))
    }

    fn text(&self) -> String {
        let Self { sweeps, samples, extent, region, craters, rocks, shadow, frames, .. } = self;
        let middle = f64::from(*extent) / 2.0;
        let area = f64::from(*extent) * f64::from(*extent);
        let mut text = format!(
            "format = 1\ntitle = \"Ladder\"\nshows = \"What a frame costs.\"\nmachine = \"ideal\"\nframes = {frames}\n\
             [landscape.generated]\nseed = 7\nextent_m = [{extent}, {extent}]\nregion_size_m = {region}\n\
             [landscape.generated.undulation]\nrms_height_m = 3\nhurst = 0.8\nlongest_m = 600\nshortest_m = 240\n\
             [sun]\nazimuth_deg = 60\nelevation_deg = 25\n\
             [path]\nkeyframes = [ {{ t_s = 0, x_m = {middle}, y_m = {middle} }}, {{ t_s = {}, x_m = {}, y_m = {} }} ]\n\
             [raster]\nsweeps = {sweeps}\nsamples_per_sweep = {samples}\ncolumns = 525\nlines = 401\n\
             [range]\nprogramme = \"geometric\"\nstart_m = 2\nend_m = {REACH}\n",
            *frames as f64 / RATE,
            middle + 1.0,
            middle + 0.5,
        );
        if *craters > 0.0 {
            // Above 1 m of radius by a power law of exponent 1.9.
            text += &format!(
                "[[features.population]]\nseed = 3\nkind = \"fresh\"\ndensity_per_m2 = {}\nreference_m = 2\nslope = 1.9\n\
                 smallest_radius_m = 1\nlargest_radius_m = 20\n",
                craters / area
            );
        }
        if *rocks > 0.0 {
            let [smallest, largest] = [0.15, 2.0];
            // Densities count rocks of 1 m and more; how many there are of a size falls with its square.
            let above_one_metre =
                rocks / (4.0 * REACH * REACH) / (1.0 / (smallest * smallest) - 1.0 / (largest * largest));
            let [low, high] = [middle - REACH, middle + REACH];
            text += &format!(
                "[rocks]\nseed = 5\ndensity_per_m2 = {above_one_metre}\nslope = 2.0\nsmallest_m = {smallest}\n\
                 largest_m = {largest:.1}\narea_m = [{low}, {low}, {high}, {high}]\n"
            );
        }
        if *shadow > 0.0 {
            text += &format!("[shadows]\nfinest_m = {shadow}\nangle_mrad = 0\nreach_m = {SHADOWED}\n");
        }
        text
    }
}
