#include "core/kinds/geometry/tables.h"

#include <algorithm>
#include <cmath>

#include "core/kinds/geometry/start.h"
#include "core/math/decompositions.h"
#include "core/text/numbers.h"

namespace covaria::geometry {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double strong_correlation = 0.99;

/// Indices among the parameters of the centre across, the slopes and the radius; npos: the form has none.
struct ParameterPlaces {
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
    std::size_t centre = npos, centre_count = 0, slopes = npos, slope_count = 0, offset = npos, radius = npos;
    std::size_t height = npos;  ///< height of the middle of the arc
};

ParameterPlaces places_in(Form form) {
    constexpr std::size_t none = ParameterPlaces::npos;
    switch (form) {
        case Form::point:
            return {0, 3, none, 0, none, none, none};
        case Form::line_2d:
            return {none, 0, 1, 1, 0, none, none};
        case Form::line:
            return {0, 2, 2, 2, none, none, none};
        case Form::plane:
            return {none, 0, 1, 2, 0, none, none};
        case Form::circle_2d:
            return {0, 2, none, 0, none, 2, 0};
        case Form::circle:
            return {3, 2, 1, 2, 0, 5, 3};
        case Form::sphere:
            return {0, 3, none, 0, none, 3, 2};
        case Form::cylinder:
        case Form::cone:
            break;
    }
    return {0, 2, 2, 2, none, 4, 0};
}

/// Uncertainties of a feature for a u of 1 in every coordinate, whatever that of the points really is.
struct ConditionOfFeature {
    std::vector<double> centre, slopes;  ///< along their principal axes, falling
    double offset = 0.0, radius = 0.0, angle = 0.0;
    double correlation = 0.0;  ///< correlation of the radius and the centre, along the middle of the arc
    double covered = 0.0;      ///< largest angle of a point from the middle of the arc
};

std::vector<double> principal(const MatrixXd& block) {
    const Eigen::VectorXd values = eigen_decomposition(block).eigenvalues().reverse();
    std::vector<double> roots;
    for (const double value : values) roots.push_back(std::sqrt(std::max(0.0, value)));
    return roots;
}

double covered_angle(const Feature& feature) {
    const Shape<double> shape(feature.form(), feature.fitted.v);
    const bool is_sphere = feature.form() == Form::sphere;
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero(),
                          middle = is_sphere ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    double largest = 0.0;
    for (const FeaturePoint& point : feature.points) {
        Eigen::Vector3d w = feature.fitted.to_local<double>(point.p) - shape.place(zero);
        if (!is_sphere) w -= shape.direction() * shape.direction().dot(w);
        largest = std::max(largest, std::atan2(w.cross(middle).norm(), w.dot(middle)));
    }
    return largest;
}

ConditionOfFeature condition_of(const Feature& feature) {
    const ParameterPlaces at = places_in(feature.form());
    MatrixXd C = cofactors(feature.fitted, feature.places());
    if (at.height != ParameterPlaces::npos) {  // the centre is at h - r
        MatrixXd T = MatrixXd::Identity(C.rows(), C.cols());
        T(Index(at.height), Index(at.radius)) = -1.0;
        C = (T * C * T.transpose()).eval();
    }
    const auto root = [&](std::size_t i) { return std::sqrt(C(Index(i), Index(i))); };
    ConditionOfFeature condition;
    const auto block = [&](std::size_t first, std::size_t count) {
        return principal(C.block(Index(first), Index(first), Index(count), Index(count)));
    };
    if (at.centre_count > 0) condition.centre = block(at.centre, at.centre_count);
    if (at.slope_count > 0) condition.slopes = block(at.slopes, at.slope_count);
    if (at.offset != ParameterPlaces::npos) condition.offset = root(at.offset);
    if (feature.form() == Form::cone) condition.angle = 2.0 * root(5);
    if (at.radius == ParameterPlaces::npos) return condition;
    condition.radius = root(at.radius);
    condition.correlation = C(Index(at.radius), Index(at.height)) / (root(at.radius) * root(at.height));
    condition.covered = covered_angle(feature);
    return condition;
}

class ConditionTable {
public:
    Table table(const GeometrySetup& setup) {
        table_.add("feature");
        table_.add("quantity");
        table_.add(known_text<"at a standard deviation of 1 mm">()).figure(7);
        table_.add(known_text<"at the scatter of the points">()).figure(4);
        for (const Feature& feature : setup.features) add(feature);
        table_.notes = {
            tell<"Standard uncertainties that independent deviations of all coordinates alike would give, "
                 "first with a standard deviation of 1 mm: they depend on where the points are alone. "
                 "Places and tilts are along the directions in which they are largest and smallest.">()};
        return std::move(table_);
    }

private:
    void add(const Feature& feature) {
        const ConditionOfFeature condition = condition_of(feature);
        feature_ = &feature;
        const bool has_axis =
            feature.form() == Form::line || feature.form() == Form::cylinder || feature.form() == Form::cone;
        for (const double root : condition.centre)
            length(has_axis ? tell<"place across the axis">() : tell<"place">(), root);
        if (condition.offset > 0.0)
            length(feature.form() == Form::line_2d ? tell<"offset across the line">()
                                                   : tell<"offset along the normal">(),
                   condition.offset);
        for (const double root : condition.slopes) angle(tell<"tilt">(), root);
        if (!(condition.radius > 0.0)) return;
        length(tell<"diameter">(), 2.0 * condition.radius);
        if (condition.angle > 0.0) angle(tell<"angle of the cone">(), condition.angle);
        line(tell<"correlation of diameter and centre along the middle of the arc">(), condition.correlation,
             {});
        line(tell<"angle to both sides of that middle within which the points are">(),
             Quantity{Unit::of("deg").from_si(condition.covered), Unit::of("deg")}, {});
    }
    void line(Message words, Cell factor, Cell at_scatter) {
        table_.row({feature_->name, std::move(words), std::move(factor), std::move(at_scatter)});
    }
    Cell scaled(double root, const Unit& unit) const {
        if (!(feature_->s > 0.0)) return {};
        return Quantity{unit.from_si(root * feature_->s), unit};
    }
    void length(Message words, double root) {
        const Unit mm = Unit::of("mm");
        line(std::move(words), Quantity{root, mm}, scaled(root, mm));
    }
    void angle(Message words, double root) {
        const Unit mrad = Unit::of("mrad");
        line(std::move(words), Quantity{root, mrad}, scaled(root, mrad));
    }

