// Input quantities of "measurement equation": rows of the table to components of uncertainty.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/temperature.h"
#include "core/equation/operations.h"
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/equation/observations.h"
#include "core/kinds/equation/sampled.h"
#include "core/kinds/equation/setup.h"
#include "core/kinds/instruments/sensor.h"
#include "core/quantity/input_quantity.h"
#include "core/quantity/statement.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria::equation_model {

namespace {

std::string place_of(std::size_t row) {
    return equation_fields().place(&StatedEquations::components, row);
}

bool is_symbol(const std::string& text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !text.empty() && is_letter(text.front()) && std::all_of(text.begin(), text.end(), [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
    });
}

/// A quantity while its rows are read.
struct Draft {
    InputQuantity quantity;
    Unit unit;
    std::size_t first_row = 0;
    std::optional<double> estimate;  ///< SI
    std::size_t components = 0;
    std::optional<std::size_t> observed;  ///< component from observations
    std::string estimate_of_variance;     ///< name of the variance from simultaneous observations
};

/// Means of simultaneous observations have one estimate of their covariance matrix: c^T S c has n - 1
/// degrees of freedom for any c.
void rest_together(Draft& first, Draft& second, InputSet& inputs) {
    std::string& of_first = first.estimate_of_variance;
    std::string& of_second = second.estimate_of_variance;
    if (of_first.empty()) {
        of_first = first.quantity.symbol + ".observations";
        inputs.rest_on_estimate(of_first, *first.observed);
    }
    if (!of_second.empty()) return;
    of_second = of_first;
    inputs.rest_on_estimate(of_second, *second.observed);
}

/// Quantities that were observed at the same time.
void correlate_observed(std::vector<Draft>& drafts, const Observations& observations, InputSet& inputs) {
    for (std::size_t i = 0; i < drafts.size(); ++i)
        for (std::size_t j = i + 1; j < drafts.size(); ++j) {
            Draft &first = drafts[i], &second = drafts[j];
            if (!first.observed || !second.observed) continue;
            const auto r = observations.correlation(first.quantity.symbol, second.quantity.symbol);
            if (!r) continue;
            if (*r != 0.0) inputs.correlations.push_back({*first.observed, *second.observed, *r});
            rest_together(first, second, inputs);
        }
}

void credit(UncertaintyComponent& component, const Referred& instrument) {
    component.origin = tell<"%1 (%2)">(instrument.name, component.origin);
    component.contributor = instrument.id;
    component.contributor_name = instrument.name;
}

Message nu_words(double nu) {
    return Message::number(format_short(nu, 6));
}

class QuantityReader {
public:
    QuantityReader(const StatedEquations& stated, Problems& problems)
        : stated_(stated), problems_(problems), observations_(stated.observations) {}

    StatedQuantities run() {
        for (std::size_t row = 0; row < stated_.components.size(); ++row) read(row);
        for (Draft& draft : drafts_) finish(draft);
        check_observations();
        correlate_observed(drafts_, observations_, result_.inputs);
        return std::move(result_);
    }

private:
    const StatedComponent& at(std::size_t row) const { return stated_.components[row]; }
    template <class M>
    void refuse(std::size_t row, M StatedComponent::*column, const Message& message) {
        problems_.error(equation_fields().place(&StatedEquations::components, row, column),
                        "'" + at(row).symbol + "': " + message);
    }

    void read(std::size_t row) {
        const std::string symbol = plain_symbol(at(row).symbol);
        if (!is_symbol(symbol) || equation::is_reserved(symbol))
            return refuse(
                row, &StatedComponent::symbol,
                is_symbol(symbol)
                    ? tell<"the name is one of a function or a word of the equations; choose another">()
                    : tell<"a symbol is made of letters, Greek ones too, digits and '_', a letter first">());
        const Result<Unit> unit = Unit::parse(at(row).unit);
        if (!unit) return refuse(row, &StatedComponent::unit, unit.error().message);
        const auto known = index_.find(symbol);
        if (known == index_.end()) return first_row(row, symbol, *unit);
        Draft& draft = drafts_[known->second];
        if (at(row).value)
            return refuse(row, &StatedComponent::value,
                          tell<"only the first row of a symbol has a value; further rows add components">());
        if (unit->dimension() != draft.unit.dimension())
            return refuse(
                row, &StatedComponent::unit,
                tell<"the component is in %1, the quantity in %2">(unit->text(), draft.unit.text()));
        component(draft, row, *unit);
    }

    void first_row(std::size_t row, const std::string& symbol, const Unit& unit) {
        index_[symbol] = drafts_.size();
        Draft& draft = drafts_.emplace_back();
        draft.unit = unit;
        draft.first_row = row;
        draft.quantity.symbol = symbol;
        draft.quantity.name = at(row).name.empty() ? symbol_to_unicode(symbol) : at(row).name;
        draft.quantity.unit = unit;
        draft.quantity.source = place_of(row);
        if (at(row).value) draft.estimate = unit.to_si(*at(row).value);
        component(draft, row, unit);
    }

