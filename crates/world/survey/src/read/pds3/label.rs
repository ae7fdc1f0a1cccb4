//! PDS3 labels: keyword = value statements of the Object Description Language.

/// A value as the label has it.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A word, number or quoted text, with its unit.
    Plain {
        /// Characters without quotes; white space of quoted text joined.
        text: String,
        /// Unit of the value: the characters between `<` and `>`.
        unit: Option<String>,
    },
    /// `(a, b)` or `{a, b}`.
    List(Vec<Value>),
}

/// One statement of a label: keyword = value.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// Innermost OBJECT or GROUP around it, empty at the top.
    pub object: String,
    /// Keyword in capitals, pointers with `^`.
    pub keyword: String,
    /// Value that stands after the equals sign.
    pub value: Value,
    /// Line of the keyword, from 1.
    pub line: usize,
}

/// What is wrong with the text of a label.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LabelFault {
    /// Line of the fault in the label, from 1.
    pub line: usize,
    /// Text that stands there, for the message.
    pub found: String,
    /// Text or syntax that was expected there.
    pub expected: &'static str,
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Word(String),
    Quoted(String),
    Unit(String),
    Mark(u8),
}

/// Statements up to END; what follows END is not looked at.
pub fn parse(bytes: &[u8]) -> Result<Vec<Statement>, LabelFault> {
    let mut reader = Reader { bytes, at: 0, line: 1 };
    let (mut objects, mut out): (Vec<String>, Vec<Statement>) = (Vec::new(), Vec::new());
    loop {
        let (line, keyword) = match reader.next()? {
            Some((line, Token::Word(word))) => (line, word.to_ascii_uppercase()),
            Some((line, token)) => return Err(fault(line, format!("{token:?}"), "a keyword")),
            None => return Err(fault(reader.line, "the end of the label", "END: the label is truncated")),
        };
        match keyword.as_str() {
            "END" => break,
            "END_OBJECT" | "END_GROUP" => {
                if objects.pop().is_none() {
                    return Err(fault(line, keyword, "an OBJECT before it"));
                }
                if reader.peek()?.is_some_and(|token| token == Token::Mark(b'=')) {
                    reader.next()?;
                    reader.value()?;
                }
                continue;
            }
            _ => {}
        }
        match reader.next()? {
            Some((_, Token::Mark(b'='))) => {}
            other => {
                let found = other.map_or("the end".to_string(), |(_, token)| format!("{token:?}"));
                return Err(fault(line, format!("{keyword} followed by {found}"), "="));
            }
        }
        let value = reader.value()?;
        if let ("OBJECT" | "GROUP", Value::Plain { text, .. }) = (keyword.as_str(), &value) {
            objects.push(text.to_ascii_uppercase());
        } else {
            let object = objects.last().cloned().unwrap_or_default();
            out.push(Statement { object, keyword, value, line });
        }
    }
    match objects.last() {
        None => Ok(out),
        Some(open) => Err(fault(reader.line, format!("END inside OBJECT = {open}"), "END_OBJECT before it")),
    }
}

fn fault(line: usize, found: impl Into<String>, expected: &'static str) -> LabelFault {
    LabelFault { line, found: found.into(), expected }
}

