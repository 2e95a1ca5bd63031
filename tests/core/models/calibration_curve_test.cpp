// Calibration curves against published fits.
#include <gtest/gtest.h>

#include <cmath>

#include "core/model/asset.h"
#include "core/models/registry.h"
#include "core/propagation/engine.h"

namespace covaria::calibration_curve_test {
namespace {

struct Points {
    std::vector<double> x, u_x, y, u_y;
};

covaria::Setup setup_of(const Points& points, const std::string& uncertainty, int degree = 1) {
    covaria::Setup setup;
    SetupTable table;
    table.units.assign(4, Unit{});
    for (std::size_t i = 0; i < points.x.size(); ++i)
        table.rows.push_back({points.x[i], points.u_x.empty() ? SetupCell{} : SetupCell(points.u_x[i]),
                              points.y[i], points.u_y.empty() ? SetupCell{} : SetupCell(points.u_y[i])});
    setup.values["points"] = table;
    setup.values["uncertainty"] = uncertainty;
    setup.values["degree"] = Quantity{double(degree), Unit{}};
    return setup;
}

std::unique_ptr<MeasurementModel> model_of(const covaria::Setup& setup, Problems& problems) {
    const ModelDescriptor& d = *find_model("calibration-curve");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

// Pearson's data with York's weights (D. York, Can. J. Phys. 44 (1966) 1079): the exact solution is known.
Points pearson_york() {
    Points p;
    p.x = {0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
    p.y = {5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
    for (double w : {1000.0, 1000.0, 500.0, 800.0, 200.0, 80.0, 60.0, 20.0, 1.8, 1.0})
        p.u_x.push_back(1 / std::sqrt(w));
    for (double w : {1.0, 1.8, 4.0, 8.0, 20.0, 20.0, 70.0, 70.0, 100.0, 500.0})
        p.u_y.push_back(1 / std::sqrt(w));
    return p;
}

TEST(CalibrationCurve, YorksLineWithUncertaintiesInBoth) {
    Problems problems;
    const auto model = model_of(setup_of(pearson_york(), "stated"), problems);
    ASSERT_TRUE(model);
    const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
    EXPECT_NEAR(result.outputs[0].estimate, 5.47991022, 5e-9);
    EXPECT_NEAR(result.outputs[1].estimate, -0.48053341, 5e-9);
    // York et al. 2004, Table II: standard errors 0.29497 and 0.057985 in the least-squares estimation, to a
    // few per cent: these are evaluated at the adjusted points.
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 0.295, 0.02);
    EXPECT_NEAR(result.outputs[1].standard_uncertainty, 0.058, 0.004);
}

// JCGM 100 4.2.3 in disguise: the line through equally uncertain points has its textbook covariance.
TEST(CalibrationCurve, StatedUncertaintiesOfYAloneGiveTheCovarianceOfLeastSquares) {
    Points p;
    p.x = {1, 2, 3, 4, 5};
    p.y = {1.1, 1.9, 3.2, 3.9, 5.1};
    p.u_y.assign(5, 0.1);
    Problems problems;
    const auto model = model_of(setup_of(p, "stated"), problems);
    ASSERT_TRUE(model);
    const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
    EXPECT_NEAR(result.outputs[1].standard_uncertainty, 0.1 / std::sqrt(10.0), 1e-12);
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 0.1 * std::sqrt(55.0 / 50.0), 1e-12);
    EXPECT_NEAR(result.covariance(0, 1), -0.01 * 15.0 / 50.0, 1e-12);
}

TEST(CalibrationCurve, APolynomialGoesThroughItsPoints) {
    Points p;
    for (int i = 0; i < 9; ++i) {
        p.x.push_back(i);
        p.y.push_back(2.0 - 0.5 * i + 0.25 * i * i - 0.01 * i * i * i);
    }
    Problems problems;
    const auto model = model_of(setup_of(p, "residuals", 3), problems);
    ASSERT_TRUE(model);
    const auto result = evaluate_first_order(*model, model->inputs(), {}).value();
    const double expected[] = {2.0, -0.5, 0.25, -0.01};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(result.outputs[k].estimate, expected[k], 1e-9);
}

TEST(CalibrationCurve, RefusesWhatDoesNotDetermineACurve) {
    const auto message = [](const Points& points, const std::string& uncertainty, int degree) {
        Problems problems;
        EXPECT_EQ(model_of(setup_of(points, uncertainty, degree), problems), nullptr);
        return problems.items().empty() ? std::string() : problems.items().front().message;
    };
    EXPECT_NE(message({{1, 1, 1}, {}, {1, 2, 3}, {}}, "residuals", 1).find("different places"),
              std::string::npos);
    EXPECT_NE(message({{1, 2}, {}, {1, 2}, {}}, "residuals", 1).find("more points than"), std::string::npos);
    EXPECT_NE(message({{1, 2, 3}, {}, {1, 2, 3}, {}}, "stated", 1).find("is missing in row 1"),
              std::string::npos);
    EXPECT_NE(
        message({{1, 2, 3}, {}, {1, 2, 3}, {0.1, 0, 0.1}}, "stated", 1).find("greater than zero in row 2"),
        std::string::npos);
}

}  // namespace
}  // namespace covaria::calibration_curve_test
