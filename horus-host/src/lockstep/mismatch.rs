use std::fmt;

/// What core and std version disagreed about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layer {
    /// How far the window moved, or where it lies.
    Window,
    /// Beams counted, or the rectangle of changed cells.
    ScanReport,
    /// Whether a call was refused.
    Refusal,
    /// A cell's occupancy.
    Occupancy,
    /// A cell's cost.
    Cost,
}

impl Layer {
    /// A short name in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Window => "window",
            Self::ScanReport => "scan report",
            Self::Refusal => "refusal",
            Self::Occupancy => "occupancy",
            Self::Cost => "cost",
        }
    }
}

/// The first disagreement of a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mismatch {
    /// What it is about.
    pub layer: Layer,
    /// The tick, from 0.
    pub tick: u64,
    /// The tick's time.
    pub stamp_ns: u64,
    /// The cell (gx, gy), where it is about cells.
    pub cell: Option<(u32, u32)>,
    /// What the core says.
    pub core: String,
    /// What the std version says.
    pub std: String,
    /// The surroundings of the cell on both sides and where they differ; empty without a cell.
    pub picture: String,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "first mismatch: {}", self.layer.name())?;
        if let Some((gx, gy)) = self.cell {
            write!(f, " of cell ({gx}, {gy})")?;
        }
        write!(
            f,
            " in tick {} at {} ns: core {}, std {}",
            self.tick, self.stamp_ns, self.core, self.std
        )?;
        if !self.picture.is_empty() {
            write!(f, "\n{}", self.picture.trim_end())?;
        }
        Ok(())
    }
}
