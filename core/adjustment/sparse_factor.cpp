#include "core/adjustment/sparse_factor.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/lanes.h"

namespace covaria::adjustment {

namespace {

using Index = Eigen::Index;
using Order = EliminationOrder;

/// Columns of the factor that are spread out over the dense block together.
constexpr Index panel_columns = 192;
/// Whether a column with so many elements in the dense block is better spread out than added one by one: a
/// product of dense matrices is about that much faster for each element.
bool is_spread(Index elements, Index root) {
    constexpr Index faster = 16;
    return faster * elements * elements > root * root;
}

/// The first element of the column that is in the dense block.
int first_in_root(const Order& order, int column) {
    const auto begin = order.rows.begin();
    return static_cast<int>(std::lower_bound(begin + order.starts[static_cast<std::size_t>(column)],
                                             begin + order.starts[static_cast<std::size_t>(column) + 1],
                                             order.root) -
                            begin);
}

/// The elimination of the sparse columns, one after the other (left-looking).
class SparseElimination {
public:
    SparseElimination(const Order& order, const SparseColumns& lower, std::vector<double>& values,
                      std::vector<double>& diagonal, Eigen::MatrixXd& root)
        : order_(order),
          values_(values),
          diagonal_(diagonal),
          root_(root),
          work_(order.place.size(), 0.0),
          first_(static_cast<std::size_t>(order.root), -1),
          next_(first_),
          at_(first_) {
        values_.assign(order.rows.size(), 0.0);
        diagonal_.assign(static_cast<std::size_t>(order.root), 0.0);
        root_ = Eigen::MatrixXd::Zero(order.size() - order.root, order.size() - order.root);
        gather(lower);
    }

    bool run() {
        panel_.resize(root_.rows(), panel_columns);
        for (int j = 0; j < order_.root; ++j) {
            if (!eliminate(j)) return false;
            update_root(j);
        }
        empty_panel();
        return true;
    }

private:
    /// Sorts the elements of the matrix into the columns of the order.
    void gather(const SparseColumns& lower) {
        columns_.resize(static_cast<std::size_t>(order_.root));
        for (Index j = 0; j < lower.cols(); ++j)
            for (SparseColumns::InnerIterator it(lower, j); it; ++it) {
                const int a = order_.place[static_cast<std::size_t>(it.row())],
                          b = order_.place[static_cast<std::size_t>(j)];
                const int row = std::max(a, b), column = std::min(a, b);
                if (column < order_.root)
                    columns_[static_cast<std::size_t>(column)].emplace_back(row, it.value());
                else
                    root_(row - order_.root, column - order_.root) += it.value();
            }
    }

    bool eliminate(int j) {
        const auto c = static_cast<std::size_t>(j);
        for (const auto& [row, value] : columns_[c]) work_[static_cast<std::size_t>(row)] += value;
        columns_[c] = {};
        for (int k = first_[c]; k >= 0;) {
            const auto b = static_cast<std::size_t>(k);
            const int after = next_[b], from = at_[b], end = order_.starts[b + 1];
            const double by = values_[static_cast<std::size_t>(from)] * diagonal_[b];
            for (int e = from; e < end; ++e)
                work_[static_cast<std::size_t>(order_.rows[static_cast<std::size_t>(e)])] -=
                    by * values_[static_cast<std::size_t>(e)];
            wait_for_next_row(k, from + 1);
            k = after;
        }
        const double d = std::exchange(work_[c], 0.0);
        diagonal_[c] = d;
        for (int e = order_.starts[c]; e < order_.starts[c + 1]; ++e) {
            double& w = work_[static_cast<std::size_t>(order_.rows[static_cast<std::size_t>(e)])];
            values_[static_cast<std::size_t>(e)] = w / d;
            w = 0.0;
        }
        wait_for_next_row(j, order_.starts[c]);
        return d > 0.0 && std::isfinite(d);
    }

    /// Column k is next needed by the column of its element `e`, if that is sparse too.
    void wait_for_next_row(int k, int e) {
        const auto b = static_cast<std::size_t>(k);
        at_[b] = e;
        if (e >= order_.starts[b + 1]) return;
        const int row = order_.rows[static_cast<std::size_t>(e)];
        if (row >= order_.root) return;
        next_[b] = first_[static_cast<std::size_t>(row)];
        first_[static_cast<std::size_t>(row)] = k;
    }

