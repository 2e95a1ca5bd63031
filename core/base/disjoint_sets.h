// Numbers that are joined into sets, each set led by its smallest number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace covaria {

class DisjointSets {
public:
    /// Makes each of the numbers from 0 to `count` - 1 a set by itself.
    explicit DisjointSets(std::size_t count) : above_(count) {
        std::iota(above_.begin(), above_.end(), std::size_t{0});
    }

    std::size_t leader_of(std::size_t i) {
        while (above_[i] != i) i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        const std::size_t a = leader_of(i), b = leader_of(j);
        above_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> above_;
};

}  // namespace covaria
