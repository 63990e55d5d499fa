use horus_core::prelude::CellRect;

/// What is known since every cost was last exact: what the promises about unfinished updates are
/// checked against.
pub(super) struct Promises {
    width: u32,
    /// Costs read when they were last exact.
    exact: Vec<u8>,
    /// Cells whose value changed since, in the map's present indices.
    touched: Vec<bool>,
    /// Budgeted calls since the last change.
    pub calls: u32,
    /// The window has moved since.
    pub shifted: bool,
    /// Everything returned since.
    union: Option<CellRect>,
}

impl Promises {
    pub fn new(exact: Vec<u8>, width: u32) -> Self {
        Self {
            width,
            touched: vec![false; exact.len()],
            exact,
            calls: 0,
            shifted: false,
            union: None,
        }
    }

    /// Cells got other values.
    pub fn changed(&mut self, before: &[i8], after: &[i8]) {
        self.calls = 0;
        for ((touched, a), b) in self.touched.iter_mut().zip(before).zip(after) {
            *touched |= a != b;
        }
    }

    /// The window moved.
    pub fn shift(&mut self, [dx, dy]: [i32; 2], height: u32) {
        if dx == 0 && dy == 0 {
            return;
        }
        self.calls = 0;
        self.shifted = true;
        self.touched = shifted(&self.touched, (self.width, height), [dx, dy], false);
    }

    /// An update returned this.
    pub fn updated(&mut self, rect: Option<CellRect>) {
        self.calls += 1;
        self.union = match (self.union, rect) {
            (Some(a), Some(b)) => Some(a.union(&b)),
            (a, b) => a.or(b),
        };
    }

    /// What all updates since the costs were exact returned, and those exact costs.
    pub fn since_exact(&self) -> (Option<CellRect>, &[u8]) {
        (self.union, &self.exact)
    }

    /// Whether sources that appeared must be in by now: every call does a step of at most `least`
    /// visits, looking at a changed word takes three.
    pub fn additions_are_in(&self, is_source: impl Fn(usize) -> bool, least: u32) -> bool {
        let touched = self.touched.iter().filter(|t| **t).count() as u32;
        let appeared = (0..self.touched.len()).filter(|i| self.touched[*i] && is_source(*i));
        let appeared = appeared.count() as u32;
        appeared == 0 || self.calls >= appeared + (3 * touched).div_ceil(least) + 2
    }
}

/// Row-major cells after the window moved.
pub(super) fn shifted<T: Copy>(cells: &[T], (w, h): (u32, u32), [dx, dy]: [i32; 2], fill: T) -> Vec<T> {
    let at = |gx: u32, gy: u32| {
        let x = u32::try_from(i64::from(gx) + i64::from(dx))
            .ok()
            .filter(|x| *x < w)?;
        let y = u32::try_from(i64::from(gy) + i64::from(dy))
            .ok()
            .filter(|y| *y < h)?;
        cells.get(y as usize * w as usize + x as usize).copied()
    };
    (0..h)
        .flat_map(|gy| (0..w).map(move |gx| (gx, gy)))
        .map(|(gx, gy)| at(gx, gy).unwrap_or(fill))
        .collect()
}
