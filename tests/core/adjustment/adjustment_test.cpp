// Least squares of any family: against dense matrices, and what no datum changes.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/adjustment/lanes.h"
#include "core/adjustment/reliability.h"

namespace covaria::adjustment_test {
namespace {

using adjustment::Adjustment;
using adjustment::CovarianceBlock;
using adjustment::SparseRows;

struct Levelling {
    Eigen::MatrixXd design;  ///< height differences by heights
    Eigen::VectorXd readings, u;
    SparseRows sparse() const { return design.sparseView(); }
};

// Five points, nine lines between them: f = 5, one height undetermined.
Levelling levelling() {
    constexpr int lines[9][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {0, 2}, {1, 3}, {2, 4}, {0, 3}};
    constexpr double heights[5] = {10.0, 12.3456, 9.8765, 15.4321, 11.1111};
    Levelling made{Eigen::MatrixXd::Zero(9, 5), Eigen::VectorXd(9), Eigen::VectorXd(9)};
    for (int i = 0; i < 9; ++i) {
        made.design(i, lines[i][0]) = -1.0;
        made.design(i, lines[i][1]) = 1.0;
        made.u[i] = 1e-3 * std::sqrt(1.0 + 0.3 * i);
        made.readings[i] = heights[lines[i][1]] - heights[lines[i][0]] + made.u[i] * std::sin(2.0 + 3.7 * i);
    }
    return made;
}

Eigen::VectorXd solution(const Adjustment& a, const SparseRows& whitening, const Eigen::VectorXd& l) {
    return a.step(a.whitened().transpose() * Eigen::VectorXd(whitening * l));
}

Eigen::MatrixXd cofactors(const Adjustment& a) {
    const auto n = static_cast<Eigen::Index>(a.unknowns());
    Eigen::MatrixXd Q(n, n);
    for (Eigen::Index j = 0; j < n; ++j) Q.col(j) = a.cofactors(Eigen::VectorXd::Unit(n, j));
    return Q;
}

TEST(Adjustment, IsLeastSquaresWithOneHeightHeld) {
    const Levelling l = levelling();
    const SparseRows W = adjustment::whitening(l.u, {});
    const Adjustment a(l.sparse(), W, {0});
    ASSERT_TRUE(a.is_solved());
    EXPECT_EQ(a.defect(), 1u);
    EXPECT_EQ(a.degrees_of_freedom(), 5);
    // Point 0 is the datum alone: it stays, and the rest is ordinary least squares.
    const Eigen::MatrixXd J = l.design.rightCols(4), P = l.u.cwiseAbs2().cwiseInverse().asDiagonal();
    const Eigen::MatrixXd Q = (J.transpose() * P * J).inverse();
    const Eigen::VectorXd x = Q * J.transpose() * P * l.readings, found = solution(a, W, l.readings);
    EXPECT_LT((found.tail(4) - x).norm(), 1e-11);
    EXPECT_NEAR(found[0], 0.0, 1e-12);
    EXPECT_LT((cofactors(a).bottomRightCorner(4, 4) - Q).norm(), 1e-10 * Q.norm());
    const Eigen::VectorXd v = l.readings - J * x;
    const adjustment::Reliability r = adjustment::reliability_of(a, W, {}, l.readings - l.design * found);
    EXPECT_NEAR(r.sum_of_squares, v.dot(P * v), 1e-9);
    EXPECT_NEAR(r.s0, std::sqrt(v.dot(P * v) / 5.0), 1e-10);
    const Eigen::MatrixXd Qvv = Eigen::MatrixXd(P.inverse()) - J * Q * J.transpose();
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 9; ++i) {
        const adjustment::ReadingReliability& of = r.readings[static_cast<std::size_t>(i)];
        EXPECT_NEAR(of.redundancy, (Qvv * P)(i, i), 1e-11);
        EXPECT_NEAR(of.w, v[i] / std::sqrt(Qvv(i, i)), 1e-8);
        EXPECT_NEAR(of.tau, of.w / r.s0, 1e-10);
        EXPECT_NEAR(of.detectable, 4.13215 * l.u[i] / std::sqrt(of.redundancy), 1e-5 * of.detectable);
        const Eigen::VectorXd effect = adjustment::effect_of(a, W, static_cast<std::size_t>(i));
        EXPECT_LT((effect.tail(4) - Q * J.transpose() * P.col(i)).norm(), 1e-10);
        sum += of.redundancy;
    }
    EXPECT_NEAR(sum, 5.0, 1e-10);
}

TEST(Adjustment, TestsFindAnErrorOfDeltaNought) {
    EXPECT_NEAR(adjustment::outlier_limit(), 3.29053, 1e-5);
    EXPECT_NEAR(adjustment::non_centrality(), 4.13215, 1e-5);
}

TEST(Adjustment, WhatTheDatumDoesNotChangeStays) {
    const Levelling l = levelling();
    const SparseRows W = adjustment::whitening(l.u, {});
    const Adjustment held(l.sparse(), W, {3});
    const adjustment::Reliability first =
        adjustment::reliability_of(held, W, {}, l.readings - l.design * solution(held, W, l.readings));
    for (const std::vector<std::size_t>& datum : {std::vector<std::size_t>{0}, {0, 1, 2, 3, 4}, {1, 4}}) {
        const Adjustment a(l.sparse(), W, datum);
        ASSERT_TRUE(a.is_solved());
        const Eigen::VectorXd x = solution(a, W, l.readings);
        double moved = 0.0;
        for (const std::size_t i : datum) moved += x[static_cast<Eigen::Index>(i)];
        EXPECT_NEAR(moved, 0.0, 1e-11) << "the mean of the datum stays";
        const adjustment::Reliability r = adjustment::reliability_of(a, W, {}, l.readings - l.design * x);
        EXPECT_NEAR(r.sum_of_squares, first.sum_of_squares, 1e-9);
        EXPECT_EQ(r.degrees_of_freedom, 5);
        for (std::size_t i = 0; i < 9; ++i) {
            EXPECT_NEAR(r.readings[i].residual, first.readings[i].residual, 1e-12);
            EXPECT_NEAR(r.readings[i].redundancy, first.readings[i].redundancy, 1e-10);
            EXPECT_NEAR(r.readings[i].w, first.readings[i].w, 1e-8);
        }
        const Eigen::MatrixXd Q = cofactors(a), Qh = cofactors(held);
        EXPECT_LT((Q - Q.transpose()).norm(), 1e-12 * Q.norm());
        // Baarda's S-transformation of the other datum.
        Eigen::VectorXd b = Eigen::VectorXd::Zero(5);
        for (const std::size_t i : datum)
            b[static_cast<Eigen::Index>(i)] = 1.0 / static_cast<double>(datum.size());
        const Eigen::MatrixXd S = Eigen::MatrixXd::Identity(5, 5) - Eigen::VectorXd::Ones(5) * b.transpose();
        EXPECT_LT((Q - S * Qh * S.transpose()).norm(), 1e-10 * Q.norm());
        for (std::size_t i = 0; i < 5; ++i)
            EXPECT_NEAR(a.cofactor(i, i), Q(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)),
                        1e-10 * Q.norm());
        // A height difference has the same uncertainty in every datum.
        const Eigen::VectorXd d = Eigen::VectorXd::Unit(5, 1) - Eigen::VectorXd::Unit(5, 4);
        EXPECT_NEAR(d.dot(Q * d), d.dot(Qh * d), 1e-10 * Q.norm());
    }
}

