use super::{Preprocessed, preprocess};
use crate::source::SourceMap;

/// The tokens that are left, with a space where there was some, and the messages.
fn run(text: &str) -> (String, Vec<String>) {
    let mut files = SourceMap::default();
    let file = files.add("a", text);
    let Preprocessed {
        tokens,
        diagnostics,
    } = preprocess(&files, &[file], &[("HOST", "1")]);
    let spelled = tokens
        .iter()
        .map(|token| token.text.as_ref())
        .collect::<Vec<_>>()
        .join(" ");
    let messages = diagnostics
        .into_iter()
        .map(|diagnostic| diagnostic.message)
        .collect();
    (spelled, messages)
}

#[track_caller]
fn expands(text: &str, expected: &str) {
    assert_eq!(run(text), (expected.to_owned(), Vec::new()), "{text}");
}

#[track_caller]
fn refuses(text: &str, part: &str) {
    let (_, messages) = run(text);
    assert!(
        messages.iter().any(|message| message.contains(part)),
        "{text}: {messages:?}"
    );
}

#[test]
fn macros_without_parameters() {
    expands("#define A 1 + B\n#define B 2\nA A", "1 + 2 1 + 2");
    expands("#define EMPTY\na EMPTY b", "a b");
    expands("#define A 1\n#undef A\nA", "A");
    expands("#define A 1 /* one */ + 1 // two\nA", "1 + 1");
    expands("#define A (x)\nA", "( x )");
    expands("#define float vec4\nfloat x", "vec4 x");
}

#[test]
fn macros_with_parameters() {
    expands(
        "#define F(x, y) x * y\nF(1 + 2, g(3, 4))",
        "1 + 2 * g ( 3 , 4 )",
    );
    expands("#define F(x) [x]\nF F (1) F() F\n(2)", "F [ 1 ] [ ] [ 2 ]");
    expands("#define F() f\nF() F( )", "f f");
    expands("#define F(x) x x\n#define A 1\nF(A)", "1 1");
    expands("#define F(x) G(x)\n#define G(x) x + F\nF(1)", "1 + F");
    expands("#define CALL(f) f(1)\n#define SQ(x) x*x\nCALL(SQ)", "1 * 1");
    expands(
        "#define F(a,b) a b\nF(\n1,\n#ifdef HOST\n2\n#endif\n)",
        "1 2",
    );
    expands("#define F(x,) x\nF(1)", "1");
    refuses("#define F(x) x\nF(1, 2)", "takes 1 arguments, not 2");
    refuses("#define F(x) x\nF(1", "never closed");
    refuses("#define F(x, x) x", "same name");
}

#[test]
fn a_macro_does_not_expand_within_itself() {
    expands("#define A A\nA", "A");
    expands("#define A B\n#define B A\nA B", "A B");
    expands("#define f(x) f(x + 1)\nf(f(1))", "f ( f ( 1 + 1 ) + 1 )");
}

#[test]
fn definitions() {
    expands("#define A 1  +  2\n#define A 1 + 2\nA", "1 + 2");
    refuses("#define A 1\n#define A 2", "already defined");
    refuses("#define A 1+2\n#define A 1 + 2", "already defined");
    refuses("#define GL_ES 2", "reserved");
    refuses("#define __LINE__ 2", "already defined");
    refuses("#undef __LINE__", "cannot be undefined");
    expands("#undef HOST\n#define HOST 2\nHOST", "2");
    refuses("#define defined 1", "reserved");
    refuses("#define GL_x 1", "reserved");
    refuses("#define 3", "name is missing");
}

#[test]
fn conditions() {
    let chosen = |condition: &str| run(&format!("#if {condition}\nyes\n#else\nno\n#endif"));
    for condition in [
        "1",
        "HOST",
        "GL_ES",
        "__VERSION__ == 300",
        "defined HOST && defined(GL_ES)",
        "!defined X",
        "1 + 2 * 3 == 7",
        "-1 < 0",
        "~0 == -1",
        "0x10 == 16",
        "010 == 8",
        "1 || X",
        "!(0 && 1/0)",
        "(1 << 4) >> 2 == 4",
        "7 % 4 == 3",
        "1 ? 2 : 3",
    ] {
        let expected = if condition.contains('?') { "no" } else { "yes" };
        assert_eq!(chosen(condition).0, expected, "{condition}");
    }
    for (condition, part) in [
        ("X", "is not a macro"),
        ("", "ends too early"),
        ("1 2", "does not belong"),
        ("1.5", "not a whole number"),
        ("1 / 0", "division by zero"),
        ("(1", "never closed"),
        ("defined", "wants a name"),
    ] {
        refuses(&format!("#if {condition}\n#endif"), part);
    }
}

#[test]
fn branches() {
    expands("#if 0\na\n#elif 1\nb\n#elif X\nc\n#else\nd\n#endif", "b");
    expands("#if 0\n#if X\n#nonsense\n#else\n#endif\n#endif\ne", "e");
    expands("#ifdef X\na\n#endif\n#ifndef X\nb\n#endif", "b");
    refuses("#if 1", "has no `#endif`");
    refuses("#endif", "has no `#if`");
    refuses("#if 1\n#else\n#else\n#endif", "second `#else`");
    refuses("#if 1\n#else\n#elif 1\n#endif", "after `#else`");
    refuses("#ifdef X y\n#endif", "should end");
    refuses("#if 1\n#endif x", "should end");
}

#[test]
fn other_directives() {
    expands("#\n#pragma anything goes\nx", "x");
    expands(
        "a __LINE__\n__LINE__\n#line 10\n__LINE__ \\\n __LINE__",
        "a 1 2 10 11",
    );
    refuses("#error no way", "no way");
    refuses("#version 300 es", "`#version`");
    refuses("#include <x>", "`#include`");
    refuses("#nonsense", "no such directive");
    refuses("a # b", "means nothing");
    refuses("x = “1”;", "means nothing");
}

#[test]
fn endless_expansions_are_refused() {
    let mut bomb = String::from("#define M0 x\n");
    for level in 1..40 {
        let inner = level - 1;
        bomb += &format!("#define M{level} M{inner} M{inner}\n");
    }
    refuses(&(bomb + "M39"), "without end");
    let mut bomb = String::from("#define D(x) x x\n");
    bomb += &"D(".repeat(40);
    bomb += &")".repeat(40);
    expands(&bomb, "");
    refuses(&bomb.replace("()", "(y)"), "without end");
}
