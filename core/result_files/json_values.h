// JSON of results: members in the order in which they are written, null for what is not finite.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace covaria {

using OrderedJson = nlohmann::ordered_json;

inline OrderedJson json_number(double value) {
    return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

}  // namespace covaria
