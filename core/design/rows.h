// Choices of rows of a table, as the searches for rows make them.
#pragma once

#include <functional>
#include <vector>

#include "core/design/design.h"

namespace covaria::detail {

using Rows = std::vector<std::size_t>;  ///< rising

Rows added(Rows rows, std::size_t row);
Rows removed(Rows rows, std::size_t row);
bool contains(const Rows& rows, std::size_t row);

/// Number of choices of k of n; the largest double where there are more.
double number_of_choices(std::size_t n, std::size_t k);
inline constexpr double most_choices = 50'000;  ///< largest number that are all evaluated

/// Rows that a design may choose among.
struct RowChoice {
    explicit RowChoice(const PreparedDesign& design);
    std::size_t count, keep, least;
    Rows fixed, free_rows;
    std::uint64_t seed;

    bool is_fixed(std::size_t row) const { return contains(fixed, row); }
    double number(std::size_t size) const { return number_of_choices(free_rows.size(), size - fixed.size()); }
    /// Gives all choices of this size in lexicographic order, some hundred at a time; `size` is at least that
    /// of the fixed rows.
    void for_all(std::size_t size, const std::function<void(const std::vector<Rows>&)>& take) const;
    /// Random choice of `keep` rows; equal starts give equal rows.
    Rows at_random(std::size_t start) const;
    /// `rows` with a third of those that are not fixed, at least two where there are two, replaced at random.
    Rows shaken(const Rows& rows, std::size_t start) const;
    Rows all() const;
};

}  // namespace covaria::detail
