use super::Cost;

/// Costs of several calls of one operation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stat {
    calls: u32,
    sum: u64,
    max: u32,
    stack: u32,
}

impl Stat {
    /// Adds one call.
    pub fn add(&mut self, cost: Cost) {
        self.calls += 1;
        self.sum += u64::from(cost.instructions);
        self.max = self.max.max(cost.instructions);
        self.stack = self.stack.max(cost.stack);
    }

    /// Mean instructions, rounded down; 0 without calls.
    pub fn mean(&self) -> u32 {
        self.sum.checked_div(self.calls.into()).unwrap_or(0) as u32
    }

    /// Most instructions.
    pub fn max(&self) -> u32 {
        self.max
    }

    /// Most bytes of stack.
    pub fn stack(&self) -> u32 {
        self.stack
    }
}

impl From<Cost> for Stat {
    fn from(cost: Cost) -> Self {
        let mut stat = Self::default();
        stat.add(cost);
        stat
    }
}
