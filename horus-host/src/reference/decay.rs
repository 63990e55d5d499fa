/// How cost falls with the distance from an obstacle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Decay {
    /// HORUS: `(lethal_cost - 1) * (1 - d / inflation_radius) ^ cost_scaling_factor` up to the inflation radius.
    #[default]
    Polynomial,
    /// nav2: 253 up to the inscribed radius, then `252 * exp(-cost_scaling_factor * (d - inscribed_radius))` up to the
    /// inflation radius rounded up to whole cells.
    Exponential,
}
