/// Version of the binary interface: compare it with horus_abi_version() to see that header and
/// library belong together.
pub const HORUS_ABI_VERSION: u32 = 1;

/// The HORUS_ABI_VERSION that the library was built with.
#[unsafe(no_mangle)]
pub extern "C" fn horus_abi_version() -> u32 {
    HORUS_ABI_VERSION
}
