#include "core/design/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random/uniforms.h"

namespace covaria::detail {

Rows added(Rows rows, std::size_t row) {
    rows.insert(std::lower_bound(rows.begin(), rows.end(), row), row);
    return rows;
}

Rows removed(Rows rows, std::size_t row) {
    rows.erase(std::lower_bound(rows.begin(), rows.end(), row));
    return rows;
}

bool contains(const Rows& rows, std::size_t row) {
    return std::binary_search(rows.begin(), rows.end(), row);
}

double number_of_choices(std::size_t n, std::size_t k) {
    double number = 1.0;
    for (std::size_t i = 1; i <= std::min(k, n - k); ++i)
        number = number * static_cast<double>(n - i + 1) / static_cast<double>(i);
    return std::min(std::round(number), std::numeric_limits<double>::max());
}

RowChoice::RowChoice(const PreparedDesign& design)
    : count(design.table->rows.rows.size()),
      keep(design.design.choose->keep),
      least(std::max<std::size_t>(1, design.table->least)),
      fixed(design.design.choose->fixed),
      seed(design.design.seed) {
    std::sort(fixed.begin(), fixed.end());
    for (std::size_t row = 0; row < count; ++row)
        if (!is_fixed(row)) free_rows.push_back(row);
}

void RowChoice::for_all(std::size_t size, const std::function<void(const std::vector<Rows>&)>& take) const {
    constexpr std::size_t batch = 512;
    std::vector<bool> taken(free_rows.size(), false);
    std::fill_n(taken.begin(), size - fixed.size(), true);
    std::vector<Rows> choices;
    do {
        Rows rows = fixed;
        for (std::size_t i = 0; i < taken.size(); ++i)
            if (taken[i]) rows.push_back(free_rows[i]);
        std::sort(rows.begin(), rows.end());
        choices.push_back(std::move(rows));
        if (choices.size() < batch) continue;
        take(choices);
        choices.clear();
    } while (std::prev_permutation(taken.begin(), taken.end()));
    if (!choices.empty()) take(choices);
}

Rows RowChoice::at_random(std::size_t start) const {
    Rows rows = fixed, left = free_rows;
    std::vector<double> u(left.size());
    uniforms(seed, DrawPurpose::design_starts, static_cast<std::uint32_t>(start), 0, u);
    for (std::size_t i = 0; rows.size() < keep; ++i) {  // Fisher and Yates
        const auto last = static_cast<double>(left.size() - i);
        std::swap(left[i], left[i + static_cast<std::size_t>(u[i] * last)]);
        rows.push_back(left[i]);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

Rows RowChoice::shaken(const Rows& rows, std::size_t start) const {
    Rows in, out;
    for (const std::size_t row : free_rows) (contains(rows, row) ? in : out).push_back(row);
    const std::size_t changes = std::min({std::max<std::size_t>(2, in.size() / 3), in.size(), out.size()});
    std::vector<double> u(2 * changes);
    uniforms(seed, DrawPurpose::design_starts, static_cast<std::uint32_t>(start), 0, u);
    Rows other = rows;
    const auto draw = [](Rows& from, double at) {
        const auto i = from.begin() + static_cast<std::ptrdiff_t>(at * static_cast<double>(from.size()));
        const std::size_t row = *i;
        from.erase(i);
        return row;
    };
    for (std::size_t i = 0; i < changes; ++i) {
        other = removed(other, draw(in, u[2 * i]));
        other = added(other, draw(out, u[2 * i + 1]));
    }
    return other;
}

Rows RowChoice::all() const {
    Rows rows(count);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
}

}  // namespace covaria::detail
