// Ids of assets, analyses and studies.
#pragma once

#include <string>

namespace covaria {

/// Made of letters, digits, '-' and '_'.
bool is_project_id(const std::string& id);

/// "Arm X (5)" -> "arm-x-5"; `otherwise` where nothing is left. At most `longest` characters.
std::string project_id_of(const std::string& name, const std::string& otherwise,
                          std::size_t longest = std::string::npos);

/// The id, with the first number from 2 behind it that makes it one that is not taken.
template <class IsTaken>
std::string free_id(const std::string& id, IsTaken is_taken) {
    std::string free = id;
    for (int n = 2; is_taken(free); ++n) free = id + "-" + std::to_string(n);
    return free;
}

}  // namespace covaria
