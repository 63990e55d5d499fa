/*
 * Occupancy grids, incremental cost maps, exact distances and rays for microcontrollers.
 *
 * SI units, REP 103 axes, REP 105 frames, REP 117 ranges; angles in radians, counter-clockwise.
 * Costs are bytes: 0 free .. 254 lethal, 255 unknown.
 *
 * Memory. Nothing is allocated. An object (horus_grid, horus_scan_workspace, horus_cost_map,
 * horus_distance_map, horus_local_map, horus_local_mapping) lies with all its buffers in one block of
 * your memory, aligned to HORUS_ALIGN: horus_..._bytes() tells how long, horus_..._init() makes it
 * there, and its handle is the block's address. For static
 * memory there are macros:
 *
 *     static HORUS_MEMORY(memory, HORUS_COST_MAP_BYTES(200, 200, 1, 0));
 *
 * While you use an object, leave its block alone: neither write, move nor free it, and read it only
 * through the pointers that horus_grid_data() and horus_cost_map_costs() give. To end an object,
 * use its memory for something else.
 *
 * Status. Every call that can fail returns a horus_status. Unless it is HORUS_STATUS_OK, nothing has
 * changed and nothing was written; horus_status_text() says why in words. These are refused, not
 * undefined: NULL, misaligned and overlapping pointers, memory that is too short, handles of another
 * kind, objects that were copied or never made, numbers that are not what an enumeration names. What
 * a call cannot see is yours: pointers must reach as many elements as their type and length say,
 * memory must have been written before it is read (a handle's, too), and one object serves one call
 * at a time, interrupts included. Arrays of length 0 may be NULL.
 *
 * Linking. Firmware without other Rust code builds the library with the feature panic-handler and
 * provides `void horus_panic(void)`, which must not return. It is called if the library finds a
 * defect of its own; no input is known to bring that about.
 *
 * Written by cbindgen from horus-core/src/c_abi. Do not edit.
 */


#ifndef HORUS_H
#define HORUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if UINTPTR_MAX > 0xFFFFFFFFu
#define HORUS_POINTERS_64
#else
#define HORUS_POINTERS_32
#endif

/// `bytes`, rounded up to a multiple of HORUS_ALIGN.
#define HORUS_ROUND_UP(bytes) (((size_t)(bytes) + HORUS_ALIGN - 1) / HORUS_ALIGN * HORUS_ALIGN)

/// Declares an array of at least `bytes` bytes that is aligned to HORUS_ALIGN.
#define HORUS_MEMORY(name, bytes) uint64_t name[HORUS_ROUND_UP(bytes) / sizeof(uint64_t)]

/// At least horus_grid_bytes(), as a constant expression.
#define HORUS_GRID_BYTES(width, height) \
    HORUS_ROUND_UP(HORUS_GRID_FIXED_BYTES + (size_t)(width) * (size_t)(height))

/// At least horus_scan_workspace_bytes(), as a constant expression.
#define HORUS_SCAN_WORKSPACE_BYTES(beams, accumulate_cells) \
    HORUS_ROUND_UP(HORUS_SCAN_WORKSPACE_FIXED_BYTES + 12 * (size_t)(beams) + \
                   4 * (((size_t)(accumulate_cells) + 31) / 32))

/// Words of one bit per cell: every row starts a word.
#define HORUS_BITMAP_WORDS(width, height) (((size_t)(width) + 31) / 32 * (size_t)(height))

/// Words of source and change bits.
#define HORUS_COST_MAP_BIT_WORDS(width, height) \
    (2 * HORUS_BITMAP_WORDS(width, height) + (HORUS_BITMAP_WORDS(width, height) + 31) / 32 + \
     2 * HORUS_BITMAP_WORDS(width, 1))

/// At least horus_cost_map_bytes(), as a constant expression.
#define HORUS_COST_MAP_BYTES(width, height, field_bytes, keep_costs) \
    HORUS_ROUND_UP( \
        ((field_bytes) == 1 ? HORUS_COST_MAP_1_FIXED_BYTES : HORUS_COST_MAP_2_FIXED_BYTES) + \
        4 * HORUS_COST_MAP_BIT_WORDS(width, height) + \
        (size_t)(width) * (size_t)(height) * (1 + (size_t)(field_bytes) + ((keep_costs) ? 1 : 0)))

/// At least horus_distance_map_bytes(), as a constant expression.
#define HORUS_DISTANCE_MAP_BYTES(width, height, cell_bytes, is_signed) \
    HORUS_ROUND_UP(HORUS_DISTANCE_MAP_FIXED_BYTES + \
                   12 * (size_t)(width) * ((is_signed) ? 2 : 1) + \
                   (size_t)(width) * (size_t)(height) * (size_t)(cell_bytes))

/// At least horus_local_map_bytes(), as a constant expression.
#define HORUS_LOCAL_MAP_BYTES(width, height, lidars, beams, publishes) \
    HORUS_ROUND_UP(HORUS_LOCAL_MAP_FIXED_BYTES + (size_t)(lidars) * (16 * (size_t)(beams) + 24) + \
                   (size_t)(width) * (size_t)(height) * ((publishes) ? 2 : 1))

/// Bytes of two bits per cell of a sensor's lattice and its border.
#define HORUS_CLASS_BYTES(rows, cols) ((((size_t)(rows) + 5) / 4 + 1) * ((size_t)(cols) + 2))

/// At least horus_local_mapping_bytes(), as a constant expression: rows and columns of the fused map,
/// beams of a scan, rows and columns of the largest sensor lattice.
#define HORUS_LOCAL_MAPPING_BYTES(rows, cols, beams, sensor_rows, sensor_cols) \
    HORUS_ROUND_UP(HORUS_LOCAL_MAPPING_FIXED_BYTES + 6 * (size_t)(rows) * (size_t)(cols) + \
                   4 * HORUS_BITMAP_WORDS(rows, cols) + 8 * (size_t)(beams) + 12 * (size_t)(rows) + \
                   HORUS_CLASS_BYTES(sensor_rows, sensor_cols))


/// Version of the binary interface: compare it with horus_abi_version() to see that header and
/// library belong together.
#define HORUS_ABI_VERSION 1

/// Alignment, in bytes, of the memory given to every init.
#define HORUS_ALIGN 8

#if defined(HORUS_POINTERS_64)
/// Bytes of a grid besides its cells.
#define HORUS_GRID_FIXED_BYTES 192
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a grid besides its cells.
#define HORUS_GRID_FIXED_BYTES 176
#endif

#if defined(HORUS_POINTERS_64)
/// Bytes of a scan workspace besides its beams and cells.
#define HORUS_SCAN_WORKSPACE_FIXED_BYTES 80
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a scan workspace besides its beams and cells.
#define HORUS_SCAN_WORKSPACE_FIXED_BYTES 48
#endif

#if defined(HORUS_POINTERS_64)
/// Bytes of a cost map with a one-byte field besides its cells.
#define HORUS_COST_MAP_1_FIXED_BYTES 4032
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a cost map with a one-byte field besides its cells.
#define HORUS_COST_MAP_1_FIXED_BYTES 3936
#endif

#if defined(HORUS_POINTERS_64)
/// Bytes of a cost map with a two-byte field besides its cells.
#define HORUS_COST_MAP_2_FIXED_BYTES 11976
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a cost map with a two-byte field besides its cells.
#define HORUS_COST_MAP_2_FIXED_BYTES 9832
#endif

