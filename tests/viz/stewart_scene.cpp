// The Stewart platform of the picture tests.
#include "tests/viz/stewart_scene.h"

#include <cmath>
#include <cstdint>

namespace covaria::test {
namespace {

constexpr double height = 1.175;
constexpr std::array<std::array<double, 3>, 6> nests{{{-0.344, 0.196, 0},
                                                      {0.344, 0.196, 0},
                                                      {0, -0.399825, 0},
                                                      {-0.196, -0.111, height},
                                                      {0.196, -0.111, height},
                                                      {0, 0.228482, height}}};
constexpr std::array<double, 3> u_base{66e-6, 110e-6, 105e-6};
constexpr double u_platform = 236e-6;

/// Sum of twelve uniforms less six: near enough to normal for a picture.
class Draws {
public:
    double normal() {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
            sum += static_cast<double>(state_ >> 11) * 0x1p-53;
        }
        return sum;
    }

private:
    std::uint64_t state_ = 20'240'607;
};

double u_of(std::size_t nest, std::size_t axis) {
    return nest < 3 ? u_base[axis] : u_platform;
}

void add_layout(Layout& layout) {
    LayoutFrame base{"base b", Eigen::Isometry3d::Identity(), "", {"/base_frame"}};
    LayoutFrame platform{"platform p", Eigen::Isometry3d::Identity(), "pose 3", {}};
    platform.X_WF.translation() = Eigen::Vector3d(0, 0, height);
    layout.frames = {base, platform};
    LayoutBody plates[2] = {{"base", BodyKind::plate}, {"moving platform", BodyKind::plate}};
    plates[1].group = "pose 3";
    for (std::size_t i = 0; i < nests.size(); ++i) {
        const Eigen::Vector3d p(nests[i][0], nests[i][1], nests[i][2]);
        LayoutPoint point{(i < 3 ? "b" : "p") + std::to_string(i % 3 + 1), PointKind::nest, p};
        point.group = i < 3 ? "" : "pose 3";
        point.inputs = {{3 * i, 3 * i + 1, 3 * i + 2}};
        point.source.path = i < 3 ? "/base_points/rows/" + std::to_string(i)
                                  : "/platform_points/rows/" + std::to_string(i - 3);
        point.source.draggable = i < 3;
        layout.points.push_back(point);
        plates[i / 3].outline_W.push_back(p);
    }
    layout.bodies = {plates[0], plates[1]};
    LayoutPoint origin{"platform origin", PointKind::other, platform.X_WF.translation(), "pose 3"};
    origin.outputs = {{0, 1, 2}};
    layout.points.push_back(origin);
    layout.points.push_back({"elsewhere", PointKind::target, {5, 5, 5}, "pose 4"});
}

void add_inputs(InputSet& inputs, double scale) {
    for (std::size_t i = 0; i < nests.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            UncertaintyComponent component;
            component.id = std::to_string(i) + "." + std::to_string(k);
            component.distribution = Distribution::normal(scale * u_of(i, k));
            InputQuantity quantity;
            quantity.symbol = component.id;
            quantity.offset = nests[i][k];
            quantity.shares = {{inputs.components.size(), 1.0}};
            inputs.components.push_back(component);
            inputs.quantities.push_back(quantity);
        }
}

/// u(x) = 0.367 mm, u(y) = 0.313 mm, u(z) = 0.149 mm, and r(x, y) = -0.3 to have something to see.
Eigen::Matrix3d output_covariance(double scale) {
    const Eigen::Vector3d u = scale * Eigen::Vector3d(367e-6, 313e-6, 149e-6);
    Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
    r(0, 1) = r(1, 0) = -0.3;
    return u.asDiagonal() * r * u.asDiagonal();
}

void add_outputs(UncertaintyResult& result, double scale) {
    const Eigen::Matrix3d covariance = output_covariance(scale);
    result.covariance = covariance;
    for (int i = 0; i < 3; ++i) {
        OutputResult output;
        output.quantity.symbol = std::string(1, "xyz"[i]);
        output.quantity.group = "pose 3";
        output.first_order.estimate = i == 2 ? height : 0.0;
        output.estimate = output.first_order.estimate;
        output.standard_uncertainty = std::sqrt(covariance(i, i));
        output.expanded_uncertainty = 2 * output.standard_uncertainty;
        result.outputs.push_back(output);
    }
}

}  // namespace

StewartSetup stewart_setup(int trials, double scale) {
    StewartSetup setup;
    add_layout(setup.layout);
    InputSet inputs;
    add_inputs(inputs, scale);
    setup.result.inputs = std::move(inputs);
    add_outputs(setup.result, scale);
    Draws draws;
    setup.input_trials.resize(18, trials);
    setup.output_trials.resize(3, trials);
    const double c = std::sqrt(1 - 0.3 * 0.3);
    for (int t = 0; t < trials; ++t) {
        for (int i = 0; i < 18; ++i) {
            const auto nest = static_cast<std::size_t>(i / 3), axis = static_cast<std::size_t>(i % 3);
            setup.input_trials(i, t) = nests[nest][axis] + scale * u_of(nest, axis) * draws.normal();
        }
        const double a = draws.normal(), b = draws.normal();
        setup.output_trials.col(t) << scale * 367e-6 * a, scale * 313e-6 * (-0.3 * a + c * b),
            height + scale * 149e-6 * draws.normal();
    }
    return setup;
}

Scene stewart_with_tracker() {
    StewartSetup setup = stewart_setup(200);
    LayoutBody tracker{"tracker", BodyKind::instrument};
    tracker.glyph = "tracker";
    tracker.X_WB.translation() = Eigen::Vector3d(2, 0, 1);
    setup.layout.bodies.push_back(tracker);
    setup.layout.links.push_back({"sight", LinkKind::sight_line, {2, 0, 1}, setup.layout.points[0].p_W});
    return build_scene(setup.source(), {});
}

}  // namespace covaria::test
