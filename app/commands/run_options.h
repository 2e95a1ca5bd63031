// Options shared by the commands that evaluate a project.
#pragma once

#include <string>

#include "app/evaluation.h"

namespace CLI {
class App;
}

namespace covaria {

/// Adds FILE, --analysis, --trials, --adaptive, --first-order, --seed, --threads. `request` must outlive the
/// parser.
void add_run_options(CLI::App& command, RunRequest& request);

}  // namespace covaria
