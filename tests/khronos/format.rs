//! The format that Khronos keeps its shader tests in: groups of cases, each with shaders, values and
//! what is expected of them.
//!
//! `framework/opengl/gluShaderLibrary.cpp` of VK-GL-CTS defines it. What only other versions of the
//! language use (tessellation, geometry, pipelines of programs) is not known here.

use std::fmt;
use std::path::Path;

/// One test.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The names of its groups and its own, with `/` between them.
    pub path: String,
    /// What must come of it.
    pub expectation: Expectation,
    /// Whether it is written in GLSL ES 3.00.
    pub is_es300: bool,
    /// What goes in and what must come out.
    pub values: Values,
    /// The text.
    pub shaders: Shaders,
}

/// What must come of a case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Expectation {
    /// It draws white.
    #[default]
    Pass,
    /// It compiles and links.
    BuildSuccessful,
    /// The compiler refuses it.
    CompileFail,
    /// The linker refuses it, or the compiler already.
    CompileOrLinkFail,
    /// The compiler takes the shaders, the linker refuses them.
    LinkFail,
    /// It builds, but cannot be drawn.
    ValidationFail,
}

/// The text of a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shaders {
    /// A template for a vertex shader and for a fragment shader alike.
    Both(String),
    /// A vertex and a fragment shader.
    Halves {
        /// The vertex shader.
        vertex: String,
        /// The fragment shader.
        fragment: String,
    },
}

/// What goes in and what must come out, in sets: the first elements of all values belong together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    /// What the vertex shader, or the vertices, give to the shader.
    pub inputs: Vec<Value>,
    /// What the shader must compute.
    pub outputs: Vec<Value>,
    /// Uniforms.
    pub uniforms: Vec<Value>,
}

impl Values {
    /// How many sets there are. Without outputs the shader is drawn once all the same.
    pub fn sets(&self) -> usize {
        self.outputs.first().map_or(1, Value::sets)
    }
}

/// A variable and what it is in each set.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// Its name; that of a member of a structure has dots.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// The bits of all components of all sets, matrices column by column.
    pub words: Vec<u32>,
}

impl Value {
    /// How many sets it has elements for.
    pub fn sets(&self) -> usize {
        self.words.len() / self.ty.components()
    }

    /// The components in a set. Uniforms may have fewer sets than outputs: the first then holds for all.
    pub fn set(&self, set: usize) -> &[u32] {
        let set = if set < self.sets() { set } else { 0 };
        let count = self.ty.components();
        &self.words[set * count..][..count]
    }
}

/// A type of one to sixteen numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Type {
    /// What the numbers are.
    pub scalar: Scalar,
    /// 1, but for matrices.
    pub columns: u8,
    /// The number of components of a vector, or of a column.
    pub rows: u8,
}

/// What a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scalar {
    Float,
    Int,
    Uint,
    Bool,
}

impl Type {
    /// The type of this name.
    pub fn named(name: &str) -> Option<Self> {
        let scalar = |scalar| Type::new(scalar, 1, 1);
        match name {
            "float" => return Some(scalar(Scalar::Float)),
            "int" => return Some(scalar(Scalar::Int)),
            "uint" => return Some(scalar(Scalar::Uint)),
            "bool" => return Some(scalar(Scalar::Bool)),
            _ => {}
        }
        if let Some(size) = name.strip_prefix("mat") {
            let (columns, rows) = size.split_once('x').unwrap_or((size, size));
            return Some(Type::new(Scalar::Float, digit(columns)?, digit(rows)?));
        }
        let (letter, rows) = name.split_once("vec")?;
        let scalar = match letter {
            "" => Scalar::Float,
            "i" => Scalar::Int,
            "u" => Scalar::Uint,
            "b" => Scalar::Bool,
            _ => return None,
        };
        Some(Type::new(scalar, 1, digit(rows)?))
    }

    fn new(scalar: Scalar, columns: u8, rows: u8) -> Self {
        Type {
            scalar,
            columns,
            rows,
        }
    }

