//! Stages for the tests, and the frames that they come to.

use std::sync::Arc;

use crate::eye::Eye;
use generator::{FrameCounts, Generator, Label, PlaneKind, Planes, Session, Stage};
use glam::DVec3;
use landscape::{Attitude, Bank, Landscape, Level, Sun};
use quantities::{Rate, radians};
use sampled::{Parameters, Sampled};
use scenario::{
    Carried, Curvature, Display, Effects, FieldOfView, Laws, LightPoint, LightSource, Medium, Pose, Scenery,
    Sheet, Standing, View,
};
use signal::Probe;

/// Half the side of the ground (m), and the eye's place north and east.
pub const HOME: f64 = 2000.0;

/// Everything that a frame follows from.
#[derive(Clone)]
pub struct Shot {
    pub run: Parameters,
    pub view: View,
    pub ground: Arc<Landscape>,
    pub sun: Sun,
    pub effects: Effects,
    pub standing: Vec<Standing>,
    pub pose: Pose,
}

impl Shot {
    /// A level look to the north over black level ground without curvature, which is one square of triangles. Pixels are square.
    pub fn new(columns: u32, lines: u32, focal: f64) -> Self {
        let rate = Rate::new(30, 1).unwrap();
        let tangent = |pixels: u32| f64::from(pixels) / (2.0 * focal);
        Self {
            run: Parameters { ground_half_side: HOME, ground_cells: 8, ..Parameters::default() },
            view: View {
                columns,
                lines,
                field: FieldOfView { tan_half_width: tangent(columns), tan_half_height: tangent(lines) },
                update: rate,
                refresh: rate,
                display: Display { white: 1.0, gamma: 1.0 },
                laws: Laws { curvature: Curvature::None, ..Laws::default() },
                ranges: [0.1, 1e5],
                yoke: None,
                levels: None,
                shadows: None,
            },
            ground: level_ground(HOME, 0.0),
            sun: Sun { azimuth: radians(140.0), elevation: radians(30.0) },
            effects: Effects::default(),
            standing: Vec::new(),
            pose: Pose { time: 0.0, eye: [HOME, HOME, 2.0], attitude: Attitude::default(), yoke: 0.0 },
        }
    }

    /// The eye of the shot.
    pub fn eye(&self) -> Eye {
        Eye::new(&self.pose, &self.view)
    }

    /// A lamp that is seen at a place on the screen (pixels) in a depth (m).
    pub fn lamp(&self, id: u32, at: [f64; 2], depth: f64, diameter: f64) -> LightPoint {
        lamp(id, self.eye().place(at, depth), diameter)
    }

    /// A sheet whose corners are seen at places on the screen (pixels), all in one depth (m).
    pub fn sheet(&self, id: u32, at: &[[f64; 2]], depth: f64, colour: [f64; 3], share: f64) -> Sheet {
        let corners = at.iter().map(|at| self.eye().place(*at, depth)).collect();
        Sheet { id, corners, colour, medium: Medium::Share(share), priority: 0 }
    }

    /// A sheet that fills the screen in a depth (m).
    pub fn filling(&self, id: u32, depth: f64, colour: [f64; 3], share: f64) -> Sheet {
        let [right, bottom] = [self.view.columns, self.view.lines].map(|pixels| f64::from(pixels) + 2.0);
        self.sheet(id, &[[-2.0, -2.0], [right, -2.0], [right, bottom], [-2.0, bottom]], depth, colour, share)
    }

    /// The stage of the shot.
    pub fn stage(&self) -> Stage {
        let scenery = Scenery::still(self.sun)
            .with_bodies(self.standing.clone())
            .with_effects(vec![Carried::still(self.effects.clone())]);
        Stage { landscape: Arc::clone(&self.ground), scenery: Arc::new(scenery), view: self.view.clone() }
    }

    fn generator(&self) -> Sampled {
        Sampled { parameters: self.run, hardware: sampled::Hardware::shipped().unwrap() }
    }

    /// The generator ready for the shot.
    pub fn session(&self) -> Box<dyn Session> {
        self.generator().prepare(self.stage()).unwrap()
    }

    /// The frame of the shot.
    pub fn draw(&self) -> Frame {
        self.draw_by(&self.generator())
    }

    /// The frame of the shot by a generator with run parameters of its own.
    pub fn draw_by(&self, generator: &dyn Generator) -> Frame {
        let session = generator.prepare(self.stage()).unwrap();
        let size = [self.view.columns, self.view.lines].map(|count| count as usize);
        let mut planes = Planes::new(size[0], size[1], generator.planes());
        let counts = session.frame(0, &self.pose, &mut planes, &mut Probe::off()).unwrap();
        Frame { planes, counts }
    }
}

/// What a frame has come to.
#[derive(Debug, PartialEq)]
pub struct Frame {
    pub planes: Planes,
    pub counts: FrameCounts,
}

impl Frame {
    /// All values of a plane.
    pub fn plane(&self, kind: PlaneKind) -> &[f32] {
        self.planes.get(kind).unwrap()
    }

    /// Red, green and blue of a pixel, counted row by row.
    pub fn colour(&self, index: usize) -> [f64; 3] {
        PlaneKind::COLOUR.map(|kind| f64::from(self.plane(kind)[index]))
    }

    /// Sum of a plane over all pixels.
    pub fn sum(&self, kind: PlaneKind) -> f64 {
        self.plane(kind).iter().copied().map(f64::from).sum()
    }

    /// Pixels of a label, counted row by row.
    pub fn labelled(&self, label: Label) -> Vec<usize> {
        let labels = self.plane(PlaneKind::Label).iter().enumerate();
        labels.filter(|(_, code)| **code == f32::from(label.code())).map(|(index, _)| index).collect()
    }
}

/// A white lamp of intensity 1, drawn in the raster.
pub fn lamp(id: u32, at: DVec3, diameter: f64) -> LightPoint {
    let source = LightSource::Lamp { at, diameter };
    LightPoint { id, source, colour: [1.0; 3], intensity: 1.0, lobe: None, priority: 0, calligraphic: false }
}

/// Level ground of height 0 and one albedo, twice `half_side` wide (m).
pub fn level_ground(half_side: f64, albedo: f64) -> Arc<Landscape> {
    let level = Level::new(half_side / 10.0, [0.0; 2], [21, 21], vec![[0.0; 9]; 441]).unwrap();
    Arc::new(Landscape::new(Bank::new("test", vec![level], None).unwrap(), albedo))
}

/// Whether a value of a plane is what was worked out: planes hold 24 bits, and 1e-9 are left for the working.
pub fn is_same(plane: f64, expected: f64) -> bool {
    (plane - expected).abs() <= 1e-9 + expected.abs() / f64::from(1 << 24)
}

/// Whether a sum over pixels is what was worked out, up to the rounding of the planes.
pub fn is_same_sum(sum: f64, expected: f64) -> bool {
    (sum / expected - 1.0).abs() < 1e-9 + 1.0 / f64::from(1 << 24)
}
