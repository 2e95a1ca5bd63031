// Artefact with calibrated points (Porath et al., section 2.1, Eqs 1-3).
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/name.h"
#include "core/kinds/points/artefact_fields.h"
#include "core/kinds/points/assets.h"
#include "core/kinds/points/own_frame_source.h"
#include "core/kinds/points/point_uncertainty.h"

namespace covaria {

namespace {

constexpr std::array<const char*, 3> coordinates{"x", "y", "z"};

/// Coordinates left out of the errors since they define the frame.
enum class Excluded { three_two_one, by_point, none };

struct CalibratedPoint {
    std::string name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::string defines;  ///< coordinates that define the frame, by_point
};

struct MeasuredPoint {
    std::string point;
    int run = 0;
    Eigen::Vector3d indicated = Eigen::Vector3d::Zero();
};

struct CoordinateComponents {
    std::size_t coordinate = 0;
    PrintedComponents printed;
};

struct StatedArtefact {
    std::vector<CalibratedPoint> points;
    bool from_observations = true;
    std::vector<MeasuredPoint> observations;
    std::vector<CoordinateComponents> components;
    Excluded excluded = Excluded::three_two_one;
    StatedBias bias;
    MeasuredArtefact measured;
    bool by_distance = true;  ///< L_max of Eq 3
};

/// Eq 1 for one measured point; coordinates that define the frame are empty.
struct ObservedErrors {
    std::string point;
    int run = 0;
    std::array<std::optional<double>, 3> e;
};

std::array<ColumnSpec, 3> coordinate_columns(const std::string& sort) {
    std::array<ColumnSpec, 3> columns;
    for (std::size_t i = 0; i < 3; ++i)
        columns[i] = {.key = coordinates[i],
                      .title = coordinates[i],
                      .unit = Unit::of("mm"),
                      .help = sort + " coordinate " + coordinates[i] + "."};
    return columns;
}

void add_points(Fields<StatedArtefact>& fields) {
    fields.section("Artefact")
        .table(&StatedArtefact::points, "points", "Calibrated points",
               "The artefact's points with their calibrated coordinates in the artefact's frame.",
               Columns<CalibratedPoint>()
                   .add(&CalibratedPoint::name, "name", "point", "Name of the point.")
                   .each(&CalibratedPoint::position, coordinate_columns("Calibrated"))
                   .add(&CalibratedPoint::defines, "defines", "defines",
                        "Coordinates that define the frame (\"xyz\", \"yz\"), when they are named by point.",
                        {.optional = true}),
               {.optional = true, .measured = true});
    add_evaluation(fields, "Table 1");
    fields
        .table(&StatedArtefact::observations, "observations", "Observations",
               "Measured coordinates in the artefact's frame: one row for each point and run, typed or from "
               "a CSV file.",
               Columns<MeasuredPoint>()
                   .add(&MeasuredPoint::point, "point", "point", "Name of a calibrated point.")
                   .add(&MeasuredPoint::run, "run", "run", "Number of the repetition.")
                   .each(&MeasuredPoint::indicated, coordinate_columns("Indicated")),
               {.optional = true, .measured = true})
        .table(&StatedArtefact::components, "components", "Components of uncertainty",
               "One row for each coordinate, as Table 1 of the paper prints them.",
               Columns<CoordinateComponents>()
                   .choice(&CoordinateComponents::coordinate, "coordinate", "coordinate",
                           "Coordinate of the row.", {{0, "x", "x"}, {1, "y", "y"}, {2, "z", "z"}})
                   .part(&CoordinateComponents::printed, component_columns()),
               {.optional = true});
}

const Fields<StatedArtefact>& artefact_fields() {
    using S = StatedArtefact;
    static const auto fields = [] {
        Fields<S> made;
        add_points(made);
        made.choice(&S::excluded, "excluded", "Coordinates that define the frame",
                    "Errors of these coordinates are zero by construction of the frame and are left out of "
                    "the statistics.",
                    {{Excluded::three_two_one, "three-two-one", "first point x, y, z; second y, z; third z"},
                     {Excluded::by_point, "by-point", "as the points' column 'defines' says"},
                     {Excluded::none, "none", "none"}},
                    Excluded::three_two_one)
            .part(&S::bias, bias_fields())
            .part(&S::measured, measured_artefact_fields())
            .section("Temperature")
            .choice(&S::by_distance, "l_max", "Length for the thermal expansion",
                    "L_max of Eq 3. The paper's figures result with the largest distance between two "
                    "points; its text says the largest value of the coordinate, which gives 0 for a flat "
                    "artefact's z.",
                    {{true, "largest-distance", "largest distance between two points"},
                     {false, "largest-coordinate", "largest value of the coordinate (text of Eq 3)"}},
                    true)
            .shown_where(&S::from_observations, {true}, &S::observations, &S::excluded, &S::measured,
                         &S::by_distance)
            .shown_where(&S::from_observations, {false}, &S::components);
        return made;
    }();
    return fields;
}

class ArtefactEvaluation {
public:
    ArtefactEvaluation(const StatedArtefact& stated, Problems& problems)
        : stated_(stated), problems_(problems) {
        std::set<std::string> names;
        for (std::size_t row = 0; row < stated_.points.size(); ++row) {
            const std::string& name = stated_.points[row].name;
            if (!names.insert(name).second)
                problems_.error(artefact_fields().place(&StatedArtefact::points, row),
                                tell<"there are two points called '%1'; rename one">(name));
            defines_.push_back(defined_by(row));
        }
    }