    /// Of how many numbers it is.
    pub fn components(self) -> usize {
        usize::from(self.columns) * usize::from(self.rows)
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, letter) = match self.scalar {
            Scalar::Float => ("float", ""),
            Scalar::Int => ("int", "i"),
            Scalar::Uint => ("uint", "u"),
            Scalar::Bool => ("bool", "b"),
        };
        match (self.columns, self.rows) {
            (1, 1) => f.write_str(name),
            (1, rows) => write!(f, "{letter}vec{rows}"),
            (columns, rows) if columns == rows => write!(f, "mat{columns}"),
            (columns, rows) => write!(f, "mat{columns}x{rows}"),
        }
    }
}

fn digit(text: &str) -> Option<u8> {
    text.parse().ok().filter(|size| (2..=4).contains(size))
}

/// Reads a file, and what it imports from the same folder.
pub fn read(path: &Path) -> Result<Vec<Case>, String> {
    let in_file = |error: &dyn fmt::Display| format!("{}: {error}", path.display());
    let bytes = std::fs::read(path).map_err(|error| in_file(&error))?;
    let import = |name: &str| read(&path.with_file_name(name));
    parse(&String::from_utf8_lossy(&bytes), &import).map_err(|error| in_file(&error))
}

/// Reads a text. `import` reads another file.
fn parse(
    text: &str,
    import: &dyn Fn(&str) -> Result<Vec<Case>, String>,
) -> Result<Vec<Case>, String> {
    let mut parser = Parser {
        tokens: Vec::new(),
        next: 0,
        import,
        groups: Vec::new(),
        cases: Vec::new(),
    };
    let mut lexer = Lexer { text, at: 0 };
    while let Some(token) = lexer.next()? {
        parser.tokens.push((token, lexer.at));
    }
    parser
        .nodes(false)
        .map_err(|error| match parser.tokens.get(parser.next) {
            Some((token, end)) => {
                format!("line {}, at {token:?}: {error}", line(&text[..*end]))
            }
            None => format!("at the end: {error}"),
        })?;
    Ok(parser.cases)
}

/// The line that this text ends in.
fn line(text: &str) -> usize {
    text.matches('\n').count() + 1
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Token {
    /// A word, a number or a sign.
    Word(String),
    /// In single or double quotes.
    Text(String),
    /// In doubled double quotes.
    Source(String),
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
}

impl Lexer<'_> {
    fn next(&mut self) -> Result<Option<Token>, String> {
        self.skip_blanks();
        let rest = &self.text[self.at..];
        let Some(first) = rest.chars().next() else {
            return Ok(None);
        };
        if let Some(quoted) = rest.strip_prefix("\"\"") {
            return self.source(quoted).map(Some);
        }
        if first == '"' || first == '\'' {
            let (text, len) = self.unescape(&rest[1..], &rest[..1])?;
            self.at += len + 2;
            return Ok(Some(Token::Text(text)));
        }
        let len = match first {
            'a'..='z' | 'A'..='Z' => rest
                .find(|c: char| !(c.is_ascii_alphanumeric() || "_-.".contains(c)))
                .unwrap_or(rest.len()),
            '0'..='9' => number_len(rest),
            _ => first.len_utf8(),
        };
        self.at += len;
        Ok(Some(Token::Word(rest[..len].to_owned())))
    }

    fn source(&mut self, quoted: &str) -> Result<Token, String> {
        let (text, len) = self.unescape(quoted, "\"\"")?;
        self.at += len + 4;
        // What stands behind the opening quotes is no line of the shader.
        let text = text.trim_start_matches(' ');
        let text = text.strip_prefix('\r').unwrap_or(text);
        let text = text.strip_prefix('\n').unwrap_or(text);
        Ok(Token::Source(without_indentation(text)))
    }

    fn skip_blanks(&mut self) {
        loop {
            let rest = &self.text[self.at..];
            let blanks = rest.len() - rest.trim_start_matches([' ', '\t', '\r', '\n']).len();
            self.at += blanks;
            let rest = &rest[blanks..];
            if !rest.starts_with('#') {
                return;
            }
            self.at += rest.find(['\r', '\n']).unwrap_or(rest.len());
        }
    }

    /// What stands before the closing quotes, and how long it is as it is written.
    fn unescape(&self, rest: &str, close: &str) -> Result<(String, usize), String> {
        let mut text = String::new();
        let mut chars = rest.char_indices();
        while let Some((at, c)) = chars.next() {
            if rest[at..].starts_with(close) {
                return Ok((text, at));
            }
            text.push(match c {
                '\\' => match chars.next().ok_or("nothing behind a backslash")?.1 {
                    'n' => '\n',
                    't' => '\t',
                    other => other,
                },
                other => other,
            });
        }
        let line = line(&self.text[..self.at]);
        Err(format!("line {line}: a quotation does not end"))
    }
}