TEST(Adjustment, WithoutADatumWhatIsOpenIsFound) {
    const Levelling l = levelling();
    const Adjustment a(l.sparse(), adjustment::whitening(l.u, {}), {});
    EXPECT_FALSE(a.is_solved());
    ASSERT_EQ(a.open().cols(), 1);
    const Eigen::VectorXd all = a.scale().cwiseInverse().cwiseProduct(a.open().col(0));
    EXPECT_LT((all / all[0] - Eigen::VectorXd::Ones(5)).norm(), 1e-6) << "all heights alike";
    // A point without a reading, beside the common height.
    Eigen::MatrixXd more = Eigen::MatrixXd::Zero(9, 6);
    more.leftCols(5) = l.design;
    const Adjustment lonely(SparseRows(more.sparseView()), adjustment::whitening(l.u, {}), {});
    EXPECT_EQ(lonely.open().cols(), 2);
}

TEST(Adjustment, APriorOfLargeUIsNoneAndOfSmallUIsFixed) {
    const Levelling l = levelling();
    const auto with_prior = [&](double u) {
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(11, 5);
        J.topRows(9) = l.design;
        J(9, 0) = J(10, 2) = 1.0;  // the datum, and a stated height
        Eigen::VectorXd uu(11), y(11);
        uu << l.u, 1e-9, u;
        y << l.readings, 10.0, 9.9;
        const SparseRows W = adjustment::whitening(uu, {});
        const Adjustment a(SparseRows(J.sparseView()), W, {});
        EXPECT_TRUE(a.is_solved());
        return std::pair(solution(a, W, y), cofactors(a));
    };
    const SparseRows W = adjustment::whitening(l.u, {});
    const Adjustment none(l.sparse(), W, {0});
    const Eigen::VectorXd free = solution(none, W, l.readings).array() + 10.0;
    const auto [x, Q] = with_prior(1e6);
    EXPECT_LT((x - free).norm(), 1e-9);
    EXPECT_LT((Q - cofactors(none)).norm(), 1e-9 * Q.norm());
    // Held at 9.9: the same as without it as an unknown.
    const Eigen::MatrixXd J = l.design(Eigen::all, std::vector<int>{1, 3, 4});
    const Eigen::MatrixXd P = l.u.cwiseAbs2().cwiseInverse().asDiagonal();
    const Eigen::MatrixXd Qf = (J.transpose() * P * J).inverse();
    const Eigen::VectorXd rest = l.readings - l.design.col(0) * 10.0 - l.design.col(2) * 9.9;
    const Eigen::VectorXd fixed = Qf * J.transpose() * P * rest;
    const auto [y, Qy] = with_prior(1e-9);
    EXPECT_LT((y(std::vector<int>{1, 3, 4}) - fixed).norm(), 1e-9);
    EXPECT_NEAR(y[2], 9.9, 1e-9);
}

