//! A run as its user follows it: progress, Ctrl-C, and a cancel after a time.

use crate::plugin::Watcher;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};
use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Returns the flag that becomes true once the user asks to stop. The first call catches Ctrl-C and SIGTERM: the first one sets the
/// flag, and a second one ends the program at once.
pub(crate) fn stop_flag() -> &'static Arc<AtomicBool> {
    static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();
    FLAG.get_or_init(|| {
        const STATUS_OF_INTERRUPT: i32 = 130;
        let flag = Arc::new(AtomicBool::new(false));
        for signal in [SIGINT, SIGTERM] {
            // Without the handlers a signal ends the program, as usual.
            let _ = signal_hook::flag::register_conditional_shutdown(signal, STATUS_OF_INTERRUPT, Arc::clone(&flag));
            let _ = signal_hook::flag::register(signal, Arc::clone(&flag));
        }
        flag
    })
}

/// Makes the end of a file's permitted size an error of writing. By default the signal for it ends the program.
pub(crate) fn catch_size_limit() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// Returns whether the user has asked to stop.
pub(crate) fn is_stopped() -> bool {
    stop_flag().load(Ordering::Relaxed)
}

/// Follows one run.
pub(crate) struct Steering {
    bar: Option<ProgressBar>,
    is_terminal: bool,
    deadline: Option<Instant>,
    /// The last line that was written without a terminal.
    last_line: std::cell::RefCell<String>,
}

impl Steering {
    /// `shown`: progress goes to standard error. `cancel_after`: time from now.
    pub(crate) fn new(shown: bool, cancel_after: Option<Duration>) -> Self {
        stop_flag();
        let is_terminal = std::io::stderr().is_terminal();
        let bar = (shown && is_terminal).then(|| {
            const STEPS: u64 = 1000;
            let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::stderr());
            if let Ok(style) = ProgressStyle::with_template("[{bar:30}] {percent:>3} % {msg}") {
                bar.set_style(style.progress_chars("##."));
            }
            bar
        });
        let deadline = cancel_after.map(|time| Instant::now() + time);
        let last_line = if shown && !is_terminal { String::new() } else { "-".into() };
        Self { bar, is_terminal, deadline, last_line: last_line.into() }
    }

    /// Returns the time since the deadline, if it has passed.
    pub(crate) fn time_since_deadline(&self) -> Option<Duration> {
        self.deadline.and_then(|deadline| Instant::now().checked_duration_since(deadline))
    }

    /// Removes the bar.
    pub(crate) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    fn show_line(&self, fraction: f64, stage: &str) {
        let mut last = self.last_line.borrow_mut();
        if *last == "-" {
            return;
        }
        const WIDTH: usize = 30;
        let filled = (fraction * WIDTH as f64) as usize;
        let line =
            format!("[{}{}] {} % {stage}", "#".repeat(filled), ".".repeat(WIDTH - filled), (fraction * 100.0) as u32);
        if line != *last {
            crate::writing::tell!("{line}");
            *last = line;
        }
    }
}

impl Watcher for Steering {
    fn progress(&self, fraction: f64, stage: &str) -> bool {
        // Plugins may pass NaN.
        let fraction = if fraction > 0.0 { fraction.min(1.0) } else { 0.0 };
        if let Some(bar) = &self.bar {
            bar.set_position((fraction * 1000.0) as u64);
            if bar.message() != stage {
                bar.set_message(stage.to_owned());
            }
        } else if !self.is_terminal {
            self.show_line(fraction, stage);
        }
        is_stopped() || self.time_since_deadline().is_some()
    }

    fn remark(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.println(text),
            None => crate::writing::tell!("{text}"),
        }
    }
}
