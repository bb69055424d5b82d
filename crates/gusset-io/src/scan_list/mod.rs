//! scan_list

use crate::document::Document;
use crate::error::{Loss, ReadError, WriteError, WriteErrorKind};
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{Resources, Target};

pub(crate) fn read_scan_list(_: &[u8], _: &dyn Resources, _: &ReadOptions) -> Result<Document, ReadError> {
    Err(ReadError::unsupported("not yet"))
}
