use std::env;
use std::fs;
use std::path::PathBuf;

use iceoryx2::prelude::{CallbackProgression, Config, FileName, Path, SemanticString, Service as _, ipc};

use iceoryx2::service::static_config::messaging_pattern::MessagingPattern as ServicePattern;

use super::TopicError;

/// Longest name: file names in shared memory are short.
const NAME_LIMIT: usize = 32;

/// The environment variable that names the domain.
const VARIABLE: &str = "HORUS_DOMAIN";

/// Processes see the topics of their own domain only: all of one user, unless told otherwise.
#[derive(Debug, Clone)]
pub struct Domain {
    prefix: String,
    root: PathBuf,
    config: Config,
}

impl Domain {
    /// The domain of this name, for this user: letters, digits and `_`, at most 32.
    ///
    /// # Errors
    /// [`TopicError::Name`].
    pub fn new(name: &str) -> Result<Self, TopicError> {
        let refuse = || TopicError::Name {
            what: "domain",
            name: name.to_owned(),
        };
        let is_legal = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
        if name.is_empty() || name.len() > NAME_LIMIT || !name.bytes().all(is_legal) {
            return Err(refuse());
        }
        // What one user creates, another cannot write.
        let user = user();
        let prefix = format!("horus_{user}_{name}_");
        let root = env::temp_dir().join(format!("horus-topics-{user}"));
        let mut config = Config::default();
        config.global.prefix = FileName::new(prefix.as_bytes()).map_err(|_| refuse())?;
        let path = root.to_str().ok_or_else(refuse)?;
        let path = Path::new(path.as_bytes()).map_err(|_| refuse())?;
        config.global.set_root_path(&path);
        Ok(Self { prefix, root, config })
    }

    /// The domain that `HORUS_DOMAIN` names, or `0`.
    ///
    /// # Errors
    /// [`TopicError::Name`].
    pub fn of_user() -> Result<Self, TopicError> {
        Self::new(&env::var(VARIABLE).unwrap_or_else(|_| "0".to_owned()))
    }

    /// Removes every file of the domain. Only for a domain that nobody uses any more: what killed
    /// processes leave is cleaned without it when the next process opens a topic.
    pub fn remove(&self) {
        let memory = PathBuf::from("/dev/shm");
        let directories = [
            memory,
            self.root.clone(),
            self.root.join("nodes"),
            self.root.join("services"),
        ];
        for directory in directories {
            let Ok(entries) = fs::read_dir(directory) else {
                continue;
            };
            for entry in entries.flatten() {
                if entry.file_name().to_string_lossy().starts_with(&self.prefix) {
                    let path = entry.path();
                    let _ = if path.is_dir() {
                        fs::remove_dir_all(path)
                    } else {
                        fs::remove_file(path)
                    };
                }
            }
        }
    }

    /// Names of the topics that somebody has open.
    ///
    /// # Errors
    /// [`TopicError::Open`] if shared memory cannot be read.
    pub fn topics(&self) -> Result<Vec<String>, TopicError> {
        let mut names = Vec::new();
        let listed = ipc::Service::list(&self.config, |service| {
            let details = &service.static_details;
            if matches!(details.messaging_pattern(), ServicePattern::PublishSubscribe(_)) {
                names.push(details.name().to_string());
            }
            CallbackProgression::Continue
        });
        listed.map_err(|error| TopicError::Open {
            topic: "list".to_owned(),
            reason: format!("{error:?}"),
        })?;
        names.sort();
        Ok(names)
    }

    pub(super) fn config(&self) -> &Config {
        &self.config
    }
}

/// A name for the user of this process.
#[cfg(unix)]
fn user() -> String {
    use std::os::unix::fs::MetadataExt;
    fs::metadata("/proc/self").map_or_else(|_| "0".to_owned(), |process| process.uid().to_string())
}

#[cfg(not(unix))]
fn user() -> String {
    "0".to_owned()
}