#if defined(HORUS_POINTERS_64)
/// Bytes of a distance map besides its cells and columns.
#define HORUS_DISTANCE_MAP_FIXED_BYTES 176
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a distance map besides its cells and columns.
#define HORUS_DISTANCE_MAP_FIXED_BYTES 128
#endif

#if defined(HORUS_POINTERS_64)
/// Bytes of a local map besides its cells and its lidars' beams.
#define HORUS_LOCAL_MAP_FIXED_BYTES 3328
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a local map besides its cells and its lidars' beams.
#define HORUS_LOCAL_MAP_FIXED_BYTES 2816
#endif

#if defined(HORUS_POINTERS_64)
/// Bytes of a local mapping besides its cells, beams and columns.
#define HORUS_LOCAL_MAPPING_FIXED_BYTES 1280
#endif

#if defined(HORUS_POINTERS_32)
/// Bytes of a local mapping besides its cells, beams and columns.
#define HORUS_LOCAL_MAPPING_FIXED_BYTES 1088
#endif

/// Most lidars of a local map.
#define HORUS_LOCAL_MAP_LIDARS 4

/// Bytes of a name in a local map's configuration; a shorter one ends with a zero.
#define HORUS_LOCAL_MAP_NAME 32

/// Most sensors of a local mapping.
#define HORUS_LOCAL_MAPPING_SENSORS 4

/// Most painted rectangles of a local mapping.
#define HORUS_LOCAL_MAPPING_INPAINTS 4

/// Whether a call did what it was asked to. Anything but HORUS_STATUS_OK: nothing has changed and
/// nothing was written, unless the function says otherwise.
enum horus_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// Done.
    HORUS_STATUS_OK = 0,
    /// A pointer is NULL.
    HORUS_STATUS_NULL_POINTER = 1,
    /// A pointer is not aligned for what it points to; memory for an object: to HORUS_ALIGN.
    HORUS_STATUS_MISALIGNED = 2,
    /// Two of the call's pointers reach the same memory, or one reaches into an object's memory.
    HORUS_STATUS_OVERLAP = 3,
    /// Not an object of this kind: never initialised, of another kind, moved, or overwritten.
    HORUS_STATUS_INVALID_HANDLE = 4,
    /// A size or a length is beyond the address space, or a grid would have 2^32 - 1 cells or more.
    HORUS_STATUS_SIZE_OVERFLOW = 5,
    /// The memory or a buffer is too short; for an object, its `bytes` function tells the length.
    HORUS_STATUS_BUFFER_TOO_SMALL = 6,
    /// An array has not exactly one element per cell.
    HORUS_STATUS_LENGTH_MISMATCH = 7,
    /// The cell or the point lies outside the grid, or the point is not finite.
    HORUS_STATUS_OUTSIDE = 8,
    /// A number is none of the named constants (decay, kind of scan model, bytes per field cell).
    HORUS_STATUS_INVALID_CHOICE = 9,
    /// A text is not UTF-8.
    HORUS_STATUS_INVALID_TEXT = 10,
    /// The cost map keeps no cost bytes.
    HORUS_STATUS_NOT_KEPT = 11,
    /// The resolution is not finite or not above zero.
    HORUS_STATUS_INVALID_RESOLUTION = 12,
    /// A coordinate of a pose is NaN or infinite.
    HORUS_STATUS_NON_FINITE_POSE = 13,
    /// The window would move beyond 2^30 cells.
    HORUS_STATUS_OFFSET_OUT_OF_RANGE = 14,
    /// An angle of the scan is not finite, or a range limit is NaN.
    HORUS_STATUS_INVALID_SCAN = 15,
    /// The scan model needs hit >= 0, miss <= 0 and 0 <= min <= max <= 100.
    HORUS_STATUS_INVALID_MODEL = 16,
    /// The workspace has too few beams for the scan or, accumulating, too few cells for the grid.
    HORUS_STATUS_WORKSPACE_TOO_SMALL = 17,
    /// inflation_radius must be finite and not negative.
    HORUS_STATUS_INVALID_INFLATION_RADIUS = 18,
    /// cost_scaling_factor must be finite and not negative.
    HORUS_STATUS_INVALID_COST_SCALING_FACTOR = 19,
    /// lethal_cost must be 2 to 254.
    HORUS_STATUS_INVALID_LETHAL_COST = 20,
    /// lethal_threshold must be 1 to 100.
    HORUS_STATUS_INVALID_LETHAL_THRESHOLD = 21,
    /// inscribed_radius must be finite and not negative.
    HORUS_STATUS_INVALID_INSCRIBED_RADIUS = 22,
    /// Costs reach farther than the field can hold: 15 cells with one byte, 255 with two.
    HORUS_STATUS_RADIUS_TOO_LARGE = 23,
    /// The budget is below horus_cost_map_min_budget().
    HORUS_STATUS_BUDGET_TOO_SMALL = 24,
    /// A polygon needs three or more finite vertices within 2^30 cells.
    HORUS_STATUS_INVALID_POLYGON = 25,
    /// A name is longer than 32 bytes.
    HORUS_STATUS_NAME_TOO_LONG = 26,
    /// Two lidars of a local map have the same name.
    HORUS_STATUS_DUPLICATE_NAME = 27,
    /// A footprint's radius must be finite and not negative.
    HORUS_STATUS_INVALID_FOOTPRINT_RADIUS = 28,
    /// A lidar's angles must be finite, its longest range finite and not negative.
    HORUS_STATUS_INVALID_LIDAR = 29,
    /// A cost map cannot follow a local map of another size, resolution or first corner.
    HORUS_STATUS_GEOMETRY_MISMATCH = 30,
    /// Nothing of this name was written, or something else.
    HORUS_STATUS_NOT_FOUND = 31,
    /// Belief masses must be 0 to 1 and sum to at most 1.
    HORUS_STATUS_INVALID_MASSES = 32,
    /// A scan has no beams.
    HORUS_STATUS_EMPTY_SCAN = 33,
    /// There is no sensor of this index.
    HORUS_STATUS_UNKNOWN_SENSOR = 34,
    /// The sensor stands outside the map.
    HORUS_STATUS_SENSOR_OUTSIDE_MAP = 35,
    /// A threshold, floor, thickness, width, range, rectangle or distance of a local mapping is out of
    /// its range.
    HORUS_STATUS_INVALID_MAPPING_PARAMETER = 36,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_status horus_status;
#else
typedef int32_t horus_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// How inflated cost falls with the distance d (metres) to the nearest source.
enum horus_decay
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// HORUS: trunc((lethal_cost - 1) * (1 - d / R)^k) for d <= R.
    HORUS_DECAY_POLYNOMIAL = 0,
    /// nav2: 254 at d = 0, 253 up to the inscribed radius, then
    /// trunc(252 * exp(-k * (d - inscribed_radius))) within R rounded up to whole cells.
    HORUS_DECAY_EXPONENTIAL = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_decay horus_decay;
#else
typedef int32_t horus_decay;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// How a scan changes the cells it sees.
enum horus_scan_model_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// Cleared cells become 0, hit cells 100.
    HORUS_SCAN_MODEL_KIND_SET = 0,
    /// Hit cells take one step up, other cleared cells one step down; an unknown cell starts at 50.
    HORUS_SCAN_MODEL_KIND_ACCUMULATE = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_scan_model_kind horus_scan_model_kind;
