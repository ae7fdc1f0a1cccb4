//! JSON as programs of other people write it.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde_json::{Error, Map, Number, Value};

use crate::without_byte_order_mark;

/// Reads JSON, with or without a byte order mark. Two values of one key are refused. Most readers keep the last and say
/// nothing of the first.
///
/// # Errors
/// What is no JSON, and a key with two values, with line and column.
pub fn read_json(bytes: &[u8]) -> Result<Value, Error> {
    serde_json::from_slice(without_byte_order_mark(bytes)).map(|OneOfAKey(value)| value)
}

/// A value whose objects have one value of a key.
struct OneOfAKey(Value);

impl<'de> Deserialize<'de> for OneOfAKey {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AnyValue).map(Self)
    }
}

struct AnyValue;

impl<'de> Visitor<'de> for AnyValue {
    type Value = Value;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str("a value of JSON")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, truth: bool) -> Result<Value, E> {
        Ok(Value::Bool(truth))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Value, E> {
        Ok(Value::Number(number.into()))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Value, E> {
        Ok(Value::Number(number.into()))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Value, E> {
        Ok(Number::from_f64(number).map_or(Value::Null, Value::Number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::String(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let mut list = Vec::new();
        while let Some(OneOfAKey(item)) = items.next_element()? {
            list.push(item);
        }
        Ok(Value::Array(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let mut object = Map::new();
        while let Some(key) = entries.next_key::<String>()? {
            if object.contains_key(&key) {
                return Err(A::Error::custom(format!("two values of the key `{}`", crate::visible(&key))));
            }
            let OneOfAKey(value) = entries.next_value()?;
            object.insert(key, value);
        }
        Ok(Value::Object(object))
    }
}

#[cfg(test)]
mod tests {
    use super::read_json;
    use serde_json::{Value, from_str};

    #[test]
    fn values_of_every_kind() {
        let text = r#"{"a":[null,true,-3,18446744073709551615,0.1,"x\né",{}],"b":{"a":1e300}}"#;
        assert_eq!(read_json(text.as_bytes()).unwrap(), from_str::<Value>(text).unwrap());
        assert_eq!(read_json(b"\xef\xbb\xbf7").unwrap(), Value::from(7));
    }

    #[test]
    fn a_key_has_one_value() {
        let said = read_json(b"{\"a\": [{\"b\": 1,\n \"b\": 1}]}").unwrap_err().to_string();
        assert!(said.contains("two values of the key `b`") && said.contains("line 2"), "{said}");
        assert!(read_json(b"{\"a\": {\"b\": 1}, \"b\": 1}").is_ok(), "one of each object");
        for bad in ["", "{", "{\"a\":1}}", "[1,]", "nan", "1e999"] {
            assert!(read_json(bad.as_bytes()).is_err(), "{bad}");
        }
    }
}