TEST(Adjustment, CorrelatedReadingsAreWeighedByTheirCovariance) {
    const Levelling l = levelling();
    Eigen::MatrixXd C = l.u.cwiseAbs2().asDiagonal();
    const std::vector<std::size_t> block{1, 4, 7};
    for (const auto& [i, j, c] : {std::tuple(1, 4, 0.6), std::tuple(4, 7, -0.3), std::tuple(1, 7, 0.1)})
        C(i, j) = C(j, i) = c * l.u[i] * l.u[j];
    const std::vector<CovarianceBlock> blocks{{block, C(block, block)}};
    const SparseRows W = adjustment::whitening(l.u, blocks);
    const Adjustment a(l.sparse(), W, {0});
    const Eigen::MatrixXd J = l.design.rightCols(4), P = C.inverse();
    const Eigen::MatrixXd Q = (J.transpose() * P * J).inverse(), Qvv = C - J * Q * J.transpose();
    const Eigen::VectorXd x = Q * J.transpose() * P * l.readings, v = l.readings - J * x;
    EXPECT_LT((solution(a, W, l.readings).tail(4) - x).norm(), 1e-11);
    const adjustment::Reliability r =
        adjustment::reliability_of(a, W, blocks, l.readings - l.design * solution(a, W, l.readings));
    EXPECT_NEAR(r.sum_of_squares, v.dot(P * v), 1e-9);
    const Eigen::MatrixXd tested = P * Qvv * P;
    for (Eigen::Index i = 0; i < 9; ++i) {
        const adjustment::ReadingReliability& of = r.readings[static_cast<std::size_t>(i)];
        EXPECT_NEAR(of.redundancy, (Qvv * P)(i, i), 1e-10);
        EXPECT_NEAR(of.w, (P * v)[i] / std::sqrt(tested(i, i)), 1e-8);
        EXPECT_NEAR(of.detectable, 4.13215 / std::sqrt(tested(i, i)), 1e-5 * of.detectable);
    }
    EXPECT_EQ(adjustment::whitening(l.u, {{{0, 1}, Eigen::Matrix2d::Ones()}}).rows(), 0) << "no covariance";
}