    /// Takes d l lᵀ of the column off the dense block.
    void update_root(int j) {
        const int from = first_in_root(order_, j), end = order_.starts[static_cast<std::size_t>(j) + 1];
        const double d = diagonal_[static_cast<std::size_t>(j)];
        const auto row = [&](int e) { return order_.rows[static_cast<std::size_t>(e)] - order_.root; };
        const auto value = [&](int e) { return values_[static_cast<std::size_t>(e)]; };
        if (is_spread(end - from, root_.rows())) {
            auto column = panel_.col(filled_++);
            column.setZero();
            const double root_of_d = std::sqrt(d);
            for (int e = from; e < end; ++e) column[row(e)] = root_of_d * value(e);
            if (filled_ == panel_columns) empty_panel();
            return;
        }
        for (int b = from; b < end; ++b) {
            const double by = d * value(b);
            for (int a = b; a < end; ++a) root_(row(a), row(b)) -= by * value(a);
        }
    }

    void empty_panel() {
        if (filled_ == 0) return;
        root_.selfadjointView<Eigen::Lower>().rankUpdate(panel_.leftCols(filled_), -1.0);
        filled_ = 0;
    }

    const Order& order_;
    std::vector<double>&values_, &diagonal_;
    Eigen::MatrixXd& root_;
    std::vector<double> work_;
    std::vector<int> first_, next_, at_;  ///< columns that wait for each one, and their elements in its row
    std::vector<std::vector<std::pair<int, double>>> columns_;
    Eigen::MatrixXd panel_;
    Index filled_ = 0;
};

}  // namespace

bool SparseFactor::factorise(const SparseColumns& lower, const SparseFactor* like) {
    order_ = like && like->order_ && like->order_->fits(lower) ? like->order_ : elimination_order(lower);
    return SparseElimination(*order_, lower, values_, diagonal_, root_).run() && factorise_root();
}

bool SparseFactor::factorise_root() {
    if (root_.rows() == 0) return true;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(root_);
    return llt.info() == Eigen::Success && root_.diagonal().allFinite();
}

double SparseFactor::least_pivot() const {
    double least = std::numeric_limits<double>::infinity();
    for (const double d : diagonal_) least = std::min(least, d);
    for (Index i = 0; i < root_.rows(); ++i) least = std::min(least, root_(i, i) * root_(i, i));
    return least;
}

template <class Number>
void SparseFactor::solve_root(Number* b) const {
    const Index n = root_.rows();
    if constexpr (std::is_same_v<Number, double>) {
        Eigen::Map<Eigen::VectorXd> dense(b, n);
        root_.triangularView<Eigen::Lower>().solveInPlace(dense);
        root_.triangularView<Eigen::Lower>().transpose().solveInPlace(dense);
    } else {
        for (Index j = 0; j < n; ++j) {
            b[j] /= root_(j, j);
            const Number own = b[j];
            for (Index i = j + 1; i < n; ++i) add_product(b[i], -root_(i, j), own);
        }
        for (Index j = n; j-- > 0;) {
            Number own = b[j];
            for (Index i = j + 1; i < n; ++i) add_product(own, -root_(i, j), b[i]);
            own /= root_(j, j);
            b[j] = own;
        }
    }
}

template <class Number>
void SparseFactor::solve(Number* b, Number* scratch) const {
    const std::size_t n = size(), root = diagonal_.size();
    const int *place = order_->place.data(), *starts = order_->starts.data(), *rows = order_->rows.data();
    for (std::size_t i = 0; i < n; ++i) scratch[place[i]] = b[i];
    for (std::size_t j = 0; j < root; ++j) {
        const Number s = scratch[j];
        for (int k = starts[j]; k < starts[j + 1]; ++k)
            add_product(scratch[rows[k]], -values_[static_cast<std::size_t>(k)], s);
    }
    for (std::size_t j = 0; j < root; ++j) scratch[j] /= diagonal_[j];
    if (root < n) solve_root(scratch + root);
    for (std::size_t j = root; j-- > 0;) {
        Number s = scratch[j];
        for (int k = starts[j]; k < starts[j + 1]; ++k)
            add_product(s, -values_[static_cast<std::size_t>(k)], scratch[rows[k]]);
        scratch[j] = s;
    }
    for (std::size_t i = 0; i < n; ++i) b[i] = scratch[place[i]];
}

template void SparseFactor::solve(double*, double*) const;
template void SparseFactor::solve(OneLane*, OneLane*) const;
template void SparseFactor::solve(FewLanes*, FewLanes*) const;
template void SparseFactor::solve(ManyLanes*, ManyLanes*) const;

namespace {

/// Z = D⁻¹ L⁻¹ + (I − Lᵀ) Z of the sparse columns, from the last to the first; that of the dense block is
/// there.
class SparseInversion {
public:
    SparseInversion(const Order& order, const std::vector<double>& L, const std::vector<double>& D,
                    const Eigen::MatrixXd& root, std::vector<double>& Z, std::vector<double>& diagonal)
        : order_(order),
          L_(L),
          D_(D),
          root_(root),
          Z_(Z),
          diagonal_(diagonal),
          index_of_(order.place.size(), -1),
          panel_(root.rows(), panel_columns) {
        Z_.assign(L.size(), 0.0);
        diagonal_.assign(D.size(), 0.0);
    }