#else
typedef int32_t horus_scan_model_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// Which cells a ray between two cells visits.
enum horus_walk_rule
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// One per step along the longer side; exactly between two cells, the one nearer to the start.
    HORUS_WALK_RULE_STANDARD = 0,
    /// Every cell that the line between the two centres touches.
    HORUS_WALK_RULE_SUPERCOVER = 1,
    /// As standard, but exactly between two cells the one farther from the start.
    HORUS_WALK_RULE_NAVGROUND = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_walk_rule horus_walk_rule;
#else
typedef int32_t horus_walk_rule;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// What a local map frees around the robot.
enum horus_footprint_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// A square of twice the radius, along the map's axes.
    HORUS_FOOTPRINT_KIND_RECTANGULAR = 0,
    /// A disc of the radius.
    HORUS_FOOTPRINT_KIND_CIRCULAR = 1,
    /// Nothing.
    HORUS_FOOTPRINT_KIND_NONE = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_footprint_kind horus_footprint_kind;
#else
typedef int32_t horus_footprint_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// How two pieces of evidence about a cell become one.
enum horus_fusion_operator
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// Proportional conflict redistribution; the default.
    HORUS_FUSION_OPERATOR_PCR6 = 0,
    /// Dempster's rule of combination.
    HORUS_FUSION_OPERATOR_DEMPSTER_SHAFER = 1,
    /// Josang's averaging belief fusion: cells that no beam covers forget what they knew.
    HORUS_FUSION_OPERATOR_JOSANG_AVERAGE = 2,
    /// Josang's cumulative belief fusion.
    HORUS_FUSION_OPERATOR_JOSANG_CUMULATIVE = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_fusion_operator horus_fusion_operator;
#else
typedef int32_t horus_fusion_operator;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// The frame that a painted rectangle lies in.
enum horus_inpaint_frame
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// It moves with the robot.
    HORUS_INPAINT_FRAME_ROBOT = 0,
    /// It stays where it is.
    HORUS_INPAINT_FRAME_WORLD = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_inpaint_frame horus_inpaint_frame;
#else
typedef int32_t horus_inpaint_frame;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// What a scan says about a cell.
enum horus_scan_class
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /// Nothing: no beam covers it, or it lies behind the hit.
    HORUS_SCAN_CLASS_VACUOUS = 0,
    /// Before the hit.
    HORUS_SCAN_CLASS_FREE = 1,
    /// At the hit.
    HORUS_SCAN_CLASS_OCCUPIED = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum horus_scan_class horus_scan_class;
#else
typedef int32_t horus_scan_class;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// An occupancy grid with inflated costs that follow its every change. Costs are bytes: 0 free ..
/// lethal_cost, 255 unknown. It lies in memory of its user.
typedef struct horus_cost_map horus_cost_map;

/// Exact distances from the cells of a grid to the nearest obstacle. It lies in memory of its user.
typedef struct horus_distance_map horus_distance_map;

/// A rolling grid of occupancy values: -1 unknown, 0 free .. 100 occupied, row by row from the
/// lowest y. It lies in memory of its user.
typedef struct horus_grid horus_grid;

/// A rolling map of what lidars see around a robot: one byte per cell, 0 occupied, 128 unknown, 255
/// free, row by row from the lowest y. It lies, with its sensing state, in memory of its user.
typedef struct horus_local_map horus_local_map;

/// The whole chain of local mapping: scans become evidence, are fused into a rolling map, which is
/// painted over, cut into free and occupied, and measured for distances. It lies in memory of its
/// user.
typedef struct horus_local_mapping horus_local_mapping;

/// What integrating scans of one lidar needs beside the grid: its beams' directions, computed again
/// only when the scan's angles change. Keep one per lidar.
typedef struct horus_scan_workspace horus_scan_workspace;

/// Position in metres and heading in radians, counter-clockwise, in the frame its user names.
///
/// Plain fields, so that an all-zero one is the identity and costs no flash image in a `static`.
typedef struct {
    /// Metres along the frame's x axis.
    float x;
    /// Metres along the frame's y axis.
    float y;
    /// Heading in radians, counter-clockwise from the x axis.
    float theta;
} horus_pose2d;

/// Size and place of a grid.
typedef struct {
    /// Columns.
    uint32_t width;
    /// Rows.
    uint32_t height;
    /// Metres per cell.
    float resolution;
    /// World pose of the corner (not the centre) of cell (0, 0).
    horus_pose2d origin;
} horus_grid_config;

/// Whole cells along the grid's axes.
typedef struct {
    /// Columns.
    int32_t dx;
    /// Rows.
    int32_t dy;
} horus_shift;

/// One revolution of a planar lidar: sensor_msgs/LaserScan's fields.
///
/// Beam i points to angle_min + i * angle_increment radians, counter-clockwise from the sensor's x
/// axis. Ranges and limits are metres and follow REP 117: +inf, and from range_max on, is a miss
/// at range_max; NaN, -inf and below range_min say nothing.
typedef struct {
    /// One range per beam.
    const float *ranges;
    /// Beams.
    size_t count;
    /// Angle of the first beam in radians.
    float angle_min;
    /// Angle between beams in radians; may be negative.
    float angle_increment;
    /// Ranges below this are too close to be measured.
    float range_min;
    /// Ranges from this on are misses.
    float range_max;
} horus_laser_scan;

/// How a scan changes cells, and the steps of HORUS_SCAN_MODEL_KIND_ACCUMULATE.
typedef struct {
    /// A horus_scan_model_kind.
    int32_t kind;
    /// Added to a hit cell, >= 0.
    int8_t hit;
    /// Added to a cleared cell, <= 0.
    int8_t miss;
    /// Lowest value that a step leaves, >= 0.
    int8_t min;
    /// Highest value that a step leaves, <= 100.
    int8_t max;
} horus_scan_model;

/// A half-open rectangle of cells: `x0 <= gx < x1`, `y0 <= gy < y1`, in grid indices.
typedef struct {
    /// First column.
    uint32_t x0;
    /// First row.
    uint32_t y0;
    /// One past the last column.
    uint32_t x1;
    /// One past the last row.
    uint32_t y1;
} horus_cell_rect;

/// What a scan did to a grid.
typedef struct {
    /// Smallest rectangle of the cells whose value differs from before; all zero if none does.
    horus_cell_rect changed;
    /// Beams that ended at an obstacle, inside the map or not.
    uint32_t hits;
    /// Beams that saw nothing up to range_max.
    uint32_t misses;
    /// Beams without a usable range, or that end more than 2^30 cells away.
    uint32_t ignored;
} horus_scan_report;

/// Size, resolution and place of a grid as it is now.
typedef struct {
    /// Columns.
    uint32_t width;
    /// Rows.
    uint32_t height;
    /// Metres per cell.
    float resolution;
    /// World pose of the corner of cell (0, 0); it moves with the window.
    horus_pose2d origin;
    /// Cells the window has moved since the grid was made.
    horus_shift offset;
} horus_map_info;

/// A cell of a grid: column and row, from the corner at the origin.
typedef struct {
    /// Column.
    uint32_t gx;
    /// Row; row 0 has the lowest y.
    uint32_t gy;
} horus_cell;

/// A point in metres, in the frame that its user names.
typedef struct {
    /// Metres along the frame's x axis.
    float x;
    /// Metres along the frame's y axis.
    float y;
} horus_point;

/// Sizes of a horus_scan_workspace.
typedef struct {
    /// Most beams a scan may have.
    uint32_t beams;
    /// width * height of the largest grid that scans accumulate in; 0 if they only set cells.
    uint32_t accumulate_cells;
} horus_scan_workspace_config;

