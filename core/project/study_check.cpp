// Problems of studies, and everything that a study can vary.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/in_quotes.h"
#include "core/base/temperature.h"
#include "core/project/analysis_fields.h"
#include "core/project/entry_graph.h"
#include "core/project/json_location.h"
#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/project/project_id.h"
#include "core/project/study_fields.h"
#include "core/project/study_target.h"
#include "core/setup/difference_remedy.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

template <class M>
std::string at(M Study::*member) {
    return study_fields().place(member);
}
template <class M>
std::string at(M StudyAxis::*member) {
    return axis_fields().place(member);
}

class StudyCheck {
public:
    StudyCheck(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
               const std::vector<OutputQuantity>* outputs, Problems& problems)
        : project_(project), analysis_(analysis), inputs_(inputs), outputs_(outputs), problems_(problems) {}

    void run() {
        std::set<std::string> ids;
        for (std::size_t i = 0; i < analysis_.studies.size(); ++i) {
            path_ = analysis_fields().place(&AnalysisEntry::studies, i);
            const std::string& id = analysis_.studies[i].id;
            if (!ids.insert(id).second)
                problems_.error(path_ + at(&Study::id), tell<"another study has the same id">());
            check(analysis_.studies[i]);
        }
    }

    void check_axis(const StudyAxis& axis, const std::string& path) {
        if (axis.values < 2)
            problems_.error(path + at(&StudyAxis::values), tell<"an axis needs at least two values">());
        if (!std::isfinite(axis.from) || !std::isfinite(axis.to) || axis.from == axis.to)
            problems_.error(path + at(&StudyAxis::to),
                            tell<"'from' and 'to' must be two different numbers">());
        if (axis.spacing == StudySpacing::logarithmic && !(axis.from > 0 && axis.to > 0))
            problems_.error(path + at(&StudyAxis::spacing),
                            tell<"with logarithmic spacing both ends must be greater than zero">());
        const auto target = find_study_target(project_, analysis_, inputs_, axis);
        if (!target) return problems_.error(path + target.error().path, target.error().message);
        check_change(axis, *target, path);
        if (target->whole && axis.change == StudyChange::value &&
            std::abs(axis.to - axis.from) + 1.0 < static_cast<double>(axis.values))
            problems_.error(path + at(&StudyAxis::values),
                            tell<"'%1' takes whole numbers: there are fewer than %2 between the ends">(
                                target->title.message(), axis.values));
    }

private:
    void check(const Study& study) {
        if (!is_project_id(study.id))
            problems_.error(path_ + at(&Study::id),
                            tell<"its id must be made of letters, digits, '-' and '_'">());
        if (study.axes.empty() || study.axes.size() > 3)
            problems_.error(path_ + at(&Study::axes),
                            tell<"a study has one to three axes; this one has %1">(study.axes.size()));
        check_size(study);
        for (std::size_t i = 0; i < study.axes.size(); ++i) {
            check_axis(study.axes[i], path_ + study_fields().place(&Study::axes, i));
            for (std::size_t j = 0; j < i; ++j)
                if (study.axes[j].asset == study.axes[i].asset &&
                    study.axes[j].target == study.axes[i].target)
                    problems_.error(path_ + study_fields().place(&Study::axes, i) + at(&StudyAxis::target),
                                    tell<"%1 is varied by two axes">(in_quotes(study.axes[i].target)));
        }
        for (std::size_t i = 0; i < study.outputs.size(); ++i)
            check_study_output(outputs_, study.outputs[i], path_ + study_fields().place(&Study::outputs, i),
                               problems_);
        if (study.method == Method::monte_carlo && study.trials < 2)
            problems_.error(path_ + at(&Study::trials), tell<"Monte Carlo needs at least two trials">());
    }

    void check_size(const Study& study) {
        double points = 1.0;
        for (const StudyAxis& axis : study.axes) points *= static_cast<double>(axis.values);
        if (points > static_cast<double>(most_study_points))
            problems_.error(path_ + at(&Study::axes), tell<"the grid has %1 points; a study may have %2">(
                                                          readable_number(points), most_study_points));
    }

