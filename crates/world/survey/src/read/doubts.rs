//! Stored numbers that may be no heights: told, not refused.

/// Numbers that programs write where they have no height: ends of integers of 8 and 16 bits, and rows of nines.
const USUAL_MARKS: [f64; 10] =
    [-128.0, 255.0, -32768.0, -32767.0, 32767.0, 65535.0, -9999.0, 9999.0, -99999.0, 99999.0];

/// Distance from the other heights, in parts of their range, from which on such a number is told.
const FAR: f64 = 0.5;

/// The usual marks of voids among stored numbers that are no declared voids.
#[derive(Debug)]
pub struct Marks {
    /// How often each of [`USUAL_MARKS`] was met.
    counts: [usize; USUAL_MARKS.len()],
    /// Least and greatest of the other numbers.
    others: [f64; 2],
}

impl Default for Marks {
    fn default() -> Self {
        Self { counts: [0; USUAL_MARKS.len()], others: [f64::INFINITY, f64::NEG_INFINITY] }
    }
}

impl Marks {
    /// Counts a stored number that is no declared void.
    pub fn meet(&mut self, stored: f64) {
        match USUAL_MARKS.iter().position(|mark| *mark == stored) {
            Some(mark) => self.counts[mark] += 1,
            None => self.others = [self.others[0].min(stored), self.others[1].max(stored)],
        }
    }

    /// Says so if some lie far from all other numbers; `declared` are the voids that are known already.
    pub fn note(&self, declared: &[f64]) -> Option<String> {
        let [low, high] = self.others;
        let is_far = |mark: f64| (low - mark).max(mark - high) > FAR * (high - low);
        let met = USUAL_MARKS.iter().zip(self.counts).filter(|(mark, count)| *count > 0 && is_far(**mark));
        let (found, counts): (Vec<f64>, Vec<usize>) = met.map(|(mark, count)| (*mark, count)).unzip();
        if found.is_empty() || low > high {
            return None;
        }
        let samples: usize = counts.iter().sum();
        let list = listed(&[declared, &found].concat());
        Some(format!(
            "{samples} samples are {}, far from the others ({low} to {high}), and taken as heights: if they mark voids, give \
             --no-data {list}",
            listed(&found)
        ))
    }
}

/// Numbers as an option takes them: joined by commas, exact to the bit.
pub fn listed(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:?}")).collect::<Vec<_>>().join(",")
}

/// What is told of samples that are stored as those of pictures are, and have neither a scale nor an offset.
pub const PICTURE: &str = "the samples have 8 bits or fewer and no scale, as those of a picture: they are taken as heights in \
                           whole metres; if the file is a picture, name an elevation file; if not, --scale 1 says so";

#[cfg(test)]
mod tests {
    use super::Marks;

    fn note(stored: &[f64], declared: &[f64]) -> Option<String> {
        let mut marks = Marks::default();
        stored.iter().for_each(|number| marks.meet(*number));
        marks.note(declared)
    }

    #[test]
    fn marks_far_from_the_others_are_told() {
        let told = note(&[1.0, -32768.0, 9.0, -32768.0, 32767.0], &[-9999.0]).unwrap();
        assert!(told.starts_with("3 samples are -32768.0,32767.0, far from the others (1 to 9)"), "{told}");
        assert!(told.ends_with("give --no-data -9999.0,-32768.0,32767.0"), "{told}");
        assert!(note(&[5.0, 5.0, 255.0], &[]).unwrap().contains("255.0"));
    }

    #[test]
    fn marks_among_the_others_are_heights() {
        assert_eq!(note(&[-8700.0, -9999.0, 2000.0], &[]), None);
        assert_eq!(note(&[0.0, 200.0, 255.0], &[]), None);
        assert_eq!(note(&[-9999.0, -9999.0], &[]), None);
        assert_eq!(note(&[1.0, 2.0, -5000.0], &[]), None);
    }
}