/// Parameters of a cost map. Start from one of the presets.
///
/// The base cost of a cell with occupancy v: unknown 255; v >= lethal_threshold: lethal_cost; else
/// min(2 * v, lethal_cost - 1). Lethal cells are the sources of inflation.
typedef struct {
    /// R, metres, finite and >= 0.
    float inflation_radius;
    /// k, finite and >= 0: an exponent (polynomial) or 1/m (exponential).
    float cost_scaling_factor;
    /// Metres, finite and >= 0; exponential only.
    float inscribed_radius;
    /// A horus_decay.
    int32_t decay;
    /// Cost of lethal cells, 2 .. 254.
    uint8_t lethal_cost;
    /// Lowest occupancy that is lethal, 1 .. 100.
    int8_t lethal_threshold;
    /// Not 0: unknown cells are sources, too.
    uint8_t unknown_inflates;
    /// Not 0: unknown cells take any inflated cost above zero, not only 253 and 254; exponential only.
    uint8_t inflate_unknown;
} horus_cost_params;

/// Size, place, parameters and layout of a cost map.
typedef struct {
    /// The grid inside.
    horus_grid_config grid;
    /// How costs follow from cells.
    horus_cost_params params;
    /// Bytes per cell of the distance field: 1 for costs that reach up to 15 cells, 2 for up to 255.
    uint8_t field_bytes;
    /// Not 0: keep the costs of the last update as bytes, one per cell, for horus_cost_map_costs().
    uint8_t keep_costs;
} horus_cost_map_config;

/// What a budgeted update did.
typedef struct {
    /// Every cost that differs from before the call lies in here; all zero if none does.
    horus_cell_rect changed;
    /// Changed cells and edge blocks that still wait; 0: every cost is exact.
    uint32_t pending;
} horus_cost_update;

/// What lies under a polygon.
typedef struct {
    /// The highest known cost, 0 .. 254; -1 if no cell under the polygon is known.
    int32_t cost;
    /// A cell under the polygon is unknown.
    bool touches_unknown;
    /// Part of the polygon lies outside the map.
    bool leaves_map;
} horus_footprint_cost;

/// Room and layout of a distance map.
typedef struct {
    /// Columns that there is room for.
    uint32_t width;
    /// Rows that there is room for.
    uint32_t height;
    /// Bytes per cell, 2 or 4: squared distances up to 65535 or 4294967295, half of that if signed.
    uint8_t cell_bytes;
    /// Not 0: an obstacle holds minus the squared distance to the nearest cell that is none.
    uint8_t is_signed;
} horus_distance_map_config;

/// How distances are computed.
typedef struct {
    /// The cap in squared cells: what is farther away, or does not exist, reads as the cap. More
    /// than the map's cells hold: the most that they hold.
    uint32_t max_squared;
    /// Not 0: unknown cells are obstacles, too.
    uint8_t unknown_is_obstacle;
} horus_distance_options;

/// A ray through a grid.
typedef struct {
    /// Where it starts, world frame.
    horus_pose2d pose;
    /// Its direction, radians counter-clockwise from the pose's heading.
    float bearing;
    /// How far it goes, metres.
    float range;
    /// A horus_walk_rule.
    int32_t rule;
} horus_ray;

/// Size, sensors and outputs of a local map.
typedef struct {
    /// Columns.
    uint32_t width;
    /// Rows.
    uint32_t height;
    /// Metres per cell.
    float resolution;
    /// A horus_footprint_kind.
    int32_t footprint;
    /// Radius of the footprint in metres.
    float radius;
    /// Lidars, at most HORUS_LOCAL_MAP_LIDARS.
    uint32_t lidars;
    /// Most beams of a scan.
    uint32_t beams;
    /// Not 0: there is an odometry sensor.
    uint8_t has_odometry;
    /// Not 0: room for horus_local_map_publish(), one more byte per cell.
    uint8_t publishes;
    /// Not 0: what is published includes the transformation from the map's frame to the world.
    uint8_t include_transformation;
    /// Prefix of what is published, UTF-8.
    uint8_t name[32];
    /// Name of the odometry sensor, UTF-8.
    uint8_t odometry[32];
    /// Names of the lidars, UTF-8, each another one, in the order in which their scans are drawn.
    uint8_t lidar_names[4][32];
} horus_local_map_config;

/// A scan of a lidar whose beams are spread evenly over its field of view.
///
/// Beam i of n points to start_angle + i * fov / (n - 1) radians, counter-clockwise from the sensor's
/// x axis. Ranges are metres: +inf is a miss at max_range; NaN and -inf say nothing.
typedef struct {
    /// One range per beam.
    const float *ranges;
    /// Beams; 0: there is no scan at present.
    size_t count;
    /// Where the lidar sits on the robot.
    horus_pose2d mount;
    /// Angle of the first beam in radians.
    float start_angle;
    /// Angle between the first beam and the last in radians.
    float fov;
    /// Longest range in metres.
    float max_range;
} horus_lidar_scan;

/// What an update of a local map did.
typedef struct {
    /// Cells the window moved.
    horus_shift shift;
    /// The robot's pose in the map's frame that was used.
    horus_pose2d pose;
    /// 1 if the map has an odometry sensor that has written no pose: the given one was used.
    uint32_t missing_odometries;
    /// Lidars whose scans were drawn.
    uint32_t lidars;
    /// Lidars that have written no scan.
    uint32_t missing_lidars;
    /// Lidars whose scans had no ranges.
    uint32_t empty_lidars;
    /// Beams that marked a cell of the map.
    uint32_t marks;
    /// Beams that were NaN or -inf.
    uint32_t ignored;
} horus_local_update;

/// A map that was published.
typedef struct {
    /// All cells, row by row, to be read until the map is next changed.
    const uint8_t *data;
    /// Columns.
    uint32_t width;
    /// Rows.
    uint32_t height;
    /// Metres per cell.
    float resolution;
    /// The corner of cell (0, 0) in the map's frame.
    horus_point origin;
} horus_grid_map_view;

/// Where the cells of a grid lie: rows along x, columns along y of the pose of the corner of cell
/// (0, 0).
typedef struct {
    /// Cells along x.
    uint32_t rows;
    /// Cells along y.
    uint32_t cols;
    /// Metres per cell.
    float cell_size;
    /// Pose of the corner of cell (0, 0) in its frame.
    horus_pose2d pose;
} horus_lattice;

/// Belief masses of a cell, each 0 to 1, their sum at most 1; the rest is uncertain.
typedef struct {
    /// Belief that the cell is free.
    float free;
    /// Belief that the cell is occupied.
    float occupied;
} horus_masses;

/// A sensor on the robot, and what its beams say.
typedef struct {
    /// The cells its scans are turned into, in the robot's frame.
    horus_lattice lattice;
    /// Its pose in the robot's frame.
    horus_pose2d mount;
    /// Masses of a cell before the hit.
    horus_masses m_free;
    /// Masses of a cell at the hit.
    horus_masses m_occ;
    /// Depth of an obstacle behind the hit, metres.
    float wall_thickness;
    /// How far a beam that hit nothing frees cells, metres; below 0: the scan's out_of_range_threshold.
    float max_free_range;
    /// Half the angle of each beam, radians; below 0: half the gaps between beams.
    float beam_half_width;
} horus_sensor_config;

