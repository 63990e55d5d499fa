//! Other processes, and domains that leave nothing behind.

use std::env;
use std::io::{BufRead, BufReader};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use horus_host::topic::Domain;

/// How long anything may take before a test fails.
pub const PATIENCE: Duration = Duration::from_secs(20);

/// A domain of one test, gone when the test is over.
pub struct TestDomain(pub Domain, String);

impl TestDomain {
    pub fn new(test: &str) -> Self {
        let name = format!("{test}_{}", std::process::id());
        let domain = Domain::new(&name).unwrap();
        domain.remove();
        Self(domain, name)
    }

    /// Starts this program as `role`, the name of an ignored test.
    pub fn start(&self, role: &str, variables: &[(&str, &str)]) -> Peer {
        let mut child = Command::new(env::current_exe().unwrap())
            .args(["--exact", role, "--ignored", "--nocapture", "--test-threads", "1"])
            .env("HORUS_DOMAIN", &self.1)
            .envs(variables.iter().copied())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let lines = BufReader::new(child.stdout.take().unwrap());
        Peer { child, lines }
    }
}

impl Drop for TestDomain {
    fn drop(&mut self) {
        self.0.remove();
    }
}

/// A process that plays a role.
pub struct Peer {
    child: Child,
    lines: BufReader<ChildStdout>,
}

impl Peer {
    /// The rest of the next line that starts with `word`.
    pub fn line(&mut self, word: &str) -> String {
        let mut line = String::new();
        while self.lines.read_line(&mut line).unwrap() > 0 {
            // The test harness may have begun the line.
            if let Some((_, rest)) = line.split_once(word) {
                return rest.trim().to_owned();
            }
            line.clear();
        }
        panic!("the other process never said {word:?}");
    }

    /// Ends it as `kill -9` does.
    pub fn kill(mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }

    /// Waits until it ends by itself, and well.
    pub fn join(mut self) {
        drop(self.child.stdin.take());
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                assert!(status.success(), "the other process failed");
                return;
            }
            if Instant::now() > end {
                self.child.kill().unwrap();
                panic!("the other process never ended");
            }
            thread::sleep(Duration::from_millis(2));
        }
    }
}

/// The domain a role was started in.
pub fn domain() -> Domain {
    Domain::of_user().unwrap()
}

/// A number a role was given.
pub fn number(name: &str) -> u64 {
    env::var(name).map_or(0, |text| text.parse().unwrap())
}

/// Calls `poll` until it returns something.
pub fn until<T>(mut poll: impl FnMut() -> Option<T>) -> T {
    let end = Instant::now() + PATIENCE;
    loop {
        if let Some(found) = poll() {
            return found;
        }
        assert!(Instant::now() < end, "waited too long");
        thread::sleep(Duration::from_micros(200));
    }
}
