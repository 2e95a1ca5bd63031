// Options shared by the commands that evaluate a project.
#pragma once

#include <string>

#include "app/evaluation.h"

namespace CLI {
class App;
}

namespace covaria {

// `request` must outlive the parser.

/// Adds how it is evaluated: --trials, --adaptive, --first-order, --variance-reduction, --seed, --threads.
void add_method_options(CLI::App& command, RunRequest& request);
/// --threads alone.
void add_threads_option(CLI::App& command, int& threads);
/// The former and FILE, --analysis, --set, --no-studies.
void add_run_options(CLI::App& command, RunRequest& request);

}  // namespace covaria
