use super::Stat;
use crate::rt::hprintln;

/// The most instructions an operation should take on average.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The setting's column.
    pub setting: &'static str,
    /// The operation's column.
    pub operation: &'static str,
    /// Instructions.
    pub limit: u32,
}

/// Prints one row per operation and setting; remembers the deepest stack and which targets were
/// met with.
#[derive(Debug)]
pub struct Table {
    targets: &'static [Target],
    rows_with_target: usize,
    missed: usize,
    deepest: u32,
}

impl Table {
    /// Most bytes of stack that an operation may take.
    pub const STACK_LIMIT: u32 = 2048;

    /// Prints the heading.
    pub fn new(targets: &'static [Target]) -> Self {
        hprintln!(
            "{:46} | {:21} | {:>9} | {:>9} | {:>5} | target",
            "operation",
            "setting",
            "mean",
            "max",
            "stack"
        );
        Self {
            targets,
            rows_with_target: 0,
            missed: 0,
            deepest: 0,
        }
    }

    /// Prints a row.
    pub fn row(&mut self, setting: &str, operation: &str, stat: impl Into<Stat>) {
        let stat = stat.into();
        let (mean, max, stack) = (stat.mean(), stat.max(), stat.stack());
        let target = self
            .targets
            .iter()
            .find(|t| t.setting == setting && t.operation == operation);
        let verdict = match target {
            Some(t) if mean <= t.limit => "reached",
            Some(_) => "missed",
            None => "",
        };
        self.deepest = self.deepest.max(stack);
        match target {
            Some(t) => {
                self.rows_with_target += 1;
                self.missed += usize::from(mean > t.limit);
                hprintln!(
                    "{:46} | {:21} | {:9} | {:9} | {:5} | {:7} {}",
                    operation,
                    setting,
                    mean,
                    max,
                    stack,
                    t.limit,
                    verdict
                );
            }
            None => hprintln!(
                "{:46} | {:21} | {:9} | {:9} | {:5} |",
                operation,
                setting,
                mean,
                max,
                stack
            ),
        }
    }

    /// Prints the sums; `false` if an operation took too much stack or a target has no row.
    pub fn finish(self) -> bool {
        let targets = self.targets.len();
        hprintln!("targets reached: {} of {}", targets - self.missed, targets);
        hprintln!("deepest stack: {} B of {} B", self.deepest, Self::STACK_LIMIT);
        if self.rows_with_target != targets {
            hprintln!(
                "meter: {} targets have a row, {} exist",
                self.rows_with_target,
                targets
            );
            return false;
        }
        if self.deepest > Self::STACK_LIMIT {
            hprintln!("meter: an operation takes more stack than that");
            return false;
        }
        true
    }
}
