// Lists of problems that people can read.
#pragma once

#include "core/base/error.h"

namespace covaria {

/// Number of problems of a kind (same severity, file and place but for the row) that stay; one more problem
/// counts the rest: a column of 80,000 wrong cells is one mistake.
inline constexpr std::size_t most_of_a_kind = 100;
void count_beyond_a_hundred(Problems& problems);
/// "and 7 more like these"
Message counted_words(std::size_t more);

}  // namespace covaria