    void run() {
        for (int end = order_.root; end > 0; end -= static_cast<int>(panel_columns)) {
            const int begin = std::max(0, end - static_cast<int>(panel_columns));
            multiply(begin, end);
            for (int j = end - 1; j >= begin; --j) invert(j, products_.col(j - begin));
        }
    }

private:
    std::size_t at(int e) const { return static_cast<std::size_t>(e); }
    int row(int e) const { return order_.rows[at(e)]; }

    /// The dense block of Z times the columns of L that have elements there.
    void multiply(int begin, int end) {
        panel_.leftCols(end - begin).setZero();
        bool any = false;
        for (int j = begin; j < end; ++j) {
            const int from = first_in_root(order_, j), last = order_.starts[at(j) + 1];
            if (!is_spread(last - from, root_.rows())) continue;
            any = true;
            for (int e = from; e < last; ++e) panel_(row(e) - order_.root, j - begin) = L_[at(e)];
        }
        if (any)
            products_.noalias() = root_ * panel_.leftCols(end - begin);
        else
            products_.resize(root_.rows(), end - begin);
    }

    template <class Product>
    void invert(int j, const Product& product) {
        const int first = order_.starts[at(j)], end = order_.starts[at(j) + 1],
                  root = first_in_root(order_, j);
        for (int k = first; k < end; ++k) index_of_[at(row(k))] = k;
        if (is_spread(end - root, root_.rows()))
            for (int k = root; k < end; ++k) Z_[at(k)] = -product[row(k) - order_.root];
        else
            for (int k = root; k < end; ++k)
                for (int e = root; e < end; ++e)
                    Z_[at(k)] -= L_[at(e)] * root_(row(k) - order_.root, row(e) - order_.root);
        for (int k = first; k < root; ++k) {
            const int column = row(k);
            const double l = L_[at(k)];
            double own = l * diagonal_[at(column)];
            for (int e = order_.starts[at(column)]; e < order_.starts[at(column) + 1]; ++e) {
                const int i = index_of_[at(row(e))];
                if (i < 0) continue;
                Z_[at(i)] -= l * Z_[at(e)];
                own += L_[at(i)] * Z_[at(e)];
            }
            Z_[at(k)] -= own;
        }
        double own = 1.0 / D_[at(j)];
        for (int k = first; k < end; ++k) {
            own -= L_[at(k)] * Z_[at(k)];
            index_of_[at(row(k))] = -1;
        }
        diagonal_[at(j)] = own;
    }

    const Order& order_;
    const std::vector<double>&L_, &D_;
    const Eigen::MatrixXd& root_;
    std::vector<double>&Z_, &diagonal_;
    std::vector<int> index_of_;
    Eigen::MatrixXd panel_, products_;
};

}  // namespace

SelectedInverse SparseFactor::selected_inverse() const {
    SelectedInverse Z;
    Z.order_ = order_;
    Z.root_ = Eigen::MatrixXd::Identity(root_.rows(), root_.rows());
    if (root_.rows() > 0) {
        root_.triangularView<Eigen::Lower>().solveInPlace(Z.root_);
        const Eigen::MatrixXd inverse_of_factor = Z.root_;
        Z.root_.noalias() = inverse_of_factor.transpose() * inverse_of_factor;
    }
    SparseInversion(*order_, values_, diagonal_, Z.root_, Z.values_, Z.diagonal_).run();
    return Z;
}

namespace {

/// Elements of a matrix of readings with the place of their column in the order of elimination; those of each
/// sparse column in a row.
struct PlacedElements {
    std::vector<int> places;                  ///< of each element; -1: its column does not count
    std::vector<double> values;               ///< over the scale of their column
    std::vector<int> starts, elements, rows;  ///< by sparse column: elements, and their rows

