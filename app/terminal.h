// Messages and progress of the command line for people, on stderr, never on stdout.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/base/run_control.h"

namespace covaria {

/// Prints "covaria: FILE:LINE: /json/path: message".
void print_error(const Error& error);
/// Prints a line per problem: "FILE:LINE: error: /json/path: message". A warning that has been printed is not
/// printed again: a table of values reads the same project for each row.
void print_problems(const Problems& problems);
void print_message(const std::string& message);

/// A progress callback that keeps one line up to date on a terminal; empty when stderr is not a terminal.
std::function<void(const Progress&)> progress_line(const std::string& what);
/// Puts words in the place of the progress line; nothing when stderr is not a terminal.
void show_progress(const std::string& words);
/// Ends the progress line, if there is one.
void end_progress_line();

}  // namespace covaria
