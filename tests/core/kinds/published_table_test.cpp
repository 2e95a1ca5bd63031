// Table 4 of Porath et al. explained: a variant of the model with two slips reproduces all of its 78 cells.
//
// (1) The standard uncertainties (0.066, 0.110, 0.105) mm are applied by point instead of by coordinate.
// (2) Eq 18 takes p1 without its deviation: o_p = nominal p1 + R_p s_p.
// The triangles have sides of 678 and 391 mm. An inference from the table, not knowledge of the authors'
// code.
#include <gtest/gtest.h>

#include <numbers>

#include "core/math/frames.h"
#include "core/math/rotation.h"
#include "core/model/equation_model.h"
#include "core/propagation/engine.h"
#include "tests/core/kinds/pose/stewart.h"

namespace covaria::published_table_test {
namespace {

using namespace stewart;

enum class Slips { both, only_eq_18 };

class Variant : public EquationModel<Variant> {
public:
    Variant(std::size_t k, Slips slips) {
        const auto& row = table_3[k];
        constexpr double deg = std::numbers::pi / 180.0;
        const Matrix3<double> R = rotation_from_zyx<double>({row[3] * deg, row[4] * deg, row[5] * deg});
        const Eigen::Vector3d o(row[0], row[1], row[2]);
        const std::array<double, 3> u_b{.066, .110, .105};
        for (std::size_t i = 0; i < 3; ++i)
            add_point(Eigen::Vector3d(base_678[i].data()),
                      slips == Slips::both ? std::array<double, 3>{u_b[i], u_b[i], u_b[i]} : u_b);
        for (std::size_t i = 0; i < 3; ++i)
            add_point(R * Eigen::Vector3d(platform_391[i].data()) + o, {.236, .236, .236});
        p1_ = R * Eigen::Vector3d(platform_391[0].data()) + o;
        for (const char* symbol : {"x", "y", "z", "alpha", "beta", "gamma"})
            outputs_.push_back({.symbol = symbol, .name = symbol});
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        std::array<Vector3<Real>, 6> q;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t c = 0; c < 3; ++c) q[i][static_cast<int>(c)] = x[3 * i + c];
        const Matrix3<Real> Rb = axes_3_2_1(q[0], q[1], q[2], ThirdPoint::negative_y);
        const Matrix3<Real> Rp = axes_3_2_1(q[3], q[4], q[5], ThirdPoint::positive_y);
        const Vector3<Real> s_b(Real(344.0), Real(-196.0), Real(0.0)),
            s_p(Real(196.0), Real(111.0), Real(0.0));
        const Vector3<Real> o_b = q[0] + Rb * s_b, o_p = p1_.cast<Real>() + Rp * s_p;
        const Vector3<Real> d = o_p - o_b;
        const Matrix3<Real> Rb_T = Rb.transpose();
        const Vector3<Real> o = Rb_T * d;
        const Vector3<Real> angles = zyx_from_rotation<Real>(Rb_T * Rp);
        for (std::size_t i = 0; i < 3; ++i) {
            y.set(i, o[static_cast<int>(i)]);
            y.set(3 + i, angles[static_cast<int>(i)] * Real(180.0 / std::numbers::pi));
        }
        return mask_of<Real>(true);
    }

private:
    void add_point(const Eigen::Vector3d& q, const std::array<double, 3>& u) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string symbol = "q_" + std::to_string(inputs_.quantities.size());
            inputs_.add({.symbol = symbol, .name = symbol, .offset = q[static_cast<int>(c)]},
                        {{.id = symbol, .name = symbol, .distribution = Distribution::normal(u[c])}});
        }
    }
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    Eigen::Vector3d p1_;
};

int reproduced_cells(Slips slips) {
    int count = 0;
    for (std::size_t k = 0; k < poses; ++k) {
        const Variant model(k, slips);
        const UncertaintyResult r = evaluate_first_order(model, model.inputs(), {}).value();
        for (std::size_t j = 0; j < 6; ++j) {
            const double U = 2.0 * r.outputs[j].first_order.standard_uncertainty;
            count += std::abs(U - (j < 3 ? table_4[j][k] : .10)) <= .005 ? 1 : 0;
        }
    }
    return count;
}

TEST(PublishedTable4, TwoSlipsReproduceAllCells) {
    EXPECT_EQ(reproduced_cells(Slips::both), 78);
}

TEST(PublishedTable4, OneSlipAloneDoesNot) {
    EXPECT_LT(reproduced_cells(Slips::only_eq_18), 60);
}

}  // namespace
}  // namespace covaria::published_table_test
