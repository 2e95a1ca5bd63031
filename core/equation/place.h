// Places in the text of equations, and what is wrong there.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace covaria::equation {

/// A part of one line. Columns count characters, not bytes.
struct Place {
    std::size_t line = 1;    ///< counts from 1
    std::size_t column = 1;  ///< counts from 1
    std::size_t length = 1;  ///< characters; 0 = behind the last one
};

/// Place from the begin of `first` to the end of `last`, if both are on one line; else `first`.
Place joined(const Place& first, const Place& last);

struct TextProblem {
    Place place;
    Message message;  ///< without the place
    /// Text of the name ("t") whose temperatures in degC the problem is about, and each of their places;
    /// empty: it is about something else.
    std::string reading = {};
    std::vector<Place> readings = {};
};
using TextProblems = std::vector<TextProblem>;

/// "line 2, columns 14-16: ".
Message place_words(const Place& place);

}  // namespace covaria::equation