/// A rectangle whose cells are given masses, whatever the sensors say.
typedef struct {
    /// A horus_inpaint_frame.
    int32_t frame;
    /// First x, metres.
    float x0;
    /// Last x, metres.
    float x1;
    /// First y, metres.
    float y0;
    /// Last y, metres.
    float y1;
    /// What its cells hold.
    horus_masses masses;
} horus_inpaint;

/// What a local mapping does, stage by stage.
typedef struct {
    /// The window of the fused map in the world; it moves with the robot.
    horus_lattice lattice;
    /// A horus_fusion_operator.
    int32_t fusion;
    /// Least uncertain mass under Dempster's and Josang's cumulative rule; 0: none.
    float ignorance_floor;
    /// Least mass free of a free cell.
    float free_threshold;
    /// Least mass occupied of an occupied cell.
    float occupied_threshold;
    /// Whether other cells are free (not 0) or occupied (0).
    uint32_t is_optimistic;
    /// Metres at which distances are capped.
    float max_distance;
    /// Most beams a scan may have.
    uint32_t beams;
    /// Sensors in use; scans name them by index.
    uint32_t sensor_count;
    /// The sensors.
    horus_sensor_config sensors[HORUS_LOCAL_MAPPING_SENSORS];
    /// Painted rectangles in use, the last one uppermost.
    uint32_t inpaint_count;
    /// The rectangles.
    horus_inpaint inpaints[HORUS_LOCAL_MAPPING_INPAINTS];
} horus_local_mapping_config;

/// One sweep of a range sensor with beams at any angles. Ranges are metres: NaN and -inf say nothing,
/// +inf is no hit.
typedef struct {
    /// Directions of the beams in the sensor's frame, radians, ascending.
    const float *angles;
    /// One range per beam.
    const float *ranges;
    /// How far each beam could see, metres; NULL if that is not known.
    const float *visibilities;
    /// Beams.
    size_t count;
    /// Index of the sensor in the configuration.
    uint32_t sensor;
    /// Ranges up to this say nothing.
    float invalid_range_threshold;
    /// Ranges from this on are no hit.
    float out_of_range_threshold;
} horus_flatscan;

/// What a tick did.
typedef struct {
    /// Whole cells by which the window moved.
    horus_shift shift;
    /// Cells in which the scan contradicted the map.
    uint32_t conflicts;
    /// The mass in conflict, over all cells.
    float conflict_mass;
    /// Cells that became vacuous in a total conflict (Dempster's rule).
    uint32_t undefined;
    /// Rows of distances that still wait; 0: they can be read.
    uint32_t distance_rows_left;
} horus_tick_report;

/// A mass cell: free and occupied in steps of 1 / 65535; what they leave of 65535 is uncertain.
typedef struct {
    /// Mass free.
    uint16_t free;
    /// Mass occupied, at most 65535 - free.
    uint16_t occupied;
} horus_evidence_cell;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/// The HORUS_ABI_VERSION that the library was built with.
uint32_t horus_abi_version(void);

/// A status as a short English sentence, for ever; any number is legal.
const char *horus_status_text(int32_t status);

/// Bytes of memory that such a grid takes: one per cell, and a few.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_NON_FINITE_POSE,
/// HORUS_STATUS_SIZE_OVERFLOW.
horus_status horus_grid_bytes(const horus_grid_config *config, size_t *bytes);

/// Makes a grid of unknown cells in `length` bytes of memory. 0 x 0 cells are legal.
///
/// Fails as horus_grid_bytes does, and with HORUS_STATUS_BUFFER_TOO_SMALL.
horus_status horus_grid_init(void *memory,
                             size_t length,
                             const horus_grid_config *config,
                             horus_grid **grid);

/// Gives the grid a new size and place; every cell becomes unknown, texts and time are cleared.
///
/// Fails as horus_grid_bytes does; with HORUS_STATUS_BUFFER_TOO_SMALL if it was made with fewer
/// cells.
horus_status horus_grid_reset(horus_grid *grid, const horus_grid_config *config);

/// Makes every cell unknown; the window stays where it is.
horus_status horus_grid_clear(horus_grid *grid);

/// Sets a cell, clamped to -1 .. 100.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_grid_set_occupancy(horus_grid *grid, uint32_t gx, uint32_t gy, int8_t value);

/// Replaces all cells, row by row, each clamped to -1 .. 100.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is width * height.
horus_status horus_grid_load(horus_grid *grid, const int8_t *values, size_t count);

/// Moves the window by whole cells so that the pose is nearest to its centre; tells by how many
/// (`shift` may be NULL). Cells keep their contents, new ones are unknown.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE.
horus_status horus_grid_recenter(horus_grid *grid, horus_pose2d pose, horus_shift *shift);

/// Integrates a scan taken at a world pose of the sensor: beams clear cells up to their ends, then
/// hits are marked. `report` may be NULL.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_INVALID_SCAN, HORUS_STATUS_INVALID_MODEL,
/// HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_WORKSPACE_TOO_SMALL.
horus_status horus_grid_integrate_scan(horus_grid *grid,
                                       const horus_laser_scan *scan,
                                       horus_pose2d sensor_pose,
                                       horus_scan_model model,
                                       horus_scan_workspace *workspace,
                                       horus_scan_report *report);

/// Names the frame (UTF-8, at most 32 bytes are kept) and sets the time, in nanoseconds.
///
/// Fails with HORUS_STATUS_INVALID_TEXT.
horus_status horus_grid_set_header(horus_grid *grid,
                                   const char *frame_id,
                                   size_t length,
                                   uint64_t timestamp_ns);

/// Sets the grid's free-form text (UTF-8, at most 64 bytes are kept).
///
/// Fails with HORUS_STATUS_INVALID_TEXT.
horus_status horus_grid_set_metadata(horus_grid *grid, const char *metadata, size_t length);

/// Size, resolution and place of the grid.
horus_status horus_grid_info(const horus_grid *grid, horus_map_info *info);

/// All cells, row by row: *count = width * height values at *data, to be read until the next call
/// that changes the grid.
horus_status horus_grid_data(const horus_grid *grid, const int8_t **data, size_t *count);

/// The value of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_grid_occupancy(const horus_grid *grid, uint32_t gx, uint32_t gy, int8_t *value);

/// Whether the world point lies in a cell with a value of 0 .. 49; not if unknown or outside.
horus_status horus_grid_is_free(const horus_grid *grid, float x, float y, bool *free);

/// Whether the world point lies in a cell with a value of 50 .. 100; not if unknown or outside.
horus_status horus_grid_is_occupied(const horus_grid *grid, float x, float y, bool *occupied);

/// The cell that holds a world point; one on a boundary belongs to the upper cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_grid_world_to_grid(const horus_grid *grid, float x, float y, horus_cell *cell);

/// The world point at the centre of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_grid_grid_to_world(const horus_grid *grid,
                                      uint32_t gx,
                                      uint32_t gy,
                                      horus_point *point);

/// The frame's name with its terminating zero, into a text of `length` bytes: 33 suffice.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL.
horus_status horus_grid_frame_id(const horus_grid *grid, char *frame_id, size_t length);

/// The free-form text with its terminating zero, into a text of `length` bytes: 65 suffice.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL.
horus_status horus_grid_metadata(const horus_grid *grid, char *metadata, size_t length);

/// The grid's time in nanoseconds.
horus_status horus_grid_timestamp(const horus_grid *grid, uint64_t *timestamp_ns);

/// The model that sets cells to 0 and 100.
horus_scan_model horus_scan_model_set(void);

