//! Text in fixed-size, zero-filled byte fields.

/// The text up to the first zero byte; what is not UTF-8 ends it.
pub(crate) fn read(bytes: &[u8]) -> &str {
    let end = bytes.iter().position(|b| *b == 0).unwrap_or(bytes.len());
    let bytes = bytes.get(..end).unwrap_or(&[]);
    match core::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(e) => bytes
            .get(..e.valid_up_to())
            .and_then(|valid| core::str::from_utf8(valid).ok())
            .unwrap_or(""),
    }
}

/// Stores as many whole characters of `text` as fit and fills the rest with zeros.
pub(crate) fn write(bytes: &mut [u8], text: &str) {
    bytes.fill(0);
    let end = text.floor_char_boundary(bytes.len());
    for (to, from) in bytes.iter_mut().zip(text.bytes().take(end)) {
        *to = from;
    }
}

#[cfg(test)]
mod tests {
    use super::{read, write};

    #[test]
    fn text_is_cut_at_a_character_boundary() {
        let mut field = [0xffu8; 4];
        write(&mut field, "aé€");
        assert_eq!(read(&field), "aé");
        assert_eq!(field, [b'a', 0xc3, 0xa9, 0]);
        write(&mut field, "map");
        assert_eq!(read(&field), "map");
        write(&mut field, "long name");
        assert_eq!(read(&field), "long");
        assert_eq!(read(&[b'x', 0xff, 0]), "x");
        assert_eq!(read(&[]), "");
    }
}
