//! What the two fixed-point cells share: a cell is two unsigned integers f and o with f + o <= Q,
//! a full scale Q of all ones, and u = Q - f - o.

/// Declares a fixed-point mass cell.
macro_rules! integer_cell {
    ($(#[$doc:meta])* $name:ident, $int:ty, $bits:literal, $supports:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[repr(C)]
        pub struct $name {
            free: $int,
            occupied: $int,
        }

        impl $name {
            /// The whole mass, 1, in steps.
            pub const FULL: $int = <$int>::MAX;

            /// A cell of so many steps free and occupied; `None` if they exceed the whole.
            pub const fn from_steps(free: $int, occupied: $int) -> Option<Self> {
                if free <= Self::FULL - occupied {
                    Some(Self { free, occupied })
                } else {
                    None
                }
            }

            /// The mass free in steps.
            pub const fn free_steps(self) -> $int {
                self.free
            }

            /// The mass occupied in steps.
            pub const fn occupied_steps(self) -> $int {
                self.occupied
            }

            /// The uncertain mass in steps: what the other two leave, exactly.
            pub const fn uncertain_steps(self) -> $int {
                Self::FULL - self.free - self.occupied
            }
        }

        impl IntegerCell for $name {
            const BITS: u32 = $bits;

            #[inline(always)]
            fn parts(self) -> (u32, u32) {
                (u32::from(self.free), u32::from(self.occupied))
            }

            #[inline(always)]
            fn of(free: u32, occupied: u32) -> Self {
                Self {
                    free: free as $int,
                    occupied: occupied as $int,
                }
            }
        }

        impl MassCell for $name {
            const VACUOUS: Self = Self { free: 0, occupied: 0 };

            fn from_masses(masses: Masses) -> Self {
                let full = f64::from(Self::FULL);
                let steps = |mass: f32| (f64::from(mass) * full + 0.5) as u32;
                let occupied = steps(masses.occupied());
                let free = steps(masses.free()).min(u32::from(Self::FULL) - occupied);
                Self::of(free, occupied)
            }

            fn masses(self) -> Masses {
                let mass = |steps: $int| f32::from(steps) / f32::from(Self::FULL);
                Masses::of_cell(mass(self.free), mass(self.occupied))
            }

            fn supports(rule: FusionRule) -> Result<(), Error> {
                #[allow(clippy::redundant_closure_call)]
                ($supports)(rule)
            }
        }

        impl Kernel for $name {
            const CONFLICT_UNIT: f32 = integer::conflict_unit::<Self>();
            type Blend = integer::Blend<Self>;

            #[inline(never)]
            fn fuse(rule: &PreparedRule, state: &mut [Self], sensor: &[Self]) -> Tally {
                integer::fuse(rule, state, sensor)
            }

            fn interpolate(corners: [Self; 4], weights: [u32; 4]) -> Self {
                integer::interpolate(corners, weights)
            }

            fn blend(free: Masses, occupied: Masses) -> Self::Blend {
                integer::Blend::new(free, occupied)
            }

            #[inline]
            fn mix(blend: &Self::Blend, free: u32, occupied: u32) -> Self {
                blend.mix(free, occupied)
            }

            fn steps(mass: f32) -> u32 {
                (f64::from(mass) * f64::from(Self::FULL) + 0.5) as u32
            }

            #[inline]
            fn in_steps(self) -> (u32, u32) {
                self.parts()
            }
        }
    };
}
pub(super) use integer_cell;