/// The model that accumulates: +20 per hit, -7 per miss, between 0 and 100.
horus_scan_model horus_scan_model_accumulate(void);

/// Bytes of memory that such a workspace takes: 12 per beam, one bit per cell, and a few.
///
/// Fails with HORUS_STATUS_SIZE_OVERFLOW.
horus_status horus_scan_workspace_bytes(const horus_scan_workspace_config *config, size_t *bytes);

/// Makes a workspace in `length` bytes of memory.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL, HORUS_STATUS_SIZE_OVERFLOW.
horus_status horus_scan_workspace_init(void *memory,
                                       size_t length,
                                       const horus_scan_workspace_config *config,
                                       horus_scan_workspace **workspace);

/// Bytes of memory that such a cost map takes.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_NON_FINITE_POSE,
/// HORUS_STATUS_SIZE_OVERFLOW, HORUS_STATUS_INVALID_CHOICE, and one of HORUS_STATUS_INVALID_... for
/// a parameter.
horus_status horus_cost_map_bytes(const horus_cost_map_config *config, size_t *bytes);

/// Makes a cost map of unknown cells in `length` bytes of memory and computes its costs.
///
/// Fails as horus_cost_map_bytes() does, and with HORUS_STATUS_BUFFER_TOO_SMALL; with
/// HORUS_STATUS_RADIUS_TOO_LARGE the memory holds no object.
horus_status horus_cost_map_init(void *memory,
                                 size_t length,
                                 const horus_cost_map_config *config,
                                 horus_cost_map **map);

/// horus_cost_map_init() for a one-byte field only: an image that makes its maps with it does not
/// hold the code for two bytes.
///
/// Fails as it does; with HORUS_STATUS_INVALID_CHOICE unless field_bytes is 1.
horus_status horus_cost_map_init_1(void *memory,
                                   size_t length,
                                   const horus_cost_map_config *config,
                                   horus_cost_map **map);

/// horus_cost_map_init() for a two-byte field only, likewise.
///
/// Fails as it does; with HORUS_STATUS_INVALID_CHOICE unless field_bytes is 2.
horus_status horus_cost_map_init_2(void *memory,
                                   size_t length,
                                   const horus_cost_map_config *config,
                                   horus_cost_map **map);

/// The default parameters: R 0.55 m, k 10, polynomial, lethal from occupancy 50 on.
horus_cost_params horus_cost_params_default(void);

/// HORUS 0.4.1: the defaults, but lethal from occupancy 65 on, and unknown cells inflate.
horus_cost_params horus_cost_params_horus(void);

/// nav2's inflation layer: exponential, lethal cost 254 from occupancy 100 on.
horus_cost_params horus_cost_params_nav2(void);

/// The parameters in force.
horus_status horus_cost_map_params(const horus_cost_map *map, horus_cost_params *params);

/// Takes new parameters and recomputes everything before it returns.
///
/// Fails with HORUS_STATUS_INVALID_CHOICE, one of HORUS_STATUS_INVALID_... for a parameter,
/// HORUS_STATUS_RADIUS_TOO_LARGE.
horus_status horus_cost_map_set_params(horus_cost_map *map, const horus_cost_params *params);

/// Largest offset, in cells, at which a source still costs something.
horus_status horus_cost_map_effective_radius(const horus_cost_map *map, uint32_t *cells);

/// Sets a cell, clamped to -1 .. 100; its costs follow with the next update.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_cost_map_set_occupancy(horus_cost_map *map,
                                          uint32_t gx,
                                          uint32_t gy,
                                          int8_t value);

/// Integrates a scan as horus_grid_integrate_scan() does; costs follow with the next update.
///
/// Fails as it does.
horus_status horus_cost_map_integrate_scan(horus_cost_map *map,
                                           const horus_laser_scan *scan,
                                           horus_pose2d sensor_pose,
                                           horus_scan_model model,
                                           horus_scan_workspace *workspace,
                                           horus_scan_report *report);

/// Moves the window as horus_grid_recenter() does; costs move with their cells.
///
/// Fails as it does.
horus_status horus_cost_map_recenter(horus_cost_map *map, horus_pose2d pose, horus_shift *shift);

/// Replaces all cells, row by row, each clamped to -1 .. 100, and recomputes everything.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is width * height.
horus_status horus_cost_map_load(horus_cost_map *map, const int8_t *values, size_t count);

/// Names the frame (UTF-8, at most 32 bytes are kept) and sets the time, in nanoseconds.
///
/// Fails with HORUS_STATUS_INVALID_TEXT.
horus_status horus_cost_map_set_header(horus_cost_map *map,
                                       const char *frame_id,
                                       size_t length,
                                       uint64_t timestamp_ns);

/// Computes every cost from the cells.
horus_status horus_cost_map_compute(horus_cost_map *map);

/// Brings every cost up to date with all changes since the last update: equal to
/// horus_cost_map_compute() in every byte. `changed`, which may be NULL, becomes the rectangle that
/// contains every cost that changed, all zero if none did; after a window shift the whole map.
horus_status horus_cost_map_update(horus_cost_map *map, horus_cell_rect *changed);

/// Updates, but stops before it exceeds `budget` cell visits (one field or cost byte read or
/// written, or one bitmap word), and goes on with the next call. Sources that appeared come first:
/// once they are in, no known cell is cheaper than its final cost. `update` may be NULL.
///
/// Fails with HORUS_STATUS_BUDGET_TOO_SMALL.
horus_status horus_cost_map_update_within(horus_cost_map *map,
                                          uint32_t budget,
                                          horus_cost_update *update);

/// The smallest budget, in cell visits; it depends on the parameters.
horus_status horus_cost_map_min_budget(const horus_cost_map *map, uint32_t *budget);

/// Upper bound on the calls of horus_cost_map_update_within() that make every cost exact if nothing
/// else changes.
horus_status horus_cost_map_calls_left(const horus_cost_map *map, uint32_t *calls);

/// Changed cells and edge blocks that wait for an update; 0: every cost is exact.
horus_status horus_cost_map_pending(const horus_cost_map *map, uint32_t *pending);

/// The grid inside, for the functions that read one: a handle that lives as long as the map's.
horus_status horus_cost_map_grid(const horus_cost_map *map, const horus_grid **grid);

/// The cost at a world point.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_cost_map_cost(const horus_cost_map *map, float x, float y, uint8_t *cost);

/// The cost of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_cost_map_cost_at(const horus_cost_map *map,
                                    uint32_t gx,
                                    uint32_t gy,
                                    uint8_t *cost);

/// Copies the costs of a row into `costs`, which has room for `length` bytes: its width suffices.
///
/// Fails with HORUS_STATUS_OUTSIDE, HORUS_STATUS_BUFFER_TOO_SMALL.
horus_status horus_cost_map_row(const horus_cost_map *map,
                                uint32_t gy,
                                uint8_t *costs,
                                size_t length);

/// The kept costs as of the last update, row by row: *count = width * height bytes at *costs, to be
/// read until the next call that changes the map.
///
/// Fails with HORUS_STATUS_NOT_KEPT.
horus_status horus_cost_map_costs(const horus_cost_map *map, const uint8_t **costs, size_t *count);

/// The highest known cost under a polygon, and whether it touches unknown cells or leaves the map.
/// The vertices lie in the frame of `pose`, which lies in the world frame.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_INVALID_POLYGON.
horus_status horus_cost_map_footprint_cost(const horus_cost_map *map,
                                           horus_pose2d pose,
                                           const horus_point *vertices,
                                           size_t count,
                                           horus_footprint_cost *under);