    void component(Draft& draft, std::size_t row, const Unit& unit) {
        const std::string& kind = at(row).statement;
        const bool first = row == draft.first_row;
        if (kind.empty() || kind == "constant") {
            if (!first)
                refuse(row, &StatedComponent::statement,
                       tell<"a further row states a component of uncertainty">());
            return;
        }
        UncertaintyComponent made;
        made.name = first || at(row).name.empty() ? draft.quantity.name : Message(at(row).name);
        made.unit = unit.interval();
        if (kind == "instrument") return reading(draft, row);
        const bool is_observed = kind == "observations" || kind == "pooled";
        const bool is_sampled = kind == "sample" || kind == "histogram";
        const bool done = is_observed  ? observed(draft, row, kind, made)
                          : is_sampled ? sampled(draft, row, made)
                                       : stated(draft, row, unit, made);
        if (done) add(draft, row, std::move(made));
    }

    void add(Draft& draft, std::size_t row, UncertaintyComponent component) {
        component.id = draft.quantity.symbol + "." + std::to_string(++draft.components);
        if (!at(row).source.empty()) component.origin = at(row).source;
        component.source = place_of(row);
        const std::size_t index = result_.inputs.add(std::move(component));
        draft.quantity.shares.push_back({index, 1.0});
        if (!at(row).ensemble.empty()) join_ensemble(row, index);
    }

    /// Quantities that one evaluation gave rest on its estimate of variance (JCGM 102 5.3.2).
    void join_ensemble(std::size_t row, std::size_t index) {
        const UncertaintyComponent& component = result_.inputs.components[index];
        const double nu = degrees_of_freedom_of(component);
        const auto [first, is_new] = ensembles_.try_emplace(at(row).ensemble, nu);
        const std::string_view kind = component.distribution.kind();
        if (at(row).statement == "observations")
            refuse(
                row, &StatedComponent::ensemble,
                tell<"observations have degrees of freedom of their own; those made together have the same "
                     "numbers in the table of observations">());
        else if ((kind != "normal" && kind != "student-t") || !std::isfinite(nu))
            refuse(
                row, &StatedComponent::ensemble,
                tell<"the members of an ensemble have a standard or expanded uncertainty with finite nu">());
        else if (!is_new && first->second != nu)
            refuse(row, &StatedComponent::ensemble,
                   tell<"the members of ensemble '%1' have one and the same nu; it is %2 in the first, %3 "
                        "here">(at(row).ensemble, nu_words(first->second), nu_words(nu)));
        else
            result_.inputs.rest_on_estimate("ensemble " + at(row).ensemble, index);
    }

    bool stated(Draft& draft, std::size_t row, const Unit& unit, UncertaintyComponent& made) {
        const std::string& kind_key = at(row).statement;
        const StatementKind& kind = *find_statement(kind_key);
        const Result<Unit> stated =
            at(row).stated_unit.empty() ? Result<Unit>(unit) : Unit::parse(at(row).stated_unit);
        bool good = stated.has_value();
        if (!good) refuse(row, &StatedComponent::stated_unit, stated.error().message);
        const auto figure = [&](const std::optional<double>& value, bool has_unit) -> std::optional<double> {
            if (!value || !has_unit || !good) return value;
            const auto si = figure_in_si(*value, *stated, draft.unit, kind_key == "limits", draft.estimate);
            if (si) return *si;
            good = false;
            refuse_statement(draft, row, si.error().message);
            return value;
        };
        const Statement statement{kind_key,
                                  figure(at(row).a, kind.a_has_unit),
                                  figure(at(row).b, kind.b_has_unit),
                                  at(row).nu,
                                  at(row).r_u,
                                  draft.estimate,
                                  draft.unit};
        if (!good) return false;
        const auto component = stated_component(statement);
        if (!component) {
            refuse_statement(draft, row, component.error().message);
            return false;
        }
        if (component->estimate) draft.estimate = component->estimate;
        made.distribution = component->distribution;
        made.degrees_of_freedom = component->degrees_of_freedom;
        made.type = component->type;
        made.normal_draws = component->type == EvaluationType::type_a && stated_.normal_means;
        made.origin = Message::declared(component->words);
        return true;
    }

    void refuse_statement(const Draft& draft, std::size_t row, const Message& message) {
        refuse(row, &StatedComponent::statement, message);
        problems_.items().back().remedies = remedies_for_statement(stated_, row, draft.unit, draft.estimate);
    }

