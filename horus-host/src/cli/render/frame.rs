use horus_host::picture::{Picture, PictureError};

use super::{GridPicture, Overlay};

/// Frames are enlarged up to this many pixels on their longer side.
const SIZE: u32 = 800;

/// How frames are painted.
pub struct FrameOptions {
    /// Pixels per cell.
    pub scale: Option<u32>,
    pub lethal_cost: u8,
}

/// A grid with overlay and scale bar. With `other`: beside it the other log's grid of the same time,
/// if there is one, and where the two differ, if they have one size.
pub fn paint(
    grid: &GridPicture,
    other: Option<Option<&GridPicture>>,
    overlay: Option<&Overlay>,
    options: &FrameOptions,
) -> Result<Picture, PictureError> {
    let longer = grid.width.max(grid.height).max(1);
    let scale = options.scale.unwrap_or((SIZE / longer).clamp(1, 16));
    let one = |grid: &GridPicture| -> Result<Picture, PictureError> {
        let mut picture = grid.paint(scale)?;
        if let Some(overlay) = overlay {
            overlay.draw(grid, &mut picture);
        }
        Ok(picture)
    };
    let mut pictures = vec![one(grid)?];
    if let Some(Some(other)) = other {
        pictures.push(one(other)?);
        match grid.paint_difference(other, scale) {
            Ok(difference) => pictures.push(difference),
            Err(PictureError::ShapesDiffer { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    Picture::beside(&pictures)?.with_scale_bar(grid.resolution / f64::from(scale))
}
