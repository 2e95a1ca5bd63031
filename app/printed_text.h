// Text that the program prints, made safe for a terminal.
#pragma once

namespace covaria {

/// Shows control characters from now on in what is printed to standard output and error, and obeys none:
/// names and notes of a project can be anybody's.
void show_control_characters();

/// Whether everything printed to standard output has arrived; says it if not. At the end of the program.
bool all_is_printed();

}  // namespace covaria