    bool observed(Draft& draft, std::size_t row, const std::string& kind, UncertaintyComponent& made) {
        const std::string& symbol = draft.quantity.symbol;
        const auto mean =
            kind == "pooled" ? observations_.pooled(symbol, at(row).a) : observations_.mean_of(symbol);
        if (!mean) {
            refuse(row, &StatedComponent::statement, mean.error().message);
            return false;
        }
        const double u = draft.unit.interval_to_si(mean->u);
        const std::optional<double>& typed = at(row).value;
        if (kind == "observations" && typed && std::abs(*typed - mean->mean) > 1e-9 * std::abs(mean->mean))
            problems_.warning(
                equation_fields().place(&StatedEquations::components, row, &StatedComponent::value),
                "'" + at(row).symbol + "': " +
                    tell<"the value typed is used, not the mean of the observations, %1">(
                        Message::number(format_short(mean->mean, 9))));
        if (!draft.estimate && mean->count > 0) draft.estimate = draft.unit.to_si(mean->mean);
        made.unit = draft.unit.interval();
        made.type = EvaluationType::type_a;
        made.degrees_of_freedom = mean->degrees_of_freedom;
        made.distribution = Distribution::normal(u);
        made.normal_draws = stated_.normal_means;
        made.origin = kind == "pooled" ? tell<"pooled standard deviation">()
                                       : tell<"mean of %1 observations">(mean->count);
        if (kind == "observations") draft.observed = result_.inputs.components.size();
        return true;
    }

    bool sampled(Draft& draft, std::size_t row, UncertaintyComponent& made) {
        const bool histogram = at(row).statement == "histogram";
        if (draft.estimate) {
            refuse(row, &StatedComponent::value,
                   tell<"the sample gives the estimate: leave the value empty">());
            return false;
        }
        const auto drawn =
            sampled_distribution(stated_.observations, draft.quantity.symbol, draft.unit, histogram);
        if (!drawn) {
            refuse(row, &StatedComponent::statement, drawn.error().message);
            return false;
        }
        draft.estimate = drawn->mean();
        made.unit = draft.unit.interval();
        made.distribution = drawn->shifted(-*draft.estimate);
        made.origin = histogram ? tell<"histogram">() : tell<"sample of values">();
        return true;
    }

    /// The instrument's own deviation and those that all its readings share.
    void reading(Draft& draft, std::size_t row) {
        const Referred& instrument = at(row).instrument;
        if (!instrument.asset)
            return refuse(row, &StatedComponent::instrument,
                          tell<"the instrument of the project is missing">());
        if (!draft.estimate)
            return refuse(row, &StatedComponent::value, tell<"the reading of an instrument needs a value">());
        if (draft.unit.dimension() != Unit::of("m").dimension())
            return refuse(row, &StatedComponent::unit,
                          tell<"an instrument reads distances here; the unit must be one of length">());
        const double distance = *draft.estimate;
        if (const SensorSource* sensor = offers<SensorSource>(instrument.asset)) {
            if (!sensor->reads(Observable::distance))
                return refuse(row, &StatedComponent::instrument,
                              tell<"%1 reads no distances">(instrument.name));
            const Eigen::Vector3d target(distance, 0.0, 0.0);
            own_reading(draft, row, sensor->reading(Observable::distance, target));
            for (const SystematicDeviation& s : sensor->systematic())
                share(draft, row, s.component, s.effect(Observable::distance, target));
        } else if (const BallbarSource* bars = offers<BallbarSource>(instrument.asset)) {
            own_reading(draft, row, bars->reading(0, distance));
            for (const SharedLengthDeviation& s : bars->shared())
                if (s.is_scale || s.bar == 0) share(draft, row, s.component, s.is_scale ? distance : 1.0);
        }
    }

    void own_reading(Draft& draft, std::size_t row, UncertaintyComponent own) {
        credit(own, at(row).instrument);
        add(draft, row, std::move(own));
    }

    void share(Draft& draft, std::size_t row, const UncertaintyComponent& component, double factor) {
        if (factor == 0.0) return;
        const std::string id = at(row).instrument.id + "." + component.id;
        const auto [known, is_new] = shared_.try_emplace(id, result_.inputs.components.size());
        if (is_new) {
            UncertaintyComponent made = component;
            made.id = made.identity = id;
            credit(made, at(row).instrument);
            result_.inputs.add(std::move(made));
        }
        draft.quantity.shares.push_back({known->second, factor});
    }

    void finish(Draft& draft) {
        if (!draft.estimate)
            return refuse(draft.first_row, &StatedComponent::value,
                          tell<"the value is missing, and no statement gives it">());
        draft.quantity.offset = *draft.estimate;
        if (observations_.has(draft.quantity.symbol))
            result_.observed.push_back(observations_.listed(draft.quantity));
        result_.inputs.quantities.push_back(draft.quantity);
        result_.symbols.push_back({draft.quantity.symbol, draft.unit});
        result_.rows.push_back(draft.first_row);
    }

    void check_observations() {
        for (const std::string& quantity : observations_.quantities())
            if (!index_.contains(quantity))
                problems_.error(
                    equation_fields().place(&StatedEquations::observations),
                    tell<"'%1' has observations and no row in the table of quantities">(quantity));
    }

    const StatedEquations& stated_;
    Problems& problems_;
    Observations observations_;
    std::vector<Draft> drafts_;
    std::map<std::string, std::size_t> index_;
    std::map<std::string, std::size_t> shared_;
    std::map<std::string, double> ensembles_;  ///< their degrees of freedom
    StatedQuantities result_;
};

}  // namespace

StatedQuantities read_quantities(const StatedEquations& stated, Problems& problems) {
    return QuantityReader(stated, problems).run();
}

}  // namespace covaria::equation_model
