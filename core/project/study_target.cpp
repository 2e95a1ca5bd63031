// Targets of studies: from a JSON pointer to a number of a set-up or an input quantity.
#include "core/project/study_target.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/in_quotes.h"
#include "core/base/temperature.h"
#include "core/project/entry_names.h"
#include "core/project/kind_lookup.h"
#include "core/project/links.h"
#include "core/setup/message_text.h"
#include "core/text/symbol.h"

namespace covaria {

namespace {

bool is_numeric(FieldKind kind) {
    return kind == FieldKind::number || kind == FieldKind::integer;
}

// The tokens of a JSON pointer, unescaped (RFC 6901); none when it does not begin with '/'.
std::vector<std::string> tokens_of(const std::string& pointer) {
    std::vector<std::string> tokens;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            tokens.emplace_back();
        } else if (tokens.empty()) {
            return {};
        } else if (pointer[i] == '~' && i + 1 < pointer.size()) {
            tokens.back() += pointer[++i] == '1' ? '/' : '~';
        } else {
            tokens.back() += pointer[i];
        }
    }
    return tokens;
}

std::optional<std::size_t> index_from(const std::string& text) {
    std::size_t index = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (status != std::errc{} || end != text.data() + text.size()) return {};
    return index;
}

class TargetFinder {
public:
    TargetFinder(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                 const StudyAxis& axis)
        : project_(project),
          analysis_(analysis),
          inputs_(inputs),
          axis_(axis),
          tokens_(tokens_of(axis.target)) {}

    Result<StudyTarget> find() {
        if (tokens_.size() >= 2 && tokens_[0] == "setup") return in_setup();
        if (!axis_.asset.empty()) return no(tell<"only numbers of the set-up of an asset can be varied">());
        if (tokens_.size() == 3 && tokens_[0] == "inputs") return quantity();
        if (tokens_.size() == 2 && tokens_[0] == "components") return component();
        return no(tell<"a target is written as \"/setup/KEY\", \"/setup/KEY/rows/0/COLUMN\", "
                       "\"/inputs/SYMBOL/estimate\" or \"/inputs/SYMBOL/components\"">());
    }

private:
    tl::unexpected<Error> no(const Message& why) const {
        return fail(ErrorCode::bad_input, tell<"it cannot be varied: %1">(why), "/target");
    }

    /// The title of a target, which stands behind its name where it is one of an asset.
    Message titled(Message title) const {
        return prefix_.empty() ? title : tell<"%1: %2">(prefix_, std::move(title));
    }

    const AnalysisEntry* find_upstream() const {
        const std::vector<std::string> used = analyses_used_by(project_, analysis_);
        const bool is_used = std::find(used.begin(), used.end(), axis_.asset) != used.end();
        return is_used ? project_.find_analysis(axis_.asset) : nullptr;
    }

    template <class Entry>
    const SetupSchema* of_entry(const Entry& entry) {
        setup_ = &entry.setup;
        prefix_ = entry.name.empty() ? entry.id : entry.name;
        return schema_of(entry);
    }

    Result<StudyTarget> in_setup() {
        const SetupSchema* schema = schema_of(analysis_);
        setup_ = &analysis_.setup;
        if (!axis_.asset.empty()) {
            const AssetEntry* asset = project_.find_asset(axis_.asset);
            const AnalysisEntry* upstream = asset ? nullptr : find_upstream();
            if (!asset && !upstream)
                return fail(
                    ErrorCode::bad_input,
                    tell<"there is no asset %1, and no analysis of this name that this one takes "
                         "from%2">(in_quotes(axis_.asset), did_you_mean_entry(axis_.asset, project_.assets)),
                    "/asset");
            schema = asset ? of_entry(*asset) : of_entry(*upstream);
            if (asset) target_.asset = static_cast<std::size_t>(asset - project_.assets.data());
            if (upstream) target_.upstream = static_cast<std::size_t>(upstream - project_.analyses.data());
        }
        if (!schema) return no(tell<"the set-up has no schema">());
        const FieldSpec* field = schema->find(tokens_[1]);
        if (!field)
            return no(tell<"the set-up has no field %1%2">(in_quotes(tokens_[1]),
                                                           did_you_mean(tokens_[1], schema->keys())));
        if (!is_shown(*schema, *field, *setup_))
            return no(tell<"'%1' is not used with the present choices of the set-up">(
                Message::declared(field->title)));
        target_.key = field->key;
        return of_field(*field, value_of(*field, *setup_));
    }

