// Counts calls of malloc and its relatives in this thread: proof that a hot loop allocates nothing.
#pragma once

#include <cstddef>

namespace covaria {

/// False in sanitizer builds, which bring their own allocator.
bool allocations_are_counted();
std::size_t allocations_of_this_thread();

}  // namespace covaria
