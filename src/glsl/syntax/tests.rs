use super::{Parsed, parse, show};
use crate::glsl::names::Names;
use crate::glsl::preprocess::{Options, preprocess};
use crate::source::SourceMap;

fn parsed(text: &str, strict: bool) -> Parsed {
    let mut files = SourceMap::default();
    let file = files.add("a", text);
    let made = preprocess(&files, &[file], &Options::default(), Names::default());
    parse(&made.tokens, made.names, strict)
}

/// The tree of a text, one item a line.
#[track_caller]
fn tree(text: &str) -> String {
    let parsed = parsed(text, true);
    assert_eq!(parsed.diagnostics, [], "{text}");
    show::tree(&parsed.ast)
}

/// The tree of statements.
#[track_caller]
fn body(text: &str) -> String {
    let tree = tree(&format!("void f() {{ {text} }}"));
    let body = tree
        .strip_prefix("fn void f() {")
        .and_then(|tree| tree.strip_suffix('}'));
    body.unwrap_or(&tree).to_owned()
}

/// Each diagnostic as `place: message`, where the place is what it points at.
fn complaints(text: &str, strict: bool) -> Vec<String> {
    let complaints = parsed(text, strict)
        .diagnostics
        .into_iter()
        .map(|diagnostic| {
            let span = diagnostic.span.expect("every diagnostic has a place");
            let place = &text[span.start as usize..span.end as usize];
            match place {
                "" => {
                    let before = text[..span.start as usize].split_whitespace().last();
                    format!("{}‸: {}", before.unwrap_or_default(), diagnostic.message)
                }
                _ => format!("{place}: {}", diagnostic.message),
            }
        });
    complaints.collect()
}

#[track_caller]
fn refused(text: &str, expected: &[&str]) {
    assert_eq!(complaints(text, true), expected, "{text}");
}

#[track_caller]
fn body_refused(text: &str, expected: &[&str]) {
    refused(&format!("void f() {{ {text} }}"), expected);
}

/// Runs with the stack that an unoptimised build may need.
fn with_stack(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(64 << 20).spawn(test);
    thread
        .expect("a thread can start")
        .join()
        .expect("the test passes");
}

#[test]
fn operators_bind_as_specified() {
    for (text, expected) in [
        ("a + b * c - d", "(- (+ a (* b c)) d)"),
        ("a || b ^^ c && d", "(|| a (^^ b (&& c d)))"),
        ("a | b ^ c & d == e", "(| a (^ b (& c (== d e))))"),
        ("a < b << c + d", "(< a (<< b (+ c d)))"),
        ("a - b - c", "(- (- a b) c)"),
        ("a * (b + c)", "(* a (+ b c))"),
        ("-a * !b", "(* (- a) (! b))"),
        ("- -a--", "(- (- (_-- a)))"),
        ("++a.x", "(++_ a.x)"),
        ("a = b += c", "(= a (+= b c))"),
        ("a ? b : c ? d : e", "(? a b (? c d e))"),
        ("a ? b, c : d = e", "(? a (, b c) (= d e))"),
        ("a = b, c <<= d", "(, (= a b) (<<= c d))"),
        ("a[i, j].xy[0]", "a[(, i j)].xy[0]"),
        ("f(void) + f()", "(+ f() f())"),
        ("vec3(a).x", "<vec3>(a).x"),
        ("float[2](a, b)[1]", "<float[2]>(a, b)[1]"),
        ("float[](a).length()", "<float[]>(a).length()"),
        ("x = S[2](a)[0]", "(= x <S[2]>(a)[0])"),
        ("x = S[](a)", "(= x <S[]>(a))"),
        ("S[1][](a)", "<S[1][]>(a)"),
        ("a.length(void)", "a.length()"),
        ("a.input.float", "a.input.float"),
        (
            "x = 1u + 0x10 + 4294967295 + .5",
            "(= x (+ (+ (+ 1u 16) -1) 0.5))",
        ),
        ("(a) = (b)", "(= a b)"),
        ("true ^^ false", "(^^ true false)"),
    ] {
        assert_eq!(body(&format!("{text};")), expected, "{text}");
    }
}

#[test]
fn statements() {
    for (text, expected) in [
        (";", "empty"),
        ("{ a; { } }", "{a; {}}"),
        (
            "if (a) b; else if (c) d; else e;",
            "if a b else if c d else e",
        ),
        ("if (a) if (b) c; else d;", "if a if b c else d"),
        (
            "for (int i = 0; i < 3; i++) a;",
            "for (let int: i = 0 | (< i 3) | (_++ i)) a",
        ),
        ("for (;;) { break; }", "for (empty |  | ) {break}"),
        (
            "for (i = 0; bool b = c; );",
            "for ((= i 0) | let bool: b = c | ) empty",
        ),
        (
            "while (bool b = a) continue;",
            "while let bool: b = a continue",
        ),
        ("do a++; while (a < 3);", "do (_++ a) while (< a 3)"),
        (
            "switch (a) { case 1: b; default: discard; }",
            "switch a {case 1; b; default; discard}",
        ),
        ("return; return a, b;", "return; return (, a b)"),
        ("if (a) float b = 1.;", "if a let float: b = 1.0"),
    ] {
        assert_eq!(body(text), expected, "{text}");
    }
}