    Result<StudyTarget> of_field(const FieldSpec& field, const SetupValue& value) {
        if (field.kind == FieldKind::table) return of_table(field, value);
        if (field.kind == FieldKind::pose) return of_pose(field, value);
        if (!is_numeric(field.kind) || tokens_.size() != 2)
            return no(tell<"'%1' is not a number">(Message::declared(field.title)));
        const auto* number = std::get_if<Quantity>(&value);
        target_.kind = StudyTarget::Kind::field;
        target_.whole = field.kind == FieldKind::integer;
        target_.unit = number ? number->unit : field.unit;
        target_.current = number ? number->value : 0.0;
        target_.title = titled(Message::declared(field.title));
        if (!number && axis_.change != StudyChange::value)
            return no(
                tell<"'%1' is not given, so there is nothing to change">(Message::declared(field.title)));
        return target_;
    }

    Result<StudyTarget> of_pose(const FieldSpec& field, const SetupValue& value) {
        static const char* const names[] = {"x", "y", "z", "alpha", "beta", "gamma"};
        const auto index = tokens_.size() == 4 ? index_from(tokens_[3]) : std::nullopt;
        const bool angle = tokens_.size() == 4 && tokens_[2] == "angles";
        if (!index || *index > 2 || !(angle || tokens_[2] == "position"))
            return no(tell<"a coordinate of the pose '%1' is written as \"/setup/%2/position/0\" or "
                           "\"/setup/%3/angles/2\"">(Message::declared(field.title), field.key, field.key));
        const auto* pose = std::get_if<PoseValue>(&value);
        if (!pose) return no(tell<"'%1' is not given">(Message::declared(field.title)));
        target_.kind = StudyTarget::Kind::pose;
        target_.column = *index + (angle ? 3 : 0);
        target_.unit = angle ? pose->angle_unit : pose->length_unit;
        target_.current = angle ? pose->angles[*index] : pose->position[*index];
        target_.title = titled(tell<"%1, %2">(Message::declared(field.title), names[target_.column]));
        return target_;
    }

    Result<StudyTarget> of_table(const FieldSpec& field, const SetupValue& value) {
        const auto* table = std::get_if<SetupTable>(&value);
        const bool cell = tokens_.size() == 5 && tokens_[2] == "rows";
        const bool column = tokens_.size() == 4 && tokens_[2] == "columns";
        if (!cell && !column)
            return no(
                tell<"a number of the table '%1' is written as \"/setup/%2/rows/0/COLUMN\" or "
                     "\"/setup/%3/columns/COLUMN\"">(Message::declared(field.title), field.key, field.key));
        const std::size_t index = SetupSchema::column(field, tokens_.back());
        if (index == SetupSchema::npos)
            return no(tell<"the table '%1' has no column %2">(Message::declared(field.title),
                                                              in_quotes(tokens_.back())));
        const ColumnSpec& spec = field.columns[index];
        if (!is_numeric(spec.kind))
            return no(tell<"the column %1 does not hold numbers">(in_quotes(spec.key)));
        if (!table || table->rows.empty())
            return no(tell<"the table '%1' is empty">(Message::declared(field.title)));
        target_.column = index;
        target_.whole = spec.kind == FieldKind::integer;
        target_.measured = field.measured || (field.states_quantities && spec.key == "value");
        target_.unit = index < table->units.size() ? table->units[index] : spec.unit;
        const std::string name = spec.title.empty() ? spec.key : spec.title;
        return cell ? of_cell(field, *table, name) : of_column(field, *table, name);
    }

    static const double* number_at(const SetupTable& table, std::size_t row, std::size_t column) {
        const auto& cells = table.rows[row];
        return column < cells.size() ? std::get_if<double>(&cells[column]) : nullptr;
    }

