// Ids of assets, analyses and studies.
#pragma once

#include <algorithm>
#include <string>

namespace covaria {

/// Made of letters, digits, '-' and '_'.
inline bool is_project_id(const std::string& id) {
    return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
}

}  // namespace covaria
