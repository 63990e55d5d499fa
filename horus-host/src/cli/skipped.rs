use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

use super::step::SkipReason;

/// Scans that were not used, by reason.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Skipped {
    reasons: BTreeMap<&'static str, Reason>,
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
struct Reason {
    scans: u64,
    /// The first of them in words.
    first: String,
}

impl Skipped {
    pub fn add(&mut self, reason: &SkipReason) {
        let entry = self.reasons.entry(reason.key()).or_insert_with(|| Reason {
            scans: 0,
            first: reason.sentence(),
        });
        entry.scans += 1;
    }

    pub fn total(&self) -> u64 {
        self.reasons.values().map(|reason| reason.scans).sum()
    }
}

impl fmt::Display for Skipped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (key, reason)) in self.reasons.iter().enumerate() {
            let separator = if i > 0 { "; " } else { "" };
            write!(f, "{separator}{} {key} ({})", reason.scans, reason.first)?;
        }
        Ok(())
    }
}
