//! Labels of PDS3 and ISIS: keyword = value statements of the Object Description Language.

use crate::read::words::seen;

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

impl Value {
    /// The value as it stands in the label, without quotes.
    pub fn text(&self) -> String {
        match self {
            Self::Plain { text, unit: Some(unit) } => format!("{text} <{unit}>"),
            Self::Plain { text, unit: None } => text.clone(),
            Self::List(values) => {
                format!("({})", values.iter().map(Self::text).collect::<Vec<_>>().join(", "))
            }
        }
    }

    /// The same value with a unit, where it has none of its own.
    fn with(self, unit: &str) -> Self {
        match self {
            Self::Plain { text, unit: None } => Self::Plain { text, unit: Some(unit.to_owned()) },
            other => other,
        }
    }
}

/// An OBJECT or GROUP of a label.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// The word that begins it: `OBJECT` or `GROUP`.
    pub word: &'static str,
    /// Name of the object in capitals.
    pub name: String,
    /// Line of the label where it begins, from 1.
    pub line: usize,
}

/// One statement of a label: keyword = value.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// OBJECTs and GROUPs around it, the outermost first.
    pub blocks: Vec<Block>,
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

/// Most OBJECTs and GROUPs within one another; those of the archives have four.
const MOST_NESTED: usize = 16;

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Word(String),
    Quoted(String),
    Unit(String),
    Mark(u8),
}

impl Token {
    /// The token as it stands in the label.
    fn text(&self) -> String {
        match self {
            Self::Word(text) => text.clone(),
            Self::Quoted(text) => format!("\"{text}\""),
            Self::Unit(text) => format!("<{text}>"),
            Self::Mark(mark) => char::from(*mark).to_string(),
        }
    }
}

/// Statements up to END; what follows END is not looked at.
pub fn parse(bytes: &[u8]) -> Result<Vec<Statement>, LabelFault> {
    let mut reader = Reader { bytes, at: 0, line: 1 };
    let (mut blocks, mut out): (Vec<Block>, Vec<Statement>) = (Vec::new(), Vec::new());
    loop {
        let (line, keyword) = match reader.next()? {
            Some((line, Token::Word(word))) => (line, word.to_ascii_uppercase()),
            Some((line, token)) => return Err(fault(line, token.text(), "a keyword")),
            None => return Err(fault(reader.line, "the end of the label", "END: the label is truncated")),
        };
        match keyword.as_str() {
            "END" => break,
            "END_OBJECT" | "END_GROUP" => {
                let name = match reader.peek()?.is_some_and(|token| token == Token::Mark(b'=')) {
                    true => {
                        reader.next()?;
                        Some(reader.value(line, &keyword)?.text())
                    }
                    false => None,
                };
                close(&mut blocks, line, &keyword, name.as_deref())?;
                continue;
            }
            _ => {}
        }
        match reader.next()? {
            Some((_, Token::Mark(b'='))) => {}
            other => {
                let found = other.map_or("the end".to_string(), |(_, token)| token.text());
                return Err(fault(line, format!("{keyword} followed by {found}"), "="));
            }
        }
        let value = reader.value(line, &keyword)?;
        match (keyword.as_str(), value) {
            ("OBJECT" | "GROUP" | "BEGIN_OBJECT" | "BEGIN_GROUP", Value::Plain { text, .. }) => {
                if blocks.len() == MOST_NESTED {
                    return Err(fault(
                        line,
                        "one more OBJECT within others",
                        "at most 16 within one another",
                    ));
                }
                let word = if keyword.ends_with("GROUP") { "GROUP" } else { "OBJECT" };
                blocks.push(Block { word, name: text.to_ascii_uppercase(), line });
            }
            (_, value) => out.push(Statement { blocks: blocks.clone(), keyword, value, line }),
        }
    }
    match blocks.last() {
        None => Ok(out),
        Some(open) => {
            let found = format!("END inside {} = {}", open.word, open.name);
            Err(fault(reader.line, found, end_of(open)))
        }
    }
}

/// Ends the innermost block, which `keyword` must be the end of, and `name` the name of, if one is given.
fn close(blocks: &mut Vec<Block>, line: usize, keyword: &str, name: Option<&str>) -> Result<(), LabelFault> {
    let Some(open) = blocks.pop() else {
        return Err(fault(line, keyword, "the OBJECT or GROUP that it ends before it"));
    };
    let is_named = name.is_none_or(|name| name.eq_ignore_ascii_case(&open.name));
    if is_named && keyword.ends_with(open.word) {
        return Ok(());
    }
    let found = format!("{keyword} = {} inside {} = {}", name.unwrap_or_default(), open.word, open.name);
    Err(fault(line, found, end_of(&open)))
}

fn end_of(open: &Block) -> &'static str {
    if open.word == "GROUP" { "END_GROUP before it" } else { "END_OBJECT before it" }
}

fn fault(line: usize, found: impl Into<String>, expected: &'static str) -> LabelFault {
    LabelFault { line, found: seen(&found.into()), expected }
}

