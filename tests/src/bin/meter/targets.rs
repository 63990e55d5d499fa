use horus_tests::meter::Target;

/// Full recomputes: 120 instructions per cell.
const FULL: u32 = 120 * 200 * 200;

/// What the operations should take; the table says which do.
pub const TARGETS: [Target; 8] = [
    target("compute_costs", FULL),
    target("update_costs, one cell in", 2_600),
    target("update_costs, one cell out", 40_000),
    target("update_costs, 360-beam scan", 900_000),
    target("integrate_scan, set", 320_000),
    target("recenter, one cell in x", 320_000),
    target("recenter, one cell in y", 120_000),
    target("tick: recenter, integrate_scan, update_costs", 1_600_000),
];

const fn target(operation: &'static str, limit: u32) -> Target {
    Target {
        setting: crate::case::R11.setting,
        operation,
        limit,
    }
}
