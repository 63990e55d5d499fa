use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};

/// The directory results go to.
#[derive(Debug)]
pub struct OutDir {
    path: PathBuf,
}

impl OutDir {
    /// Creates the directory where it is missing and checks that files can be written to it.
    pub fn create(path: &Path) -> anyhow::Result<Self> {
        let name = path.display();
        fs::create_dir_all(path).with_context(|| format!("cannot create the output directory {name}"))?;
        let out = Self {
            path: path.to_owned(),
        };
        out.replace(".horus-probe", |probe| Ok(fs::write(probe, b"horus")?))
            .and_then(|probe| Ok(fs::remove_file(probe)?))
            .with_context(|| format!("cannot write to the output directory {name}"))?;
        Ok(out)
    }

    /// Refuses to go on if one of `names` in here is the file `input`.
    pub fn keep(&self, input: &Path, names: &[&str]) -> anyhow::Result<()> {
        let Ok(input) = input.canonicalize() else {
            return Ok(());
        };
        for name in names {
            if self.file(name).canonicalize().is_ok_and(|output| output == input) {
                bail!(
                    "{}: the input would be overwritten by its own results",
                    input.display()
                );
            }
        }
        Ok(())
    }

    /// The path of a file in the directory.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes a file under another name and gives it its own when it is whole.
    pub fn replace(
        &self,
        name: &str,
        write: impl FnOnce(&Path) -> anyhow::Result<()>,
    ) -> anyhow::Result<PathBuf> {
        let (path, temporary) = (self.file(name), self.file(&format!(".{name}.part")));
        let result = write(&temporary).and_then(|()| Ok(fs::rename(&temporary, &path)?));
        if result.is_err() {
            let _ = fs::remove_file(&temporary); // the first error is the one to tell
        }
        result.with_context(|| format!("cannot write {}", path.display()))?;
        Ok(path)
    }

    /// Writes a text file as [`replace`](Self::replace) does.
    pub fn replace_text(&self, name: &str, text: &str) -> anyhow::Result<PathBuf> {
        self.replace(name, |path| {
            let mut file = fs::File::create(path)?;
            Ok(file.write_all(text.as_bytes())?)
        })
    }
}
