//! What is looked for while frames are drawn, and what is said about it.

use vitrine::render::Gpu;
use vitrine::report;
use vitrine::session::{Findings, Session};
use vitrine::translate::Checks;

use super::opening::explain;

/// What a command looks for: endless loops always, everything with `--sanitize`.
pub fn checks(sanitize: bool) -> Checks {
    if sanitize { Checks::All } else { Checks::Loops }
}

/// Says what went wrong in the frames of a session; with `--sanitize` also that nothing did.
pub fn show_findings(gpu: &Gpu, session: &Session, findings: &mut Findings) -> anyhow::Result<()> {
    if let Err(error) = findings.find_operands(gpu, session) {
        explain(error)?;
    }
    report::show(&findings.report(session));
    if findings.is_empty() && session.setup.options.checks == Checks::All {
        report::tell("nothing undefined or suspicious was seen");
    }
    Ok(())
}
