//! Bytes that a glTF file's JSON refers to: the binary chunk, `data:` addresses, files beside it, and compressed views.

use super::base64::{decode_base64, decode_percent};
use super::meshopt::{Codec, decode_view};
use crate::budget::Budget;
use crate::error::{Place, ReadError};
use crate::json_tape::Value;
use crate::resources::Resources;
use std::collections::BTreeMap;
use std::ops::{Deref, Range};
use std::rc::Rc;

/// Bytes that are cheap to copy.
#[derive(Clone)]
pub(super) enum Bytes<'a> {
    Borrowed(&'a [u8]),
    Shared(Rc<Vec<u8>>, Range<usize>),
}

impl Deref for Bytes<'_> {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match self {
            Self::Borrowed(bytes) => bytes,
            Self::Shared(bytes, range) => &bytes[range.clone()],
        }
    }
}

impl Bytes<'_> {
    fn from_vec(bytes: Vec<u8>) -> Self {
        let range = 0..bytes.len();
        Self::Shared(Rc::new(bytes), range)
    }

    /// Returns a part; the part that exists if the range exceeds the bytes.
    pub(super) fn part(&self, start: u64, length: u64) -> Self {
        let size = self.len();
        let start = usize::try_from(start).map_or(size, |start| start.min(size));
        let rest = size - start;
        let length = usize::try_from(length).map_or(rest, |length| length.min(rest));
        match self {
            Self::Borrowed(bytes) => Self::Borrowed(&bytes[start..start + length]),
            Self::Shared(bytes, range) => {
                Self::Shared(bytes.clone(), range.start + start..range.start + start + length)
            }
        }
    }
}

/// Bytes of a view, and what follows them in the buffer.
pub(super) struct View<'a> {
    pub(super) bytes: Bytes<'a>,
    /// The view's bytes and all after them in the buffer.
    pub(super) with_rest: Bytes<'a>,
    /// Bytes from one element to the next, if the view says so.
    pub(super) stride: Option<usize>,
}

/// Buffers and views of a file.
pub(super) struct Buffers<'a> {
    pub(super) budget: Budget,
    resources: &'a dyn Resources,
    binary: Option<&'a [u8]>,
    views: Vec<Value<'a>>,
    buffers: Vec<Value<'a>>,
    loaded: BTreeMap<usize, Bytes<'a>>,
    files: BTreeMap<String, Bytes<'a>>,
    decoded: BTreeMap<usize, Bytes<'a>>,
}

pub(super) const MESHOPT_EXTENSIONS: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

impl<'a> Buffers<'a> {
    pub(super) fn new(
        root: Value<'a>,
        binary: Option<&'a [u8]>,
        resources: &'a dyn Resources,
        budget: Budget,
    ) -> Result<Self, ReadError> {
        Ok(Self {
            budget,
            resources,
            binary,
            views: root.list("bufferViews")?,
            buffers: root.list("buffers")?,
            loaded: BTreeMap::new(),
            files: BTreeMap::new(),
            decoded: BTreeMap::new(),
        })
    }