/// Bytes of memory that such a distance map takes.
///
/// Fails with HORUS_STATUS_SIZE_OVERFLOW, HORUS_STATUS_INVALID_CHOICE.
horus_status horus_distance_map_bytes(const horus_distance_map_config *config, size_t *bytes);

/// Makes a distance map of nothing in `length` bytes of memory.
///
/// Fails as horus_distance_map_bytes() does, and with HORUS_STATUS_BUFFER_TOO_SMALL.
horus_status horus_distance_map_init(void *memory,
                                     size_t length,
                                     const horus_distance_map_config *config,
                                     horus_distance_map **map);

/// Computes the distances of all cells of a grid or, unless `window` is NULL, of a window of it:
/// obstacles outside the window count as well. The map needs room for the grid's columns, and for
/// the window's cells with all columns within the cap left and right of them.
///
/// Fails with HORUS_STATUS_SIZE_OVERFLOW for a grid with a side above 32767 cells,
/// HORUS_STATUS_BUFFER_TOO_SMALL, HORUS_STATUS_OUTSIDE.
horus_status horus_distance_map_compute(horus_distance_map *map,
                                        const horus_grid *grid,
                                        const horus_cell_rect *window,
                                        horus_distance_options options);

/// Starts what horus_distance_map_compute() does: reads the grid, which may change afterwards, and
/// leaves the rest to horus_distance_map_advance().
///
/// Fails as horus_distance_map_compute() does.
horus_status horus_distance_map_begin(horus_distance_map *map,
                                      const horus_grid *grid,
                                      const horus_cell_rect *window,
                                      horus_distance_options options);

/// Goes on computing for so many rows; *left = rows left, 0: the distances can be read.
horus_status horus_distance_map_advance(horus_distance_map *map, uint32_t rows, uint32_t *left);

/// The cells whose distances are, or are being, computed.
horus_status horus_distance_map_window(const horus_distance_map *map, horus_cell_rect *window);

/// The squared distance of a cell of the grid, in cells.
///
/// Fails with HORUS_STATUS_OUTSIDE outside the window, and while a computation has not ended.
horus_status horus_distance_map_squared(const horus_distance_map *map,
                                        uint32_t gx,
                                        uint32_t gy,
                                        int64_t *squared);

/// The distance of a cell of the grid in metres.
///
/// Fails with HORUS_STATUS_OUTSIDE outside the window, and while a computation has not ended.
horus_status horus_distance_map_metres(const horus_distance_map *map,
                                       uint32_t gx,
                                       uint32_t gy,
                                       float *metres);

/// All squared distances of the window, row by row, in the type that the map was made with
/// (uint16_t, int16_t, uint32_t, int32_t): *count cells at *data, to be read until the map is
/// computed anew; none while a computation has not ended.
horus_status horus_distance_map_data(const horus_distance_map *map,
                                     const void **data,
                                     size_t *count);

/// The obstacle nearest to a cell, of several the one with the lowest index; `grid` is the one that
/// the distances were computed of.
///
/// Fails with HORUS_STATUS_OUTSIDE outside the window, while a computation has not ended, and where
/// no obstacle lies within the cap.
horus_status horus_distance_map_nearest(const horus_distance_map *map,
                                        const horus_grid *grid,
                                        uint32_t gx,
                                        uint32_t gy,
                                        horus_cell *nearest);

/// Metres to the first cell of a ray that is not free, the one it starts in included: centre to
/// centre, at most the range. *hit tells whether there is one; if not, *metres is the range.
///
/// Nothing is hit outside the grid, by a ray of numbers that are not finite, and by one that ends
/// more than 2^30 cells away. Fails with HORUS_STATUS_INVALID_CHOICE.
horus_status horus_grid_cast(const horus_grid *grid,
                             const horus_ray *ray,
                             bool *hit,
                             float *metres);

/// The cells of a ray, from the one it starts in to the last one inside the grid: *count of them at
/// `cells`. A grid of width * height cells has room for all in 2 * (width + height).
///
/// Fails with HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_BUFFER_TOO_SMALL.
horus_status horus_grid_trace(const horus_grid *grid,
                              const horus_ray *ray,
                              horus_cell *cells,
                              size_t capacity,
                              size_t *count);

/// A 10 x 10 map of 0.1 m without sensors, navground's defaults.
horus_local_map_config horus_local_map_config_default(void);

/// Bytes of memory that such a local map takes: one per cell, one more if it publishes, and per lidar
/// 16 per beam and a few hundred.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_SIZE_OVERFLOW; with
/// HORUS_STATUS_INVALID_CHOICE for the footprint and the number of lidars.
horus_status horus_local_map_bytes(const horus_local_map_config *config,
                                   size_t *bytes);

/// Makes a local map of unknown cells, its corner at the frame's origin, in `length` bytes of memory.
///
/// Fails as horus_local_map_bytes() does, and with HORUS_STATUS_BUFFER_TOO_SMALL; with
/// HORUS_STATUS_INVALID_FOOTPRINT_RADIUS, HORUS_STATUS_INVALID_TEXT, HORUS_STATUS_DUPLICATE_NAME the
/// memory holds no object.
horus_status horus_local_map_init(void *memory,
                                  size_t length,
                                  const horus_local_map_config *config,
                                  horus_local_map **map);

/// Writes a scan of a lidar, counted from 0, into the map's sensing state; updates draw it until
/// another is written.
///
/// Fails with HORUS_STATUS_OUTSIDE if there is no such lidar, HORUS_STATUS_BUFFER_TOO_SMALL if it has
/// fewer beams, HORUS_STATUS_INVALID_LIDAR, HORUS_STATUS_NON_FINITE_POSE.
horus_status horus_local_map_write_scan(horus_local_map *map,
                                        uint32_t lidar,
                                        const horus_lidar_scan *scan);

/// Writes a pose of the odometry sensor, and its twist per second, into the map's sensing state.
///
/// Fails with HORUS_STATUS_NOT_FOUND if the map has none, HORUS_STATUS_NON_FINITE_POSE.
horus_status horus_local_map_write_odometry(horus_local_map *map,
                                            horus_pose2d pose,
                                            horus_pose2d twist);

/// Forgets all scans and the odometry's pose.
horus_status horus_local_map_clear_state(horus_local_map *map);

/// Makes every cell unknown; the window stays where it is.
horus_status horus_local_map_clear(horus_local_map *map);

/// Replaces all cells, row by row: from 192 on free, below 64 occupied, else unknown.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is width * height.
horus_status horus_local_map_load(horus_local_map *map, const uint8_t *values, size_t count);

/// Moves the window by whole cells so that the pose is nearest to its centre; tells by how many
/// (`shift` may be NULL). An update does this by itself.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE.
horus_status horus_local_map_recenter(horus_local_map *map, horus_pose2d pose, horus_shift *shift);

/// Makes a cost map show the local map: its window moves to where the local map lies, then the cells
/// that differ are set. The cost map has the same size and resolution, and its origin was 0, 0, 0 when
/// it was made. Its costs follow with its next update.
///
/// Fails with HORUS_STATUS_GEOMETRY_MISMATCH.
horus_status horus_local_map_update_cost_map(const horus_local_map *map,
                                             horus_cost_map *cost_map);

/// One update: moves the window with the robot, frees the cells under the footprint, and draws the
/// lidars' scans one after the other, of each all free rays, then all marks. `pose` is the robot's in
/// the world; it is also the one in the map's frame where no odometry has been written. `update` may
/// be NULL.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE.
horus_status horus_local_map_update(horus_local_map *map,
                                    horus_pose2d pose,
                                    horus_local_update *update);

