use super::{expands, refuses, run, run_with};

#[test]
fn macros_without_parameters() {
    expands("#define A 1 + B\n#define B 2\nA A", "1 + 2 1 + 2");
    expands("#define EMPTY\na EMPTY b", "a b");
    expands("#define A 1\n#undef A\nA", "A");
    expands("#define A 1 /* one */ + 1 // two\nA", "1 + 1");
    expands("#define A (x)\nA", "( x )");
    expands("#define A 1 \\\n  + 2\r\nA", "1 + 2");
    expands("#define A x ## y @\nb", "b");
}

#[test]
fn words_of_the_language_may_be_macros() {
    for (word, what) in [
        ("float", "a word"),
        ("half", "a word"),
        ("mix", "a function"),
    ] {
        let outcome = run(&format!("#define {word} a\n{word} x"));
        assert_eq!(outcome.spelled(), "a x");
        let message = format!("the macro `{word}` hides {what} of the language");
        assert_eq!(outcome.messages(), [message]);
        assert!(!outcome.has_errors());
    }
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
    expands("#define P 1, 2\n#define F(x) f(x)\nF(P)", "f ( 1 , 2 )");
    refuses("#define F(x) x\nF(1, 2)", "takes 1 argument, not 2");
    refuses("#define F() x\nF(1)", "takes 0 arguments, not 1");
    refuses("#define F(x) x\nF([1, 2])", "takes 1 argument, not 2");
    refuses("#define F(x) x\nF(1", "never closed");
    refuses("#define F(x, x) x", "same name");
    refuses("#define F(x y) x", "commas between");
    refuses("#define F(...) x", "commas between");
    refuses("#define F(x", "never closed");
}

#[test]
fn a_macro_does_not_expand_within_itself() {
    expands("#define A A\nA", "A");
    expands("#define A B\n#define B A\nA B", "A B");
    expands("#define f(x) f(x + 1)\nf(f(1))", "f ( f ( 1 + 1 ) + 1 )");
    expands("#define f(x) x f\nf(1)(2)", "1 f ( 2 )");
}

#[test]
fn tokens_know_where_they_come_from() {
    let text = "#define TWO 1 + one\n#define F(x) G(x, TWO)\n#define G(x, y) x y z\n\
                a F(b TWO)";
    let outcome = run(text);
    let places: Vec<_> = outcome
        .tokens
        .iter()
        .map(|(spelled, span, origin)| {
            let origin = origin.map(|origin| outcome.written(origin));
            (&**spelled, outcome.written(*span), origin)
        })
        .collect();
    assert_eq!(
        places,
        [
            ("a", "a", None),
            ("b", "b", None),
            ("1", "TWO", Some("1")),
            ("+", "TWO", Some("+")),
            ("one", "TWO", Some("one")),
            ("1", "F", Some("1")),
            ("+", "F", Some("+")),
            ("one", "F", Some("one")),
            ("z", "F", Some("z")),
        ]
    );
    let used = outcome.tokens[2].1;
    assert_eq!(used.start as usize, text.rfind("TWO").unwrap());
}

#[test]
fn complaints_about_macros_have_notes() {
    let notes = |text: &str| -> Vec<String> {
        let outcome = run(text);
        let first = &outcome.diagnostics[0];
        let place = outcome.written(first.span.unwrap());
        let notes = first.notes.iter();
        let notes = notes.map(|(span, note)| format!("{}: {note}", outcome.written(*span)));
        std::iter::once(place.to_owned()).chain(notes).collect()
    };
    assert_eq!(
        notes("#define F(x) x\nF(1, 2)"),
        ["F", "F: `F` is defined here"]
    );
    assert_eq!(
        notes("#define A 1 @\nA"),
        ["A", "@: a macro brings it from here"]
    );
    assert_eq!(
        notes("#define A 1\n#define A 2"),
        ["A", "A: it is defined here first"]
    );
}

#[test]
fn the_user_overrides_the_text() {
    let overrides = [
        ("N", "f(1, M)"),
        ("M", "2 +"),
        ("UNUSED", ""),
        ("HOST", "5"),
    ];
    for (text, expected) in [
        ("N", "f ( 1 , 2 + )"),
        ("#define N 3\nN", "f ( 1 , 2 + )"),
        ("#define N(x) x\n#undef N\n#define N 4\nM", "2 +"),
        ("#ifdef M\nM\n#endif", "2 +"),
        ("#if HOST == 5\nHOST M\n#endif", "5 2 +"),
    ] {
        let outcome = run_with(text, false, &overrides);
        assert_eq!(outcome.spelled(), expected, "{text}");
        assert_eq!(outcome.messages(), [""; 0], "{text}");
        assert!(outcome.unused.contains(&"UNUSED".to_owned()), "{text}");
        assert!(!outcome.unused.contains(&"M".to_owned()), "{text}");
    }
    let outcome = run_with("#define A N\n#define M 7\nM", false, &overrides);
    assert_eq!(outcome.unused, ["UNUSED", "HOST"]);
    let (_, span, origin) = outcome.tokens[0];
    assert_eq!(outcome.written(origin.unwrap()), "M");
    assert!(origin.unwrap().start < span.start);
    for (name, part) in [
        ("3x", "is no name"),
        ("F(x)", "is no name"),
        ("", "is no name"),
        ("GL_ES", "reserved"),
        ("defined", "reserved"),
    ] {
        let outcome = run_with("", false, &[(name, "1")]);
        assert!(outcome.messages()[0].contains(part), "{name}");
    }
}

#[test]
fn endless_expansions_are_refused() {
    let mut bomb = String::from("#define M0 x\n");
    for level in 1..40 {
        let inner = level - 1;
        bomb += &format!("#define M{level} M{inner} M{inner}\n");
    }
    refuses(&(bomb + "M39"), "`M39` expands without end");
    let mut bomb = String::from("#define D(x) x x\n");
    bomb += &"D(".repeat(40);
    bomb += &")".repeat(40);
    expands(&bomb, "");
    refuses(&bomb.replace("()", "(y)"), "`D` expands without end");
}

#[test]
fn depth_costs_no_stack() {
    let nest = |depth: usize| {
        format!(
            "#define F(x) x\n{}1{}",
            "F(".repeat(depth),
            ")".repeat(depth)
        )
    };
    expands(&nest(1000), "1");
    refuses(&nest(1001), "more than 1000 deep");
    refuses(&nest(20_000), "expands without end");
    let brackets = "(".repeat(50_000) + &")".repeat(50_000);
    let outcome = run(&format!("#define F(x) x\nF(F({brackets}))"));
    assert_eq!(outcome.tokens.len(), 100_000);
    assert!(!outcome.has_errors());
}
