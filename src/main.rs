//! The `vitrine` program: reads the command line, runs a command, sets the exit code.

mod cli;
mod commands;

use std::process::ExitCode;
use std::time::Instant;

use clap::Parser as _;

fn main() -> ExitCode {
    let started = Instant::now();
    let cli = cli::Cli::parse();
    commands::run(cli.command, started).unwrap_or_else(|error| {
        commands::complain(&error);
        commands::HOST_FAILED.into()
    })
}
