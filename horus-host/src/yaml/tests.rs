use super::{Document, YamlError, quoted};

fn error(text: &str) -> String {
    Document::parse(text).unwrap_err().to_string()
}

#[test]
fn values_are_read_as_what_they_are() {
    let text = "a: 0x1f\nb: -.5\nc: 'true'\nd: True\ne: ~\nf: [1, 2e3, -.inf]\ng:\n- x\n- \"7\"\nh: !!str 3\ni: nan\nj:\n";
    let document = Document::parse(text).unwrap();
    let entry = |key| document.required(key).unwrap();
    assert_eq!((entry("a").integer(), entry("a").number()), (Ok(31), Ok(31.0)));
    assert_eq!(entry("b").number(), Ok(-0.5));
    assert!(entry("b").integer().is_err() && entry("b").text().is_err());
    assert_eq!(entry("c").text(), Ok("true"));
    assert!(entry("c").boolean().is_err());
    assert_eq!(entry("d").boolean(), Ok(true));
    assert!(entry("e").is_null() && entry("j").is_null() && !entry("d").is_null());
    assert!(entry("e").text().is_err());
    assert_eq!(entry("f").numbers(), Ok(vec![1.0, 2000.0, f64::NEG_INFINITY]));
    assert!(entry("f").texts().is_err() && entry("f").number().is_err());
    assert_eq!(entry("g").texts(), Ok(vec!["x", "7"]));
    assert_eq!((entry("h").text(), entry("i").text()), (Ok("3"), Ok("nan")));
    let keys: Vec<_> = document
        .entries()
        .iter()
        .map(|entry| (entry.key(), entry.line()))
        .collect();
    assert_eq!((keys[0], keys[7], keys[9]), (("a", 1), ("h", 10), ("j", 12)));
    assert_eq!(document.required("k"), Err(YamlError::Missing("k")));
}

#[test]
fn editors_may_leave_their_marks() {
    let document = Document::parse("\u{feff}a: 1\r\nb: x y \r\n").unwrap();
    assert_eq!(document.required("a").unwrap().integer(), Ok(1));
    assert_eq!(document.required("b").unwrap().text(), Ok("x y"));
}

#[test]
fn keys_given_twice_are_refused() {
    for (text, message) in [
        (
            "a: 1\na: 2\n",
            "line 2: a: the key is given twice, first in line 1",
        ),
        (
            "{b: 1, a: 1, \"a\": [2]}",
            "line 1: a: the key is given twice, first in line 1",
        ),
        (
            "a: {x: 1}\n\n\nb: 0\na:\n",
            "line 5: a: the key is given twice, first in line 1",
        ),
    ] {
        assert_eq!(error(text), message);
    }
}

#[test]
fn what_is_no_mapping_is_refused_with_its_line() {
    for (text, start) in [
        ("", "line 1: one mapping"),
        ("\n\n- 1\n", "line 3: one mapping"),
        ("text", "line 1: one mapping"),
        ("a: 1\n---\nb: 1\n", "line 2: one mapping"),
        ("a: 1\n[b]: 1\n", "line 2: a key must be a text"),
        ("a: 1\nb: [1, 2\n", "line "),
        ("a: 1\nb: c: d\n", "line 2: "),
        ("a: *b\n", "line 1: "),
        ("a: \"\n", "line "),
    ] {
        let message = error(text);
        assert!(message.starts_with(start), "{text:?}: {message}");
        assert!(!message.contains('\n'), "{message}");
    }
}

/// Neither aliases of aliases nor depth take more than the text does.
#[test]
fn nested_values_can_only_be_ignored() {
    let document = Document::parse("a: &x {b: 1}\nc: *x\nd: [*x]\ne: [[1]]\nf: 2\n").unwrap();
    for key in ["a", "c", "d", "e"] {
        let entry = document.required(key).unwrap();
        assert!(
            entry.number().is_err() && entry.numbers().is_err() && !entry.is_null(),
            "{key}"
        );
    }
    assert_eq!(document.required("f").unwrap().integer(), Ok(2));
    let deep = format!("a:\n  {}1\nb: 2\n", "- ".repeat(20_000));
    assert!(Document::parse(&deep).is_ok());
    assert!(Document::parse(&format!("a: {}", "[".repeat(20_000))).is_err());
    let mut laughs = "a0: &a0 [x, x]\n".to_owned();
    for level in 1..60 {
        let below = level - 1;
        laughs += &format!("a{level}: &a{level} [*a{below}, *a{below}]\n");
    }
    assert!(Document::parse(&laughs).is_ok());
}

#[test]
fn random_damage_is_an_error_or_a_document() {
    use rand_pcg::rand_core::RngCore;
    let good = "a: 1\nb: [1, 2.5, .nan]\n'c': \"d\\x41\"\ne: &x {f: g}\nh: *x\n? i\n: |\n  text\n  more\nj: !!str 5 # end\n";
    let alphabet: Vec<char> = "ab1:-[]{}?&*!|>'\"#%@ \n\t,é\\".chars().collect();
    let mut random = rand_pcg::Pcg32::new(3, 1);
    let mut refused = 0;
    for _ in 0..20_000 {
        let mut text: Vec<char> = good.chars().collect();
        for _ in 0..1 + random.next_u32() % 4 {
            let at = random.next_u32() as usize % text.len();
            match random.next_u32() % 3 {
                0 => text[at] = alphabet[random.next_u32() as usize % alphabet.len()],
                1 => text.insert(at, alphabet[random.next_u32() as usize % alphabet.len()]),
                _ => {
                    text.remove(at);
                }
            }
        }
        refused += u32::from(Document::parse(&text.into_iter().collect::<String>()).is_err());
    }
    assert!((2000..19_000).contains(&refused), "{refused}");
}

#[test]
fn quoted_texts_read_back() {
    for text in [
        "map.pgm",
        "",
        "a: b",
        "\"'\\",
        "# no comment",
        "tab\tnewline\n",
        "é",
        "\u{1f600}\u{7f}",
    ] {
        let written = format!("key: {}", quoted(text));
        let document = Document::parse(&written).unwrap();
        assert_eq!(document.required("key").unwrap().text(), Ok(text));
    }
}
