//! Building the programs of `tests/footprint`.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::image::Image;

const TARGET: &str = "thumbv7em-none-eabihf";

/// A profile of that package.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Profile {
    name: &'static str,
    pub opt_level: &'static str,
}

impl Profile {
    pub const RELEASE: Self = Self {
        name: "release",
        opt_level: "3",
    };
    pub const SMALL: Self = Self {
        name: "small",
        opt_level: "s",
    };
}

pub fn package() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("footprint")
}

/// A folder of its own, within the target directory of this very build.
fn target_dir() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("footprint")
}

/// Builds programs with features of core; what cargo printed, if that fails.
pub fn build(profile: Profile, programs: &[&str], features: &str) -> Result<(), String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .current_dir(package())
        .args(["build", "--quiet", "--locked", "--target", TARGET])
        .args(["--profile", profile.name, "--features", features])
        .arg("--target-dir")
        .arg(target_dir());
    for program in programs {
        cargo.args(["--bin", program]);
    }
    // The images are those of one build: nothing in the environment may change them.
    for (name, _) in env::vars_os() {
        let text = name.to_string_lossy();
        if text.contains("RUSTFLAGS")
            || text.starts_with("CARGO_PROFILE_")
            || text.starts_with("CARGO_BUILD_")
        {
            cargo.env_remove(&name);
        }
    }
    let output = cargo.output().map_err(|e| format!("cargo does not start: {e}"))?;
    if output.status.success() {
        Ok(())
    } else {
        Err(String::from_utf8_lossy(&output.stderr).into_owned())
    }
}

/// Reads a program that has been built without features.
pub fn read(profile: Profile, program: &str) -> Image {
    let path = target_dir().join(TARGET).join(profile.name).join(program);
    let bytes = fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    Image::read(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}
