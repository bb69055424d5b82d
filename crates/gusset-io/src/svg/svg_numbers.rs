//! Numbers and lengths in attributes.

/// User units of CSS in a metre: 96 in an inch.
pub(super) const UNITS_PER_METRE: f64 = 96.0 / 0.0254;

/// Reads numbers, letters and flags of an attribute.
pub(super) struct NumberReader<'a> {
    bytes: &'a [u8],
}

impl<'a> NumberReader<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { bytes: text.as_bytes() }
    }

    /// Passes white space and commas.
    pub(super) fn skip_separators(&mut self) {
        let count = self.bytes.iter().take_while(|byte| byte.is_ascii_whitespace() || **byte == b',').count();
        self.bytes = &self.bytes[count..];
    }

    /// Returns whether nothing but separators follows.
    pub(super) fn is_at_end(&mut self) -> bool {
        self.skip_separators();
        self.bytes.is_empty()
    }

    /// Returns the next byte and passes it.
    pub(super) fn byte(&mut self) -> Option<u8> {
        self.skip_separators();
        let (&byte, rest) = self.bytes.split_first()?;
        self.bytes = rest;
        Some(byte)
    }

    /// Returns the next byte.
    pub(super) fn peek(&mut self) -> Option<u8> {
        self.skip_separators();
        self.bytes.first().copied()
    }

    /// Returns the next number. Another sign or a second point ends it.
    pub(super) fn number(&mut self) -> Option<f64> {
        self.skip_separators();
        let unsigned = self.bytes.strip_prefix(b"+").unwrap_or(self.bytes);
        // Words such as `inf` are not numbers here.
        if !matches!(unsigned.iter().find(|byte| !matches!(byte, b'-' | b'.')), Some(b'0'..=b'9')) {
            return None;
        }
        let (value, length) = fast_float2::parse_partial(unsigned).ok()?;
        self.bytes = &unsigned[length..];
        Some(value)
    }

    /// Returns the next flag of an arc, which may be followed by a number without a separator.
    pub(super) fn flag(&mut self) -> Option<bool> {
        match self.peek()? {
            b'0' => self.byte().map(|_| false),
            b'1' => self.byte().map(|_| true),
            _ => None,
        }
    }

    /// Returns the letters that follow at once.
    fn letters(&mut self) -> &'a [u8] {
        let count = self.bytes.iter().take_while(|byte| byte.is_ascii_alphabetic() || **byte == b'%').count();
        let (letters, rest) = self.bytes.split_at(count);
        self.bytes = rest;
        letters
    }
}

/// Returns a length in user units. `full` is the length that 100% means.
pub(super) fn length(text: &str, full: f64) -> Option<f64> {
    let mut reader = NumberReader::new(text);
    let value = reader.number()?;
    match metres_per_length_unit(reader.letters()) {
        Ok(metres) => Some(value * metres * UNITS_PER_METRE),
        Err(b"%") => Some(value / 100.0 * full),
        Err(b"em" | b"rem") => Some(value * 16.0),
        Err(b"ex") => Some(value * 8.0),
        Err(_) => Some(value),
    }
}

/// Returns the metres of a length with a unit of length other than the pixel.
pub(super) fn metres(text: &str) -> Option<f64> {
    let mut reader = NumberReader::new(text);
    let value = reader.number()?;
    metres_per_length_unit(reader.letters()).ok().map(|metres| value * metres)
}

fn metres_per_length_unit(unit: &[u8]) -> Result<f64, &[u8]> {
    match unit {
        b"mm" => Ok(1e-3),
        b"cm" => Ok(1e-2),
        b"m" => Ok(1.0),
        b"in" => Ok(0.0254),
        b"pt" => Ok(0.0254 / 72.0),
        b"pc" => Ok(0.0254 / 6.0),
        b"Q" | b"q" => Ok(0.25e-3),
        _ => Err(unit),
    }
}
