// The set-up of "geometry from points", read and fitted.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/geometry/fit.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria::geometry {

struct StatedFeature {
    std::string name;
    Form form = Form::plane;
    bool reversed = false;
};

struct StatedPoint {
    std::string feature, name;
    std::array<std::optional<double>, 3> p = {}, u = {};
    std::array<std::optional<double>, 3> r = {};  ///< correlation of x and y, x and z, y and z
};

enum class PointUncertainty { typed, scatter, source };

struct StatedGeometry {
    std::vector<StatedFeature> features;
    std::vector<StatedPoint> points;
    PointUncertainty uncertainty = PointUncertainty::typed;
    double u_point = 0.0;
    std::array<double, 3> u_common{};
    std::string distribution;
    Offered<PointUncertaintySource> instrument;
    bool with_form = true;
};
const Fields<StatedGeometry>& geometry_fields();

struct FeaturePoint {
    std::string name;
    std::size_t row = 0;  ///< row in the table of points
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    std::size_t first_input = 0;  ///< x; y and z follow, of flat forms y alone
};

struct Feature {
    std::string name;
    FittedForm fitted;
    std::vector<FeaturePoint> points;
    bool has_form = false;  ///< its deviations are results
    double s = 0.0;         ///< standard deviation of the points about it
    double s_plane = 0.0;   ///< standard deviation about its plane, of a circle

    Form form() const { return fitted.form; }
    std::size_t coordinates() const { return facts_of(form()).is_flat ? 2 : 3; }
    std::size_t degrees_of_freedom() const { return geometry::degrees_of_freedom(form(), points.size()); }
    std::vector<Eigen::Vector3d> places() const {
        std::vector<Eigen::Vector3d> all;
        for (const FeaturePoint& point : points) all.push_back(point.p);
        return all;
    }
};

struct GeometrySetup {
    StatedGeometry stated;
    std::vector<Feature> features;
};

/// Empty if `problems` got an error.
std::optional<GeometrySetup> read_geometry_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                 Problems& problems);

/// The coordinates with their components; says in the features where they are.
InputSet geometry_inputs(GeometrySetup& setup, Problems& problems);

/// Deviations of the points from a form.
struct Deviations {
    std::vector<double> d;        ///< deviations as by `deviation_of`
    std::vector<double> heights;  ///< heights above its plane, of a circle
    double squares = 0.0, squares_of_heights = 0.0;
};
Deviations deviations_of(const FittedForm& fitted, const std::vector<Eigen::Vector3d>& points);

}  // namespace covaria::geometry