#[test]
fn declarations_and_expressions_differ_by_their_shape() {
    for (text, expected) in [
        ("S s;", "let S: s"),
        ("S[2] s;", "let S[2]: s"),
        ("S[N + f(1)] s = x;", "let S[(+ N f(1))]: s = x"),
        ("S[] s = x;", "let S[]: s = x"),
        ("s[2] = x;", "(= s[2] x)"),
        ("S(1);", "S(1)"),
        ("float(x) = 1.;", "(= <float>(x) 1.0)"),
        ("float;", "let float: "),
        ("float[2] a, b[] = c;", "let float[2]: a, b[] = c"),
        ("float[2](1., 2.)[0];", "<float[2]>(1.0, 2.0)[0]"),
        ("const highp float x = 1.;", "let Const High float: x = 1.0"),
        ("struct { int i; } s;", "let struct _ {int: i}: s"),
        ("precision highp float;", "precision High float"),
        ("float g(int);", "fn float g(int _)"),
    ] {
        assert_eq!(body(text), expected, "{text}");
    }
}

#[test]
fn items() {
    for (text, expected) in [
        ("float f(void) { return 1.; }", "fn float f() {return 1.0}"),
        (
            "void f(const in S a[2], out float, vec2[3] b);",
            "fn void f(Const In S a[2], Out float _, vec2[3] b)",
        ),
        ("void f(highp void);", "fn void f()"),
        ("void f(void, int);", "fn void f(void _, int _)"),
        (";", ";"),
        ("int; float, x;", "let int: \nlet float: x"),
        (
            "struct S { float a, b[2]; highp S t; } s, t[2];",
            "let struct S {float: a, b[2]; High S: t}: s, t[2]",
        ),
        (
            "layout(std140, location = 1) uniform;",
            "layout(std140,location=1) Uniform ",
        ),
        ("invariant a;", "Invariant a"),
        (
            "uniform B { float x; } b[2];",
            "block Uniform B {float: x} b[2]",
        ),
        ("flat centroid in int i;", "let Flat Centroid In int: i"),
        ("S f(S s) { }", "fn S f(S s) {}"),
    ] {
        assert_eq!(tree(text), expected, "{text}");
    }
}

#[test]
fn extents_are_all_of_the_tokens() {
    let parsed = parsed("float x = (a + f(b))[1] * -c;", true);
    let extents = parsed.ast.exprs.iter().map(|(_, expr)| {
        let extent = expr.extent;
        (extent.first, expr.at, extent.last)
    });
    let extents: Vec<_> = extents.collect();
    let [a, b, call, sum, one, index, c, minus, product] = *extents else {
        panic!("{extents:?}");
    };
    assert_eq!(
        [a, b, one, c],
        [(4, 4, 4), (8, 8, 8), (12, 12, 12), (16, 16, 16)]
    );
    assert_eq!(call, (6, 6, 9));
    assert_eq!(sum, (3, 5, 10), "with its parentheses");
    assert_eq!(index, (3, 11, 13));
    assert_eq!(minus, (15, 15, 16));
    assert_eq!(product, (3, 14, 16));
}

#[test]
fn what_is_missing_is_missing_behind_the_token_before() {
    body_refused(
        "a = b\n c = d; e = ;",
        &[
            "b‸: a `;` is missing before `c`",
            ";: expected an expression, found `;`",
        ],
    );
    refused(
        "float a\nfloat b;",
        &["a‸: a `;` is missing before `float`"],
    );
    refused(
        "struct S { int i; }\nvoid f() { }",
        &["}‸: a `;` is missing before `void`"],
    );
    refused(
        "struct S { int i; }\nfloat[2] x;",
        &["}‸: a `;` is missing before `float`"],
    );
    refused("void f() {\n{", &["{‸: the text ends too early"]);
    refused("void f()", &["f()‸: the text ends too early"]);
    body_refused("a = b(c(d, e);", &[";: expected `,` or `)`, found `;`"]);
}

#[test]
fn braces() {
    refused(
        "void f() { } }\nvoid g() { } }",
        &["}: there is one `}` too many"],
    );
    refused(
        "void f() { a; } b = c; d = e; }",
        &["b: expected a declaration, found `b`"],
    );
    refused(
        "void f() { {\nvoid g() { a }\nvoid h() { }",
        &[
            "g: a function cannot be defined inside another",
            "a‸: a `;` is missing before `}`",
        ],
    );
}

