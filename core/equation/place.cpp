#include "core/equation/place.h"

namespace covaria::equation {

Place joined(const Place& first, const Place& last) {
    const std::size_t end = last.column + last.length;
    if (first.line != last.line || end < first.column) return first;
    return {first.line, first.column, end - first.column};
}

Message place_words(const Place& place) {
    if (place.length <= 1) return tell<"line %1, column %2: ">(place.line, place.column);
    return tell<"line %1, columns %2-%3: ">(place.line, place.column, place.column + place.length - 1);
}

}  // namespace covaria::equation
