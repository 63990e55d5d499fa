//! Grids as characters.

use std::fmt::Write;

/// The cells around `center`, one character each, for reports of a mismatch.
///
/// Shows the cells at most `radius` from the centre along either axis, as far as they lie in the
/// `width` x `height` grid. Every line starts with its gy, the highest first; the last line names
/// the columns. The centre stands in brackets. A window that misses the grid is empty.
///
/// # Examples
/// ```
/// use horus_host::picture::ascii_window;
///
/// let window = ascii_window(10, 10, (4, 5), 1, |gx, gy| if gx == gy { '#' } else { '.' });
/// assert_eq!(window, "6  . . .\n5  .[.]#\n4  . # .\ngx 3..=5\n");
/// ```
pub fn ascii_window(
    width: u32,
    height: u32,
    center: (u32, u32),
    radius: u32,
    mut character: impl FnMut(u32, u32) -> char,
) -> String {
    let span = |center: u32, size: u32| {
        let first = center.saturating_sub(radius);
        first..center.saturating_add(radius).saturating_add(1).min(size)
    };
    let (columns, rows) = (span(center.0, width), span(center.1, height));
    let mut text = String::new();
    if columns.is_empty() || rows.is_empty() {
        return text;
    }
    let margin = rows.end.to_string().len().max(2);
    for gy in rows.rev() {
        let _ = write!(text, "{gy:<margin$}");
        for gx in columns.clone() {
            let before = match gx {
                _ if (gx, gy) == center => '[',
                _ if gx > 0 && (gx - 1, gy) == center => ']',
                _ => ' ',
            };
            text.push(before);
            text.push(character(gx, gy));
        }
        if (columns.end - 1, gy) == center {
            text.push(']'); // no column follows that would close the bracket
        }
        text.push('\n');
    }
    let _ = writeln!(text, "{:<margin$} {}..={}", "gx", columns.start, columns.end - 1);
    text
}
