//! Pixels that let light through.

use picture::Depth;

use crate::CURVE;

/// Codes of pixels of `CHANNELS` colours and alpha behind them, laid over black in linear light. What is opaque keeps its
/// codes.
pub fn over_black<const CHANNELS: usize, const STORED: usize>(codes: &[u16], depth: Depth) -> Vec<u16> {
    let white = depth.white();
    let over = |code: u16, alpha: u16| match alpha {
        opaque if opaque == white => code,
        _ => {
            let [level, share] = [code, alpha].map(|code| f64::from(code) / f64::from(white));
            CURVE.code(CURVE.light(level) * share, depth)
        }
    };
    let pixels = codes.as_chunks::<STORED>().0.iter();
    pixels.flat_map(|pixel| pixel[..CHANNELS].iter().map(|code| over(*code, pixel[CHANNELS]))).collect()
}
