// Length standard measured in several positions (Porath et al., section 2.2, Eqs 4-6).
#include <array>
#include <numbers>

#include "core/base/name.h"
#include "core/kinds/points/artefact_fields.h"
#include "core/kinds/points/assets.h"
#include "core/kinds/points/own_frame_source.h"
#include "core/kinds/points/point_uncertainty.h"

namespace covaria {

namespace {

struct MeasuredLength {
    std::string position;
    int run = 0;
    double length = 0.0;
};

struct StatedStandard {
    double length = 0.0;
    bool from_observations = true;
    std::vector<MeasuredLength> observations;
    std::vector<PrintedComponents> components;
    StatedBias bias;
    bool divided = false;  ///< a coordinate has the length's figure by √2
    MeasuredArtefact measured;
};

void add_length_evaluation(Fields<StatedStandard>& fields) {
    add_evaluation(fields, "Table 2");
    fields
        .table(&StatedStandard::observations, "observations", "Observations",
               "Measured lengths: one row for each position and run, typed or from a CSV file. The paper "
               "proposes at least 14 positions of three runs.",
               Columns<MeasuredLength>()
                   .add(&MeasuredLength::position, "position", "position", "Where the standard stood.")
                   .add(&MeasuredLength::run, "run", "run", "Number of the repetition.")
                   .add(&MeasuredLength::length, "length", "length", "Indicated length.",
                        {.unit = Unit::of("mm")}),
               {.optional = true, .measured = true})
        .table(&StatedStandard::components, "components", "Components of uncertainty",
               "One row, as Table 2 of the paper prints it.", component_columns(), {.optional = true})
        .part(&StatedStandard::bias, bias_fields())
        .choice(&StatedStandard::divided, "coordinate_uncertainty", "Uncertainty of a coordinate",
                "A length is the difference of two points, so u of a length is √2 times u of a coordinate. "
                "The paper uses the length's figure unchanged, which is cautious.",
                {{false, "as-length", "that of the length (paper)"},
                 {true, "divided-by-sqrt2", "that of the length divided by √2"}},
                false);
}

const Fields<StatedStandard>& length_fields() {
    static const auto fields = [] {
        Fields<StatedStandard> made;
        made.section("Artefact")
            .add(&StatedStandard::length, "length", "Calibrated length",
                 "Distance between the two nests, from the certificate. It should be like the largest "
                 "distance "
                 "between the points of both frames.",
                 {.unit = Unit::of("mm"), .range = {.low = 0.0, .low_open = true}});
        add_length_evaluation(made);
        made.part(&StatedStandard::measured, measured_artefact_fields())
            .shown_where(&StatedStandard::from_observations, {true}, &StatedStandard::observations,
                         &StatedStandard::measured)
            .shown_where(&StatedStandard::from_observations, {false}, &StatedStandard::components);
        return made;
    }();
    return fields;
}

double error_of(const StatedStandard& stated, const MeasuredLength& observation) {
    return observation.length / stated.measured.expansion_at() - stated.length;  // Eq 4
}

class LengthStandard : public Asset {
public:
    LengthStandard(StatedStandard stated, ErrorBudget budget, const DeviationRule& rule)
        : stated_(std::move(stated)), budget_(std::move(budget)), rule_(rule) {
        std::vector<PointDeviation> deviations;
        constexpr std::array<const char*, 3> axes{"x", "y", "z"};
        for (int i = 0; i < 3; ++i)
            for (PointDeviation& d :
                 deviations_of(budget_, axes[static_cast<std::size_t>(i)], Eigen::Vector3d::Unit(i), rule_))
                deviations.push_back(std::move(d));
        source_ = OwnFrameSource(std::move(deviations));
        offer(source_);
    }

    std::vector<Table> evaluation() const override {
        Table budget = budget_table({budget_}, rule_.bias);
        if (rule_.factor < 1.0)
            budget.notes.push_back(tell<"A coordinate of a point has u_c divided by √2.">());
        std::vector<Table> tables{budget};
        if (!stated_.observations.empty()) tables.push_back(error_table());
        return tables;
    }

    Layout layout() const override {
        Layout layout;
        const Eigen::Vector3d end(stated_.length, 0.0, 0.0);
        layout.points = {{.name = "1", .kind = PointKind::nest},
                         {.name = "2", .kind = PointKind::nest, .p_W = end}};
        layout.links = {{.name = own_name<"length standard">(), .kind = LinkKind::bar, .to_W = end}};
        return layout;
    }

private:
    Table error_table() const {
        Table table{"errors", "Errors of indication (Eq 4)"};
        table.add("position");
        table.add("run");
        table.add("e_L").in(Unit::of("mm")).symbol().figure(3);
        for (const MeasuredLength& o : stated_.observations)
            table.row({o.position, static_cast<double>(o.run), error_of(stated_, o)});
        return table;
    }

    StatedStandard stated_;
    ErrorBudget budget_;
    DeviationRule rule_;
    OwnFrameSource source_;
};

ErrorBudget measured_budget(const StatedStandard& stated, Problems& problems) {
    std::vector<double> e;
    for (const MeasuredLength& observation : stated.observations) e.push_back(error_of(stated, observation));
    Result<ErrorBudget> budget = budget_of_errors("L", e);
    if (!budget) {
        problems.error(length_fields().place(&StatedStandard::observations),
                       tell<"the length standard needs at least two observations">());
        return {};
    }
    budget->u_calibration = stated.measured.u_calibration;
    budget->u_temperature = temperature_uncertainty(stated.length, stated.measured.expansion,
                                                    stated.measured.deviation);  // Eq 6
    return *budget;
}

ErrorBudget printed_budget(const StatedStandard& stated, Problems& problems) {
    if (stated.components.size() == 1) return stated.components[0].budget("L");
    problems.error(length_fields().place(&StatedStandard::components),
                   tell<"the table must have one row; it has %1">(stated.components.size()));
    return {};
}

std::unique_ptr<Asset> create_length_standard(const SetupReader& setup, const AssetLibrary& assets,
                                              Problems& problems) {
    StatedStandard stated = length_fields().read(setup, assets, problems);
    ErrorBudget budget =
        stated.from_observations ? measured_budget(stated, problems) : printed_budget(stated, problems);
    const DeviationRule rule{stated.bias.treatment, stated.bias.systematic_common,
                             stated.divided ? 1.0 / std::numbers::sqrt2 : 1.0,
                             "length standard, Porath et al., Eq. 5"};
    if (!problems.has_errors())
        check_correction({budget}, rule.bias, length_fields().place(&StatedStandard::components), problems);
    if (problems.has_errors()) return nullptr;
    return std::make_unique<LengthStandard>(std::move(stated), std::move(budget), rule);
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
    d.schema = length_fields().schema();
    d.create = create_length_standard;
    return d;
}

}  // namespace covaria