    Result<StudyTarget> of_cell(const FieldSpec& field, const SetupTable& table, const std::string& name) {
        const auto row = index_from(tokens_[3]);
        if (!row || *row >= table.rows.size())
            return no(tell<"the table '%1' has %2 rows, counted from 0">(Message::declared(field.title),
                                                                         table.rows.size()));
        const double* number = number_at(table, *row, target_.column);
        if (!number && axis_.change != StudyChange::value)
            return no(tell<"the cell is empty, so there is nothing to change">());
        target_.kind = StudyTarget::Kind::cell;
        target_.row = *row;
        target_.current = number ? *number : 0.0;
        target_.title = titled(tell<"%1, %2: %3">(Message::declared(field.title), row_words(table, *row),
                                                  Message::declared(name)));
        return target_;
    }

    Result<StudyTarget> of_column(const FieldSpec& field, const SetupTable& table, const std::string& name) {
        target_.kind = StudyTarget::Kind::column;
        target_.title =
            titled(tell<"%1, all rows: %2">(Message::declared(field.title), Message::declared(name)));
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (const double* number = number_at(table, row, target_.column)) {
                target_.current = *number;
                return target_;
            }
        if (axis_.change != StudyChange::value)
            return no(tell<"the column is empty, so there is nothing to change">());
        return target_;
    }

    Result<StudyTarget> quantity() {
        const bool estimate = tokens_[2] == "estimate";
        if (!estimate && tokens_[2] != "components")
            return no(tell<"of an input quantity, \"estimate\" or \"components\" can be varied">());
        target_.kind = estimate ? StudyTarget::Kind::estimate : StudyTarget::Kind::components;
        target_.measured = estimate;
        target_.key = tokens_[1];
        const Text symbol = symbol_text(tokens_[1]);
        target_.title = estimate ? TypesetMessage::of<"%1: estimate">(symbol)
                                 : TypesetMessage::of<"%1: uncertainty">(symbol);
        if (!estimate) target_.current = 1.0;
        if (!inputs_) return target_;
        target_.index = inputs_->find(target_.key);
        if (target_.index == InputSet::npos) {
            std::vector<std::string> symbols;
            for (const InputQuantity& q : inputs_->quantities) symbols.push_back(q.symbol);
            return no(tell<"the model has no input quantity %1%2">(in_quotes(target_.key),
                                                                   did_you_mean(target_.key, symbols)));
        }
        if (!estimate) return target_;
        target_.unit = inputs_->quantities[target_.index].unit;
        target_.current = target_.unit.from_si(estimate_of(*inputs_, target_.index));
        return target_;
    }

    Result<StudyTarget> component() {
        target_.kind = StudyTarget::Kind::component;
        target_.key = tokens_[1];
        target_.title = tell<"%1: uncertainty">(tokens_[1]);
        target_.current = 1.0;
        if (!inputs_) return target_;
        std::vector<std::string> ids;
        for (std::size_t i = 0; i < inputs_->components.size(); ++i) {
            ids.push_back(inputs_->components[i].id);
            if (ids.back() != target_.key) continue;
            target_.index = i;
            return target_;
        }
        return no(tell<"there is no component %1%2">(in_quotes(target_.key), did_you_mean(target_.key, ids)));
    }

    const Project& project_;
    const AnalysisEntry& analysis_;
    const InputSet* inputs_;
    const StudyAxis& axis_;
    std::vector<std::string> tokens_;
    const Setup* setup_ = nullptr;
    std::string prefix_;
    StudyTarget target_;
};

/// The unit that a text of a set-up names; the unit one where it names none, or there is no such text.
Unit unit_in(const SetupSchema& schema, const Setup& setup, const std::string& key) {
    const FieldSpec* field = schema.find(key);
    const auto* text = field ? std::get_if<std::string>(&value_of(*field, setup)) : nullptr;
    return text ? Unit::parse(*text).value_or(Unit{}) : Unit{};
}