#[derive(Clone)]
struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl Reader<'_> {
    fn value(&mut self) -> Result<Value, LabelFault> {
        let (line, token) =
            self.next()?.ok_or_else(|| fault(self.line, "the end of the label", "a value"))?;
        match token {
            Token::Word(text) | Token::Quoted(text) => {
                let mut unit = None;
                if let Some(Token::Unit(found)) = self.peek()? {
                    self.next()?;
                    unit = Some(found);
                }
                Ok(Value::Plain { text, unit })
            }
            Token::Mark(b'(' | b'{') => self.list(line),
            other => Err(fault(line, format!("{other:?}"), "a value")),
        }
    }

    fn list(&mut self, line: usize) -> Result<Value, LabelFault> {
        let mut values = Vec::new();
        loop {
            match self.peek()? {
                Some(Token::Mark(b')' | b'}')) => {
                    self.next()?;
                    return Ok(Value::List(values));
                }
                Some(Token::Mark(b',')) => drop(self.next()?),
                Some(Token::Mark(b'(' | b'{')) if values.len() > 10_000 => {
                    return Err(fault(line, "a list without end", "at most 10000 values"));
                }
                Some(Token::Mark(b'(' | b'{')) => {
                    // One level within another occurs; more would only serve to exhaust the stack.
                    self.next()?;
                    let mut inner = Vec::new();
                    while !matches!(self.peek()?, None | Some(Token::Mark(b')' | b'}'))) {
                        if self.peek()? == Some(Token::Mark(b',')) {
                            self.next()?;
                        } else {
                            inner.push(self.plain(line)?);
                        }
                    }
                    self.next()?;
                    values.push(Value::List(inner));
                }
                Some(_) => values.push(self.plain(line)?),
                None => return Err(fault(line, "a list without end", ") or }")),
            }
        }
    }

    fn plain(&mut self, line: usize) -> Result<Value, LabelFault> {
        match self.peek()? {
            Some(Token::Word(_) | Token::Quoted(_)) => self.value(),
            other => Err(fault(line, format!("{other:?} in a list"), "a value")),
        }
    }

    fn peek(&self) -> Result<Option<Token>, LabelFault> {
        Ok(self.clone().next()?.map(|(_, token)| token))
    }

    fn next(&mut self) -> Result<Option<(usize, Token)>, LabelFault> {
        self.skip_blank()?;
        let line = self.line;
        let Some(&byte) = self.bytes.get(self.at) else { return Ok(None) };
        let token = match byte {
            b'=' | b'(' | b')' | b'{' | b'}' | b',' => {
                self.at += 1;
                Token::Mark(byte)
            }
            b'"' | b'\'' => Token::Quoted(self.until(byte, "the closing quote")?),
            b'<' => Token::Unit(self.until(b'>', ">")?),
            _ => Token::Word(self.word()),
        };
        Ok(Some((line, token)))
    }

    fn skip_blank(&mut self) -> Result<(), LabelFault> {
        loop {
            match self.bytes.get(self.at) {
                Some(b'/') if self.bytes.get(self.at + 1) == Some(&b'*') => {
                    let rest = &self.bytes[self.at..];
                    let end = rest.windows(2).skip(2).position(|pair| pair == b"*/");
                    let end = end.ok_or_else(|| fault(self.line, "a comment without end", "*/"))? + 4;
                    self.advance(end);
                }
                Some(byte) if byte.is_ascii_whitespace() || *byte == 0 => self.advance(1),
                _ => return Ok(()),
            }
        }
    }

    fn advance(&mut self, count: usize) {
        self.line += self.bytes[self.at..self.at + count].iter().filter(|byte| **byte == b'\n').count();
        self.at += count;
    }

    fn until(&mut self, end: u8, expected: &'static str) -> Result<String, LabelFault> {
        let rest = &self.bytes[self.at + 1..];
        let Some(length) = rest.iter().position(|byte| *byte == end) else {
            return Err(fault(self.line, "text without end", expected));
        };
        let text = String::from_utf8_lossy(&rest[..length]);
        let joined = text.split_whitespace().collect::<Vec<_>>().join(" ");
        self.advance(length + 2);
        Ok(joined)
    }

    fn word(&mut self) -> String {
        let rest = &self.bytes[self.at..];
        let ends = |byte: &u8| byte.is_ascii_whitespace() || b"=(){},<\"".contains(byte);
        let length = rest.iter().position(ends).unwrap_or(rest.len()).max(1);
        let word = String::from_utf8_lossy(&rest[..length]).into_owned();
        self.advance(length);
        word
    }
}

#[cfg(test)]
mod tests {
    use super::{Value, parse};

    fn plain(text: &str, unit: Option<&str>) -> Value {
        Value::Plain { text: text.into(), unit: unit.map(Into::into) }
    }

    #[test]
    fn statements_wrap_nest_and_carry_units() {
        let text = b"PDS_VERSION_ID = PDS3 /* note = 3 */\r\nPHASE = {\"ONE\",\"TWO\n   MORE\"}\n^IMAGE = (\"A.IMG\", 3 <BYTES>)
OBJECT = IMAGE\n LINES\n =\n 720\n SCALE = 4 <pix/deg>\nEND_OBJECT = IMAGE\nEND\n\x00\xff = garbage";
        let found = parse(text).unwrap();
        let keywords: Vec<_> =
            found.iter().map(|s| (s.object.as_str(), s.keyword.as_str(), s.line)).collect();
        assert_eq!(
            keywords,
            [
                ("", "PDS_VERSION_ID", 1),
                ("", "PHASE", 2),
                ("", "^IMAGE", 4),
                ("IMAGE", "LINES", 6),
                ("IMAGE", "SCALE", 9)
            ]
        );
        assert_eq!(found[1].value, Value::List(vec![plain("ONE", None), plain("TWO MORE", None)]));
        assert_eq!(found[2].value, Value::List(vec![plain("A.IMG", None), plain("3", Some("BYTES"))]));
        assert_eq!(found[4].value, plain("4", Some("pix/deg")));
    }

    #[test]
    fn damaged_labels_name_the_line() {
        let fault = |text: &[u8]| parse(text).unwrap_err();
        assert_eq!(fault(b"A = 1\nB = \"open\nEND").line, 2);
        assert_eq!(fault(b"A = 1\n/* open\nEND").expected, "*/");
        assert_eq!(fault(b"A = 1\nOBJECT = X\nB = 2\nEND").expected, "END_OBJECT before it");
        assert_eq!(fault(b"A = 1\nEND_OBJECT = X\nEND").line, 2);
        assert_eq!(fault(b"A = 1\nB 2\nEND").expected, "=");
        assert!(fault(b"A = 1\n").expected.contains("truncated"));
        assert_eq!(fault(b"A = (1, 2\nEND = 3").expected, "a value");
        assert_eq!(fault(b"A = = 3\nEND").expected, "a value");
    }
}
