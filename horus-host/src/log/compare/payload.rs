//! The difference between two payloads of one type.
use super::cells::Cells;
use crate::log::{
    LogChannel, MESSAGE_ENCODING,
    cdr::CdrError,
    msg::{Costmap, Grid, LaserScan, Message, OccupancyGrid, Path, PoseStamped, TFMessage, TransformStamped},
};

/// The first difference between two payloads.
pub(super) struct PayloadDifference {
    pub field: String,
    pub cell: Option<[u64; 2]>,
    pub a: String,
    pub b: String,
}

impl PayloadDifference {
    pub fn new(field: &str, a: impl ToString, b: impl ToString) -> Self {
        Self {
            field: field.to_owned(),
            cell: None,
            a: a.to_string(),
            b: b.to_string(),
        }
    }
}

/// The first difference between payloads `a` and `b` of `channel`'s type, and the number of
/// differing cells. Floats and known cells at most `tolerance` apart are equal.
pub(super) fn difference(
    channel: &LogChannel,
    a: &[u8],
    b: &[u8],
    tolerance: f64,
) -> (Option<PayloadDifference>, u64) {
    if a == b {
        return (None, 0);
    }
    let compare = match channel.type_name.as_str() {
        _ if channel.encoding != MESSAGE_ENCODING => bytes,
        OccupancyGrid::TYPE => decoded::<OccupancyGrid>,
        Costmap::TYPE => decoded::<Costmap>,
        Grid::TYPE => decoded::<Grid>,
        LaserScan::TYPE => decoded::<LaserScan>,
        TFMessage::TYPE => decoded::<TFMessage>,
        Path::TYPE => decoded::<Path>,
        PoseStamped::TYPE => decoded::<PoseStamped>,
        TransformStamped::TYPE => decoded::<TransformStamped>,
        _ => bytes,
    };
    compare(a, b, tolerance)
        .or_else(|_| bytes(a, b, tolerance))
        .unwrap_or((None, 0))
}

type Found = (Option<PayloadDifference>, u64);

/// Field by field.
fn decoded<M: Message + Cells>(a: &[u8], b: &[u8], tolerance: f64) -> Result<Found, CdrError> {
    let (a, mut b) = (M::from_payload(a)?, M::from_payload(b)?);
    if tolerance > 0.0 {
        b.settle_cells(&a, tolerance);
    }
    let Some(first) = a.difference(&b) else {
        return Ok((None, 0));
    };
    let in_cells = |index| (first.path == "data").then(|| a.cell_value(&b, index)).flatten();
    let difference = match first.element {
        Some(index) => match in_cells(index) {
            Some(value) => PayloadDifference {
                field: value.field,
                cell: Some(value.cell),
                a: value.a,
                b: value.b,
            },
            None => PayloadDifference::new(&format!("{}[{index}]", first.path), first.a, first.b),
        },
        None => PayloadDifference::new(&first.path, first.a, first.b),
    };
    Ok((Some(difference), a.differing_cells(&b)))
}

/// Byte by byte.
fn bytes(a: &[u8], b: &[u8], _tolerance: f64) -> Result<Found, CdrError> {
    let first = a.iter().zip(b).position(|(a, b)| a != b);
    let difference = match first {
        Some(at) => PayloadDifference::new(&format!("payload[{at}]"), a[at], b[at]),
        None => {
            let length = |bytes: &[u8]| format!("{} bytes", bytes.len());
            PayloadDifference::new("payload", length(a), length(b))
        }
    };
    Ok((Some(difference), 0))
}
