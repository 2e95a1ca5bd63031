#include "core/equation/place.h"

namespace covaria::equation {

Place joined(const Place& first, const Place& last) {
    const std::size_t end = last.column + last.length;
    if (first.line != last.line || end < first.column) return first;
    return {first.line, first.column, end - first.column};
}

std::string place_words(const Place& place) {
    std::string words = "line " + std::to_string(place.line) + ", column";
    if (place.length > 1)
        words += "s " + std::to_string(place.column) + "-" + std::to_string(place.column + place.length - 1);
    else
        words += " " + std::to_string(place.column);
    return words + ": ";
}

}  // namespace covaria::equation