/// Takes the indentation of the first line from all lines: line continuation makes it matter.
fn without_indentation(text: &str) -> String {
    let width = |c: char| if c == '\t' { 4 } else { 1 };
    let blanks = &text[..text.len() - text.trim_start().len()];
    let indentation: usize = blanks.chars().map(width).sum();
    let lines = text.split_inclusive('\n').map(|line| {
        let mut taken = 0;
        line.trim_start_matches(|c| {
            let is_indentation = taken < indentation && (c == ' ' || c == '\t');
            taken += width(c);
            is_indentation
        })
    });
    lines.collect()
}

/// The length of the number at the beginning: digits, and a fraction with an exponent if there is a point.
fn number_len(text: &str) -> usize {
    let digits = |from: usize| {
        let rest = &text[from..];
        from + rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len()
    };
    let whole = digits(0);
    if !text[whole..].starts_with('.') {
        return whole;
    }
    let fraction = digits(whole + 1);
    let Some(exponent) = text[fraction..].strip_prefix(['e', 'E']) else {
        return fraction;
    };
    let sign = usize::from(exponent.starts_with(['+', '-']));
    digits(fraction + 1 + sign)
}

struct Parser<'a> {
    /// Each with the place behind it.
    tokens: Vec<(Token, usize)>,
    next: usize,
    import: &'a dyn Fn(&str) -> Result<Vec<Case>, String>,
    groups: Vec<String>,
    cases: Vec<Case>,
}

type Parsed<T> = Result<T, String>;

