//! Where one picture is dark and the other lit.

use picture::{Depth, GreyPicture};

use crate::metrics::{CompareError, same_size};
use crate::ridges::horizon_of_picture;

/// Pixels of the ground by whether they are dark: as black as the eighth bit shows, that is in shadow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShadowAgreement {
    /// Pixels below the horizons of both pictures.
    pub compared: usize,
    /// Pixels that are dark in both pictures.
    pub both: usize,
    /// Dark in the picture under test alone.
    pub only_test: usize,
    /// Dark in the reference alone.
    pub only_reference: usize,
}

impl ShadowAgreement {
    /// Share of the pixels compared that are dark in both or lit in both, 0 to 1; 1 where none is compared.
    pub fn share(&self) -> f64 {
        let apart = self.only_test + self.only_reference;
        if self.compared == 0 { 1.0 } else { (self.compared - apart) as f64 / self.compared as f64 }
    }
}

/// Counts the pixels that are dark in one picture, in both, or in neither, below the lower of the two horizons of each
/// column: what a horizon is off by is not told twice.
///
/// # Errors
/// [`CompareError::Size`].
pub fn shadow_agreement(
    test: &GreyPicture,
    reference: &GreyPicture,
) -> Result<ShadowAgreement, CompareError> {
    same_size(test, reference)?;
    let horizons = [test, reference].map(|picture| horizon_of_picture(picture, darkest(picture)));
    let mut counts = ShadowAgreement { compared: 0, both: 0, only_test: 0, only_reference: 0 };
    for column in 0..test.columns() {
        let (Some(a), Some(b)) = (horizons[0][column], horizons[1][column]) else { continue };
        for line in a.max(b)..test.lines() {
            let is_dark = |picture: &GreyPicture| picture.code(column, line) <= darkest(picture);
            counts.compared += 1;
            match (is_dark(test), is_dark(reference)) {
                (true, true) => counts.both += 1,
                (true, false) => counts.only_test += 1,
                (false, true) => counts.only_reference += 1,
                (false, false) => {}
            }
        }
    }
    Ok(counts)
}

/// The largest code that eight bits would show black.
fn darkest(picture: &GreyPicture) -> u16 {
    match picture.depth() {
        Depth::Eight => 0,
        Depth::Sixteen => 128,
    }
}

#[cfg(test)]
mod tests {
    use picture::{Depth, GreyPicture};

    use super::{ShadowAgreement, shadow_agreement};

    fn picture(depth: Depth, codes: [u16; 8]) -> GreyPicture {
        GreyPicture::new(2, 4, depth, codes.into()).expect("a picture")
    }

    #[test]
    fn only_what_both_see_as_ground_counts() {
        // Columns: sky, ground, dark, ground; in the second the test's horizon is a line lower.
        let reference = picture(Depth::Eight, [0, 0, 90, 90, 0, 70, 80, 0]);
        let test = picture(Depth::Eight, [0, 0, 90, 0, 60, 70, 80, 80]);
        let found = shadow_agreement(&test, &reference).expect("one size");
        assert_eq!(found, ShadowAgreement { compared: 5, both: 0, only_test: 0, only_reference: 2 });
        assert_eq!(found.share(), 0.6);
        let turned = shadow_agreement(&reference, &test).expect("one size");
        assert_eq!((turned.only_test, turned.only_reference), (2, 0));
    }

    #[test]
    fn depths_meet_at_black() {
        let fine = picture(Depth::Sixteen, [0, 0, 9000, 9000, 128, 129, 9000, 9000]);
        let coarse = picture(Depth::Eight, [0, 0, 90, 90, 0, 1, 90, 90]);
        let found = shadow_agreement(&fine, &coarse).expect("one size");
        assert_eq!(found, ShadowAgreement { compared: 6, both: 1, only_test: 0, only_reference: 0 });
    }

    #[test]
    fn no_ground_is_no_disagreement() {
        let sky = picture(Depth::Eight, [0; 8]);
        assert_eq!(shadow_agreement(&sky, &sky).expect("one size").share(), 1.0);
    }
}
