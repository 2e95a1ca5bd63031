// Counts the uses of the heap, to prove that there are none.
#pragma once

#include <cstddef>

namespace covaria {

/// Calls of operator new by this thread so far.
std::size_t allocation_count();

}  // namespace covaria
