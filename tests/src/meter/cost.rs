/// What one call took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Executed instructions.
    pub instructions: u32,
    /// Bytes of stack, the frames of everything called included.
    pub stack: u32,
}