// A right-hand side in each lane, of a network that is free.
template <class Numbers>
void expect_steps_of_lanes(const Adjustment& a) {
    const std::size_t n = a.unknowns();
    std::vector<Numbers> x(n), scratch(a.scratch_size());
    Eigen::MatrixXd gradients(static_cast<Eigen::Index>(Numbers::size), static_cast<Eigen::Index>(n));
    for (Eigen::Index i = 0; i < gradients.cols(); ++i)
        for (Eigen::Index lane = 0; lane < gradients.rows(); ++lane)
            gradients(lane, i) = 1e3 * std::sin(1.0 + 3.1 * double(i) + 0.7 * double(lane));
    // The last unknown is what the others leave over: no reading pulls the network as a whole.
    gradients.col(gradients.cols() - 1) = -gradients.leftCols(gradients.cols() - 1).rowwise().sum();
    for (std::size_t i = 0; i < n; ++i)
        x[i] = Numbers::load(gradients.col(static_cast<Eigen::Index>(i)).data());
    a.step(x.data(), scratch.data());
    for (Eigen::Index lane = 0; lane < gradients.rows(); ++lane) {
        const Eigen::VectorXd alone = a.step(Eigen::VectorXd(gradients.row(lane)));
        for (std::size_t i = 0; i < n; ++i) {
            std::array<double, Numbers::size> numbers;
            x[i].store(numbers.data());
            EXPECT_NEAR(numbers[static_cast<std::size_t>(lane)], alone[static_cast<Eigen::Index>(i)],
                        1e-12 * alone.norm());
        }
    }
}

TEST(Adjustment, StepsManyRightHandSidesAsEachByItself) {
    const Levelling l = levelling();
    const Adjustment a(l.sparse(), adjustment::whitening(l.u, {}), {0, 2, 3});
    ASSERT_TRUE(a.is_solved());
    expect_steps_of_lanes<adjustment::OneLane>(a);
    expect_steps_of_lanes<adjustment::FewLanes>(a);
    expect_steps_of_lanes<adjustment::ManyLanes>(a);
}

TEST(Adjustment, HasTheCofactorsOfAllReadingsAtOnce) {
    const Levelling l = levelling();
    const Adjustment a(l.sparse(), adjustment::whitening(l.u, {}), {0, 2, 3});
    const Eigen::VectorXd all = a.cofactors_of_readings();
    for (std::size_t i = 0; i < a.readings(); ++i)
        EXPECT_NEAR(all[static_cast<Eigen::Index>(i)], a.cofactor_of_readings(i, i), 1e-13);
}

// Elements of the inverse by the factor's own pattern, of a larger matrix with fill.
TEST(SparseFactor, SolvesAndInvertsWhatItHas) {
    constexpr int n = 60;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        A(i, i) = 4.0 + 0.1 * (i % 7);
        for (const int j : {(i + 1) % n, (i * 7 + 3) % n})
            if (j != i) A(i, j) = A(j, i) = -0.5 - 0.01 * (i % 3);
    }
    adjustment::SparseFactor factor;
    const adjustment::SparseColumns sparse = Eigen::MatrixXd(A.triangularView<Eigen::Lower>()).sparseView();
    ASSERT_TRUE(factor.factorise(sparse));
    const Eigen::MatrixXd inverse = A.inverse();
    const adjustment::SelectedInverse Z = factor.selected_inverse();
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            if (A(i, j) != 0.0) {
                EXPECT_NEAR(Z.at(std::size_t(i), std::size_t(j)), inverse(i, j), 1e-12) << i << " " << j;
            }
    Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0), scratch(n);
    const Eigen::VectorXd x = inverse * b;
    factor.solve(b.data(), scratch.data());
    EXPECT_LT((b - x).norm(), 1e-12);
    // Rows whose unknowns the matrix connects; the unknown of the last column is held.
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, n + 1);
    std::vector<std::ptrdiff_t> number(n + 1, -1);
    for (int i = 0; i < n; ++i) {
        number[std::size_t(i)] = i;
        rows(i, i) = 1.0 + 0.1 * i;
        rows(i, (i + 1) % n) = -2.0;
        rows(i, n) = 3.0;
    }
    const Eigen::VectorXd scale = Eigen::VectorXd::LinSpaced(n + 1, 1.0, 3.0);
    const Eigen::VectorXd forms = Z.quadratic_forms(rows.sparseView(), number, scale);
    const Eigen::MatrixXd scaled = (rows * scale.cwiseInverse().asDiagonal()).leftCols(n);
    EXPECT_LT((forms - (scaled * inverse * scaled.transpose()).diagonal()).norm(), 1e-12);
    A(5, 5) = -4.0;
    EXPECT_FALSE(factor.factorise(Eigen::MatrixXd(A.triangularView<Eigen::Lower>()).sparseView()));
}

}  // namespace
}  // namespace covaria::adjustment_test