/// Copies the map into its sensing state, for those who read it there: one who uses the map itself
/// need not.
///
/// Fails with HORUS_STATUS_BUFFER_TOO_SMALL if it was made without room for that.
horus_status horus_local_map_publish(horus_local_map *map);

/// Size, resolution and place of the local map.
horus_status horus_local_map_info(const horus_local_map *map, horus_map_info *info);

/// All cells, row by row: *count = width * height bytes at *data, to be read until the next call that
/// changes the map.
horus_status horus_local_map_data(const horus_local_map *map,
                                  const uint8_t **data,
                                  size_t *count);

/// The value of a cell.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_local_map_value(const horus_local_map *map,
                                   uint32_t gx,
                                   uint32_t gy,
                                   uint8_t *value);

/// The cell that holds a point of the map's frame.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_local_map_cell_at(const horus_local_map *map,
                                     float x,
                                     float y,
                                     horus_cell *cell);

/// The transformation from the map's frame to the world as of the last update.
///
/// Fails with HORUS_STATUS_NOT_FOUND before the first.
horus_status horus_local_map_transformation(const horus_local_map *map,
                                            horus_pose2d *transformation);

/// What was last published.
///
/// Fails with HORUS_STATUS_NOT_FOUND if nothing was.
horus_status horus_local_map_read_gridmap(const horus_local_map *map, horus_grid_map_view *view);

/// The transformation that was last published.
///
/// Fails with HORUS_STATUS_NOT_FOUND if none was.
horus_status horus_local_map_read_transformation(const horus_local_map *map,
                                                 horus_pose2d *transformation);

/// A configuration with the usual numbers, PCR6 and no sensor: set the lattice, the beams and at least
/// one sensor.
horus_local_mapping_config horus_local_mapping_config_default(void);

/// A sensor in the middle of the robot with the usual masses, over a lattice of so many cells around
/// it.
horus_sensor_config horus_sensor_config_default(uint32_t rows,
                                                uint32_t cols,
                                                float cell_size);

/// A lattice with its frame's origin in the middle.
horus_lattice horus_lattice_around(uint32_t rows, uint32_t cols, float cell_size);

/// Bytes of memory that such a mapping takes: 6 per cell of the fused map, a quarter per cell of the
/// largest sensor lattice, 8 per beam, and a few.
///
/// Fails with HORUS_STATUS_INVALID_RESOLUTION, HORUS_STATUS_NON_FINITE_POSE,
/// HORUS_STATUS_SIZE_OVERFLOW.
horus_status horus_local_mapping_bytes(const horus_local_mapping_config *config,
                                       size_t *bytes);

/// Makes a mapping that knows nothing in `length` bytes of memory.
///
/// Fails as horus_local_mapping_bytes does, and with HORUS_STATUS_BUFFER_TOO_SMALL,
/// HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_INVALID_MASSES, HORUS_STATUS_INVALID_MAPPING_PARAMETER.
horus_status horus_local_mapping_init(void *memory,
                                      size_t length,
                                      const horus_local_mapping_config *config,
                                      horus_local_mapping **mapping);

/// One tick of the whole chain: moves the window to the robot (its pose in the world), fuses a scan
/// (NULL: none), paints, cuts and measures. `report` may be NULL. For scans of several sensors tick
/// once for each.
///
/// Fails with HORUS_STATUS_NON_FINITE_POSE, HORUS_STATUS_OFFSET_OUT_OF_RANGE,
/// HORUS_STATUS_INVALID_SCAN, HORUS_STATUS_EMPTY_SCAN, HORUS_STATUS_WORKSPACE_TOO_SMALL,
/// HORUS_STATUS_UNKNOWN_SENSOR, HORUS_STATUS_SENSOR_OUTSIDE_MAP.
horus_status horus_local_mapping_tick(horus_local_mapping *mapping,
                                      const horus_flatscan *scan,
                                      horus_pose2d robot,
                                      horus_tick_report *report);

/// As horus_local_mapping_tick, but does at most `rows` rows of the distance stage, which takes
/// 2 * height of them. A stage once begun is finished by later ticks before another begins.
///
/// Fails as horus_local_mapping_tick does.
horus_status horus_local_mapping_tick_within(horus_local_mapping *mapping,
                                             const horus_flatscan *scan,
                                             horus_pose2d robot,
                                             uint32_t rows,
                                             horus_tick_report *report);

/// Size, resolution and place of the fused map.
horus_status horus_local_mapping_info(const horus_local_mapping *mapping, horus_map_info *info);

/// Size, resolution and place of the window that the distances are of: after
/// horus_local_mapping_tick_within, that of the tick which began their stage.
horus_status horus_local_mapping_distance_info(const horus_local_mapping *mapping,
                                               horus_map_info *info);

/// A cell of the fused map, before painting.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_local_mapping_evidence(const horus_local_mapping *mapping,
                                          uint32_t gx,
                                          uint32_t gy,
                                          horus_evidence_cell *cell);

/// The masses of a cell after painting.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_local_mapping_masses(const horus_local_mapping *mapping,
                                        uint32_t gx,
                                        uint32_t gy,
                                        horus_masses *masses);

/// Whether a cell of the binary map is occupied.
///
/// Fails with HORUS_STATUS_OUTSIDE.
horus_status horus_local_mapping_is_occupied(const horus_local_mapping *mapping,
                                             uint32_t gx,
                                             uint32_t gy,
                                             bool *occupied);

/// Metres from a cell to the nearest occupied one, in the window of horus_local_mapping_distance_info.
///
/// Fails with HORUS_STATUS_OUTSIDE, also while a distance stage has not ended.
horus_status horus_local_mapping_distance(const horus_local_mapping *mapping,
                                          uint32_t gx,
                                          uint32_t gy,
                                          float *metres);

/// What the scan that was fused last says about a cell of its sensor's lattice, a horus_scan_class:
/// outside, and before the first scan, vacuous. `sensor`, which may be NULL, takes that sensor's index; -1:
/// there was no scan.
horus_status horus_local_mapping_scan_class(const horus_local_mapping *mapping,
                                            uint32_t row,
                                            uint32_t col,
                                            int32_t *scan_class,
                                            int32_t *sensor);

/// Occupancy values of the fused map, before painting, row by row: the probability that a cell is
/// occupied in percent, or -1 where more than `max_uncertain` is uncertain. What horus_cost_map_load
/// takes.
///
/// Fails with HORUS_STATUS_LENGTH_MISMATCH unless count is the number of cells,
/// HORUS_STATUS_INVALID_MAPPING_PARAMETER.
horus_status horus_local_mapping_occupancy(const horus_local_mapping *mapping,
                                           float max_uncertain,
                                           int8_t *values,
                                           size_t count);

/// Fuses two mass cells by a horus_fusion_operator. `conflict`, which may be NULL, takes the mass in
/// conflict.
///
/// Fails with HORUS_STATUS_INVALID_CHOICE, HORUS_STATUS_INVALID_MASSES,
/// HORUS_STATUS_INVALID_MAPPING_PARAMETER.
horus_status horus_evidence_fuse(int32_t fusion,
                                 float ignorance_floor,
                                 horus_evidence_cell one,
                                 horus_evidence_cell two,
                                 horus_evidence_cell *fused,
                                 float *conflict);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* HORUS_H */
