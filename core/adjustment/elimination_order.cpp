// The order of elimination of a sparse matrix, and the pattern of its factor.
#include <Eigen/OrderingMethods>
#include <algorithm>
#include <utility>

#include "core/adjustment/sparse_factor.h"

namespace covaria::adjustment {

namespace {

/// Least share of elements in the block of the last columns that counts as dense, and its most columns.
constexpr double least_full = 0.7;
constexpr int largest_root = 2000;

std::vector<int> places_of(const SparseColumns& lower) {
    if (lower.cols() == 0) return {};
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
    std::vector<int> places(static_cast<std::size_t>(lower.cols()));
    for (std::size_t k = 0; k < places.size(); ++k)
        places[static_cast<std::size_t>(order.indices()[static_cast<int>(k)])] = static_cast<int>(k);
    return places;
}

/// The rows below the diagonal of each column of the factor, as those of the matrix and of the columns whose
/// first element is in this one (children in the elimination tree).
std::vector<std::vector<int>> columns_of_factor(const SparseColumns& lower, const std::vector<int>& places) {
    const int n = static_cast<int>(places.size());
    std::vector<std::vector<int>> columns(places.size()), children(places.size());
    for (int j = 0; j < n; ++j)
        for (SparseColumns::InnerIterator it(lower, j); it; ++it) {
            const int a = places[static_cast<std::size_t>(it.row())], b = places[static_cast<std::size_t>(j)];
            if (a != b) columns[static_cast<std::size_t>(std::min(a, b))].push_back(std::max(a, b));
        }
    std::vector<int> seen(places.size(), -1);
    for (int j = 0; j < n; ++j) {
        std::vector<int>& own = columns[static_cast<std::size_t>(j)];
        std::vector<int> all;
        seen[static_cast<std::size_t>(j)] = j;
        const auto take = [&](const std::vector<int>& rows) {
            for (const int i : rows)
                if (std::exchange(seen[static_cast<std::size_t>(i)], j) != j) all.push_back(i);
        };
        take(own);
        for (const int child : children[static_cast<std::size_t>(j)])
            take(columns[static_cast<std::size_t>(child)]);
        std::ranges::sort(all);
        own = std::move(all);
        if (!own.empty()) children[static_cast<std::size_t>(own.front())].push_back(j);
    }
    return columns;
}

/// The first column of the largest block at the end that is dense.
int root_of(const std::vector<std::vector<int>>& columns) {
    const int n = static_cast<int>(columns.size());
    int root = n;
    double elements = 0.0;
    for (int j = n - 1; j >= std::max(0, n - largest_root); --j) {
        elements += static_cast<double>(columns[static_cast<std::size_t>(j)].size());
        const double r = n - j;
        if (elements >= least_full * 0.5 * r * (r - 1.0)) root = j;
    }
    return root;
}

}  // namespace

bool EliminationOrder::fits(const SparseColumns& lower) const {
    return lower.cols() == size() && lower.nonZeros() == static_cast<Eigen::Index>(of_rows.size()) &&
           std::equal(of_rows.begin(), of_rows.end(), lower.innerIndexPtr()) &&
           std::equal(of_starts.begin(), of_starts.end(), lower.outerIndexPtr());
}

std::shared_ptr<const EliminationOrder> elimination_order(const SparseColumns& lower) {
    auto order = std::make_shared<EliminationOrder>();
    order->place = places_of(lower);
    const std::vector<std::vector<int>> columns = columns_of_factor(lower, order->place);
    order->root = root_of(columns);
    order->starts.assign(1, 0);
    for (int j = 0; j < order->root; ++j) {
        const std::vector<int>& rows = columns[static_cast<std::size_t>(j)];
        order->rows.insert(order->rows.end(), rows.begin(), rows.end());
        order->starts.push_back(static_cast<int>(order->rows.size()));
    }
    order->of_rows.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
    order->of_starts.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
    return order;
}

}  // namespace covaria::adjustment
