//! three_mf

use crate::document::Document;
use crate::error::{Loss, ReadError, WriteError, WriteErrorKind};
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{Resources, Target};

pub(crate) fn read_3mf(_: &[u8], _: &ReadOptions) -> Result<Document, ReadError> {
    Err(ReadError::unsupported("not yet"))
}

pub(crate) fn write_3mf(_: &Document, _: &mut Target<'_>, _: &WriteOptions) -> Result<Vec<Loss>, WriteError> {
    Err(WriteError::new(WriteErrorKind::Unsupported, "not yet"))
}
