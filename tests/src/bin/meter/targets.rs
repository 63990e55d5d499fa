use horus_tests::meter::Target;

const CELLS: u32 = 200 * 200;
/// Instructions of a full recompute and of a scan's update.
const FULL_AND_SCAN: (u32, u32) = if cfg!(feature = "dsp") {
    (55 * CELLS, 600_000)
} else {
    (120 * CELLS, 900_000)
};

/// What the operations should take; the table says which do.
pub const TARGETS: [Target; 11] = [
    target("compute_costs", FULL_AND_SCAN.0),
    target("update_costs, one cell in", 2_600),
    target("update_costs, one cell out", 40_000),
    target("update_costs, 360-beam scan", FULL_AND_SCAN.1),
    target("integrate_scan, set", 320_000),
    target("recenter, one cell in x", 320_000),
    target("recenter, one cell in y", 120_000),
    target("tick: recenter, integrate_scan, update_costs", 1_600_000),
    Target {
        setting: "128x128 u16",
        operation: "distances",
        limit: 95 * 128 * 128,
    },
    local("update, one cell in x"),
    local("update, one cell in y"),
];

/// A 360-beam update of the local map with a move of one cell.
const fn local(operation: &'static str) -> Target {
    Target {
        setting: crate::local::SETTING,
        operation,
        limit: 450_000,
    }
}

const fn target(operation: &'static str, limit: u32) -> Target {
    Target {
        setting: crate::case::R11.setting,
        operation,
        limit,
    }
}