impl Parser<'_> {
    /// What stands in a file or in a group.
    fn nodes(&mut self, in_group: bool) -> Parsed<()> {
        loop {
            if self.next == self.tokens.len() && !in_group {
                return Ok(());
            }
            match self.word()?.as_str() {
                "end" if in_group => return Ok(()),
                "group" => {
                    let name = self.word()?;
                    self.groups.push(name);
                    self.text()?;
                    self.nodes(true)?;
                    self.groups.pop();
                }
                "case" => {
                    let case = self.case()?;
                    self.cases.push(case);
                }
                "import" => {
                    let name = self.text()?;
                    let mut imported = (self.import)(&name)?;
                    for case in &mut imported {
                        case.path = self.path(&case.path);
                    }
                    self.cases.append(&mut imported);
                }
                _ => return Err(self.unexpected("a case, a group or an import")),
            }
        }
    }

    fn path(&self, name: &str) -> String {
        let mut path = self.groups.join("/");
        if !path.is_empty() {
            path.push('/');
        }
        path + name
    }

    fn case(&mut self) -> Parsed<Case> {
        let name = self.word()?;
        let mut expectation = Expectation::default();
        let mut is_es300 = None;
        let mut values = Values::default();
        let (mut both, mut vertex, mut fragment) = (None, None, None);
        loop {
            match self.word()?.as_str() {
                "end" => break,
                "desc" => drop(self.text()?),
                "expect" => expectation = self.expectation()?,
                "version" => is_es300 = Some(self.version()?),
                "require" => drop(self.word()?),
                "values" => values = self.values()?,
                "both" => both = Some(self.source()?),
                "vertex" => vertex = Some(self.source()?),
                "fragment" => fragment = Some(self.source()?),
                _ => return Err(self.unexpected("a part of a case")),
            }
        }
        let shaders = match (both, vertex, fragment) {
            (Some(text), None, None) => Shaders::Both(text),
            (None, Some(vertex), Some(fragment)) => Shaders::Halves { vertex, fragment },
            _ => {
                return Err(format!(
                    "`{name}` needs `both`, or a vertex and a fragment shader"
                ));
            }
        };
        let text = match &shaders {
            Shaders::Both(text) | Shaders::Halves { fragment: text, .. } => text,
        };
        Ok(Case {
            path: self.path(&name),
            expectation,
            // Some cases say it in the shader only.
            is_es300: is_es300.unwrap_or_else(|| text.trim_start().starts_with("#version 300 es")),
            values,
            shaders,
        })
    }

    fn expectation(&mut self) -> Parsed<Expectation> {
        Ok(match self.word()?.as_str() {
            "pass" => Expectation::Pass,
            "build_successful" => Expectation::BuildSuccessful,
            "compile_fail" => Expectation::CompileFail,
            "compile_or_link_fail" => Expectation::CompileOrLinkFail,
            "link_fail" => Expectation::LinkFail,
            "validation_fail" => Expectation::ValidationFail,
            _ => return Err(self.unexpected("what to expect")),
        })
    }

    fn version(&mut self) -> Parsed<bool> {
        let number = self.word()?;
        let is_es = self.accept("es");
        Ok(number == "300" && is_es)
    }

    fn values(&mut self) -> Parsed<Values> {
        let mut values = Values::default();
        self.expect("{")?;
        loop {
            let list = match self.word()?.as_str() {
                "}" => return Ok(values),
                "input" => &mut values.inputs,
                "output" => &mut values.outputs,
                "uniform" => &mut values.uniforms,
                _ => return Err(self.unexpected("`input`, `output` or `uniform`")),
            };
            list.push(self.value()?);
        }
    }

    fn value(&mut self) -> Parsed<Value> {
        let ty = Type::named(&self.word()?).ok_or_else(|| self.unexpected("a type"))?;
        let name = match self.token()? {
            Token::Word(name) | Token::Text(name) => name,
            Token::Source(_) => return Err(self.unexpected("a name")),
        };
        self.expect("=")?;
        let mut words = Vec::new();
        if self.accept("[") {
            loop {
                self.element(ty, &mut words)?;
                if self.accept("]") {
                    break;
                }
                self.expect("|")?;
            }
        } else {
            self.element(ty, &mut words)?;
        }
        self.expect(";")?;
        Ok(Value { name, ty, words })
    }

    fn element(&mut self, ty: Type, words: &mut Vec<u32>) -> Parsed<()> {
        if ty.components() == 1 {
            words.push(self.number(ty.scalar)?);
            return Ok(());
        }
        self.expect(&ty.to_string())?;
        for i in 0..ty.components() {
            self.expect(if i == 0 { "(" } else { "," })?;
            words.push(self.number(ty.scalar)?);
        }
        self.expect(")")
    }

    fn number(&mut self, scalar: Scalar) -> Parsed<u32> {
        let is_negative = self.accept("-");
        let word = self.word()?;
        let bits = match scalar {
            Scalar::Bool if word == "true" => Some(1),
            Scalar::Bool if word == "false" => Some(0),
            Scalar::Bool => None,
            Scalar::Float => word.parse().ok().map(|value: f32| {
                let value = if is_negative { -value } else { value };
                value.to_bits()
            }),
            Scalar::Int | Scalar::Uint => word.parse().ok().map(|value: u32| {
                if is_negative {
                    value.wrapping_neg()
                } else {
                    value
                }
            }),
        };
        bits.ok_or_else(|| self.unexpected("a number"))
    }

    fn token(&mut self) -> Parsed<Token> {
        let (token, _) = self.tokens.get(self.next).ok_or("something is missing")?;
        self.next += 1;
        Ok(token.clone())
    }

    fn word(&mut self) -> Parsed<String> {
        match self.token()? {
            Token::Word(word) => Ok(word),
            _ => Err(self.unexpected("a word")),
        }
    }

    fn text(&mut self) -> Parsed<String> {
        match self.token()? {
            Token::Text(text) => Ok(text),
            // An empty text looks like the beginning of a shader, as far as Khronos' own lexer goes.
            _ => Err(self.unexpected("a text in quotes")),
        }
    }

    fn source(&mut self) -> Parsed<String> {
        match self.token()? {
            Token::Source(text) => Ok(text),
            _ => Err(self.unexpected("a shader in doubled quotes")),
        }
    }

    fn accept(&mut self, word: &str) -> bool {
        let found = self.tokens.get(self.next);
        let is_it = found.is_some_and(|(token, _)| *token == Token::Word(word.to_owned()));
        self.next += usize::from(is_it);
        is_it
    }

    fn expect(&mut self, word: &str) -> Parsed<()> {
        match self.token()? {
            Token::Word(found) if found == word => Ok(()),
            _ => Err(self.unexpected(&format!("`{word}`"))),
        }
    }

    /// Blames the token that was read last.
    fn unexpected(&mut self, wanted: &str) -> String {
        self.next -= 1;
        format!("expected {wanted}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cases(text: &str) -> Vec<Case> {
        let import = |name: &str| match name {
            "other.test" => parse("case inner both \"\"x\"\" end", &|_| unreachable!()),
            _ => Err("no such file".to_owned()),
        };
        parse(text, &import).expect("a text that follows the format")
    }

    #[test]
    fn groups_give_paths() {
        let found = cases(
            "# a remark\n\
             group a \"first\" group uniform \"odd name\" case b.1-x both \"\"\"\" end end\n\
             import \"other.test\" end\n\
             case c vertex \"\"v\"\" fragment \"\" \nf\"\" end",
        );
        let paths: Vec<_> = found.iter().map(|case| case.path.as_str()).collect();
        assert_eq!(paths, ["a/uniform/b.1-x", "a/inner", "c"]);
        let halves = Shaders::Halves {
            vertex: "v".to_owned(),
            fragment: "f".to_owned(),
        };
        assert_eq!(found[2].shaders, halves);
    }

    #[test]
    fn values_are_read_set_by_set() {
        let found = cases(
            "case a version 300 es expect build_successful\n\
             values {\n\
               input float in0 = [ 1.0 | -2.5e1 ];\n\
               input bvec2 in1 = [ bvec2(true, false) | bvec2(false, true) ];\n\
               output mat2x3 out0 = mat2x3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);\n\
               output int 'out 1' = [ -3 | 4 ];\n\
               uniform uint s.u = 4294967295;\n\
             }\n\
             both \"\"\n  text\\n\\\\ \"quoted\"\n\"\" end",
        );
        let [case] = found.as_slice() else {
            panic!("one case, not {found:?}")
        };
        assert!(case.is_es300);
        assert_eq!(case.expectation, Expectation::BuildSuccessful);
        let Values {
            inputs,
            outputs,
            uniforms,
        } = &case.values;
        assert_eq!(inputs[0].words, [1.0_f32, -25.0].map(f32::to_bits));
        assert_eq!(inputs[0].sets(), 2);
        assert_eq!(inputs[1].set(1), [0, 1]);
        assert_eq!(outputs[0].ty.to_string(), "mat2x3");
        assert_eq!(outputs[0].set(0)[5], 6.0_f32.to_bits());
        assert_eq!(outputs[1].name, "out 1");
        assert_eq!(outputs[1].words, [-3_i32 as u32, 4]);
        assert_eq!(uniforms[0].name, "s.u");
        assert_eq!(uniforms[0].set(1), [u32::MAX]);
        let text = Shaders::Both("text\n\\ \"quoted\"\n".to_owned());
        assert_eq!(case.shaders, text);
    }

    #[test]
    fn indentation_is_taken_away() {
        assert_eq!(without_indentation("  a\n    b\n c\n\td"), "a\n  b\nc\nd");
    }

    #[test]
    fn the_version_may_stand_in_the_shader() {
        let found = cases("case a both \"\"\n#version 300 es\n\"\" end case b both \"\"\"\" end");
        assert_eq!([found[0].is_es300, found[1].is_es300], [true, false]);
    }

    #[test]
    fn errors_name_the_line() {
        let error = parse("case a\n expect pass\n wonder\nend", &|_| unreachable!());
        assert_eq!(
            error,
            Err("line 3, at Word(\"wonder\"): expected a part of a case".to_owned())
        );
        assert!(parse("case a both \"\" x", &|_| unreachable!()).is_err());
    }

    #[test]
    fn types_have_their_names() {
        for name in ["float", "uint", "ivec3", "bvec2", "vec4", "mat2", "mat4x3"] {
            let ty = Type::named(name).expect("a type");
            assert_eq!(ty.to_string(), name);
        }
        for name in ["vec5", "dvec2", "mat3x1", "void"] {
            assert_eq!(Type::named(name), None, "{name}");
        }
    }
}
