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
            radius: root(reach),
        }
    }

    /// For dy = 0, 1, ..., `radius`: the largest dx still in the disc.
    pub(crate) fn halves(self) -> impl Iterator<Item = u32> {
        (0..=self.radius).scan(self.radius, move |half, dy| {
            *half = self.half(dy * dy, *half);
            Some(*half)
        })
    }

    /// The largest dx still in the disc, given dy^2, which must not exceed the reach; sought from
    /// `near` on.
    pub(crate) fn half(self, across: u32, near: u32) -> u32 {
        let mut half = near;
        while half * half + across > self.reach {
            half -= 1; // ends at 0
        }
        while (half + 1).pow(2) + across <= self.reach {
            half += 1;
        }
        half
    }

    /// Cells of the disc's bounding box, per axis.
    pub(crate) fn side(self) -> u32 {
        2 * self.radius + 1
    }
}

/// The integer root, bit by bit: once per change of parameters, without the standard one's table.
fn root(value: u32) -> u32 {
    (0..16).rev().fold(0, |root, bit| {
        let next: u32 = root | 1 << bit;
        if next * next <= value { next } else { root }
    })
}

#[cfg(test)]
mod tests {
    use super::root;

    #[test]
    fn roots_equal_the_standard_ones() {
        for near in [0u32, 1, 15, 16, 65, 16_129, 65_025, 1 << 31, u32::MAX] {
            for value in near.saturating_sub(3)..=near.saturating_add(3) {
                assert_eq!(root(value), value.isqrt(), "{value}");
            }
        }
    }
}
