//! What an XML reader is not given.

/// Most attributes of an element. Readers compare each with all before it, so that many more take seconds; files of people have a dozen.
pub const MOST_ATTRIBUTES: usize = 1000;

/// Byte of a text in XML at which an element begins that has more than [`MOST_ATTRIBUTES`], if there is one.
///
/// A sign of equality within a tag counts as an attribute, but for those in its values.
pub fn too_many_attributes(xml: &str) -> Option<usize> {
    let tags = xml.split('<').scan(0, |at, tag| {
        let begins = *at;
        *at += tag.len() + 1;
        Some((begins, tag))
    });
    let signs = |tag: &str| {
        let mut quote = None;
        let open = tag.bytes().filter(|&byte| match quote {
            Some(mark) => {
                quote = Some(mark).filter(|mark| *mark != byte);
                false
            }
            None => {
                quote = Some(byte).filter(|byte| b"\"'".contains(byte));
                quote.is_none()
            }
        });
        open.take_while(|byte| *byte != b'>').filter(|byte| *byte == b'=').count()
    };
    tags.skip(1).find(|(_, tag)| signs(tag) > MOST_ATTRIBUTES).map(|(begins, _)| begins - 1)
}

#[cfg(test)]
mod tests {
    use super::{MOST_ATTRIBUTES, too_many_attributes};

    #[test]
    fn the_element_is_found() {
        let with = |count: usize| {
            let attributes: String = (0..count).map(|k| format!(" a{k}=\"1\"")).collect();
            format!("<r>\n<e{attributes}/></r>")
        };
        assert_eq!(too_many_attributes(&with(MOST_ATTRIBUTES)), None);
        assert_eq!(too_many_attributes(&with(MOST_ATTRIBUTES + 1)), Some(4));
        assert_eq!(too_many_attributes(""), None);
        let signs = "=".repeat(MOST_ATTRIBUTES + 1);
        assert_eq!(too_many_attributes(&format!("<e a=\"{signs}\" b='>'>{signs}</e>")), None);
        assert_eq!(too_many_attributes(&format!("<e a='>' {signs}/>")), Some(0));
    }
}