    Table table_{"condition", known_text<"How well the points determine the features">()};
    const Feature* feature_ = nullptr;
};

Table features_table(const GeometrySetup& setup) {
    const Unit mm = Unit::of("mm");
    Table table{"features", known_text<"Features and the scatter of their points">()};
    table.add("feature");
    table.add("form");
    table.add("points");
    table.add(known_text<"degrees of freedom">());
    table.add("s").in(mm).symbol().figure(9);
    table.add(known_text<"largest deviation">()).in(mm).figure(4);
    table.add(known_text<"of">());
    for (const Feature& feature : setup.features) {
        const Deviations deviations = deviations_of(feature.fitted, feature.places());
        const auto largest = std::max_element(deviations.d.begin(), deviations.d.end(),
                                              [](double a, double b) { return std::abs(a) < std::abs(b); });
        const bool free = feature.degrees_of_freedom() > 0;
        const std::size_t i = std::size_t(largest - deviations.d.begin());
        table.row({feature.name, words_of(feature.form()), double(feature.points.size()),
                   double(feature.degrees_of_freedom()), free ? Cell(feature.s) : Cell(),
                   free ? Cell(*largest) : Cell(), free ? Cell(feature.points[i].name) : Cell()});
    }
    table.notes = {
        tell<"s is the root of the sum of squares of the deviations over the degrees of freedom.">()};
    return table;
}

Table deviations_table(const GeometrySetup& setup) {
    const Unit mm = Unit::of("mm");
    Table table{"deviations", known_text<"Deviations of the points from their features">()};
    table.add("feature");
    table.add("point");
    table.add("deviation").in(mm).figure(4);
    const bool has_circle = std::any_of(setup.features.begin(), setup.features.end(),
                                        [](const Feature& f) { return f.form() == Form::circle; });
    if (has_circle) table.add(known_text<"above the plane of the circle">()).in(mm).figure(4);
    for (const Feature& feature : setup.features) {
        const Deviations deviations = deviations_of(feature.fitted, feature.places());
        // the normal that is stated, not that of the local axes
        const bool turned =
            feature.fitted.sign < 0.0 && (feature.form() == Form::plane || feature.form() == Form::line_2d);
        for (std::size_t i = 0; i < feature.points.size(); ++i) {
            std::vector<Cell> row{feature.name, feature.points[i].name,
                                  turned ? -deviations.d[i] : deviations.d[i]};
            if (has_circle)
                row.push_back(deviations.heights.empty() ? Cell()
                                                         : Cell(feature.fitted.sign * deviations.heights[i]));
            table.row(std::move(row));
        }
    }
    table.notes = {
        tell<"Positive outside of a circle, sphere, cylinder or cone and on the side of a plane to which its "
             "normal points; of a line in space the distance.">()};
    return table;
}

}  // namespace

std::vector<Table> geometry_tables(const GeometrySetup& setup) {
    return {features_table(setup), ConditionTable().table(setup), deviations_table(setup)};
}

void warn_of_condition(const GeometrySetup& setup, Problems& problems) {
    for (std::size_t k = 0; k < setup.features.size(); ++k) {
        const Feature& feature = setup.features[k];
        if (!facts_of(feature.form()).has_diameter) continue;
        const ConditionOfFeature condition = condition_of(feature);
        if (std::abs(condition.correlation) < strong_correlation) continue;
        problems.warning(
            geometry_fields().place(&StatedGeometry::features, k),
            tell<"the points of '%1' are within %2° of the middle of their arc: its diameter has %3 times "
                 "the standard uncertainty of a coordinate and correlates with the place of the centre by "
                 "%4">(feature.name,
                       Message::number(format_short(Unit::of("deg").from_si(condition.covered), 2)),
                       Message::number(format_short(2.0 * condition.radius, 2)),
                       Message::number(format_short(condition.correlation, 4))));
    }
}

}  // namespace covaria::geometry