    /// Returns the bytes of a view.
    pub(super) fn read_view(&mut self, index: usize) -> Result<View<'a>, ReadError> {
        let view = element(&self.views, index, "buffer view")?;
        let stride = view.get("byteStride").and_then(Value::whole_number).map(|stride| stride as usize);
        if let Some(compressed) = MESHOPT_EXTENSIONS.iter().find_map(|name| view.get("extensions")?.get(name)) {
            let bytes = self.decoded_view(index, compressed)?;
            let stride = compressed.get("byteStride").and_then(Value::whole_number).map(|stride| stride as usize);
            return Ok(View { bytes: bytes.clone(), with_rest: bytes, stride });
        }
        let (bytes, with_rest) = self.bytes_without_and_with_rest(view, &format!("buffer view {index}"))?;
        Ok(View { bytes, with_rest, stride })
    }

    /// Returns the bytes that `buffer`, `byteOffset` and `byteLength` name, then these bytes and all after them in the buffer.
    fn bytes_without_and_with_rest(
        &mut self,
        view: Value<'a>,
        name: &str,
    ) -> Result<(Bytes<'a>, Bytes<'a>), ReadError> {
        let number = |key: &str| match view.get(key) {
            None => Ok(None),
            Some(value) => value.whole_number().map(Some).ok_or_else(|| not_whole(name, key)),
        };
        let buffer = number("buffer")?.ok_or_else(|| malformed(format!("{name} does not name a buffer")))?;
        let start = number("byteOffset")?.unwrap_or(0);
        let length = number("byteLength")?.unwrap_or(u64::MAX);
        let whole = self.load_buffer(buffer as usize)?;
        Ok((whole.part(start, length), whole.part(start, u64::MAX)))
    }

    fn decoded_view(&mut self, index: usize, compressed: Value<'a>) -> Result<Bytes<'a>, ReadError> {
        if let Some(bytes) = self.decoded.get(&index) {
            return Ok(bytes.clone());
        }
        let name = format!("buffer view {index}");
        let (source, _) = self.bytes_without_and_with_rest(compressed, &name)?;
        let codec = Codec::from_json(compressed)
            .ok_or_else(|| malformed(format!("{name} has an unknown kind of meshopt compression")))?;
        self.budget.take_bytes_of::<u8>((codec.count as u64).saturating_mul(codec.stride as u64))?;
        let bytes = decode_view(&source, &codec)?
            .ok_or_else(|| malformed(format!("{name} is compressed by meshopt, and its bytes are not valid")))?;
        let bytes = Bytes::from_vec(bytes);
        self.decoded.insert(index, bytes.clone());
        Ok(bytes)
    }

    fn load_buffer(&mut self, index: usize) -> Result<Bytes<'a>, ReadError> {
        if let Some(bytes) = self.loaded.get(&index) {
            return Ok(bytes.clone());
        }
        let buffer = element(&self.buffers, index, "buffer")?;
        let bytes = match buffer.get("uri").and_then(Value::text) {
            Some(address) => self.load_address(&address, &format!("buffer {index}"))?,
            None => {
                let binary = self.binary.filter(|_| index == 0);
                Bytes::Borrowed(
                    binary.ok_or_else(|| malformed(format!("buffer {index} has neither bytes nor an address")))?,
                )
            }
        };
        self.loaded.insert(index, bytes.clone());
        Ok(bytes)
    }

    /// Returns the bytes of a `data:` address or of a file.
    fn load_address(&mut self, address: &str, name: &str) -> Result<Bytes<'a>, ReadError> {
        if let Some(data) = data_address(address) {
            let bytes = data.decode()?.ok_or_else(|| malformed(format!("{name} has an address of invalid base64")))?;
            self.budget.take_bytes_of::<u8>(bytes.len() as u64)?;
            return Ok(Bytes::from_vec(bytes));
        }
        let file = decode_percent(address)?;
        if let Some(bytes) = self.files.get(&file) {
            return Ok(bytes.clone());
        }
        let bytes = self.resources.load(&file)?;
        self.budget.add_source(bytes.len());
        let bytes = Bytes::from_vec(bytes);
        self.files.insert(file, bytes.clone());
        Ok(bytes)
    }
}

/// A `data:` address.
pub(super) struct DataAddress<'t> {
    pub(super) media_type: &'t str,
    is_base64: bool,
    data: &'t str,
}

impl DataAddress<'_> {
    /// Returns the bytes; `None` if they are not valid.
    pub(super) fn decode(&self) -> Result<Option<Vec<u8>>, ReadError> {
        if self.is_base64 {
            return decode_base64(self.data.as_bytes());
        }
        Ok(Some(decode_percent(self.data)?.into_bytes()))
    }
}

/// Splits an address that begins with `data:`.
pub(super) fn data_address(address: &str) -> Option<DataAddress<'_>> {
    let (head, data) = address.strip_prefix("data:")?.split_once(',')?;
    let media_type = head.split(';').next().unwrap_or_default();
    Some(DataAddress { media_type, is_base64: head.ends_with("base64"), data })
}

/// Returns an element of a list by an index of the file.
pub(super) fn element<'a>(list: &[Value<'a>], index: usize, what: &str) -> Result<Value<'a>, ReadError> {
    list.get(index)
        .copied()
        .ok_or_else(|| malformed(format!("{what} {index} does not exist (the file has {})", list.len())))
}

pub(super) fn malformed(message: impl Into<String>) -> ReadError {
    ReadError::malformed(Place::Whole, message)
}

pub(super) fn not_whole(name: &str, key: &str) -> ReadError {
    malformed(format!("{name}: {key} is not a whole number from 0"))
}