    void check_change(const StudyAxis& axis, const StudyTarget& target, const std::string& path) {
        using Kind = StudyTarget::Kind;
        const bool factor_only = target.kind == Kind::components || target.kind == Kind::component;
        if (factor_only && axis.change != StudyChange::factor)
            return problems_.error(
                path + at(&StudyAxis::change),
                tell<"the uncertainty of an input quantity can be varied by a factor only">());
        if (axis.change == StudyChange::factor) {
            if (!axis.unit.dimension().is_one())
                problems_.error(path + at(&StudyAxis::unit), tell<"a factor has no unit">());
            else if (factor_only && (axis.from < 0 || axis.to < 0))
                problems_.error(path + at(&StudyAxis::from),
                                tell<"a factor of an uncertainty must not be negative">());
            if (!part_objection(target.scale).empty())
                problems_.error(
                    path + at(&StudyAxis::change),
                    tell<"a temperature in %1 cannot be multiplied; add to it, or give its values">(
                        target.scale.text()));
            return;
        }
        if (target.kind == Kind::estimate && !inputs_) return;
        const std::string unit_place = path + at(&StudyAxis::unit);
        if (axis.change == StudyChange::added && is_reading(axis.unit)) {
            const Unit interval = axis.unit.interval();
            problems_.error(unit_place,
                            tell<"a difference of temperatures is given in %1">(interval.display()));
            problems_.items().back().remedies =
                remedies_as_difference(target.title.message(), axis.unit, interval, unit_place);
            return;
        }
        const Message objection = unit_objection(target.title.message(), {axis.from, axis.unit}, target.unit);
        if (!objection.empty() && std::isfinite(axis.from)) {
            problems_.error(unit_place, objection);
            problems_.items().back().remedies =
                remedies_as_difference(target.title.message(), axis.unit, target.unit, unit_place);
        }
    }

    const Project& project_;
    const AnalysisEntry& analysis_;
    const InputSet* inputs_;
    const std::vector<OutputQuantity>* outputs_;
    Problems& problems_;
    std::string path_;
};

class TargetList {
public:
    TargetList(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs)
        : project_(project), analysis_(analysis), inputs_(inputs) {}

    std::vector<StudyTargetChoice> take() {
        if (const SetupSchema* schema = schema_of(analysis_)) add_setup("", *schema, analysis_.setup);
        for (const std::string& id : assets_used_by(project_, analysis_)) {
            const AssetEntry& asset = *project_.find_asset(id);
            if (const SetupSchema* schema = schema_of(asset)) add_setup(id, *schema, asset.setup);
        }
        for (const std::string& id : analyses_used_by(project_, analysis_)) {
            const AnalysisEntry& upstream = *project_.find_analysis(id);
            if (const SetupSchema* schema = schema_of(upstream)) add_setup(id, *schema, upstream.setup);
        }
        if (inputs_) add_inputs();
        return std::move(choices_);
    }

private:
    void add(const std::string& asset, const std::string& pointer, StudyChange change) {
        StudyAxis axis{.asset = asset, .target = pointer, .change = change};
        auto target = find_study_target(project_, analysis_, inputs_, axis);
        if (!target || (change == StudyChange::factor && !part_objection(target->scale).empty())) return;
        const double now = target->current;
        axis.from = change == StudyChange::factor ? 0.5
                    : !std::isfinite(now)         ? 1.0
                    : now == 0.0                  ? -1.0
                                                  : std::min(0.5 * now, 1.5 * now);
        axis.to = change == StudyChange::factor ? 2.0
                  : !std::isfinite(now)         ? 100.0
                  : now == 0.0                  ? 1.0
                                                : std::max(0.5 * now, 1.5 * now);
        if (change != StudyChange::factor) axis.unit = target->unit;
        if (target->whole && change == StudyChange::value) {
            axis.from = std::max(1.0, std::floor(axis.from));
            axis.to = std::max(axis.from + 1.0, std::ceil(axis.to));
            axis.values =
                std::min<std::size_t>(axis.values, static_cast<std::size_t>(axis.to - axis.from) + 1);
        }
        choices_.push_back({std::move(*target), std::move(axis)});
    }

