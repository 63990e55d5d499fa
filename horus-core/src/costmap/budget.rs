/// The cell visits that one update may still make.
#[derive(Debug)]
pub(crate) struct Budget {
    left: Option<u32>,
}

impl Budget {
    pub(crate) fn unlimited() -> Self {
        Self { left: None }
    }

    pub(crate) fn new(visits: u32) -> Self {
        Self { left: Some(visits) }
    }

    pub(crate) fn is_limited(&self) -> bool {
        self.left.is_some()
    }

    /// Pays for a step of at most `visits`; false if the budget does not allow it.
    #[inline]
    pub(crate) fn take(&mut self, visits: u32) -> bool {
        let Some(left) = &mut self.left else {
            return true;
        };
        match left.checked_sub(visits) {
            Some(rest) => {
                *left = rest;
                true
            }
            None => false,
        }
    }
}
