#include "ui/models/requirement_cells.h"

#include <algorithm>
#include <string_view>

#include "ui/document/quantity_text.h"
#include "ui/document/requirement_edits.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// Keys of columns, with the key of the requirement's field.
constexpr std::pair<std::string_view, std::string_view> typed_columns[] = {
    {"target", "targetUncertainty"}, {"lower limit", "lowerLimit"}, {"upper limit", "upperLimit"}};

/// The unit in which a field of a requirement on the output is typed and shown.
Unit unit_of(const OutputQuantity& output, const RequirementField& field, const DisplayUnits& units) {
    const Unit unit = units.of(output.unit);
    return field.is_interval ? unit.interval() : unit;
}

double in_unit(const Quantity& quantity, const Unit& unit, const RequirementField& field) {
    return field.is_interval ? converted_interval(quantity.value, quantity.unit, unit)
                             : converted(quantity.value, quantity.unit, unit);
}

}  // namespace

std::vector<std::string> RequirementCells::columns() {
    std::vector<std::string> keys;
    for (const auto& [column, field] : typed_columns) keys.emplace_back(column);
    return keys;
}

void RequirementCells::follow(Document& document, std::string analysis) {
    if (document_ == &document && analysis_ == analysis) return;
    document_ = &document;
    analysis_ = std::move(analysis);
    refused_.clear();
}

const RequirementField* RequirementCells::field_of(const std::string& column) const {
    if (!document_) return nullptr;
    for (const auto& [key, key_of_field] : typed_columns)
        if (key == column)
            for (const RequirementField& field : requirement_fields())
                if (field.key == key_of_field) return &field;
    return nullptr;
}

const RequirementCells::Refused* RequirementCells::refused(std::size_t output,
                                                           const std::string& column) const {
    const auto found = refused_.find({output, column});
    return found == refused_.end() ? nullptr : &found->second;
}

QString RequirementCells::text_of(const OutputQuantity& output, const RequirementField& field,
                                  const DisplayUnits& units) const {
    const AnalysisEntry* entry = document_->project().find_analysis(analysis_);
    const Requirement* now = entry ? find_requirement(*entry, output) : nullptr;
    const auto quantity = now ? value_of(*now, field) : std::nullopt;
    if (!quantity) return {};
    const Unit unit = unit_of(output, field, units);
    if (!(quantity->unit.dimension() == unit.dimension())) return quantity_text(*quantity, QLocale());
    return number_text(in_unit(*quantity, unit, field), QLocale());
}

QString RequirementCells::require(const UncertaintyResult& result, std::size_t output,
                                  const RequirementField& field, const QString& text,
                                  const DisplayUnits& units) {
    const OutputQuantity& own = result.outputs[output].quantity;
    const auto quantity = parse_quantity(text, unit_of(own, field, units), QLocale());
    if (!quantity) return to_qt(quantity.error().message);
    std::vector<OutputQuantity> outputs;
    if (std::ranges::count(together_, output) > 0)
        for (const std::size_t other : together_)
            if (const OutputQuantity& of = result.outputs[other].quantity;
                of.unit.dimension() == own.unit.dimension())
                outputs.push_back(of);
    if (outputs.empty()) outputs.push_back(own);
    const AnalysisEntry* entry = document_->project().find_analysis(analysis_);
    if (!entry) return {};
    for (const OutputQuantity& of : outputs) {
        const Requirement* now = find_requirement(*entry, of);
        Requirement then = now ? *now : Requirement{};
        set_value(then, field, *quantity);
        if (const QString wrong = complaint_of_target(then.target_uncertainty); !wrong.isEmpty())
            return wrong;
        if (const QString wrong = complaint_of_limits(then.lower_limit, then.upper_limit); !wrong.isEmpty())
            return wrong;
    }
    change_requirements(*document_, analysis_, outputs,
                        [&](Requirement& requirement) { set_value(requirement, field, *quantity); });
    return {};
}

bool RequirementCells::type(const UncertaintyResult& result, std::size_t output, const std::string& column,
                            const QString& text, const DisplayUnits& units) {
    const std::pair cell(output, column);
    refused_.erase(cell);
    const QString complaint = require(result, output, *field_of(column), text, units);
    if (complaint.isEmpty()) return true;
    refused_[cell] = {text, complaint};
    return false;
}

}  // namespace covaria::ui
