use super::{expands, refuses, run, run_with, warns};

#[test]
fn numbers_that_are_none() {
    for text in ["1f", "08", "1e", "0x", "1..0", "1.0lf", "1uu"] {
        refuses(text, "is not a number");
    }
    refuses("4294967296", "too large");
    expands("0xE+1 1e+1", "0xE + 1 1e+1");
}

#[test]
fn what_browsers_refuse_and_is_clear() {
    warns("#extension GL_x : enable", "refuses `#extension`");
    warns("#version 300 es", "refuses a `#version`");
    warns(&"x".repeat(1025), "more than 1024 characters");
    warns(&format!("#if 0\n{}\n#endif", "x".repeat(1025)), "more than");
    warns(&"1".repeat(1025).replacen('1', ".", 1), "more than 1024");
    let table = "1,".repeat(5001);
    warns(&format!("#define F(x) x\nF(({table}))"), "more than 10000");
    expands(&"x".repeat(1024), &"x".repeat(1024));
    expands("\u{feff}x", "x");
    assert!(run_with("\u{feff}x", true, &[]).has_errors());
}

#[test]
fn characters() {
    let odd = |text: &str| (run(text).spelled(), run(text).has_odd_character);
    assert_eq!(odd("a é b : c"), ("a ? b : c".to_owned(), true));
    assert_eq!(odd("🙂"), ("? ?".to_owned(), true));
    assert_eq!(odd("#define É é\n// é\na ? b"), ("a ? b".to_owned(), false));
    assert_eq!(odd("#define A é\nA"), ("?".to_owned(), true));
    let ended = run("a\0#if b");
    assert_eq!(ended.spelled(), "a");
    assert!(!ended.has_errors());
}
