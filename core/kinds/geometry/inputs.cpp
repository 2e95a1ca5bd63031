// Input quantities of "geometry from points": the coordinates, with what is stated, seen or known of them.
#include <cmath>

#include "core/base/name.h"
#include "core/kinds/geometry/setup.h"
#include "core/kinds/points/located_points.h"
#include "core/kinds/points/stated_figure.h"

namespace covaria::geometry {

namespace {

class InputsOfPoints {
public:
    InputsOfPoints(GeometrySetup& setup, Problems& problems) : setup_(setup), problems_(problems) {}

    InputSet build() {
        for (std::size_t k = 0; k < setup_.features.size(); ++k)
            for (std::size_t i = 0; i < setup_.features[k].points.size(); ++i) add_point(k, i);
        switch (setup_.stated.uncertainty) {
            case PointUncertainty::typed:
                add_typed();
                break;
            case PointUncertainty::scatter:
                for (const Feature& feature : setup_.features) add_scatter(feature);
                break;
            case PointUncertainty::source:
                add_source();
        }
        return std::move(inputs_);
    }

private:
    std::string label_of(std::size_t k, std::size_t i) const {
        const std::string number = std::to_string(i + 1);
        return setup_.features.size() == 1 ? number : std::to_string(k + 1) + "," + number;
    }

    void add_point(std::size_t k, std::size_t i) {
        Feature& feature = setup_.features[k];
        FeaturePoint& point = feature.points[i];
        point.first_input = inputs_.quantities.size();
        for (std::size_t c = 0; c < feature.coordinates(); ++c) {
            InputQuantity quantity{
                .symbol = std::string(along_axes[c]) + "_" + label_of(k, i),
                .name = tell<"%1, point %2, coordinate %3">(feature.name, point.name, along_axes[c]),
                .unit = Unit::of("mm"),
                .offset = point.p[static_cast<Eigen::Index>(c)],
                .group = feature.name,
                .source = geometry_fields().place(&StatedGeometry::points, point.row)};
            inputs_.quantities.push_back(std::move(quantity));
        }
    }

    std::size_t add_component(std::string id, Message name, double u, bool local) {
        UncertaintyComponent component{.id = std::move(id),
                                       .name = std::move(name),
                                       .unit = Unit::of("mm"),
                                       .distribution = distribution_of_shape(setup_.stated.distribution, u),
                                       .origin = tell<"typed standard uncertainty">()};
        component.local = local;
        return inputs_.add(std::move(component));
    }

    void add_typed() {
        std::array<std::size_t, 3> common{};
        for (std::size_t c = 0; c < 3; ++c)
            if (const double u = setup_.stated.u_common[c]; u > 0.0)
                common[c] =
                    add_component(std::string("common.") + along_axes[c],
                                  tell<"common deviation of all points along %1">(along_axes[c]), u, false);
        for (const Feature& feature : setup_.features)
            for (const FeaturePoint& point : feature.points) {
                const StatedPoint& stated = setup_.stated.points[point.row];
                std::array<std::size_t, 3> own{};
                for (std::size_t c = 0; c < feature.coordinates(); ++c) {
                    InputQuantity& quantity = inputs_.quantities[point.first_input + c];
                    own[c] = add_component(quantity.symbol + ".point", tell<"measured coordinate">(),
                                           stated.u[c].value_or(setup_.stated.u_point), false);
                    quantity.shares = {{own[c], 1.0}};
                    if (setup_.stated.u_common[c] > 0.0) quantity.shares.push_back({common[c], 1.0});
                }
                add_correlations(stated, feature.coordinates(), own);
            }
    }

    void add_correlations(const StatedPoint& stated, std::size_t coordinates,
                          const std::array<std::size_t, 3>& own) {
        static constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
        for (std::size_t k = 0; k < 3; ++k)
            if (stated.r[k] && *stated.r[k] != 0.0 && pairs[k][1] < coordinates)
                inputs_.correlations.push_back({own[pairs[k][0]], own[pairs[k][1]], *stated.r[k]});
    }

    std::size_t add_scattering(const Feature& feature, const std::string& estimate, std::string id,
                               double s) {
        const auto nu = double(feature.degrees_of_freedom());
        UncertaintyComponent component{
            .id = std::move(id),
            .name = tell<"scatter of the points of %1">(feature.name),
            .unit = Unit::of("mm"),
            .distribution = Distribution::of(StudentT{0.0, s, nu}),
            .type = EvaluationType::type_a,
            .degrees_of_freedom = nu,
            .origin = tell<"residuals of %1 points about %2">(feature.points.size(), feature.name)};
        component.local = true;
        const std::size_t index = inputs_.add(std::move(component));
        inputs_.rest_on_estimate(feature.name + estimate, index);
        return index;
    }

    /// Alike along all axes; of a circle in its plane and across it, which scatter by themselves.
    void add_scatter(const Feature& feature) {
        if (!(feature.s > 0.0)) return;
        const bool in_plane = feature.form() == Form::circle;
        const Eigen::Matrix3d axes = in_plane ? feature.fitted.axes : Eigen::Matrix3d::Identity();
        for (const FeaturePoint& point : feature.points)
            for (std::size_t c = 0; c < feature.coordinates(); ++c) {
                const bool across = in_plane && c == 2;
                const double s = across ? feature.s_plane : feature.s;
                if (!(s > 0.0)) continue;
                const std::size_t component =
                    add_scattering(feature, across ? ".plane" : ".scatter",
                                   inputs_.quantities[point.first_input + c].symbol + ".scatter", s);
                for (std::size_t k = 0; k < feature.coordinates(); ++k)
                    if (const double share = axes(Eigen::Index(k), Eigen::Index(c)); share != 0.0)
                        inputs_.quantities[point.first_input + k].shares.push_back({component, share});
            }
    }

    void add_source() {
        const auto& instrument = setup_.stated.instrument;
        const auto* outputs = offers<PointOutputSource>(instrument.asset);
        std::vector<LocatedPoint> located;
        for (std::size_t k = 0; k < setup_.features.size(); ++k) {
            const Feature& feature = setup_.features[k];
            if (!outputs && facts_of(feature.form()).is_flat) {
                problems_.error(
                    geometry_fields().place(&StatedGeometry::features, k),
                    tell<"an instrument measures points in space; '%1' lies in the xy-plane: state the "
                         "uncertainty of its points">(feature.name));
                continue;
            }
            for (std::size_t i = 0; i < feature.points.size(); ++i) {
                const FeaturePoint& point = feature.points[i];
                for (std::size_t c = 0; outputs && c < feature.coordinates(); ++c)
                    inputs_.quantities[point.first_input + c].taken_from = outputs->coordinate(point.name, c);
                located.push_back({point.p, label_of(k, i), point.first_input, point.name});
            }
        }
        if (outputs || problems_.has_errors()) return;
        PointLocator locator;
        locator.typed = false;
        locator.instrument = instrument;
        add_point_components(locator, located, inputs_, problems_);
    }

    GeometrySetup& setup_;
    Problems& problems_;
    InputSet inputs_;
};

}  // namespace

InputSet geometry_inputs(GeometrySetup& setup, Problems& problems) {
    return InputsOfPoints(setup, problems).build();
}

}  // namespace covaria::geometry
