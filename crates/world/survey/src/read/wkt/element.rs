//! Well-known text as a tree of elements.

/// Most elements within one another; those of coordinate systems have five.
const MOST_NESTED: usize = 16;
/// An element: its keyword, its text and numbers in order, and the elements inside it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Element {
    /// The keyword, in capitals.
    pub keyword: String,
    /// Texts in quotes, in order; of an element without brackets its word.
    pub texts: Vec<String>,
    /// Its numbers, in order.
    pub numbers: Vec<f64>,
    /// Elements inside it, in order.
    pub inside: Vec<Element>,
}

impl Element {
    /// The first element of a keyword directly inside.
    pub fn child(&self, keyword: &str) -> Option<&Element> {
        self.inside.iter().find(|child| child.keyword == keyword)
    }

    /// The first element of a keyword at any depth, itself included.
    pub fn find(&self, keyword: &str) -> Option<&Element> {
        if self.keyword == keyword {
            return Some(self);
        }
        self.inside.iter().find_map(|child| child.find(keyword))
    }

    /// The first text: the name of the element.
    pub fn name(&self) -> &str {
        self.texts.first().map_or("", String::as_str)
    }
}

/// The element at the front of a text, and what stands behind it; the error is what stands in place of an element.
pub fn parse(text: &str) -> Result<(Element, &str), String> {
    let mut reader = Reader { rest: text, depth: 0 };
    let element = reader.element()?;
    Ok((element, reader.rest))
}

/// Reads elements from the front of a text.
struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    /// The next element; the error is what stands in place of one.
    fn element(&mut self) -> Result<Element, String> {
        let keyword = self.word();
        if keyword.is_empty() || !keyword.starts_with(|first: char| first.is_ascii_alphabetic()) {
            return Err(self.found(&keyword));
        }
        let mut element = Element { keyword: keyword.to_ascii_uppercase(), ..Element::default() };
        if !self.takes(&['[', '(']) {
            // A bare word, as the direction of an axis.
            element.texts.push(keyword);
            return Ok(element);
        }
        self.depth += 1;
        if self.depth > MOST_NESTED {
            return Err(format!("{} elements within one another", self.depth));
        }
        loop {
            self.value(&mut element)?;
            if self.takes(&[']', ')']) {
                self.depth -= 1;
                return Ok(element);
            }
            if !self.takes(&[',']) {
                return Err(self.found(&element.keyword));
            }
        }
    }

    fn value(&mut self, element: &mut Element) -> Result<(), String> {
        let rest = self.rest.trim_start();
        if let Some(quoted) = rest.strip_prefix('"') {
            let (text, after) = quoted.split_once('"').ok_or_else(|| self.found(&element.keyword))?;
            element.texts.push(text.to_owned());
            self.rest = after;
            return Ok(());
        }
        if rest.starts_with(|first: char| first.is_ascii_alphabetic()) {
            element.inside.push(self.element()?);
            return Ok(());
        }
        let word = self.word();
        element.numbers.push(word.parse().map_err(|_| self.found(&word))?);
        Ok(())
    }

    /// Letters, digits and what numbers are made of.
    fn word(&mut self) -> String {
        let rest = self.rest.trim_start();
        let is_part = |c: char| c.is_ascii_alphanumeric() || "_+-.".contains(c);
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        self.rest = &rest[end..];
        rest[..end].to_owned()
    }

    /// Whether one of these characters comes next, which is then taken.
    fn takes(&mut self, marks: &[char]) -> bool {
        let after = self.rest.trim_start().strip_prefix(marks);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    fn found(&self, before: &str) -> String {
        format!("{before}{}", self.rest.chars().take(40).collect::<String>())
    }
}