    void add_setup(const std::string& asset, const SetupSchema& schema, const Setup& setup) {
        for (const FieldSpec& field : schema.fields()) {
            const SetupValue& value = value_of(field, setup);
            const std::string place = "/setup/" + field.key;
            if (field.kind == FieldKind::number || field.kind == FieldKind::integer)
                add(asset, place, StudyChange::value);
            else if (std::holds_alternative<PoseValue>(value))
                for (int i = 0; i < 6; ++i)
                    add(asset, place + (i < 3 ? "/position/" : "/angles/") + std::to_string(i % 3),
                        StudyChange::value);
            else if (const auto* table = std::get_if<SetupTable>(&value))
                add_table(asset, field, *table);
        }
    }

    void add_table(const std::string& asset, const FieldSpec& field, const SetupTable& table) {
        constexpr std::size_t most_rows = 200;  // rows of a list to choose from
        const std::string place = "/setup/" + field.key;
        for (const ColumnSpec& column : field.columns) {
            if (column.kind != FieldKind::number && column.kind != FieldKind::integer) continue;
            add(asset, place + "/columns/" + pointer_token(column.key), StudyChange::factor);
        }
        for (std::size_t row = 0; row < std::min(most_rows, table.rows.size()); ++row)
            for (const ColumnSpec& column : field.columns)
                if (column.kind == FieldKind::number || column.kind == FieldKind::integer)
                    add(asset, place + "/rows/" + std::to_string(row) + "/" + pointer_token(column.key),
                        StudyChange::value);
    }

    void add_inputs() {
        for (const InputQuantity& quantity : inputs_->quantities) {
            const std::string place = "/inputs/" + pointer_token(quantity.symbol);
            add("", place + "/estimate", StudyChange::value);
            if (!quantity.shares.empty()) add("", place + "/components", StudyChange::factor);
        }
        std::vector<std::size_t> uses(inputs_->components.size(), 0);
        for (const InputQuantity& quantity : inputs_->quantities)
            for (const Share& share : quantity.shares) ++uses[share.component];
        for (std::size_t i = 0; i < uses.size(); ++i)
            if (uses[i] > 1)
                add("", "/components/" + pointer_token(inputs_->components[i].id), StudyChange::factor);
    }

    const Project& project_;
    const AnalysisEntry& analysis_;
    const InputSet* inputs_;
    std::vector<StudyTargetChoice> choices_;
};

}  // namespace

void check_studies(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                   const std::vector<OutputQuantity>* outputs, Problems& problems) {
    StudyCheck(project, analysis, inputs, outputs, problems).run();
}

void check_study_axis(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                      const StudyAxis& axis, const std::string& path, Problems& problems) {
    StudyCheck(project, analysis, inputs, nullptr, problems).check_axis(axis, path);
}

void check_study_output(const std::vector<OutputQuantity>* outputs, const StudyOutput& wanted,
                        const std::string& path, Problems& problems) {
    if (!outputs) return;
    std::vector<std::string> symbols;
    for (const OutputQuantity& output : *outputs) {
        if (output.group == wanted.group && output.symbol == wanted.symbol) return;
        symbols.push_back(output.symbol);
    }
    const Message where = wanted.group.empty() ? Message() : tell<" in %1">(in_quotes(wanted.group));
    problems.error(path, tell<"the model has no output quantity %1%2%3">(
                             in_quotes(wanted.symbol), where, did_you_mean(wanted.symbol, symbols)));
}

std::vector<StudyTargetChoice> study_targets(const Project& project, const AnalysisEntry& analysis,
                                             const InputSet* inputs) {
    return TargetList(project, analysis, inputs).take();
}

}  // namespace covaria
