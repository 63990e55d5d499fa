use super::frame::GridFrame;
use super::inflation::NO_INFORMATION;
use super::{CostMap, Pose2D, ReferenceError, walk_inside};

/// What lies under a robot's footprint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FootprintCost {
    /// Highest cost under the footprint apart from unknown; `None` if no cell under it is known.
    pub cost: Option<u8>,
    /// Whether a cell under the footprint is unknown.
    pub touches_unknown: bool,
    /// Whether a vertex of the footprint lies outside the map.
    pub leaves_map: bool,
}

/// A footprint's corner: continuous cell coordinates, and the cell it counts as being in.
struct Vertex {
    at: [f32; 2],
    cell: [i32; 2],
}

impl CostMap {
    /// The highest cost under a polygon with vertices in metres around the robot, standing at `pose` in the world.
    ///
    /// A cell is under the polygon if its centre is inside by the even-odd rule, or if the integer walk between the
    /// cells of two consecutive vertices (the last one joins the first) passes it. Cells outside the map do not count.
    ///
    /// # Errors
    /// Fewer than 3 vertices, a pose or vertex that is not finite, or a vertex more than 2^30 cells away.
    pub fn footprint_cost(
        &self,
        pose: Pose2D,
        polygon: &[(f32, f32)],
    ) -> Result<FootprintCost, ReferenceError> {
        let grid = &self.occupancy_grid;
        let vertices = vertices(&grid.frame(), pose, polygon)?;
        let edges: Vec<_> = vertices.iter().zip(vertices.iter().cycle().skip(1)).collect();

        let mut on_edge = vec![false; grid.data.len()];
        for (a, b) in &edges {
            for (_, [gx, gy]) in walk_inside(a.cell, b.cell, grid.width, grid.height) {
                if let Some(index) = grid.index(gx, gy) {
                    on_edge[index] = true;
                }
            }
        }

        let mut result = FootprintCost {
            cost: None,
            touches_unknown: false,
            leaves_map: vertices.iter().any(|v| {
                let [x, y] = v.cell.map(u32::try_from);
                !(x.is_ok_and(|x| x < grid.width) && y.is_ok_and(|y| y < grid.height))
            }),
        };
        for gy in 0..grid.height {
            for gx in 0..grid.width {
                let is_edge = grid.index(gx, gy).is_some_and(|i| on_edge[i]);
                // A centre inside lies between the vertices' cells: where f32 no longer resolves cells, what
                // `covers` says elsewhere is noise.
                let between = is_between(&vertices, [gx, gy]);
                if is_edge || (between && covers(&edges, gx as f32 + 0.5, gy as f32 + 0.5)) {
                    match self.cost_of_cell(gx, gy) {
                        Some(NO_INFORMATION) => result.touches_unknown = true,
                        cost => result.cost = result.cost.max(cost),
                    }
                }
            }
        }
        Ok(result)
    }
}

/// The polygon's vertices on the map, computed in f32.
fn vertices(frame: &GridFrame, pose: Pose2D, polygon: &[(f32, f32)]) -> Result<Vec<Vertex>, ReferenceError> {
    let [px, py, yaw] = pose.to_f32().ok_or(ReferenceError::Pose("footprint's pose"))?;
    if polygon.len() < 3 {
        return Err(ReferenceError::PolygonSize(polygon.len()));
    }
    let (c, s) = (libm::cosf(yaw), libm::sinf(yaw));
    let vertex = |(i, &(vx, vy)): (usize, &(f32, f32))| {
        if !(vx.is_finite() && vy.is_finite()) {
            return Err(ReferenceError::Vertex(i));
        }
        let world = [px + (c * vx - s * vy), py + (s * vx + c * vy)];
        Ok(Vertex {
            at: frame.cell_coordinates(world),
            cell: frame.cell(world).ok_or(ReferenceError::VertexCell(i))?,
        })
    };
    polygon.iter().enumerate().map(vertex).collect()
}

/// Whether a cell lies in the bounding box of the vertices' cells.
fn is_between(vertices: &[Vertex], cell: [u32; 2]) -> bool {
    (0..2).all(|axis| {
        let at = i64::from(cell[axis]);
        vertices.iter().any(|v| i64::from(v.cell[axis]) <= at)
            && vertices.iter().any(|v| i64::from(v.cell[axis]) >= at)
    })
}

/// Even-odd rule: whether a ray from (`x`, `y`) towards +x crosses an odd number of edges.
fn covers(edges: &[(&Vertex, &Vertex)], x: f32, y: f32) -> bool {
    let crosses = |(a, b): &&(&Vertex, &Vertex)| {
        let ([ax, ay], [bx, by]) = (a.at, b.at);
        (ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax
    };
    edges.iter().filter(crosses).count() % 2 == 1
}
