// Artefact with calibrated points (Porath et al., section 2.1, Eqs 1-3).
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/kinds/points/artefact_fields.h"
#include "core/kinds/points/assets.h"
#include "core/kinds/points/own_frame_source.h"
#include "core/kinds/points/point_uncertainty.h"

namespace covaria {

namespace {

constexpr std::array<const char*, 3> coordinates{"x", "y", "z"};

struct CalibratedPoint {
    std::string name;
    Eigen::Vector3d position;
    std::array<bool, 3> defines{};  ///< coordinates that define the frame: their errors say nothing
};

/// Eq 1 for one measured point; coordinates that define the frame are empty.
struct ObservedErrors {
    std::string point;
    int run = 0;
    std::array<std::optional<double>, 3> e;
};

std::vector<FieldSpec> table_fields() {
    const Unit mm = Unit::of("mm");
    const auto length = [&](const char* key, const char* help) {
        return ColumnSpec{.key = key, .title = key, .unit = mm, .help = help};
    };
    FieldSpec points{
        .key = "points",
        .title = "Calibrated points",
        .kind = FieldKind::table,
        .help = "The artefact's points with their calibrated coordinates in the artefact's frame.",
        .optional = true,
        .section = "Artefact"};
    points.columns = {
        {.key = "name", .title = "point", .kind = FieldKind::text, .help = "Name of the point."},
        length("x", "Calibrated coordinate x."),
        length("y", "Calibrated coordinate y."),
        length("z", "Calibrated coordinate z."),
        {.key = "defines",
         .title = "defines",
         .kind = FieldKind::text,
         .optional = true,
         .help = "Coordinates that define the frame (\"xyz\", \"yz\"), when they are named by "
                 "point."}};
    FieldSpec observations{.key = "observations",
                           .title = "Observations",
                           .kind = FieldKind::table,
                           .help =
                               "Measured coordinates in the artefact's frame: one row for each point and "
                               "run, typed or from a CSV file.",
                           .optional = true,
                           .shown_if = from_observations(),
                           .section = "Evaluation"};
    observations.columns = {
        {.key = "point", .title = "point", .kind = FieldKind::text, .help = "Name of a calibrated point."},
        {.key = "run", .title = "run", .kind = FieldKind::integer, .help = "Number of the repetition."},
        length("x", "Indicated coordinate x."),
        length("y", "Indicated coordinate y."),
        length("z", "Indicated coordinate z.")};
    FieldSpec components{.key = "components",
                         .title = "Components of uncertainty",
                         .kind = FieldKind::table,
                         .help = "One row for each coordinate, as Table 1 of the paper prints them.",
                         .optional = true,
                         .shown_if = from_components(),
                         .section = "Evaluation"};
    components.columns = {{.key = "coordinate",
                           .title = "coordinate",
                           .kind = FieldKind::choice,
                           .choices = {{"x", "x"}, {"y", "y"}, {"z", "z"}},
                           .help = "Coordinate of the row."}};
    for (const ColumnSpec& column : component_columns()) components.columns.push_back(column);
    return {points, observations, components};
}

FieldSpec exclusion_field() {
    return {.key = "excluded",
            .title = "Coordinates that define the frame",
            .kind = FieldKind::choice,
            .help =
                "Errors of these coordinates are zero by construction of the frame and are left out of the "
                "statistics.",
            .default_value = std::string("three-two-one"),
            .choices = {{"three-two-one", "first point x, y, z; second y, z; third z"},
                        {"by-point", "as the points' column 'defines' says"},
                        {"none", "none"}},
            .shown_if = from_observations(),
            .section = "Evaluation"};
}

FieldSpec length_field() {
    return {.key = "l_max",
            .title = "Length for the thermal expansion",
            .kind = FieldKind::choice,
            .help =
                "L_max of Eq 3. The paper's figures result with the largest distance between two points; "
                "its text says the largest value of the coordinate, which gives 0 for a flat artefact's z.",
            .default_value = std::string("largest-distance"),
            .choices = {{"largest-distance", "largest distance between two points"},
                        {"largest-coordinate", "largest value of the coordinate (text of Eq 3)"}},
            .shown_if = from_observations(),
            .section = "Temperature"};
}

SetupSchema artefact_schema() {
    std::vector<FieldSpec> tables = table_fields();
    std::vector<FieldSpec> fields{tables[0], evaluation_field("Table 1"), tables[1], tables[2],
                                  exclusion_field()};
    append(fields, bias_fields());
    fields.push_back(calibration_field());
    append(fields, temperature_fields());
    fields.push_back(length_field());
    return SetupSchema(std::move(fields));
}

class ArtefactReader {
public:
    ArtefactReader(const SetupReader& setup, Problems& problems) : setup_(setup), problems_(problems) {}