#[derive(Clone)]
struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl Reader<'_> {
    /// The value of the keyword on `line`, with its unit.
    fn value(&mut self, line: usize, keyword: &str) -> Result<Value, LabelFault> {
        let missing =
            |found: &str| fault(line, format!("{keyword} without a value, then {found}"), "its value");
        let (at, token) = self.next()?.ok_or_else(|| missing("the end of the label"))?;
        let value = match token {
            Token::Word(word) if at > line && self.is_keyword(&word)? => return Err(missing(&word)),
            Token::Word(text) | Token::Quoted(text) => return Ok(Value::Plain { text, unit: self.unit()? }),
            Token::Mark(b'(' | b'{') => self.list(at)?,
            other => return Err(missing(&other.text())),
        };
        // A unit behind a list is that of all its values.
        Ok(match (self.unit()?, value) {
            (Some(unit), Value::List(values)) => {
                Value::List(values.into_iter().map(|v| v.with(&unit)).collect())
            }
            (_, value) => value,
        })
    }

    /// Whether the word just read is the next keyword: then the value before it is missing.
    fn is_keyword(&self, word: &str) -> Result<bool, LabelFault> {
        let is_end = ["END", "END_OBJECT", "END_GROUP"].iter().any(|end| word.eq_ignore_ascii_case(end));
        Ok(is_end || self.peek()? == Some(Token::Mark(b'=')))
    }

    fn unit(&mut self) -> Result<Option<String>, LabelFault> {
        let Some(Token::Unit(found)) = self.peek()? else { return Ok(None) };
        self.next()?;
        Ok(Some(found))
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
            Some(Token::Word(text) | Token::Quoted(text)) => {
                self.next()?;
                Ok(Value::Plain { text, unit: self.unit()? })
            }
            other => {
                let found = other.map_or("the end of the label".to_owned(), |token| token.text());
                Err(fault(line, format!("{found} in a list"), "a value"))
            }
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
                // ISIS writes comments to the end of a line.
                Some(b'#') => {
                    let rest = &self.bytes[self.at..];
                    self.advance(rest.iter().position(|byte| *byte == b'\n').unwrap_or(rest.len()));
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
        let ends =
            |byte: &u8| byte.is_ascii_whitespace() || byte.is_ascii_control() || b"=(){},<\"".contains(byte);
        let length = rest.iter().position(ends).unwrap_or(rest.len()).max(1);
        let word = String::from_utf8_lossy(&rest[..length]).into_owned();
        self.advance(length);
        word
    }
}

#[cfg(test)]
mod tests {
    use super::{Statement, Value, parse};

    /// Name of the innermost object of a statement.
    fn inner(statement: &Statement) -> &str {
        statement.blocks.last().map_or("", |block| block.name.as_str())
    }

    fn plain(text: &str, unit: Option<&str>) -> Value {
        Value::Plain { text: text.into(), unit: unit.map(Into::into) }
    }

    #[test]
    fn statements_wrap_nest_and_carry_units() {
        let text = b"PDS_VERSION_ID = PDS3 /* note = 3 */\r\nPHASE = {\"ONE\",\"TWO\n   MORE\"}\n^IMAGE = (\"A.IMG\", 3 <BYTES>)
OBJECT = IMAGE\n LINES\n =\n 720\n SCALE = 4 <pix/deg>\nEND_OBJECT = IMAGE\nEND\n\x00\xff = garbage";
        let found = parse(text).unwrap();
        let keywords: Vec<_> = found.iter().map(|s| (inner(s), s.keyword.as_str(), s.line)).collect();
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
    fn archives_write_begin_units_behind_lists_and_nul_behind_end() {
        let text =
            b"# a comment = of ISIS\nBEGIN_OBJECT = A\nB = (1.0, 2.0 <M>) <S>\nEND_OBJECT = A\nEND\0\0\0";
        let found = parse(text).unwrap();
        assert_eq!((inner(&found[0]), found.len()), ("A", 1));
        assert_eq!(found[0].value, Value::List(vec![plain("1.0", Some("S")), plain("2.0", Some("M"))]));
        assert_eq!(found[0].value.text(), "(1.0 <S>, 2.0 <M>)");
    }

    #[test]
    fn a_missing_value_names_its_own_keyword() {
        for next in ["B = 2\nEND", "OBJECT = X\nEND", "END", "END_OBJECT = X\nEND"] {
            let text = format!("A = 1\nNOTE =\n{next}\n");
            let fault = parse(text.as_bytes()).unwrap_err();
            assert_eq!((fault.line, fault.expected), (2, "its value"), "{next}");
            assert!(fault.found.starts_with("NOTE without a value, then "), "{fault:?}");
        }
        assert_eq!(parse(b"A =\n NULL\nEND\n").unwrap()[0].value, plain("NULL", None));
    }

    #[test]
    fn damaged_labels_name_the_line() {
        let fault = |text: &[u8]| parse(text).unwrap_err();
        assert_eq!(fault(b"A = 1\nB = \"open\nEND").line, 2);
        assert_eq!(fault(b"A = 1\n/* open\nEND").expected, "*/");
        assert_eq!(fault(b"A = 1\nOBJECT = X\nB = 2\nEND").expected, "END_OBJECT before it");
        assert_eq!(fault(b"A = 1\nEND_OBJECT = X\nEND").line, 2);
        assert_eq!(fault(b"GROUP = X\nB = 2\nEND").expected, "END_GROUP before it");
        let crossed = fault(b"GROUP = X\nB = 2\nEND_OBJECT = X\nEND");
        assert_eq!((crossed.line, crossed.found.as_str()), (3, "END_OBJECT = X inside GROUP = X"));
        assert_eq!(fault(b"OBJECT = X\nB = 2\nEND_OBJECT = Y\nEND").line, 3);
        assert_eq!(fault(b"A = 1\nB 2\nEND").expected, "=");
        assert!(fault(b"A = 1\n").expected.contains("truncated"));
        assert_eq!(fault(b"A = (1, 2\nEND = 3").expected, "a value");
        assert_eq!(fault(b"A = = 3\nEND").expected, "its value");
    }
}
