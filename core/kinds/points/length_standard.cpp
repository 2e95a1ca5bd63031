// Length standard measured in several positions (Porath et al., section 2.2, Eqs 4-6).
#include <array>
#include <numbers>

#include "core/kinds/points/artefact_fields.h"
#include "core/kinds/points/assets.h"
#include "core/kinds/points/own_frame_source.h"
#include "core/kinds/points/point_uncertainty.h"

namespace covaria {

namespace {

struct LengthError {
    std::string position;
    int run = 0;
    double e = 0.0;  ///< Eq 4
};

std::vector<FieldSpec> standard_table_fields() {
    const Unit mm = Unit::of("mm");
    FieldSpec observations{.key = "observations",
                           .title = "Observations",
                           .kind = FieldKind::table,
                           .help =
                               "Measured lengths: one row for each position and run, typed or from a CSV "
                               "file. The paper proposes at least 14 positions of three runs.",
                           .optional = true,
                           .shown_if = from_observations(),
                           .section = "Evaluation"};
    observations.columns = {
        {.key = "position",
         .title = "position",
         .kind = FieldKind::text,
         .help = "Where the standard stood."},
        {.key = "run", .title = "run", .kind = FieldKind::integer, .help = "Number of the repetition."},
        {.key = "length", .title = "length", .unit = mm, .help = "Indicated length."}};
    FieldSpec components{.key = "components",
                         .title = "Components of uncertainty",
                         .kind = FieldKind::table,
                         .help = "One row, as Table 2 of the paper prints it.",
                         .optional = true,
                         .columns = component_columns(),
                         .shown_if = from_components(),
                         .section = "Evaluation"};
    return {observations, components};
}

SetupSchema length_schema() {
    const Unit mm = Unit::of("mm");
    std::vector<FieldSpec> fields{
        {.key = "length",
         .title = "Calibrated length",
         .help = "Distance between the two nests, from the certificate. It should be "
                 "like the largest distance between the points of both frames.",
         .unit = mm,
         .range = {.low = 0.0, .low_open = true},
         .section = "Artefact"},
        evaluation_field("Table 2")};
    append(fields, standard_table_fields());
    append(fields, bias_fields());
    fields.push_back({.key = "coordinate_uncertainty",
                      .title = "Uncertainty of a coordinate",
                      .kind = FieldKind::choice,
                      .help = "A length is the difference of two points, so u of a length is √2 times u of a "
                              "coordinate. The paper uses the length's figure unchanged, which is cautious.",
                      .default_value = std::string("as-length"),
                      .choices = {{"as-length", "that of the length (paper)"},
                                  {"divided-by-sqrt2", "that of the length divided by √2"}},
                      .section = "Evaluation"});
    fields.push_back(calibration_field());
    append(fields, temperature_fields());
    return SetupSchema(std::move(fields));
}

class LengthStandard : public Asset {
public:
    LengthStandard(double length, std::vector<LengthError> errors, ErrorBudget budget,
                   const DeviationRule& rule)
        : length_(length), errors_(std::move(errors)), budget_(std::move(budget)), rule_(rule) {
        std::vector<PointDeviation> deviations;
        constexpr std::array<const char*, 3> coordinates{"x", "y", "z"};
        for (int i = 0; i < 3; ++i)
            for (PointDeviation& d : deviations_of(budget_, coordinates[static_cast<std::size_t>(i)],
                                                   Eigen::Vector3d::Unit(i), rule_))
                deviations.push_back(std::move(d));
        source_ = OwnFrameSource(std::move(deviations));
        offer(source_);
    }

    std::vector<DataTable> evaluation() const override {
        DataTable budget = budget_table({budget_}, rule_.bias);
        if (rule_.factor < 1.0) budget.notes.push_back("A coordinate of a point has u_c divided by √2.");
        std::vector<DataTable> tables{budget};
        if (!errors_.empty()) tables.push_back(error_table());
        return tables;
    }

