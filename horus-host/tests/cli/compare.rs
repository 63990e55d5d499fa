//! `horus-host compare`: equal, different, unreadable.

use std::fs;

use crate::support::{S, TestLog, code, json, refused, run, scan_at, scratch};

#[test]
fn one_changed_range_is_found_and_named() {
    let dir = scratch("compare_pair");
    let path = |name: &str| dir.join(name).to_str().unwrap().to_owned();
    for (name, range) in [("a.mcap", 1.0), ("b.mcap", 1.0), ("c.mcap", 1.5)] {
        let mut log = TestLog::with_mount(&dir.join(name));
        for second in 1..=3 {
            let mut scan = scan_at(second * S);
            if second == 2 {
                scan.ranges[17] = range;
            }
            log.scan(&scan);
        }
        log.finish();
    }
    assert_eq!(
        json(&["compare", &path("a.mcap"), &path("b.mcap"), "--json"], 0)["equal"],
        true
    );
    let different = json(&["compare", &path("a.mcap"), &path("c.mcap"), "--json"], 1);
    assert_eq!(different["equal"], false);

    let output = run(&["compare", &path("a.mcap"), &path("c.mcap")]);
    assert_eq!(code(&output), 1);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("first difference on /scan: message 1 at 2000000000 ns: ranges[17]"),
        "{text}"
    );
    assert!(text.ends_with("different\n"), "{text}");
}

#[test]
fn a_truncated_log_differs_and_says_so() {
    let dir = scratch("compare_truncated");
    let (whole, part) = (dir.join("whole.mcap"), dir.join("part.mcap"));
    let mut log = TestLog::with_mount(&whole);
    log.scan(&scan_at(S));
    log.finish();
    let bytes = fs::read(&whole).unwrap();
    fs::write(&part, &bytes[..bytes.len() - 20]).unwrap();
    let output = run(&["compare", whole.to_str().unwrap(), part.to_str().unwrap()]);
    assert_eq!(code(&output), 1);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("the second log is truncated: it was read up to byte"),
        "{text}"
    );
}

#[test]
fn an_unreadable_log_is_named() {
    let dir = scratch("compare_unreadable");
    let (good, bad) = (dir.join("good.mcap"), dir.join("bad.mcap"));
    let mut log = TestLog::create(&good);
    log.scan(&scan_at(S));
    log.finish();
    fs::write(&bad, "no log at all").unwrap();
    let (good, bad) = (good.to_str().unwrap(), bad.to_str().unwrap());
    refused(&["compare", good, bad], &[bad, "not an MCAP file"]);
    refused(&["compare", "no/such.mcap", good, "--json"], &["no/such.mcap"]);
    assert_eq!(code(&run(&["compare", good])), 2, "one log is not enough");
}
