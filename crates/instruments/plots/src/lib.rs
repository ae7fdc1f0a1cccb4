//! Pictures of banks, surveys, waveforms and timing, as PNG and as SVG: the same bytes on every machine.
//!
//! - [`bank_picture`]: shaded ground in the colours of its height, with contours and axes.
//! - [`survey_picture`]: fitted ground beside the residuals of its samples, with their histogram.
//! - [`sight_picture`], [`sight_profile`]: what an observer sees of an area, and one line of sight over its ground.
//! - [`scope_picture`]: one sweep as on an oscilloscope with a logic analyser.
//! - [`xy_picture`]: one signal over another, as an oscilloscope in X-Y.
//! - [`trace_picture`]: waveforms and digital lines against a common axis, as on an oscilloscope.
//! - [`timeline_picture`]: digital events of one sweep, register by register, below its ramps.
//! - [`bar_picture`]: histograms of one kind below one another.
//! - [`ladder_picture`]: error against time or step, on logarithmic axes.
//! - [`matrix_picture`]: cases by methods, each cell in the colour of what came of it.
//! - [`columns_picture`]: grey pictures below one another, and what each column of them is.
//!
//! Each returns a [`Drawing`]. A drawing remembers its strokes, and each of the two files is the
//! same strokes on another ground. Lettering is the outlines of the font Hack, filled like every other curve.
//!
//! ```
//! use landscape::{Level, Sun};
//! let level = Level::new(250.0, [0.0, 0.0], [2, 2], vec![[0.0; 9]; 4])?;
//! let look = plots::BankLook::titled("a plate");
//! let drawing = plots::bank_picture(&level, Sun { azimuth: 1.0, elevation: 0.3 }, &look)?;
//! assert!(drawing.png().starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod bank_picture;
mod bar_picture;
mod canvas;
mod colour;
mod columns_picture;
mod drawing;
mod error;
mod flow;
mod frame;
mod ground;
mod labels;
mod ladder_picture;
mod lettering;
mod mark;
mod matrix_picture;
mod pixels;
mod residuals;
mod scope;
mod sight_picture;
mod sight_profile;
mod survey_picture;
mod svg;
mod timeline_picture;
mod trace_picture;
mod xy_picture;

pub use axis::{Axis, Scale};
pub use bank_picture::{BankLook, bank_picture};
pub use bar_picture::{Bars, bar_picture};
pub use columns_picture::{Columns, columns_picture};
pub use drawing::Drawing;
pub use error::PlotError;
pub use ladder_picture::{PointSeries, SlopeGuide, ladder_picture};
pub use matrix_picture::{MatrixBlock, MatrixCell, MatrixRow, Tone, matrix_picture};
pub use residuals::Residuals;
pub use scope::{
    Along, Clock, Crossing, Curve, Curves, Line, Logic, LogicLane, PictureColumn, Place, RegisterColour,
    Scope, ScopeLook, Theme, Upright, Volts, scope_picture, scope_svg,
};
pub use sight_picture::{SightLayer, SightLook, SightMap, sight_picture};
pub use sight_profile::{SightProfile, sight_profile};
pub use survey_picture::{SurveyLook, survey_picture};
pub use timeline_picture::{EventLane, Span, Stops, Stretch, Timeline, timeline_picture};
pub use trace_picture::{Lane, Panel, Trace, TraceLook, trace_picture};
pub use xy_picture::{Xy, xy_picture};
