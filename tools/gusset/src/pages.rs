//! The manual, and completions of shells.

use crate::failure::{Exit, Failure};
use clap::Command;
use clap_complete::Shell;
use std::io::Write;

/// Writes the manual or completions of `command`, which explains all parameters.
pub(crate) fn generate(mut command: Command, what: &str) -> Result<(), Failure> {
    let mut page = Vec::new();
    let shell = match what {
        "bash" => Some(Shell::Bash),
        "zsh" => Some(Shell::Zsh),
        "fish" => Some(Shell::Fish),
        "powershell" => Some(Shell::PowerShell),
        _ => None,
    };
    if let Some(shell) = shell {
        clap_complete::generate(shell, &mut command, "gusset", &mut page);
    } else {
        manual(&command, &mut page).map_err(|error| Failure::new(Exit::File, error.to_string()))?;
    }
    crate::writing::print(&String::from_utf8_lossy(&page))
}

fn manual(command: &Command, page: &mut Vec<u8>) -> std::io::Result<()> {
    let man = clap_mangen::Man::new(command.clone()).date("");
    man.render_title(page)?;
    man.render_name_section(page)?;
    man.render_synopsis_section(page)?;
    man.render_description_section(page)?;
    man.render_options_section(page)?;
    writeln!(page, ".SH COMMANDS")?;
    for sub in command.get_subcommands().filter(|sub| !sub.is_hide_set()) {
        let sub = sub.clone().bin_name(format!("gusset {}", sub.get_name()));
        let man = clap_mangen::Man::new(sub.clone());
        writeln!(page, ".SS gusset {}", sub.get_name())?;
        man.render_synopsis_section(page)?;
        man.render_description_section(page)?;
        man.render_options_section(page)?;
    }
    man.render_extra_section(page)
}