    PlacedElements(const SparseRows& A, const Order& order, const std::vector<std::ptrdiff_t>& number,
                   const Eigen::VectorXd& scale)
        : places(static_cast<std::size_t>(A.nonZeros())),
          values(places.size()),
          starts(static_cast<std::size_t>(order.root) + 1, 0) {
        const int* columns = A.innerIndexPtr();
        for (std::size_t e = 0; e < places.size(); ++e) {
            const std::ptrdiff_t unknown = number[static_cast<std::size_t>(columns[e])];
            places[e] = unknown < 0 ? -1 : order.place[static_cast<std::size_t>(unknown)];
            values[e] = A.valuePtr()[e] / scale[columns[e]];
            if (is_sparse(e, order)) ++starts[static_cast<std::size_t>(places[e]) + 1];
        }
        for (std::size_t c = 1; c < starts.size(); ++c) starts[c] += starts[c - 1];
        std::vector<int> at(starts.begin(), starts.end() - 1);
        elements.resize(static_cast<std::size_t>(starts.back()));
        rows.resize(elements.size());
        for (int i = 0; i < static_cast<int>(A.rows()); ++i)
            for (int e = A.outerIndexPtr()[i]; e < A.outerIndexPtr()[i + 1]; ++e) {
                if (!is_sparse(static_cast<std::size_t>(e), order)) continue;
                const auto k = static_cast<std::size_t>(
                    at[static_cast<std::size_t>(places[static_cast<std::size_t>(e)])]++);
                elements[k] = e;
                rows[k] = i;
            }
    }

private:
    bool is_sparse(std::size_t e, const Order& order) const {
        return places[e] >= 0 && places[e] < order.root;
    }
};

}  // namespace

Eigen::VectorXd SelectedInverse::quadratic_forms(const SparseRows& A,
                                                 const std::vector<std::ptrdiff_t>& number,
                                                 const Eigen::VectorXd& scale) const {
    const PlacedElements placed(A, *order_, number, scale);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(A.rows());
    const auto at = [](int k) { return static_cast<std::size_t>(k); };
    // Elements of an earlier column count with the column spread out, so that nothing is searched for.
    std::vector<double> column(order_->place.size(), 0.0);
    for (int c = 0; c < order_->root; ++c) {
        for (int k = order_->starts[at(c)]; k < order_->starts[at(c) + 1]; ++k)
            column[at(order_->rows[at(k)])] = 2.0 * values_[at(k)];
        column[at(c)] = diagonal_[at(c)];
        for (int k = placed.starts[at(c)]; k < placed.starts[at(c) + 1]; ++k) {
            const int row = placed.rows[at(k)];
            double sum = 0.0;
            for (int e = A.outerIndexPtr()[row]; e < A.outerIndexPtr()[row + 1]; ++e)
                if (placed.places[at(e)] >= c) sum += placed.values[at(e)] * column[at(placed.places[at(e)])];
            sums[row] += placed.values[at(placed.elements[at(k)])] * sum;
        }
        for (int k = order_->starts[at(c)]; k < order_->starts[at(c) + 1]; ++k)
            column[at(order_->rows[at(k)])] = 0.0;
    }
    const int root = order_->root;
    for (int i = 0; i < static_cast<int>(A.rows()); ++i)
        for (int e = A.outerIndexPtr()[i]; e < A.outerIndexPtr()[i + 1]; ++e)
            for (int f = A.outerIndexPtr()[i]; f < A.outerIndexPtr()[i + 1]; ++f) {
                const int a = placed.places[at(e)], b = placed.places[at(f)];
                if (a >= root && b >= root)
                    sums[i] += placed.values[at(e)] * placed.values[at(f)] *
                               root_(std::max(a, b) - root, std::min(a, b) - root);
            }
    return sums;
}

double SelectedInverse::at(std::size_t i, std::size_t j) const {
    const int a = std::min(order_->place[i], order_->place[j]),
              b = std::max(order_->place[i], order_->place[j]);
    if (a >= order_->root) return root_(b - order_->root, a - order_->root);
    const auto column = static_cast<std::size_t>(a);
    if (a == b) return diagonal_[column];
    const auto first = order_->rows.begin() + order_->starts[column],
               end = order_->rows.begin() + order_->starts[column + 1];
    const auto found = std::lower_bound(first, end, b);
    return found == end || *found != b ? 0.0
                                       : values_[static_cast<std::size_t>(found - order_->rows.begin())];
}

}  // namespace covaria::adjustment
