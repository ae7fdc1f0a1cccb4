//! A scene of its own whose parts grow one at a time: what a frame costs against what is in it.

use std::path::Path;
use std::{fs, io};

use crate::{Choice, Scene};

/// What the scene holds; all but one stay as they are.
#[derive(Debug, Clone, Copy)]
pub struct Size {
    /// Sweeps a frame.
    pub sweeps: u32,
    /// Samples a sweep.
    pub samples: u32,
    /// Side of the stored ground (m).
    pub extent: u32,
    /// Side of a region (m).
    pub region: u32,
    /// Craters on the stored ground, on average; none at 0.
    pub craters: f64,
    /// Rocks a square metre near the eye; none at 0.
    pub rocks: f64,
    /// Threads.
    pub threads: usize,
}

/// The scene that every ladder begins with.
pub const BASE: Size =
    Size { sweeps: 525, samples: 1000, extent: 2000, region: 40, craters: 0.0, rocks: 0.0, threads: 1 };

/// One quantity that grows.
#[derive(Debug, Clone, Copy)]
pub struct Ladder {
    /// What grows.
    pub name: &'static str,
    /// Why the cost should grow with the power that stands here.
    pub expected: (f64, &'static str),
    /// Its values.
    pub values: &'static [f64],
    /// The scene at a value.
    pub at: fn(f64) -> Size,
}

/// All ladders.
pub const LADDERS: &[Ladder] = &[
    Ladder {
        name: "sweeps",
        expected: (1.0, "each sweep is drawn by itself"),
        values: &[131.0, 262.0, 525.0, 1050.0, 2100.0],
        at: |value| Size { sweeps: value as u32, ..BASE },
    },
    Ladder {
        name: "samples",
        expected: (1.0, "beside the crossings, which stay"),
        values: &[250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0],
        at: |value| Size { samples: value as u32, ..BASE },
    },
    Ladder {
        name: "regions across",
        expected: (1.0, "crossings grow with them"),
        values: &[25.0, 50.0, 100.0, 200.0],
        at: |value| Size { region: (2000.0 / value) as u32, ..BASE },
    },
    Ladder {
        name: "side of the bank (m)",
        expected: (0.0, "sweeps end after 500 m: what they do not meet costs nothing"),
        values: &[1200.0, 2000.0, 4000.0, 8000.0],
        at: |value| Size { extent: value as u32, ..BASE },
    },
    Ladder {
        name: "craters",
        expected: (1.0, "as many more are met"),
        values: &[1e3, 1e4, 1e5, 1e6],
        at: |value| Size { craters: value, sweeps: 131, ..BASE },
    },
    Ladder {
        name: "rocks (1/m2)",
        expected: (1.0, "as many more are drawn, until they hide one another"),
        values: &[4e-5, 4e-4, 1.3e-3, 4e-3],
        at: |value| Size { rocks: value, ..BASE },
    },
    Ladder {
        name: "threads",
        expected: (-1.0, "groups of sweeps share nothing"),
        values: &[1.0, 2.0],
        at: |value| Size { threads: value as usize, craters: 1e4, ..BASE },
    },
];

impl Size {
    /// The scene, of a scenario that is written into `folder`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn scene(&self, folder: &Path) -> io::Result<Scene> {
        let path = folder.join("ladder.toml");
        fs::write(&path, self.text())?;
        Ok(Scene::read(&path, &Choice::default()))
    }

    fn text(&self) -> String {
        let Self { sweeps, samples, extent, region, craters, rocks, .. } = self;
        let middle = f64::from(*extent) / 2.0;
        let area = f64::from(*extent) * f64::from(*extent);
        let mut text = format!(
            "format = 1\ntitle = \"Ladder\"\nshows = \"What a frame costs.\"\nmachine = \"ideal\"\nframes = 1\n\
             [landscape.generated]\nseed = 7\nextent_m = [{extent}, {extent}]\nregion_size_m = {region}\n\
             [landscape.generated.undulation]\nrms_height_m = 3\nhurst = 0.8\nlongest_m = 600\nshortest_m = 240\n\
             [sun]\nazimuth_deg = 60\nelevation_deg = 25\n\
             [path]\nkeyframes = [ {{ t_s = 0, x_m = {middle}, y_m = {middle} }}, {{ t_s = 1, x_m = {}, y_m = {} }} ]\n\
             [raster]\nsweeps = {sweeps}\nsamples_per_sweep = {samples}\ncolumns = 525\nlines = 401\n\
             [range]\nprogramme = \"geometric\"\nstart_m = 2\nend_m = 500\n",
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
            text += &format!(
                "[rocks]\nseed = 5\ndensity_per_m2 = {rocks}\nslope = 2.0\nsmallest_m = 0.15\nlargest_m = 2\nradius_m = 200\n"
            );
        }
        text
    }
}
