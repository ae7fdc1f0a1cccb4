//! What one picture costs the computer and the gear between it and the video (section 19.6).

use serde::{Deserialize, Serialize};

use crate::insertion::{Method, ScanConverter};
use crate::view_lines::LineCounts;

/// Time of one point through the chain: transform and projection (s; hardware table 3.7, 60 to 150 us).
pub(crate) const POINT_S: f64 = 90e-6;
/// Time of one intersection of an edge with a line (s; hardware table 3.7, 15 to 60 us).
pub(crate) const INTERSECTION_S: f64 = 25e-6;
/// Time in which a scan converter is written all over, and in which it is erased (s; hardware table 3.8).
const WRITE_S: f64 = 33e-3;
const ERASE_S: f64 = 33e-3;

/// Counts of one picture; with a penumbra, over all points of the sun.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Work {
    /// Points that went through the chain.
    pub points: u64,
    /// Lines of the string by type.
    pub lines: LineCounts,
    /// Intersections of television lines with outlines.
    pub intersections: u64,
    /// Most edges that one television line meets: each takes a line generator and a D/A converter.
    pub line_generators: u64,
    /// Share of the picture that is dark.
    pub dark: f64,
}

/// Times of one picture.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WorkTimes {
    /// The computer's, until the next picture's shadow is set up (s).
    pub setup_s: f64,
    /// The scan converter's, erased and written (s); 0 without one.
    pub write_s: f64,
    /// Pictures that pass until a shadow is followed by the next one; 1 keeps pace.
    pub pictures: u64,
}

impl Work {
    /// Times under a method, at one picture every `period` (s). Set-up of one picture goes on while the one before is
    /// shown, and one of two tubes is erased and written while the other is read.
    pub fn times(&self, method: &Method, period: f64) -> WorkTimes {
        let points = self.points as f64 * POINT_S;
        let (setup_s, write_s) = match method {
            Method::Synchronised { .. } => (points + self.intersections as f64 * INTERSECTION_S, 0.0),
            Method::ScanConverter(ScanConverter { .. }) => (points, ERASE_S + WRITE_S * self.dark),
        };
        let pictures = (setup_s.max(write_s) / period).ceil().max(1.0) as u64;
        WorkTimes { setup_s, write_s, pictures }
    }
}

#[cfg(test)]
mod tests {
    use super::Work;
    use crate::insertion::{Method, ScanConverter};

    #[test]
    fn the_synchronised_method_pays_for_intersections() {
        let work = Work { points: 100, intersections: 1000, dark: 0.1, ..Work::default() };
        let times = work.times(&Method::Synchronised { dac_bits: 10 }, 1.0 / 30.0);
        assert!((times.setup_s - 0.034).abs() < 1e-12 && times.write_s == 0.0);
        assert_eq!(times.pictures, 2);
        let times = work.times(&Method::ScanConverter(ScanConverter::default()), 0.04);
        assert!((times.setup_s - 0.009).abs() < 1e-12 && (times.write_s - 0.0363).abs() < 1e-12);
        assert_eq!(times.pictures, 1);
        assert_eq!(Work::default().times(&Method::Synchronised { dac_bits: 10 }, 0.1).pictures, 1);
    }
}
