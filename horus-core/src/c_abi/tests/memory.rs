use core::ffi::c_void;
use core::ptr;
use std::alloc::{Layout, alloc_zeroed, dealloc};

use super::*;

/// A block from the heap that holds one object and ends where it ends. Everything reaches it through
/// the one pointer that the allocator gave, as in C.
pub struct Memory {
    start: *mut u8,
    layout: Layout,
}

impl Memory {
    pub fn new(bytes: usize) -> Self {
        let layout = Layout::from_size_align(bytes, HORUS_ALIGN).unwrap();
        // SAFETY: the length is not zero: an object has a header.
        let start = unsafe { alloc_zeroed(layout) };
        assert!(!start.is_null());
        Self { start, layout }
    }

    pub fn pointer(&self) -> *mut c_void {
        self.start.cast()
    }

    pub fn length(&self) -> usize {
        self.layout.size()
    }

    pub fn grid(config: &horus_grid_config) -> (Self, *mut horus_grid) {
        let (mut bytes, mut grid) = (0, ptr::null_mut());
        // SAFETY: the pointers are good.
        assert_eq!(unsafe { horus_grid_bytes(config, &mut bytes) }, Status::Ok);
        let memory = Self::new(bytes);
        // SAFETY: the pointers are good.
        let status = unsafe { horus_grid_init(memory.pointer(), bytes, config, &mut grid) };
        assert_eq!(status, Status::Ok);
        (memory, grid)
    }

    pub fn map(config: &horus_cost_map_config) -> (Self, *mut horus_cost_map) {
        let (mut bytes, mut map) = (0, ptr::null_mut());
        // SAFETY: the pointers are good.
        assert_eq!(unsafe { horus_cost_map_bytes(config, &mut bytes) }, Status::Ok);
        let memory = Self::new(bytes);
        // SAFETY: the pointers are good.
        let status = unsafe { horus_cost_map_init(memory.pointer(), bytes, config, &mut map) };
        assert_eq!(status, Status::Ok);
        (memory, map)
    }

    pub fn workspace(beams: u32, accumulate_cells: u32) -> (Self, *mut horus_scan_workspace) {
        let (mut bytes, mut workspace) = (0, ptr::null_mut());
        let config = horus_scan_workspace_config {
            beams,
            accumulate_cells,
        };
        // SAFETY: the pointers are good.
        let status = unsafe { horus_scan_workspace_bytes(&config, &mut bytes) };
        assert_eq!(status, Status::Ok);
        let memory = Self::new(bytes);
        // SAFETY: the pointers are good.
        let status = unsafe { horus_scan_workspace_init(memory.pointer(), bytes, &config, &mut workspace) };
        assert_eq!(status, Status::Ok);
        (memory, workspace)
    }
}

impl Drop for Memory {
    fn drop(&mut self) {
        // SAFETY: it came from `new`.
        unsafe { dealloc(self.start, self.layout) };
    }
}
