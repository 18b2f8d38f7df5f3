//! JSON objects whose keys keep their order and whose values keep their spelling.

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap as _, Serializer};
use serde_json::value::{RawValue, to_raw_value};

/// An object, key by key. A key that stands there twice is kept twice.
#[derive(Clone, Debug, Default)]
pub(super) struct Object(pub Vec<(String, Box<RawValue>)>);

impl Object {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&RawValue> {
        let found = self.0.iter().find(|(name, _)| name == key);
        found.map(|(_, value)| &**value)
    }

    /// The value of a key that is a text or a number.
    pub fn text(&self, key: &str) -> Option<String> {
        text(self.get(key)?)
    }

    /// Gives a key a value, where it stands or at the end.
    pub fn set(&mut self, key: &str, value: impl Serialize) {
        let value = raw(&value);
        match self.0.iter_mut().find(|(name, _)| name == key) {
            Some((_, old)) => *old = value,
            None => self.0.push((key.to_owned(), value)),
        }
    }

    /// Gives a key another name and another value, in its place.
    pub fn replace(&mut self, key: &str, name: &str, value: impl Serialize) {
        match self.0.iter_mut().find(|(old, _)| old == key) {
            Some(entry) => *entry = (name.to_owned(), raw(&value)),
            None => self.set(name, value),
        }
    }

    /// Gives a key another name, unless something has that already.
    pub fn rename(&mut self, key: &str, name: &str) {
        if self.get(name).is_none()
            && let Some((old, _)) = self.0.iter_mut().find(|(old, _)| old == key)
        {
            *old = name.to_owned();
        }
    }
}

/// A JSON text of a value.
pub(super) fn raw(value: &impl Serialize) -> Box<RawValue> {
    to_raw_value(value).expect("strings, numbers and lists of such are JSON")
}

/// A value that is a text or a number.
pub(super) fn text(value: &RawValue) -> Option<String> {
    let loose = serde_json::from_str::<super::super::json::Loose>(value.get());
    loose.ok().map(|loose| loose.0)
}

/// A value that is a list.
pub(super) fn list(value: Option<&RawValue>) -> Option<Vec<Box<RawValue>>> {
    serde_json::from_str(value?.get()).ok()
}

impl<'de> Deserialize<'de> for Object {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries;

        impl<'de> Visitor<'de> for Entries {
            type Value = Object;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Object, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Object(entries))
            }
        }

        deserializer.deserialize_map(Entries)
    }
}

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (key, value) in &self.0 {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}