    std::vector<CalibratedPoint> points() {
        std::vector<CalibratedPoint> points;
        std::set<std::string> names;
        for (std::size_t row = 0; row < setup_.rows("points"); ++row) {
            const std::string name = setup_.cell_text("points", row, "name");
            if (!names.insert(name).second)
                problems_.error("/points/rows/" + std::to_string(row),
                                "there are two points called '" + name + "'; rename one");
            points.push_back({name, setup_.cell_vector("points", row, "x"), defined_by(row)});
        }
        return points;
    }

    std::vector<ObservedErrors> errors(const std::vector<CalibratedPoint>& points) {
        const double expansion_at = read_temperature(setup_).expansion_at;
        std::vector<ObservedErrors> all;
        for (std::size_t row = 0; row < setup_.rows("observations"); ++row) {
            const std::string name = setup_.cell_text("observations", row, "point");
            const auto point = std::find_if(points.begin(), points.end(),
                                            [&](const CalibratedPoint& p) { return p.name == name; });
            if (point == points.end()) {
                problems_.error("/observations/rows/" + std::to_string(row) + "/point",
                                "there is no calibrated point called '" + name + "'");
                continue;
            }
            ObservedErrors observed{
                name, static_cast<int>(setup_.cell_number("observations", row, "run")), {}};
            const Eigen::Vector3d e =
                setup_.cell_vector("observations", row, "x") / expansion_at - point->position;  // Eq 1
            for (std::size_t i = 0; i < 3; ++i)
                if (!point->defines[i]) observed.e[i] = e[static_cast<int>(i)];
            all.push_back(observed);
        }
        return all;
    }

    std::vector<ErrorBudget> budgets(const std::vector<CalibratedPoint>& points,
                                     const std::vector<ObservedErrors>& errors) {
        return setup_.text("evaluation") == "components" ? printed_budgets()
                                                         : measured_budgets(points, errors);
    }

private:
    std::array<bool, 3> defined_by(std::size_t row) {
        if (setup_.text("evaluation") == "components") return {};
        const std::string rule = setup_.text("excluded");
        if (rule == "none") return {};
        if (rule == "three-two-one") return {row < 1, row < 2, row < 3};
        const std::string letters = setup_.cell_text("points", row, "defines");
        if (letters.find_first_not_of("xyz") != std::string::npos)
            problems_.error("/points/rows/" + std::to_string(row) + "/defines",
                            "'" + letters + "' must consist of the letters x, y and z");
        const auto has = [&](char c) { return letters.find(c) != std::string::npos; };
        return {has('x'), has('y'), has('z')};
    }

    std::vector<ErrorBudget> measured_budgets(const std::vector<CalibratedPoint>& points,
                                              const std::vector<ObservedErrors>& errors) {
        std::vector<ErrorBudget> budgets;
        const ArtefactTemperature temperature = read_temperature(setup_);
        for (std::size_t i = 0; i < 3; ++i) {
            std::vector<double> e;
            for (const ObservedErrors& observed : errors)
                if (observed.e[i]) e.push_back(*observed.e[i]);
            Result<ErrorBudget> budget = budget_of_errors(coordinates[i], e);
            if (!budget) {
                problems_.error("/observations",
                                std::string("coordinate ") + coordinates[i] +
                                    " has fewer than two observations that do not define the "
                                    "frame: measure more points or runs");
                continue;
            }
            budget->u_calibration = setup_.number("u_cal");
            budget->u_temperature = temperature_uncertainty(expansion_length(points, static_cast<int>(i)),
                                                            temperature.expansion, temperature.deviation);
            budgets.push_back(*budget);
        }
        return budgets;
    }