    std::vector<ObservedErrors> errors() {
        const double expansion_at = stated_.measured.expansion_at();
        std::vector<ObservedErrors> all;
        for (std::size_t row = 0; row < stated_.observations.size(); ++row) {
            const MeasuredPoint& observation = stated_.observations[row];
            const auto point =
                std::find_if(stated_.points.begin(), stated_.points.end(),
                             [&](const CalibratedPoint& p) { return p.name == observation.point; });
            if (point == stated_.points.end()) {
                problems_.error(
                    artefact_fields().place(&StatedArtefact::observations, row, &MeasuredPoint::point),
                    tell<"there is no calibrated point called '%1'">(observation.point));
                continue;
            }
            ObservedErrors observed{observation.point, observation.run, {}};
            const auto& defines = defines_[static_cast<std::size_t>(point - stated_.points.begin())];
            const Eigen::Vector3d e = observation.indicated / expansion_at - point->position;  // Eq 1
            for (std::size_t i = 0; i < 3; ++i)
                if (!defines[i]) observed.e[i] = e[static_cast<int>(i)];
            all.push_back(observed);
        }
        return all;
    }

    std::vector<ErrorBudget> budgets(const std::vector<ObservedErrors>& errors) {
        return stated_.from_observations ? measured_budgets(errors) : printed_budgets();
    }

private:
    std::array<bool, 3> defined_by(std::size_t row) {
        if (!stated_.from_observations || stated_.excluded == Excluded::none) return {};
        if (stated_.excluded == Excluded::three_two_one) return {row < 1, row < 2, row < 3};
        const std::string& letters = stated_.points[row].defines;
        if (letters.find_first_not_of("xyz") != std::string::npos)
            problems_.error(artefact_fields().place(&StatedArtefact::points, row, &CalibratedPoint::defines),
                            tell<"'%1' must consist of the letters x, y and z">(letters));
        const auto has = [&](char c) { return letters.find(c) != std::string::npos; };
        return {has('x'), has('y'), has('z')};
    }

    std::vector<ErrorBudget> measured_budgets(const std::vector<ObservedErrors>& errors) {
        std::vector<ErrorBudget> budgets;
        for (std::size_t i = 0; i < 3; ++i) {
            std::vector<double> e;
            for (const ObservedErrors& observed : errors)
                if (observed.e[i]) e.push_back(*observed.e[i]);
            Result<ErrorBudget> budget = budget_of_errors(coordinates[i], e);
            if (!budget) {
                problems_.error(artefact_fields().place(&StatedArtefact::observations),
                                tell<"coordinate %1 has fewer than two observations that do not define the "
                                     "frame: measure more points or runs">(coordinates[i]));
                continue;
            }
            budget->u_calibration = stated_.measured.u_calibration;
            budget->u_temperature =
                temperature_uncertainty(expansion_length(static_cast<int>(i)), stated_.measured.expansion,
                                        stated_.measured.deviation);
            budgets.push_back(*budget);
        }
        return budgets;
    }

    // L_max of Eq 3.
    double expansion_length(int i) const {
        double largest = 0.0;
        for (const CalibratedPoint& p : stated_.points) {
            if (!stated_.by_distance) largest = std::max(largest, std::abs(p.position[i]));
            for (const CalibratedPoint& q : stated_.points)
                if (stated_.by_distance) largest = std::max(largest, (p.position - q.position).norm());
        }
        return largest;
    }

    std::vector<ErrorBudget> printed_budgets() {
        std::vector<ErrorBudget> budgets;
        for (std::size_t i = 0; i < 3; ++i) {
            std::size_t found = 0;
            for (const CoordinateComponents& row : stated_.components)
                if (row.coordinate == i && found++ == 0)
                    budgets.push_back(row.printed.budget(coordinates[i]));
            if (found != 1)
                problems_.error(artefact_fields().place(&StatedArtefact::components),
                                tell<"coordinate %1 has %2 rows; it must have one">(coordinates[i], found));
        }
        return budgets;
    }

