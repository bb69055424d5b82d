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

/// Writes the manual: the program, then each command as a subsection.
fn manual(command: &Command, page: &mut Vec<u8>) -> std::io::Result<()> {
    writeln!(page, ".TH GUSSET 1 \"\" \"gusset {}\"", env!("CARGO_PKG_VERSION"))?;
    writeln!(page, ".SH NAME\ngusset \\- {}", crate::commands::SUMMARY)?;
    let man = clap_mangen::Man::new(command.clone());
    page.extend(section(|out| man.render_synopsis_section(out))?);
    page.extend(section(|out| man.render_options_section(out))?);
    writeln!(page, ".SH COMMANDS")?;
    for sub in command.get_subcommands().filter(|sub| !sub.is_hide_set()) {
        let name = sub.get_name();
        writeln!(page, ".SS gusset {name}")?;
        if let Some(example) = sub.get_before_help() {
            writeln!(page, "{}\n.PP", roff_text(&example.to_string()))?;
        }
        let man = clap_mangen::Man::new(sub.clone());
        let parts =
            [section(|out| man.render_description_section(out))?, section(|out| man.render_options_section(out))?];
        for line in String::from_utf8_lossy(&parts.concat()).lines() {
            match line.strip_prefix(".SH ") {
                // The subsection itself describes the command and lists its options.
                Some("DESCRIPTION" | "OPTIONS") => writeln!(page, ".PP")?,
                Some(heading) => writeln!(page, ".PP\n.I {}", heading.trim_matches('"'))?,
                None => writeln!(page, "{line}")?,
            }
        }
    }
    let extra = section(|out| man.render_extra_section(out))?;
    page.extend(String::from_utf8_lossy(&extra).replacen(".SH EXTRA", ".SH FILES AND EXIT STATUS", 1).into_bytes());
    Ok(())
}

/// Renders a section without the definitions that precede each.
fn section(render: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> std::io::Result<Vec<u8>> {
    let mut rendered = Vec::new();
    render(&mut rendered)?;
    let text = String::from_utf8_lossy(&rendered);
    let lines = text.lines().filter(|line| !line.starts_with(".ie ") && !line.starts_with(".el "));
    Ok(lines.map(|line| line.replace("\\*(Aq", "'") + "\n").map(|line| guarded(&line)).collect::<String>().into_bytes())
}

/// Keeps a quote at the start of a line from being a command.
fn guarded(line: &str) -> String {
    if line.starts_with('\'') { format!("\\&{line}") } else { line.to_owned() }
}

fn roff_text(text: &str) -> String {
    text.replace('\\', "\\e").replace('-', "\\-")
}