    // L_max of Eq 3.
    double expansion_length(const std::vector<CalibratedPoint>& points, int i) const {
        const bool by_distance = setup_.text("l_max") == "largest-distance";
        double largest = 0.0;
        for (const CalibratedPoint& p : points) {
            if (!by_distance) largest = std::max(largest, std::abs(p.position[i]));
            for (const CalibratedPoint& q : points)
                if (by_distance) largest = std::max(largest, (p.position - q.position).norm());
        }
        return largest;
    }

    std::vector<ErrorBudget> printed_budgets() {
        std::vector<ErrorBudget> budgets;
        for (const char* coordinate : coordinates) {
            std::size_t found = 0;
            for (std::size_t row = 0; row < setup_.rows("components"); ++row) {
                if (setup_.cell_text("components", row, "coordinate") != coordinate) continue;
                if (found++ == 0) budgets.push_back(read_component_row(setup_, row, coordinate));
            }
            if (found != 1)
                problems_.error("/components", std::string("coordinate ") + coordinate + " has " +
                                                   std::to_string(found) + " rows; it must have one");
        }
        return budgets;
    }

    const SetupReader& setup_;
    Problems& problems_;
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

    std::vector<DataTable> evaluation() const override {
        std::vector<DataTable> tables{budget_table(budgets_, bias_)};
        if (!errors_.empty()) tables.push_back(error_table());
        return tables;
    }

    Layout layout() const override {
        Layout layout;
        layout.frames.push_back({.name = "artefact"});
        LayoutBody plate{.name = "artefact", .kind = BodyKind::artefact};
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const LayoutSource source{"/points/rows/" + std::to_string(i), true};
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

    DataTable error_table() const {
        const Unit mm = Unit::of("mm");
        DataTable table;
        table.id = "errors";
        table.title = "Errors of indication (Eq 1)";
        table.columns = {{.header = "point"},
                         {.header = "run"},
                         {.header = "e_x", .unit = mm, .is_symbol = true, .digits = 3},
                         {.header = "e_y", .unit = mm, .is_symbol = true, .digits = 3},
                         {.header = "e_z", .unit = mm, .is_symbol = true, .digits = 3}};
        for (const ObservedErrors& observed : errors_) {
            std::vector<TableCell> row{observed.point, static_cast<double>(observed.run)};
            for (const std::optional<double>& e : observed.e) {
                row.emplace_back();
                if (e) row.back() = *e;
            }
            table.rows.push_back(std::move(row));
        }
        table.notes.push_back("Coordinates that define the frame are left out.");
        return table;
    }

    std::vector<CalibratedPoint> points_;
    std::vector<ObservedErrors> errors_;
    std::vector<ErrorBudget> budgets_;
    BiasTreatment bias_;
    OwnFrameSource source_;
};

std::unique_ptr<Asset> create_artefact(const SetupReader& setup, const AssetLibrary&, Problems& problems) {
    ArtefactReader reader(setup, problems);
    std::vector<CalibratedPoint> points = reader.points();
    std::vector<ObservedErrors> errors;
    if (setup.text("evaluation") == "observations") errors = reader.errors(points);
    std::vector<ErrorBudget> budgets = reader.budgets(points, errors);
    const DeviationRule rule{read_bias(setup), setup.flag("systematic_common"), 1.0,
                             "measured artefact, Porath et al., Eq. 2"};
    check_correction(budgets, rule.bias, problems);
    if (problems.has_errors()) return nullptr;
    return std::make_unique<ArtefactPoints>(std::move(points), std::move(errors), std::move(budgets), rule);
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
    d.schema = artefact_schema();
    d.create = create_artefact;
    return d;
}

}  // namespace covaria
