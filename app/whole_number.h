// Whole numbers as people type them on the command line: 1000000 or 1e6.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class Option;
}

namespace covaria {

/// "1e6", "2.5E3", "1000"; empty for what is no whole number of 64 bits ("1e-3", "1.5", "-4", "6 mm"). Exact:
/// no number goes through a double.
std::optional<std::uint64_t> whole_number(const std::string& text);
/// The option takes whole numbers in all these forms.
CLI::Option* takes_whole_number(CLI::Option* option);

}  // namespace covaria
