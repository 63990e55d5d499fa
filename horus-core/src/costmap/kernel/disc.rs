/// The offsets at which a source still costs something: `dx^2 + dy^2 <= reach`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Disc {
    /// Largest squared distance with a cost above zero.
    pub reach: u32,
    /// Largest offset along an axis: the integer root of `reach`.
    pub radius: u32,
}

impl Disc {
    pub(crate) fn new(reach: u32) -> Self {
        Self {
            reach,
            radius: reach.isqrt(),
        }
    }

    /// For dy = 0, 1, ..., `radius`: the largest dx still in the disc.
    pub(crate) fn halves(self) -> impl Iterator<Item = u32> {
        let mut half = self.radius;
        (0..=self.radius).map(move |dy| {
            while half * half + dy * dy > self.reach {
                half -= 1; // ends at 0: dy <= radius
            }
            half
        })
    }

    /// Cells of the disc's bounding box, per axis.
    pub(crate) fn side(self) -> u32 {
        2 * self.radius + 1
    }
}