    Layout layout() const override {
        Layout layout;
        const Eigen::Vector3d end(length_, 0.0, 0.0);
        layout.points = {{.name = "1", .kind = PointKind::nest},
                         {.name = "2", .kind = PointKind::nest, .p_W = end}};
        layout.links = {{.name = "length standard", .kind = LinkKind::bar, .to_W = end}};
        return layout;
    }

private:
    DataTable error_table() const {
        DataTable table;
        table.id = "errors";
        table.title = "Errors of indication (Eq 4)";
        table.columns = {{.header = "position"},
                         {.header = "run"},
                         {.header = "e_L", .unit = Unit::of("mm"), .is_symbol = true, .digits = 3}};
        for (const LengthError& error : errors_)
            table.rows.push_back({error.position, static_cast<double>(error.run), error.e});
        return table;
    }

    double length_;
    std::vector<LengthError> errors_;
    ErrorBudget budget_;
    DeviationRule rule_;
    OwnFrameSource source_;
};

std::vector<LengthError> read_errors(const SetupReader& setup) {
    const double expansion_at = read_temperature(setup).expansion_at;
    std::vector<LengthError> errors;
    for (std::size_t row = 0; row < setup.rows("observations"); ++row)
        errors.push_back({setup.cell_text("observations", row, "position"),
                          static_cast<int>(setup.cell_number("observations", row, "run")),
                          setup.cell_number("observations", row, "length") / expansion_at -
                              setup.number("length")});  // Eq 4
    return errors;
}

ErrorBudget measured_budget(const SetupReader& setup, const std::vector<LengthError>& errors,
                            Problems& problems) {
    std::vector<double> e;
    for (const LengthError& error : errors) e.push_back(error.e);
    Result<ErrorBudget> budget = budget_of_errors("L", e);
    if (!budget) {
        problems.error("/observations", "the length standard needs at least two observations");
        return {};
    }
    const ArtefactTemperature t = read_temperature(setup);
    budget->u_calibration = setup.number("u_cal");
    budget->u_temperature =
        temperature_uncertainty(setup.number("length"), t.expansion, t.deviation);  // Eq 6
    return *budget;
}

ErrorBudget printed_budget(const SetupReader& setup, Problems& problems) {
    if (setup.rows("components") == 1) return read_component_row(setup, 0, "L");
    problems.error("/components",
                   "the table must have one row; it has " + std::to_string(setup.rows("components")));
    return {};
}

std::unique_ptr<Asset> create_length_standard(const SetupReader& setup, const AssetLibrary&,
                                              Problems& problems) {
    const bool measured = setup.text("evaluation") == "observations";
    std::vector<LengthError> errors;
    if (measured) errors = read_errors(setup);
    ErrorBudget budget =
        measured ? measured_budget(setup, errors, problems) : printed_budget(setup, problems);
    const bool divided = setup.text("coordinate_uncertainty") == "divided-by-sqrt2";
    const DeviationRule rule{read_bias(setup), setup.flag("systematic_common"),
                             divided ? 1.0 / std::numbers::sqrt2 : 1.0,
                             "length standard, Porath et al., Eq. 5"};
    if (!problems.has_errors()) check_correction({budget}, rule.bias, problems);
    if (problems.has_errors()) return nullptr;
    return std::make_unique<LengthStandard>(setup.number("length"), std::move(errors), std::move(budget),
                                            rule);
}

}  // namespace

AssetDescriptor length_standard_kind() {
    AssetDescriptor d;
    d.kind = "length-standard";
    d.title = "Length standard";
    d.category = AssetCategory::artefact;
    d.summary =
        "A bar of calibrated length, measured in many positions and orientations. Its errors of indication "
        "give "
        "one figure for every coordinate of a measured point.";
    d.references = {
        {"Porath, Gross, Eger: Experimental-numerical approach to the estimation of uncertainty in "
         "robot pose measurement, section 2.2, Eqs 4-6"}};
    d.notes = {
        "u² = u_cal² + u_var² + u_T² + b² (Eq 5) with u_T = L α ΔT/√3 (Eq 6).",
        "A length is a difference of two points: dividing by √2 would be consistent; the paper does not."};
    d.capabilities = {PointUncertaintySource::capability};
    d.schema = length_schema();
    d.create = create_length_standard;
    return d;
}

}  // namespace covaria
