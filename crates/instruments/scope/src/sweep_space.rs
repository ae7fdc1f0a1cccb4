//! Sweep space: a signal of the display over all sweeps of a frame, a column a sweep, as the tube has the vertical raster.

use picture::{Depth, Encoder, GreyPicture, Transfer};
use scenario::Display;
use signal::{Signal, Unit, Waveform};

use crate::ScopeError;

/// The picture of `waveforms`, those of `signal` by sweep: each is a column from the top of the raster on. Light is shown as `display`
/// has it; of a gate 1 is white.
///
/// # Errors
/// If there is none, they are not alike in length, or a value is no number.
pub fn sweep_space(
    waveforms: &[Waveform],
    signal: &Signal,
    display: &Display,
) -> Result<GreyPicture, ScopeError> {
    let (columns, lines) = (waveforms.len(), waveforms.first().map_or(0, |wave| wave.values.len()));
    let mut plane = vec![f32::NAN; columns * lines];
    for (column, wave) in waveforms.iter().enumerate() {
        for (line, value) in wave.values.iter().take(lines).enumerate() {
            plane[line * columns + column] = *value as f32;
        }
    }
    let white = if signal.unit == Unit::Reflectivity { display.white } else { 1.0 };
    let transfer = Transfer::new(white as f32, display.gamma as f32)?;
    Ok(Encoder::new(transfer, Depth::Eight).encode(&plane, columns, lines)?)
}
