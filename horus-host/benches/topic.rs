//! A 200x200 grid from one process to another: over a `Topic`, and over a Unix socket in the same run.
//!
//! `cargo bench -p horus-host --bench topic`. Latency is half of a round trip in which both sides send a
//! grid; throughput is grids one way, all of them received. Median and 99th percentile of the round trips.
//! Both senders fill every cell before they send, both receivers look at the last cell.

use std::env;
use std::io::{Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::PathBuf;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use horus_host::topic::{Domain, GridHeader, OccupancyGridMsg, Topic, TopicOptions};

const CELLS: usize = 200 * 200;
type Grid = OccupancyGridMsg<CELLS>;

const ROUNDS: u64 = 20_000;
const GRIDS: u64 = 50_000;

/// Names the role of the other process.
const ROLE: &str = "HORUS_BENCH_ROLE";

fn main() {
    match env::var(ROLE).as_deref() {
        Ok("topic") => topic_peer(),
        Ok("socket") => socket_peer(),
        _ => compare(),
    }
}

fn compare() {
    println!("200x200 cells, {} bytes per message", size_of::<Grid>());
    let (latency, throughput) = over_topic();
    report("Topic", latency, throughput);
    let (latency, throughput) = over_socket();
    report("Unix socket", latency, throughput);
}

fn report(name: &str, mut latency: Vec<Duration>, throughput: Duration) {
    latency.sort_unstable();
    let at = |share: f64| latency[((latency.len() - 1) as f64 * share) as usize].as_secs_f64() * 1e6 / 2.0;
    let per_second = GRIDS as f64 / throughput.as_secs_f64();
    println!(
        "{name:12} latency median {:7.2} us, p99 {:7.2} us; {per_second:9.0} grids/s, {:6.0} MB/s",
        at(0.5),
        at(0.99),
        per_second * CELLS as f64 * 1e-6
    );
}

fn start(role: &str) -> Child {
    let program = env::current_exe().expect("this program");
    let mut command = Command::new(program);
    command.env(ROLE, role).env("HORUS_DOMAIN", domain_name());
    command.spawn().expect("the other process")
}

/// The domain of this run: that of the parent.
fn domain_name() -> String {
    env::var("HORUS_DOMAIN").unwrap_or_else(|_| format!("bench_{}", std::process::id()))
}

fn topics() -> [Topic<Grid>; 2] {
    let domain = Domain::new(&domain_name()).expect("a domain");
    ["there", "back"].map(|name| Topic::open(&domain, name, TopicOptions::reliable()).expect("a topic"))
}

fn send(topic: &Topic<Grid>, n: u64) {
    let mut message = topic.loan().expect("a message");
    message.elements_mut().fill(n as i8);
    message.header = GridHeader {
        timestamp_ns: n,
        resolution: 0.05,
        width: 200,
        height: 200,
        ..GridHeader::default()
    };
    assert_eq!(message.send().expect("sent"), 1);
}

fn receive(topic: &Topic<Grid>, n: u64) {
    let message = loop {
        if let Some(message) = topic.recv().expect("received") {
            break message;
        }
        std::hint::spin_loop();
    };
    assert_eq!(
        (message.header.timestamp_ns, message.elements()[CELLS - 1]),
        (n, n as i8)
    );
}

fn over_topic() -> (Vec<Duration>, Duration) {
    let [there, back] = topics();
    let mut peer = start("topic");
    there
        .wait_for_subscribers(1, Duration::from_secs(20))
        .expect("a subscriber");
    let mut latency = Vec::new();
    for n in 0..ROUNDS {
        let start = Instant::now();
        send(&there, n);
        receive(&back, n);
        latency.push(start.elapsed());
    }
    let start = Instant::now();
    for n in 0..GRIDS {
        send(&there, n);
    }
    receive(&back, GRIDS);
    let throughput = start.elapsed();
    peer.wait().expect("the end of the other process");
    drop((there, back));
    Domain::new(&domain_name()).expect("a domain").remove();
    (latency, throughput)
}

fn topic_peer() {
    let [there, back] = topics();
    let first = loop {
        if let Some(message) = there.recv().expect("received") {
            break message.header.timestamp_ns;
        }
    };
    back.wait_for_subscribers(1, Duration::from_secs(20))
        .expect("a subscriber");
    send(&back, first);
    for n in 1..ROUNDS {
        receive(&there, n);
        send(&back, n);
    }
    for n in 0..GRIDS {
        receive(&there, n);
    }
    send(&back, GRIDS);
    std::thread::sleep(Duration::from_millis(200));
}

fn socket_path() -> PathBuf {
    env::temp_dir().join(format!("{}.sock", domain_name()))
}

fn write(stream: &mut UnixStream, cells: &mut [u8], n: u64) {
    cells.fill(n as u8);
    stream.write_all(&n.to_le_bytes()).expect("sent");
    stream.write_all(cells).expect("sent");
}

fn read(stream: &mut UnixStream, cells: &mut [u8], n: u64) {
    let mut number = [0; 8];
    stream.read_exact(&mut number).expect("received");
    stream.read_exact(cells).expect("received");
    assert_eq!((u64::from_le_bytes(number), cells[CELLS - 1]), (n, n as u8));
}

fn over_socket() -> (Vec<Duration>, Duration) {
    let listener = UnixListener::bind(socket_path()).expect("a socket");
    let mut peer = start("socket");
    let (mut stream, _) = listener.accept().expect("a connection");
    let mut cells = vec![0; CELLS];
    let mut latency = Vec::new();
    for n in 0..ROUNDS {
        let start = Instant::now();
        write(&mut stream, &mut cells, n);
        read(&mut stream, &mut cells, n);
        latency.push(start.elapsed());
    }
    let start = Instant::now();
    for n in 0..GRIDS {
        write(&mut stream, &mut cells, n);
    }
    read(&mut stream, &mut cells, GRIDS);
    let throughput = start.elapsed();
    peer.wait().expect("the end of the other process");
    let _ = std::fs::remove_file(socket_path());
    (latency, throughput)
}

fn socket_peer() {
    let mut stream = UnixStream::connect(socket_path()).expect("a connection");
    let mut cells = vec![0; CELLS];
    for n in 0..ROUNDS {
        read(&mut stream, &mut cells, n);
        write(&mut stream, &mut cells, n);
    }
    for n in 0..GRIDS {
        read(&mut stream, &mut cells, n);
    }
    write(&mut stream, &mut cells, GRIDS);
}
