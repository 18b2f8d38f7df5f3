//! Statements.

use arbitrary::Result;

use super::types::{BOOL, INT};
use super::{Variable, Writer};

impl Writer<'_, '_> {
    /// A few statements in a scope of their own.
    pub fn statements(&mut self, depth: u32) -> Result<()> {
        let outer = self.variables.len();
        for _ in 0..self.below(6)? {
            self.statement(depth)?;
        }
        self.variables.truncate(outer);
        Ok(())
    }

    fn block(&mut self, depth: u32) -> Result<()> {
        self.put("{\n");
        self.statements(depth)?;
        self.put("}\n");
        Ok(())
    }

    fn statement(&mut self, depth: u32) -> Result<()> {
        let deepest = depth == 0;
        match self.below(if deepest { 6 } else { 14 })? {
            0 | 1 => self.assignment()?,
            2 | 3 => self.declaration()?,
            4 => {
                let ty = self.any_type()?;
                self.expression(&ty, 3)?;
                self.put(";\n");
            }
            5 => self.jump()?,
            6 | 7 => {
                self.put("if (");
                self.expression(&BOOL, 2)?;
                self.put(") ");
                self.block(depth - 1)?;
                if self.below(2)? == 1 {
                    self.put("else ");
                    self.block(depth - 1)?;
                }
            }
            8 => self.block(depth - 1)?,
            9 | 10 => self.for_loop(depth - 1)?,
            11 => {
                self.put("while (");
                self.expression(&BOOL, 2)?;
                self.put(") ");
                self.looped(depth - 1)?;
            }
            12 => {
                self.put("do ");
                self.looped(depth - 1)?;
                self.put("while (");
                self.expression(&BOOL, 2)?;
                self.put(");\n");
            }
            _ => self.switch(depth - 1)?,
        }
        Ok(())
    }

    fn looped(&mut self, depth: u32) -> Result<()> {
        self.loops += 1;
        let written = self.block(depth);
        self.loops -= 1;
        written
    }

    fn for_loop(&mut self, depth: u32) -> Result<()> {
        let outer = self.variables.len();
        let name = self.name("i")?;
        let end = self.below(9)?;
        let step = self.pick(&["++", "--", " += 2", " *= 2"])?;
        let op = self.pick(&["<", "<=", ">", "!="])?;
        self.put(&format!(
            "for (int {name} = 0; {name} {op} {end}; {name}{step}) "
        ));
        self.declare(&name, INT);
        self.looped(depth)?;
        self.variables.truncate(outer);
        Ok(())
    }

    fn switch(&mut self, depth: u32) -> Result<()> {
        self.put("switch (");
        self.expression(&INT, 2)?;
        self.put(") {\n");
        self.switches += 1;
        let outer = self.variables.len();
        for i in 0..1 + self.below(4)? {
            match self.once_in(4)? {
                true => self.put("default:\n"),
                false => self.put(&format!("case {i}:\n")),
            }
            for _ in 0..self.below(3)? {
                self.statement(depth)?;
            }
            if self.below(3)? > 0 {
                self.put("break;\n");
            }
        }
        self.variables.truncate(outer);
        self.switches -= 1;
        self.put("}\n");
        Ok(())
    }

    fn jump(&mut self) -> Result<()> {
        match self.below(4)? {
            0 if self.loops > 0 => self.put("continue;\n"),
            0 | 1 if self.loops + self.switches > 0 => self.put("break;\n"),
            2 => self.put("discard;\n"),
            _ => match self.result.clone() {
                None => self.put("return;\n"),
                Some(ty) => {
                    self.put("return ");
                    self.expression(&ty, 2)?;
                    self.put(";\n");
                }
            },
        }
        Ok(())
    }

    fn declaration(&mut self) -> Result<()> {
        let ty = self.any_type()?;
        let name = self.name("v")?;
        let kind = self.below(4)?;
        let text = format!(
            "{}{} {name}",
            if kind == 1 { "const " } else { "" },
            self.spell(&ty)
        );
        self.put(&text);
        if kind > 0 {
            self.put(" = ");
            self.constant = kind == 1;
            let written = self.expression(&ty, 3);
            self.constant = false;
            written?;
        }
        self.put(";\n");
        self.variables.push(Variable {
            name,
            ty,
            written: kind != 1,
            constant: kind == 1,
        });
        Ok(())
    }

    fn assignment(&mut self) -> Result<()> {
        let ty = self.any_written_type()?;
        self.assign(&ty, 3)?;
        self.put(";\n");
        Ok(())
    }
}
