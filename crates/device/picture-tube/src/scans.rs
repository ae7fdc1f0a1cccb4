//! Which scans a line still shows: interlace and the decay of the phosphor.

use hardware_model::PictureTubeParts;

/// Light that nobody sees, of white's: less than the first of 255 codes of a display with an exponent of 2.2.
const UNSEEN: f64 = 1e-6;

/// Scans of a line that a phosphor remembers at most.
const MOST_SCANS: usize = 16;

/// The scans that the lines of a picture show.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scans {
    /// Fields of a picture.
    fields: u64,
    /// Fields in a frame: showings of one update.
    pub showings: u64,
    /// Share of each scan in the light of a line, the last scan first.
    shares: Vec<f32>,
}

/// A scan of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Scan {
    /// Number of the field since the start of the mission; those before it count down from `u64::MAX`.
    pub field: u64,
    /// Frames before the one that is shown.
    pub age: usize,
    /// Its share in the light of the line.
    pub share: f32,
}

impl Scans {
    /// Scans of `parts`, with `showings` fields of `field_time` (s) each in a frame.
    pub fn new(parts: &PictureTubeParts, showings: u64, field_time: f64) -> Self {
        let scan_time = f64::from(parts.fields) * field_time;
        let left = if parts.phosphor > 0.0 { libm::pow(10.0, -scan_time / parts.phosphor) } else { 0.0 };
        Self { fields: parts.fields.max(1).into(), showings, shares: shares(left) }
    }

    /// Frames before one that count in its showing `showing`.
    pub fn frames_before(&self, showing: u64) -> u64 {
        (self.fields * self.shares.len() as u64 - 1).saturating_sub(showing).div_ceil(self.showings)
    }

    /// Whether a line shows more than one scan, or some lines are not scanned in a showing.
    pub fn are_several(&self) -> bool {
        self.fields * self.shares.len() as u64 > 1
    }

    /// Lines for which a field has time, of a picture of `lines`: the shorter field of an odd number has one to spare.
    pub fn lines_of_field(&self, lines: u64) -> u64 {
        lines.div_ceil(self.fields)
    }

    /// The showing in which the beam scans line `number` of frame `frame`, counted in the order of time, with its field and its line
    /// from the top, of `lines`; no line where the shorter field has none.
    pub fn scanned(&self, frame: u64, number: u64, lines: u64) -> (u64, Option<u64>) {
        let (showing, place) = (number / self.lines_of_field(lines), number % self.lines_of_field(lines));
        let field = frame.wrapping_mul(self.showings).wrapping_add(showing);
        let line = place * self.fields + field % self.fields;
        (field, Some(line).filter(|&line| line < lines))
    }

    /// The scans of line `line` in showing `showing` of frame `frame`, the last first.
    pub fn of_line(&self, frame: u64, showing: u64, line: u64) -> impl Iterator<Item = Scan> {
        let Self { fields, showings, .. } = *self;
        let field = frame.wrapping_mul(showings).wrapping_add(showing);
        let since = (field % fields + fields - line % fields) % fields;
        self.shares.iter().zip(0..).map(move |(share, scans)| {
            let back = since + scans * fields;
            let age = back.saturating_sub(showing).div_ceil(showings) as usize;
            Scan { field: field.wrapping_sub(back), age, share: *share }
        })
    }
}

/// Shares of the last scans in the light of a line, of which `left` is left after one scan: all of it together.
fn shares(left: f64) -> Vec<f32> {
    let powers = std::iter::successors(Some(1.0), |power| Some(power * left));
    let seen: Vec<f64> = powers.take_while(|power| *power >= UNSEEN).take(MOST_SCANS).collect();
    let all: f64 = seen.iter().sum();
    seen.iter().map(|power| (power / all) as f32).collect()
}

#[cfg(test)]
mod tests {
    use hardware_model::PictureTubeParts;
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    use super::{MOST_SCANS, Scans};

    fn scans(fields: u32, phosphor: f64, showings: u64) -> Scans {
        let parts = PictureTubeParts { fields, phosphor, ..PictureTubeParts::IDEAL };
        Scans::new(&parts, showings, 1.0 / 60.0)
    }

    fn of_line(scans: &Scans, frame: u64, showing: u64, line: u64) -> Vec<(u64, usize)> {
        scans.of_line(frame, showing, line).map(|scan| (scan.field, scan.age)).collect()
    }

    #[test]
    fn a_field_scans_the_lines_of_its_parity() {
        let two = scans(2, 0.0, 2);
        // Frame 3 is fields 6 and 7.
        assert_eq!(of_line(&two, 3, 0, 10), [(6, 0)]);
        assert_eq!(of_line(&two, 3, 0, 11), [(5, 1)]);
        assert_eq!(of_line(&two, 3, 1, 10), [(6, 0)]);
        assert_eq!(of_line(&two, 3, 1, 11), [(7, 0)]);
        let one_a_frame = scans(2, 0.0, 1);
        assert_eq!(of_line(&one_a_frame, 3, 0, 11), [(3, 0)]);
        assert_eq!(of_line(&one_a_frame, 3, 0, 10), [(2, 1)]);
        assert_eq!(of_line(&scans(1, 0.0, 2), 3, 1, 10), [(7, 0)]);
    }

    #[test]
    fn before_the_mission_fields_count_down() {
        assert_eq!(of_line(&scans(2, 0.0, 2), 0, 0, 1), [(u64::MAX, 1)]);
    }

    /// A tenth is left after the time of the part: of scans a field apart, `10^(-T / t)` each.
    #[test]
    fn light_decays_from_scan_to_scan() {
        for (fields, decay) in [(1, 0.02), (2, 0.02), (1, 0.1)] {
            let left = libm::pow(10.0, -f64::from(fields) / 60.0 / decay);
            let shares = scans(fields, decay, 2).shares;
            let whole: f32 = shares.iter().sum();
            assert!((whole - 1.0).abs() < 1e-6, "{shares:?}");
            for pair in shares.windows(2) {
                assert!((f64::from(pair[1] / pair[0]) - left).abs() < 1e-5, "{shares:?}");
            }
            let forgotten = libm::pow(left, shares.len() as f64);
            assert!(forgotten < 1e-6 || shares.len() == MOST_SCANS);
        }
    }

    #[test]
    fn a_quick_phosphor_has_forgotten_by_the_next_scan() {
        assert_eq!(scans(2, 40e-6, 2).shares, [1.0]);
        assert!(!scans(1, 40e-6, 2).are_several() && scans(2, 40e-6, 2).are_several());
    }

    proptest! {
        #[test]
        fn no_scan_is_of_an_earlier_frame_than_those_before(
            fields in 1..3u32, decay in 0.0..0.3f64, showings in 1..13u64, frame in 40..90u64, line in 0..9u64,
        ) {
            let scans = scans(fields, decay, showings);
            for showing in 0..showings {
                let ages = scans.of_line(frame, showing, line).map(|scan| scan.age as u64);
                prop_assert!(ages.max().unwrap() <= scans.frames_before(showing));
                for scan in scans.of_line(frame, showing, line) {
                    prop_assert_eq!(scan.field / showings, frame - scan.age as u64);
                    prop_assert_eq!(scan.field % u64::from(fields), line % u64::from(fields));
                }
            }
        }
    }
}