    const StatedArtefact& stated_;
    Problems& problems_;
    std::vector<std::array<bool, 3>> defines_;  ///< coordinates of each point that define the frame
};

class ArtefactPoints : public Asset {
public:
    ArtefactPoints(std::vector<CalibratedPoint> points, std::vector<ObservedErrors> errors,
                   std::vector<ErrorBudget> budgets, const DeviationRule& rule)
        : points_(std::move(points)),
          errors_(std::move(errors)),
          budgets_(std::move(budgets)),
          bias_(rule.bias) {
        std::vector<PointDeviation> deviations;
        for (std::size_t i = 0; i < 3; ++i)
            for (PointDeviation& d :
                 deviations_of(budgets_[i], coordinates[i], Eigen::Vector3d::Unit(static_cast<int>(i)), rule))
                deviations.push_back(std::move(d));
        source_ = OwnFrameSource(std::move(deviations));
        offer(source_);
    }

    std::vector<Table> evaluation() const override {
        std::vector<Table> tables{budget_table(budgets_, bias_)};
        if (!errors_.empty()) tables.push_back(error_table());
        return tables;
    }

    Layout layout() const override {
        Layout layout;
        layout.frames.push_back({.name = own_name<"artefact">()});
        LayoutBody plate{.name = own_name<"artefact">(), .kind = BodyKind::artefact};
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const LayoutSource source{artefact_fields().place(&StatedArtefact::points, i), true};
            layout.points.push_back({.name = points_[i].name,
                                     .kind = PointKind::nest,
                                     .p_W = points_[i].position,
                                     .source = source});
            plate.outline_W.push_back(points_[i].position);
        }
        order_around_centre(plate.outline_W);
        if (plate.outline_W.size() >= 3) layout.bodies.push_back(plate);
        return layout;
    }

private:
    static void order_around_centre(std::vector<Eigen::Vector3d>& outline) {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& p : outline) centre += p / static_cast<double>(outline.size());
        std::sort(outline.begin(), outline.end(), [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
            return std::atan2(a.y() - centre.y(), a.x() - centre.x()) <
                   std::atan2(b.y() - centre.y(), b.x() - centre.x());
        });
    }

    Table error_table() const {
        const Unit mm = Unit::of("mm");
        Table table{"errors", "Errors of indication (Eq 1)"};
        table.add("point");
        table.add("run");
        table.add("e_x").in(mm).symbol().figure(3);
        table.add("e_y").in(mm).symbol().figure(3);
        table.add("e_z").in(mm).symbol().figure(3);
        for (const ObservedErrors& observed : errors_) {
            std::vector<Cell> row{observed.point, static_cast<double>(observed.run)};
            for (const std::optional<double>& e : observed.e) {
                row.emplace_back();
                if (e) row.back() = *e;
            }
            table.row(std::move(row));
        }
        table.notes.push_back(tell<"Coordinates that define the frame are left out.">());
        return table;
    }

    std::vector<CalibratedPoint> points_;
    std::vector<ObservedErrors> errors_;
    std::vector<ErrorBudget> budgets_;
    BiasTreatment bias_;
    OwnFrameSource source_;
};

std::unique_ptr<Asset> create_artefact(const SetupReader& setup, const AssetLibrary& assets,
                                       Problems& problems) {
    StatedArtefact stated = artefact_fields().read(setup, assets, problems);
    ArtefactEvaluation evaluation(stated, problems);
    std::vector<ObservedErrors> errors = evaluation.errors();
    std::vector<ErrorBudget> budgets = evaluation.budgets(errors);
    const DeviationRule rule{stated.bias.treatment, stated.bias.systematic_common, 1.0,
                             tell<"measured artefact, Porath et al., Eq. 2">()};
    check_correction(budgets, rule.bias, artefact_fields().place(&StatedArtefact::components), problems);
    if (problems.has_errors()) return nullptr;
    return std::make_unique<ArtefactPoints>(std::move(stated.points), std::move(errors), std::move(budgets),
                                            rule);
}

}  // namespace

AssetDescriptor artefact_points_kind() {
    AssetDescriptor d;
    d.kind = "artefact-points";
    d.title = "Artefact with calibrated points";
    d.category = AssetCategory::artefact;
    d.summary =
        "A plate or frame with calibrated nests, measured repeatedly where the real points will be. Its "
        "errors of "
        "indication give the uncertainty of each coordinate of a measured point.";
    d.references = {
        {"Porath, Gross, Eger: Experimental-numerical approach to the estimation of uncertainty in "
         "robot pose measurement, section 2.1, Eqs 1-3"}};
    d.notes = {
        "u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Eq 2) with u_T = L_max α ΔT/√3 (Eq 3).",
        "The paper draws all parts independently for each point; calibration, temperature and bias are in "
        "truth common to all points, which can be chosen.",
        "The noise of the three points that define the artefact's frame is part of the errors of the "
        "others; the errors of the defining coordinates themselves are never observed."};
    d.capabilities = {PointUncertaintySource::capability};
    d.schema = artefact_fields().schema();
    d.create = create_artefact;
    return d;
}

}  // namespace covaria
