use super::{Lattice, Masses};

/// A pose in the plane, f64: x, y in metres, heading in radians.
type Pose = [f64; 3];

/// A point through a pose.
pub(super) fn transform([px, py, theta]: Pose, [x, y]: [f64; 2]) -> [f64; 2] {
    let (s, c) = libm::sincos(theta);
    [px + c * x - s * y, py + s * x + c * y]
}

/// A point of the parent frame seen from a pose.
pub(super) fn seen_from([px, py, theta]: Pose, [x, y]: [f64; 2]) -> [f64; 2] {
    let (s, c) = libm::sincos(theta);
    let (dx, dy) = (x - px, y - py);
    [c * dx + s * dy, c * dy - s * dx]
}

/// An evidence grid at a point of its frame (metres): bilinear between the four cells around it, vacuous outside.
pub fn sample(grid: &[Masses], lattice: &Lattice, point: [f64; 2]) -> Masses {
    let local = seen_from(lattice.pose.map(f64::from), point);
    let g = local.map(|l| {
        let g = l / f64::from(lattice.cell_size) - 0.5;
        let whole = libm::rint(g);
        if (g - whole).abs() < 1e-4 { whole } else { g }
    });
    let [row, col] = g.map(libm::floor);
    let [a, b] = [g[0] - row, g[1] - col];
    let cell = |down: f64, right: f64| {
        let index = lattice.index((row + down) as i64, (col + right) as i64);
        index.map_or(Masses::VACUOUS, |i| grid[i])
    };
    let corners = [
        (cell(0.0, 0.0), (1.0 - a) * (1.0 - b)),
        (cell(0.0, 1.0), (1.0 - a) * b),
        (cell(1.0, 0.0), a * (1.0 - b)),
        (cell(1.0, 1.0), a * b),
    ];
    let mean = |mass: fn(&Masses) -> f64| corners.iter().map(|(m, w)| w * mass(m)).sum();
    Masses::new(mean(|m| m.free), mean(|m| m.occupied), mean(|m| m.uncertain))
}

/// An evidence grid at the cell centres of another lattice.
pub fn resample(grid: &[Masses], src: &Lattice, dst: &Lattice, src_from_dst: Pose) -> Vec<Masses> {
    let at = |(row, col): (u32, u32)| {
        let center = [row, col].map(|k| (f64::from(k) + 0.5) * f64::from(dst.cell_size));
        let point = transform(src_from_dst, transform(dst.pose.map(f64::from), center));
        sample(grid, src, point)
    };
    dst.cells().map(at).collect()
}
