//! Sizes of a firmware image, from its sections and symbols.

use std::collections::BTreeMap;

use object::{Object, ObjectSection, ObjectSymbol, SymbolKind};

/// What an image takes, in bytes.
#[derive(Debug, Default)]
pub struct Image {
    pub text: u64,
    pub rodata: u64,
    pub data: u64,
    pub bss: u64,
    /// Code of libm and of the float routines below it.
    pub libm_code: u64,
    /// Code of the compiler's other routines: copies, integer division.
    pub runtime_code: u64,
    /// Sizes of the statics in `.bss`.
    pub storage: Vec<u64>,
    /// Mangled names of all symbols.
    pub names: Vec<String>,
}

impl Image {
    pub fn read(elf: &[u8]) -> Result<Self, object::Error> {
        let file = object::File::parse(elf)?;
        let size = |name| file.section_by_name(name).map_or(0, |section| section.size());
        let mut image = Self {
            text: size(".text"),
            rodata: size(".rodata"),
            data: size(".data"),
            bss: size(".bss"),
            ..Self::default()
        };
        let bss = file.section_by_name(".bss").map(|section| section.index());
        // By address: several names may stand for one function.
        let mut functions = BTreeMap::new();
        for symbol in file.symbols() {
            let name = symbol.name()?;
            image.names.push(name.to_owned());
            match symbol.kind() {
                SymbolKind::Text => {
                    functions.insert(symbol.address(), (symbol.size(), Origin::of(name)));
                }
                SymbolKind::Data if bss.is_some() && symbol.section_index() == bss => {
                    image.storage.push(symbol.size());
                }
                _ => {}
            }
        }
        for (size, origin) in functions.into_values() {
            match origin {
                Origin::Libm => image.libm_code += size,
                Origin::Runtime => image.runtime_code += size,
                Origin::Core => {}
            }
        }
        Ok(image)
    }

    /// Code and constants.
    pub fn flash(&self) -> u64 {
        self.text + self.rodata + self.data
    }
}

/// Where a function comes from.
enum Origin {
    Libm,
    Runtime,
    Core,
}

impl Origin {
    /// From its mangled name. Core's only door to libm, into which parts of it are inlined, counts
    /// as libm.
    fn of(name: &str) -> Self {
        let has = |part: &str| name.contains(part);
        let float = |routine: &str| {
            let operands = ["d", "f", "i2d", "i2f", "ui2", "l2", "ul2"];
            operands.iter().any(|start| routine.starts_with(start))
        };
        let eabi = name.strip_prefix("__aeabi_");
        if has("4libm")
            || has("10horus_core4math")
            || has("17compiler_builtins5float")
            || eabi.is_some_and(float)
        {
            Self::Libm
        } else if eabi.is_some() || has("17compiler_builtins") || name.starts_with("mem") {
            Self::Runtime
        } else {
            Self::Core
        }
    }
}