std::string text_at(const FieldSpec& field, const std::vector<SetupCell>& row, const std::string& column) {
    const std::size_t index = SetupSchema::column(field, column);
    const auto* text = index < row.size() ? std::get_if<std::string>(&row[index]) : nullptr;
    return text ? *text : std::string();
}

/// The unit of a quantity, which is stated in its first row.
Unit unit_of_quantity(const SetupSchema& schema, const Setup& setup, const std::string& symbol) {
    const FieldSpec* field = schema.find(&FieldSpec::states_quantities);
    const auto* table = field ? std::get_if<SetupTable>(&value_of(*field, setup)) : nullptr;
    for (std::size_t row = 0; table && row < table->rows.size(); ++row)
        if (plain_symbol(text_at(*field, table->rows[row], "symbol")) == plain_symbol(symbol))
            return Unit::parse(text_at(*field, table->rows[row], "unit")).value_or(Unit{});
    return {};
}

/// The unit on whose scale a value in a row is: what its table, or a field beside it, says.
Unit scale_in_row(const SetupSchema& schema, const Setup& setup, const FieldSpec& field,
                  const std::vector<SetupCell>& row, const std::string& column) {
    if (field.states_quantities) {
        const bool is_limit =
            text_at(field, row, "statement") == "limits" && (column == "a" || column == "b");
        return column == "value" || is_limit ? unit_of_quantity(schema, setup, text_at(field, row, "symbol"))
                                             : Unit{};
    }
    if (field.observes_quantities && column == "value")
        return unit_of_quantity(schema, setup, text_at(field, row, "quantity"));
    const bool is_value = column == "value" || column == "mean";
    return unit_in(schema, setup, is_value && schema.find("unit") ? "unit" : column + "_unit");
}

Unit scale_of(const Project& project, const AnalysisEntry& analysis, const StudyTarget& target) {
    const bool in_table = target.kind == StudyTarget::Kind::cell || target.kind == StudyTarget::Kind::column;
    if (!in_table || is_reading(target.unit)) return target.unit;
    const bool of_analysis = target.asset == StudyTarget::analysis;
    const SetupSchema* schema = of_analysis ? schema_of(analysis) : schema_of(project.assets[target.asset]);
    const Setup& setup = of_analysis ? analysis.setup : project.assets[target.asset].setup;
    const FieldSpec* field = schema ? schema->find(target.key) : nullptr;
    const auto* table = field ? std::get_if<SetupTable>(&value_of(*field, setup)) : nullptr;
    for (std::size_t row = 0; table && row < table->rows.size(); ++row) {
        if (target.kind == StudyTarget::Kind::cell && row != target.row) continue;
        const Unit scale =
            scale_in_row(*schema, setup, *field, table->rows[row], field->columns[target.column].key);
        if (is_reading(scale)) return scale;
    }
    return target.unit;
}

}  // namespace

Message row_words(const SetupTable& table, std::size_t row) {
    for (const SetupCell& cell : table.rows[row])
        if (const auto* text = std::get_if<std::string>(&cell); text && !text->empty()) return *text;
    return tell<"row %1">(row + 1);
}

const Setup& varied_setup(const StudyTarget& target, std::size_t own, const Project& project) {
    if (target.asset != StudyTarget::analysis) return project.assets[target.asset].setup;
    return project.analyses[target.upstream == StudyTarget::analysis ? own : target.upstream].setup;
}

Setup& varied_setup(const StudyTarget& target, std::size_t own, Project& project) {
    return const_cast<Setup&>(varied_setup(target, own, std::as_const(project)));
}

TypesetMessage changed_title(const StudyTarget& target, StudyChange change) {
    if (change == StudyChange::factor) return target.title.within<"%1, factor">();
    if (change == StudyChange::added) return target.title.within<"%1, added">();
    return target.title;
}

Result<StudyTarget> find_study_target(const Project& project, const AnalysisEntry& analysis,
                                      const InputSet* inputs, const StudyAxis& axis) {
    auto target = TargetFinder(project, analysis, inputs, axis).find();
    if (target) target->scale = scale_of(project, analysis, *target);
    return target;
}

}  // namespace covaria
