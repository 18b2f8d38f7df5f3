//! What stands outside of functions.

use arbitrary::Result;

use super::types::{FLOAT, Scalar, Structure, Type};
use super::{Function, Variable, Writer};

impl Writer<'_, '_> {
    pub fn program(&mut self) -> Result<()> {
        for _ in 0..self.below(6)? {
            match self.below(6)? {
                0 | 1 => self.definition()?,
                2 | 3 => self.structure()?,
                _ => self.global()?,
            }
        }
        self.hosts_variables();
        for _ in 0..self.below(4)? {
            match self.below(8)? {
                0 => self.global()?,
                _ => self.function()?,
            }
        }
        let outer = self.variables.len();
        self.put("void mainImage(out vec4 colour, in vec2 position) {\n");
        self.declare("colour", Type::Vector(Scalar::Float, 4));
        self.declare("position", Type::Vector(Scalar::Float, 2));
        self.statements(4)?;
        self.put("}\n");
        self.variables.truncate(outer);
        Ok(())
    }

    /// Makes a variable known.
    pub fn declare(&mut self, name: &str, ty: Type) {
        self.variables.push(Variable {
            name: name.to_owned(),
            ty,
            written: true,
            constant: false,
        });
    }

    fn hosts_variables(&mut self) {
        let vec = |size| Type::Vector(Scalar::Float, size);
        let known = [
            ("iTime", FLOAT),
            ("iResolution", vec(3)),
            ("iMouse", vec(4)),
            ("iFrame", Type::Vector(Scalar::Int, 1)),
            ("iChannelTime", Type::Array(Box::new(FLOAT), 4)),
            ("iChannelResolution", Type::Array(Box::new(vec(3)), 4)),
            ("gl_FragCoord", vec(4)),
        ];
        for (name, ty) in known {
            self.variables.push(Variable {
                name: name.to_owned(),
                ty,
                written: false,
                constant: false,
            });
        }
    }

    fn definition(&mut self) -> Result<()> {
        let name = self.name("M")?;
        let has_parameter = self.below(2)? == 1;
        match has_parameter {
            false => {
                self.put(&format!("#define {name} "));
                self.constant = true;
                let written = self.expression(&FLOAT, 2);
                self.constant = false;
                written?;
            }
            true => {
                let op = self.pick(&["+", "*", "-", "/"])?;
                self.put(&format!("#define {name}(x) ((x) {op} x)"));
            }
        }
        self.put("\n");
        self.macros.push((name, has_parameter));
        Ok(())
    }

    fn structure(&mut self) -> Result<()> {
        let name = self.name("S")?;
        let mut fields = Vec::new();
        self.put(&format!("struct {name} {{ "));
        for i in 0..1 + self.below(4)? {
            let ty = self.any_type()?;
            let text = format!("{} m{i}; ", self.spell(&ty));
            self.put(&text);
            fields.push((format!("m{i}"), ty));
        }
        self.put("};\n");
        self.structures.push(Structure { name, fields });
        Ok(())
    }

    fn global(&mut self) -> Result<()> {
        let ty = self.any_type()?;
        let name = self.name("g")?;
        let constant = self.below(2)? == 1;
        let text = format!(
            "{}{} {name}",
            if constant { "const " } else { "" },
            self.spell(&ty)
        );
        self.put(&text);
        if constant || self.below(2)? == 1 {
            self.put(" = ");
            self.constant = true;
            let written = self.expression(&ty, 3);
            self.constant = false;
            written?;
        }
        self.put(";\n");
        self.variables.push(Variable {
            name,
            ty,
            written: !constant,
            constant,
        });
        Ok(())
    }

    fn function(&mut self) -> Result<()> {
        let name = self.name("f")?;
        let result = match self.below(4)? {
            0 => None,
            _ => Some(self.any_type()?),
        };
        let spelled = match &result {
            None => "void".to_owned(),
            Some(ty) => self.spell(ty),
        };
        self.put(&format!("{spelled} {name}("));
        let outer = self.variables.len();
        let mut parameters = Vec::new();
        for i in 0..self.below(4)? {
            let direction = self.pick(&["", "in ", "const ", "out ", "inout "])?;
            let ty = self.any_type()?;
            let parameter = self.name("p")?;
            let comma = if i > 0 { ", " } else { "" };
            let text = format!("{comma}{direction}{} {parameter}", self.spell(&ty));
            self.put(&text);
            parameters.push((ty.clone(), direction.contains("out")));
            self.variables.push(Variable {
                name: parameter,
                ty,
                written: direction != "const ",
                constant: false,
            });
        }
        self.put(") {\n");
        self.result = result.clone();
        self.statements(3)?;
        if let Some(ty) = &result
            && !self.once_in(8)?
        {
            self.put("return ");
            self.expression(ty, 3)?;
            self.put(";\n");
        }
        self.result = None;
        self.put("}\n");
        self.variables.truncate(outer);
        self.functions.push(Function {
            name,
            result,
            parameters,
        });
        Ok(())
    }
}
