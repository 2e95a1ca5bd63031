// What the program prints, as a terminal may get it.
#pragma once

namespace covaria {

/// From now on control characters in what is printed to standard output and error are shown, not obeyed:
/// names and notes of a project can be anybody's.
void show_control_characters();

/// Whether all that was printed to standard output has arrived; says it if not. At the end of the program.
bool all_is_printed();

}  // namespace covaria