#[test]
fn one_mistake_is_told_once() {
    for (text, expected) in [
        (
            "for (int i = 0; i < ; i++) { }",
            ";: expected an expression, found `;`",
        ),
        (
            "if (a + ) b = c; else d = e;",
            "): expected an expression, found `)`",
        ),
        (
            "if (a) b = ; else c = d;",
            ";: expected an expression, found `;`",
        ),
        ("if a > b { c; }", "a: expected `(` behind `if`, found `a`"),
        ("x = a ? b;", ";: expected `:`, found `;`"),
        ("a + b = c;", "=: expected `;`, found `=`"),
        ("f(a));", "): expected `;`, found `)`"),
        (
            "float a[2] = {1., 2.};",
            "{: a list in braces is no value in GLSL ES 3.00",
        ),
        (
            "float case = 1.; x = case;",
            "case: `case` is a keyword and cannot be a name",
        ),
        (
            "float const x = 1.;",
            "const: expected a name, found `const`",
        ),
        ("else a;", "else: this `else` has no `if`"),
        ("a = b->c;", ">: expected an expression, found `>`"),
        ("a = (t)b;", "b: expected `;`, found `b`"),
        ("a[];", "]: expected an expression, found `]`"),
        (
            "precise float x;",
            "precise: `precise` is neither a type nor a qualifier",
        ),
    ] {
        body_refused(text, &[expected]);
    }
    for (text, expected) in [
        ("f() { }", "f: expected a type, found `f`"),
        (
            "void f(float x; float y) { }",
            ";: expected `,` or `)`, found `;`",
        ),
        (
            "void f(float x = 1.) { }",
            "=: expected `,` or `)`, found `=`",
        ),
        ("vec<2> x;", "vec: expected a declaration, found `vec`"),
        ("struct S { };", "}: expected a member, found `}`"),
        ("const x = 1.;", "=: expected a name, found `=`"),
    ] {
        refused(text, &[expected]);
    }
}

#[test]
fn errors_in_several_places() {
    refused(
        "float a = ;\nvoid f() { b = ); c + ; }\nfloat d e;",
        &[
            ";: expected an expression, found `;`",
            "): expected an expression, found `)`",
            ";: expected an expression, found `;`",
            "d‸: a `;` is missing before `e`",
        ],
    );
    assert_eq!(
        complaints(&"void f() { a = ; }".repeat(100), true).len(),
        20
    );
}

#[test]
fn reserved_words() {
    refused(
        "float half, x = half;",
        &["half: `half` is a reserved word"],
    );
    let warning = "half: `half` is a reserved word, which WebGL2 refuses";
    assert_eq!(complaints("float half, x = half;", false), [warning]);
    assert!(!parsed("float half;", false).diagnostics[0].is_error());
    // What would be wrong without the rule as well is always an error.
    let error = "static: `static` is a reserved word and means nothing here";
    assert_eq!(complaints("static float x;", false), [error]);
    assert_eq!(complaints("static const float x;", true), [error]);
    refused("float packed, shared, buffer;", &[]);
}

#[test]
fn depth() {
    with_stack(|| {
        let nested = |open: &str, close: &str, depth: usize| {
            let text = format!(
                "void f() {{ x = {}1{}; }}",
                open.repeat(depth),
                close.repeat(depth)
            );
            parsed(&text, true)
                .diagnostics
                .first()
                .map(|diagnostic| diagnostic.code)
        };
        assert_eq!(nested("(", ")", 5_000), None);
        assert_eq!(nested("(", ")", 30_000), Some("too-deep"));
        assert_eq!(nested("f(", ")", 30_000), Some("too-deep"));
        assert_eq!(nested("a||b^^c&&d|e^f&g==h<i<<j+k*(", ")", 1_500), None);
        assert_eq!(
            nested("a||b^^c&&d|e^f&g==h<i<<j+k*(", ")", 30_000),
            Some("too-deep")
        );
        assert_eq!(nested("a + ", "", 19_000), None);
        assert_eq!(nested("", "+ a", 30_000), Some("too-deep"));
        assert_eq!(nested("- ", "", 30_000), Some("too-deep"));
        assert_eq!(nested("a = ", "", 30_000), Some("too-deep"));
        assert_eq!(nested("a ? b : ", "", 30_000), Some("too-deep"));
        assert_eq!(nested("a[", "", 30_000), Some("too-deep"));
        let body = |open: &str, close: &str, depth: usize| {
            let text = format!(
                "void f() {{ {};{} }}",
                open.repeat(depth),
                close.repeat(depth)
            );
            let parsed = parsed(&text, true);
            parsed.diagnostics.first().map(|diagnostic| diagnostic.code)
        };
        assert_eq!(body("{", "}", 990), None);
        for open in [
            "{",
            "if (a) ",
            "if (a) b; else {",
            "for (;;) ",
            "while (a) ",
            "do ",
        ] {
            assert_eq!(body(open, "", 30_000), Some("too-deep"), "{open}");
        }
        assert_eq!(body("if (a) b; else ", "", 2_000), None);
        assert_eq!(body("if (a) b; else ", "", 30_000), Some("too-deep"));
        let ladders = "if (a) b; else if (a) b; else if (a) b; else if (a) {";
        assert_eq!(
            body(ladders, "}", 900),
            Some("too-deep"),
            "a tree of 3,600 statements"
        );
    });
}
