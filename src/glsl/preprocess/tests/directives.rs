use super::{expands, refuses, run};

#[test]
fn definitions() {
    expands("#define A 1  +  2\n#define A 1 + 2\nA", "1 + 2");
    expands("#undef HOST\n#define HOST 2\nHOST", "2");
    expands("#undef NOBODYS\n#undef GL_NOBODYS", "");
    expands("#define gl_x 1\n#define a__b 2\ngl_x a__b", "1 2");
    for (text, part) in [
        ("#define A 1\n#define A 2", "already defined"),
        ("#define A 1+2\n#define A 1 + 2", "already defined"),
        ("#define A(x) x\n#define A(y) y", "already defined"),
        ("#define A(x) x\n#define A x", "already defined"),
        ("#define HOST 2", "already defined"),
        ("#define GL_ES 2", "already defined, by the language"),
        ("#define __LINE__ 2", "already defined"),
        ("#undef __LINE__", "cannot be undefined"),
        ("#undef A x", "should end"),
        ("#undef", "name is missing"),
        ("#define defined 1", "reserved"),
        ("#define GL_x 1", "reserved"),
        ("#define 3", "name is missing"),
        ("#define", "name is missing"),
        ("#define F(x) x\nF(\n#undef F\n1)", "amid a use"),
        ("#define F(x) x\nF\n#undef F\nx", "amid a use"),
    ] {
        refuses(text, part);
    }
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
        "2 - 1 - 1 == 0",
        "-1 < 0",
        "~0 == -1",
        "-!0 == -1",
        "0x10 == 16",
        "010 == 8",
        "10u == 10",
        "4294967295 == -1",
        "1 || X",
        "0 && X || 1",
        "!(0 && 1/0)",
        "(1 << 4) >> 2 == 4",
        "-1 >> 31 == 1",
        "(-2147483647 - 1) / -1 == 2147483647",
        "(-2147483647 - 1) % -1 == 0",
        "7 % 4 == 3",
        "1 | 0 ^ 1 & 0",
    ] {
        assert_eq!(chosen(condition).spelled(), "yes", "{condition}");
    }
    for (condition, part) in [
        ("X", "is not a macro"),
        ("X == 1", "is not a macro"),
        ("true", "is not a macro"),
        ("", "ends too early"),
        ("1 +", "ends too early"),
        ("1 2", "does not belong"),
        ("1 = 1", "does not belong"),
        ("1 ? 2 : 3", "does not belong"),
        ("1)", "does not belong"),
        ("é", "does not belong"),
        ("1.5", "not a whole number"),
        ("4294967296", "too large"),
        ("1 / 0", "division by zero"),
        ("1 % 0", "division by zero"),
        ("1 << 32", "shift"),
        ("(1", "never closed"),
        ("defined", "wants a name"),
        ("defined 1", "wants a name"),
        ("defined(HOST", "missing"),
    ] {
        refuses(&format!("#if {condition}\n#endif"), part);
    }
    refuses("#define A defined HOST\n#if A\n#endif", "is not a macro");
    let deep = format!("{}1{}", "(".repeat(100_000), ")".repeat(100_000));
    assert_eq!(chosen(&deep).spelled(), "yes");
}

#[test]
fn branches() {
    expands("#if 0\na\n#elif 1\nb\n#elif X\nc\n#else\nd\n#endif", "b");
    expands(
        "#if 0\n#if X\n#nonsense @ é\n#else y\n#endif\n#endif\ne",
        "e",
    );
    expands("#ifdef X\na\n#endif\n#ifndef X\nb\n#endif", "b");
    for (text, part) in [
        ("#if 1", "has no `#endif`"),
        ("#endif", "has no `#if`"),
        ("#else", "has no `#if`"),
        ("#elif 1", "has no `#if`"),
        ("#if 1\n#else\n#else\n#endif", "second `#else`"),
        ("#if 1\n#else\n#elif 1\n#endif", "after `#else`"),
        ("#ifdef X y\n#endif", "should end"),
        ("#ifdef 1\n#endif", "name is missing"),
        ("#if 1\n#endif x", "should end"),
        ("#if 0\n#endif x", "should end"),
        ("#if 1\n#else x\n#endif", "should end"),
    ] {
        refuses(text, part);
    }
}

#[test]
fn lines() {
    expands(
        "a __LINE__\n__LINE__\n#line 10\n__LINE__ \\\n __LINE__",
        "a 1 2 10 11",
    );
    expands("\r\r\n\n\r__LINE__ /*\n*/ __LINE__", "5 6");
    expands("#line 2 * 3 7\n__LINE__ __FILE__", "6 7");
    expands("#define L 20\n#line L\n__LINE__", "20");
    expands(
        "#define F(x, y) x y __LINE__\nF(\n__LINE__,\n__LINE__\n)",
        "3 4 5",
    );
    refuses("#line", "ends too early");
    refuses("#line 1 2 3", "does not belong");
    refuses("#line 1.5", "not a whole number");
    refuses("#line 1 \"a\"", "does not belong");
    refuses("#line 2147483648", "too large");
}

#[test]
fn other_directives() {
    expands("#\n#pragma anything goes é @\nx", "x");
    expands("#pragma optimize(on)\n#pragma debug(off)\n#pragma", "");
    expands("#pragma optimize on\n#pragma STDGL other(x)", "");
    for (text, part) in [
        ("#pragma optimize(x)", "wants `(on)`"),
        ("#pragma debug", "wants `(on)`"),
        ("#pragma STDGL invariant(all)", "fragment shader"),
        ("#error no  way, é", "no way , é"),
        ("#version 310 es", "no other version"),
        ("#version 300", "no other version"),
        ("#extension GL_x", "wants a name"),
        ("#include <x>", "`#include`"),
        ("#nonsense", "no such directive"),
        ("# #define A", "no such directive"),
        ("a # b", "means nothing"),
        ("a \\\n#define B", "means nothing"),
        ("a \\ b", "means nothing"),
        ("x = \"1\";", "means nothing"),
        ("#define A @\nA", "means nothing"),
    ] {
        refuses(text, part);
    }
}
