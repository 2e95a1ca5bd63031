#include "core/kinds/geometry/setup.h"

#include <cmath>
#include <map>
#include <set>

#include "core/kinds/geometry/feature_source.h"
#include "core/kinds/geometry/start.h"

namespace covaria::geometry {

namespace {

constexpr double no_deviation = 1e-10;  // relative to the size: less belongs to computed points

std::string row_of(std::size_t row) {
    return geometry_fields().place(&StatedGeometry::points, row);
}

class GeometryReading {
public:
    GeometryReading(StatedGeometry stated, Problems& problems) : problems_(problems) {
        read_.stated = std::move(stated);
        if (read_.stated.uncertainty == PointUncertainty::source) take_source(read_.stated.instrument.asset);
    }

    std::optional<GeometrySetup> read() {
        list_features();
        if (problems_.has_errors()) return {};
        for (std::size_t row = 0; row < read_.stated.points.size(); ++row) take_point(row);
        if (problems_.has_errors()) return {};
        for (std::size_t k = 0; k < read_.features.size(); ++k) fit_feature(k);
        if (problems_.has_errors()) return {};
        return std::move(read_);
    }

private:
    void take_source(const std::shared_ptr<const Asset>& source) {
        outputs_ = offers<PointOutputSource>(source);
        estimates_ = offers<FeatureSource>(source);
    }

    void list_features() {
        for (std::size_t k = 0; k < read_.stated.features.size(); ++k) {
            const StatedFeature& stated = read_.stated.features[k];
            if (!by_name_.emplace(stated.name, k).second)
                problems_.error(geometry_fields().place(&StatedGeometry::features, k),
                                tell<"two features are called '%1'">(stated.name));
            Feature feature{.name = stated.name, .fitted = {}, .points = {}};
            feature.fitted.form = stated.form;
            read_.features.push_back(std::move(feature));
        }
    }

    void take_point(std::size_t row) {
        const StatedPoint& stated = read_.stated.points[row];
        if (!stated.feature.empty()) {
            const auto found = by_name_.find(stated.feature);
            if (found == by_name_.end())
                return problems_.error(row_of(row), tell<"there is no feature '%1'">(stated.feature));
            current_ = found->second;
        }
        Feature& feature = read_.features[current_];
        FeaturePoint point{
            .name = stated.name.empty() ? std::to_string(feature.points.size() + 1) : stated.name,
            .row = row};
        if (!names_.insert({current_, point.name}).second)
            problems_.error(row_of(row),
                            tell<"two points of '%1' are called '%2'">(feature.name, point.name));
        if (outputs_ && !outputs_->coordinate(point.name, 0))
            return problems_.error(
                row_of(row), tell<"%1 has no point called '%2'">(read_.stated.instrument.name, point.name));
        const std::optional<Eigen::Vector3d> measured =
            estimates_ ? estimates_->place(point.name) : std::nullopt;
        for (std::size_t c = 0; c < feature.coordinates(); ++c) {
            if (!stated.p[c] && !measured)
                return problems_.error(row_of(row) + "/" + along_axes[c],
                                       tell<"point '%1' has no coordinate %2">(point.name, along_axes[c]));
            const auto i = static_cast<Eigen::Index>(c);
            point.p[i] = stated.p[c] ? *stated.p[c] : (*measured)[i];
        }
        feature.points.push_back(std::move(point));
    }

    void fit_feature(std::size_t k) {
        Feature& feature = read_.features[k];
        const std::string place = geometry_fields().place(&StatedGeometry::features, k);
        const std::size_t n = feature.points.size(), least = facts_of(feature.form()).least_points;
        if (n < least)
            return problems_.error(place, tell<"'%1' has %2 points; a %3 needs %4 or more">(
                                              feature.name, n, words_of(feature.form()), least));
        const bool from_scatter = read_.stated.uncertainty == PointUncertainty::scatter;
        const std::size_t nu = feature.degrees_of_freedom();
        if (from_scatter && nu == 0)
            return problems_.error(
                place, tell<"the %1 points of '%2' do not scatter: with so few the form goes through all of "
                            "them; add points, or state their uncertainty">(n, feature.name));
        auto fitted = fitted_form(feature.form(), feature.places());
        if (!fitted)
            return problems_.error(place,
                                   tell<"the points of '%1': %2">(feature.name, fitted.error().message));
        feature.fitted = std::move(*fitted);
        if (read_.stated.features[k].reversed) feature.fitted.sign = -feature.fitted.sign;
        const Deviations deviations = deviations_of(feature.fitted, feature.places());
        if (nu > 0) {
            feature.s = std::sqrt(deviations.squares / double(nu));
            feature.s_plane = std::sqrt(deviations.squares_of_heights / double(nu));
        }
        const bool deviates = std::sqrt(deviations.squares / double(n)) > no_deviation * feature.fitted.size;
        feature.has_form = read_.stated.with_form && nu > 0 && deviates && feature.form() != Form::point;
        if (from_scatter && !deviates)
            problems_.warning(place, tell<"the points of '%1' lie exactly on it: their scatter says nothing "
                                          "of their uncertainty">(feature.name));
    }

    Problems& problems_;
    GeometrySetup read_;
    const PointOutputSource* outputs_ = nullptr;
    const FeatureSource* estimates_ = nullptr;
    std::map<std::string, std::size_t> by_name_;
    std::set<std::pair<std::size_t, std::string>> names_;
    std::size_t current_ = 0;
};

}  // namespace

std::optional<GeometrySetup> read_geometry_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                 Problems& problems) {
    StatedGeometry stated = geometry_fields().read(reader, assets, problems);
    if (problems.has_errors()) return {};
    return GeometryReading(std::move(stated), problems).read();
}

Deviations deviations_of(const FittedForm& fitted, const std::vector<Eigen::Vector3d>& points) {
    const Shape<double> shape(fitted.form, fitted.v);
    Rows<double> rows;
    Deviations deviations;
    for (const Eigen::Vector3d& p : points) {
        shape.rows(fitted.to_local<double>(p), rows);
        deviations.d.push_back(deviation_of<double>(fitted.form, rows));
        deviations.squares += square_of<double>(fitted.form, rows);
        if (fitted.form != Form::circle) continue;
        deviations.heights.push_back(rows.d[0]);
        deviations.squares_of_heights += rows.d[0] * rows.d[0];
    }
    return deviations;
}

}  // namespace covaria::geometry
