// Measurement model "observations in groups": the model class and its descriptor.
#include "core/kinds/groups/model.h"

#include "core/kinds/groups/evidence.h"
#include "core/kinds/groups/setup.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using group_observations::Between;
using group_observations::GroupSetup;
using group_observations::Variances;

/// Equations of all ways to take the groups into account, in the order of `Between`.
const std::vector<ModelEquation>& group_equations() {
    static const std::vector<ModelEquation> all{
        {"s_a² = Σ n_j (V̄_j − V̄)²/(J − 1),  s_b² = Σ (V_jk − V̄_j)²/(N − J)",
         tell<"JCGM 100, Eqs H.24, H.25, for groups of any size">()},
        {"u²(V̄) = s²(V̄_j)/J,  ν = J − 1", tell<"groups included, JCGM 100 H.5.2.3">()},
        {"u²(V̄) = 1/Σ w_j,  1/w_j = s_B² + s_b²/n_j,  s_B² = (s_a² − s_b²)/n_0",
         tell<"components of variance, Searle et al. 1992">()},
        {"u²(V̄) = ((J − 1) s_a² + (N − J) s_b²)/(N (N − 1)),  ν = N − 1",
         tell<"groups not included, JCGM 100, Eq H.28">()}};
    return all;
}

class GroupObservations : public EquationModel<GroupObservations> {
public:
    explicit GroupObservations(GroupSetup setup)
        : setup_(std::move(setup)),
          variances_(group_observations::variances_of(setup_)),
          evidence_(group_observations::redundant_readings(setup_)) {
        UncertaintyComponent component;
        component.id = setup_.symbol + ".mean";
        component.name = setup_.between == Between::included ? tell<"scatter of the means of the groups">()
                         : setup_.between == Between::components
                             ? tell<"components of variance between and within the groups">()
                             : tell<"scatter of all observations">();
        component.unit = setup_.unit.interval();
        component.distribution = Distribution::of(StudentT{0.0, variances_.u, variances_.degrees_of_freedom});
        component.type = EvaluationType::type_a;
        component.degrees_of_freedom = variances_.degrees_of_freedom;
        component.origin = tell<"%1 groups, %2 observations">(
            setup_.groups.size(), static_cast<long long>(variances_.observations));
        inputs_.add({.symbol = setup_.symbol + "_mean",
                     .name = tell<"mean of all observations">(),
                     .unit = setup_.unit,
                     .offset = variances_.mean},
                    {component});
        outputs_.push_back({.symbol = setup_.symbol, .name = setup_.name, .unit = setup_.unit});
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    std::vector<ModelEquation> formulas() const override {
        const std::vector<ModelEquation>& all = group_equations();
        return {all.front(), all[1 + static_cast<std::size_t>(setup_.between)]};
    }
    std::vector<Table> evaluation() const override {
        return group_observations::group_evaluation(setup_, variances_);
    }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        y.set(0, x[0]);
        return Real(0.0) == Real(0.0);
    }

private:
    GroupSetup setup_;
    Variances variances_;
    std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< null: nothing is stated
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_group_model(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems) {
    auto setup = group_observations::read_group_setup(reader, assets, problems);
    if (!setup) return nullptr;
    return std::make_unique<GroupObservations>(std::move(*setup));
}

}  // namespace

ModelDescriptor group_observations_model() {
    ModelDescriptor d;
    d.id = "observations-in-groups";
    d.title = "Observations in groups";
    d.summary =
        "The mean of observations made on several days, with several instruments or by several operators, "
        "and an "
        "analysis of variance that says whether these have an effect.";
    d.references = {{"JCGM 100:2008 (GUM), H.5"}};
    d.references.push_back(
        {"S. R. Searle, G. Casella, C. E. McCulloch: Variance Components, Wiley 1992, 3.6"});
    d.equations = group_equations();
    d.notes = {
        "Groups may have different numbers of observations; n_0 = (N − Σ n_j²/N)/(J − 1) is then their size "
        "in the components of variance.",
        "JCGM 100 H.5, published V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV with "
        "nine degrees of "
        "freedom, or 13 µV with 49 without an effect of the days: reproduces."};
    d.help_page = "observations-in-groups.md";
    d.example = "gum/h5-zener.covaria";
    d.schema = group_observations::group_schema();
    d.create = create_group_model;
    return d;
}

}  // namespace covaria
