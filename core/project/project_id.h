// Ids of assets, analyses and studies.
#pragma once

#include <string>

namespace covaria {

/// Whether a text is made of letters, digits, '-' and '_'.
bool is_project_id(const std::string& id);

/// The id made of a name, at most `longest` characters: "Arm X (5)" gives "arm-x-5". It is `otherwise` where
/// nothing is left.
std::string project_id_of(const std::string& name, const std::string& otherwise,
                          std::size_t longest = std::string::npos);

/// The id itself or, where it is taken, the id with the first number from 2 behind it that is free.
template <class IsTaken>
std::string free_id(const std::string& id, IsTaken is_taken) {
    std::string free = id;
    for (int n = 2; is_taken(free); ++n) free = id + "-" + std::to_string(n);
    return free;
}

}  // namespace covaria
