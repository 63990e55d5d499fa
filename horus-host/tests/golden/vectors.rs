//! Reading the recorded vectors.

use std::path::{Path, PathBuf};

use serde_json::Value;

/// The folders holding vectors of one program.
pub fn folders(program: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    ["../tests/golden", "../../shared/golden"]
        .map(|folder| root.join(folder).join(program))
        .into_iter()
        .filter(|folder| {
            let found = folder.is_dir();
            if !found {
                println!("skipped: {} is not there", folder.display());
            }
            found
        })
        .collect()
}

pub fn read(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).expect("a readable file");
    serde_json::from_str(&text).expect("JSON")
}

/// Every copy of one vector file.
pub fn vectors(program: &str, file: &str) -> Vec<Value> {
    let paths = folders(program).into_iter().map(|f| f.join(file));
    let found: Vec<_> = paths.filter(|p| p.is_file()).map(|p| read(&p)).collect();
    assert!(!found.is_empty(), "no {program}/{file} anywhere");
    found
}

pub fn items(value: &Value) -> &[Value] {
    value.as_array().expect("an array")
}

pub fn int(value: &Value) -> i64 {
    value.as_i64().expect("an integer")
}

pub fn f32_of(value: &Value) -> f32 {
    value.as_f64().expect("a number") as f32
}

pub fn bits(value: &Value) -> u64 {
    let hex = value.as_str().expect("hex").trim_start_matches("0x");
    u64::from_str_radix(hex, 16).expect("hex")
}

pub fn f64_bits(value: &Value) -> f64 {
    f64::from_bits(bits(value))
}

pub fn f32_bits(value: &Value) -> f32 {
    f32::from_bits(bits(value) as u32)
}

pub fn bytes(value: &Value) -> Vec<u8> {
    let hex = value.as_str().expect("hex").as_bytes();
    let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).unwrap(), 16).unwrap();
    hex.chunks(2).map(byte).collect()
}

pub fn costs_of(value: &Value) -> Vec<u8> {
    items(value).iter().map(|v| int(v) as u8).collect()
}

pub fn cells_of(value: &Value) -> Vec<i8> {
    items(value).iter().map(|v| int(v) as i8).collect()
}

pub fn size_of(value: &Value) -> (u32, u32) {
    (int(&value["width"]) as u32, int(&value["height"]) as u32)
}
