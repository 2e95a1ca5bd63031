// The way a SetupTableModel follows the document: the smallest change of rows, and problems at their cells.
#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "core/setup/shared_decimals.h"
#include "core/text/symbol.h"
#include "ui/document/quantity_text.h"
#include "ui/document/setup_cells.h"
#include "ui/document/taken_rows.h"
#include "ui/models/setup_table_model.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

int to_int(std::string_view text) {
    int value = -1;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    return parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size() ? value : -1;
}

}  // namespace

SetupTable SetupTableModel::read() const {
    if (!field()) return {};
    const Setup* setup = find_setup(document_.project(), address_);
    return setup ? table_of(*field(), *setup)
                 : SetupTable{default_units(*field()), {}, {}};  // the entry is gone
}

std::vector<std::vector<int>> SetupTableModel::decimals_of_table() const {
    std::vector<std::vector<int>> decimals;
    for (std::size_t c = 0; field() && c < field()->columns.size(); ++c)
        decimals.push_back(shared_decimals(*field(), table_, c));
    return decimals;
}

void SetupTableModel::refresh() {
    const SetupTable next = read();
    if (next == table_) return;
    const bool heads = next.units != table_.units;
    bool everything = heads || next.csv_file != table_.csv_file;
    change_rows(next);
    table_ = next;
    auto decimals = decimals_of_table();  // one cell can change those of the cells beside it
    everything = everything || decimals != decimals_;
    decimals_ = std::move(decimals);
    // A text goes when something else comes into its cell; in another unit the cell is the same.
    for (auto& [at, mark] : rejected_)
        if (heads) mark.instead_of = written(at);
    std::erase_if(rejected_, [this](const auto& one) { return written(one.first) != one.second.instead_of; });
    if (kept_texts() == seen_)
        remember_rejected();
    else
        recall_rejected();  // another view of the table came first
    if (heads) emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (everything && rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void SetupTableModel::change_rows(const SetupTable& next) {
    auto& rows = table_.rows;
    const auto [old_first, new_first] =
        std::mismatch(rows.begin(), rows.end(), next.rows.begin(), next.rows.end());
    const auto first = old_first - rows.begin();
    auto old_last = static_cast<std::ptrdiff_t>(rows.size());
    auto new_last = static_cast<std::ptrdiff_t>(next.rows.size());
    while (old_last > first && new_last > first &&
           rows[static_cast<std::size_t>(old_last - 1)] ==
               next.rows[static_cast<std::size_t>(new_last - 1)]) {
        --old_last;
        --new_last;
    }
    const auto in_place = std::min(old_last, new_last) - first;
    std::copy_n(new_first, in_place, rows.begin() + first);
    if (in_place > 0)
        emit dataChanged(index(static_cast<int>(first), 0),
                         index(static_cast<int>(first + in_place) - 1, columnCount() - 1));
    const auto at = first + in_place;
    const int position = static_cast<int>(at);
    if (old_last > at) {
        beginRemoveRows({}, position, static_cast<int>(old_last) - 1);
        rows.erase(rows.begin() + at, rows.begin() + old_last);
        shift_rejected(position, -static_cast<int>(old_last - at));
        endRemoveRows();
    } else if (new_last > at) {
        beginInsertRows({}, position, static_cast<int>(new_last) - 1);
        rows.insert(rows.begin() + at, next.rows.begin() + at, next.rows.begin() + new_last);
        shift_rejected(position, static_cast<int>(new_last - at));
        endInsertRows();
    }
}

void SetupTableModel::shift_rejected(int row, int count) {
    Marks shifted;
    for (auto& [at, mark] : rejected_) {
        if (at.first < row)
            shifted[at] = mark;
        else if (at.first + count >= row)
            shifted[{at.first + count, at.second}] = mark;
    }
    rejected_ = std::move(shifted);
}

/// Text of the project's cell, by which a change of it is recognised.
std::string SetupTableModel::written(const CellPosition& at) const {
    const auto row = static_cast<std::size_t>(at.first), cell = static_cast<std::size_t>(at.second);
    return to_std(cell_text(column(at.second), table_.rows[row][cell], QLocale::c()));
}

/// Keeps the refused texts in the document, where they outlive this view of them.
void SetupTableModel::remember_rejected() {
    UnreadTexts::Texts texts;
    for (const auto& [at, mark] : rejected_) texts[place_of(at)] = {mark.text, mark.reason, mark.instead_of};
    document_.unread().replace_under(address_, "/setup/" + field_ + "/rows/", std::move(texts));
    seen_ = kept_texts();
}

/// Place of a cell among the texts that cannot be read.
TextPlace SetupTableModel::place_of(const CellPosition& at) const {
    return {address_,
            "/setup/" + field_ + "/rows/" + std::to_string(at.first) + "/" + std::to_string(at.second)};
}

UnreadTexts::Texts SetupTableModel::kept_texts() const {
    return document_.unread().under(address_, "/setup/" + field_ + "/rows/");
}

/// Takes over refused texts that another view of the same table has added, moved or taken back.
void SetupTableModel::recall_rejected() {
    if (!field() || read() != table_) return;  // it comes with the refresh
    seen_ = kept_texts();
    Marks kept;
    const std::size_t head = std::string("/setup/" + field_).size();
    for (const auto& [place, text] : seen_) {
        const CellPosition at = position_of_path(place.part.substr(head));
        const bool there =
            at.first >= 0 && at.first < rowCount() && at.second >= 0 && at.second < columnCount();
        if (there && written(at) == text.instead_of) kept[at] = {text.text, text.reason, text.instead_of};
    }
    const Marks before = std::exchange(rejected_, std::move(kept));
    const auto tell = [this](const Marks& marks, const Marks& others) {
        for (const auto& [at, mark] : marks)
            if (const auto same = others.find(at); same == others.end() || !(same->second == mark))
                emit dataChanged(index(at.first, at.second), index(at.first, at.second));
    };
    tell(before, rejected_);
    tell(rejected_, before);
}

void SetupTableModel::refresh_problems() {
    problems_.clear();
    const std::string prefix = setup_path(document_.project(), address_) + '/' + field_;
    for (const Problem& problem : document_.problems().items()) {
        if (!problem.path.starts_with(prefix + "/rows/")) continue;
        QString& text = problems_[position_of_path(problem.path.substr(prefix.size()))];
        text += (text.isEmpty() ? QString() : QString('\n')) + to_qt(problem.message);
    }
    if (rowCount() > 0 && columnCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1),
                         {Qt::ToolTipRole, Qt::BackgroundRole});
        emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
    }
}

/// Marks the rows that links replace; which quantities rows state is known once the project is made.
void SetupTableModel::refresh_taken() {
    std::map<int, QString> taken;
    const auto& made = document_.maker().made();
    const MadeAnalysis* analysis =
        made && address_.owner == SetupOwner::analysis ? made->find_analysis(address_.id) : nullptr;
    if (analysis) {
        const std::string prefix = '/' + field_;
        for (const auto& [place, link] : taken_rows(*made->project().find_analysis(address_.id), *analysis)) {
            if (!place.starts_with(prefix + "/rows/")) continue;
            const AnalysisEntry* from = made->project().find_analysis(link.output.analysis);
            taken[position_of_path(place.substr(prefix.size())).first] =
                tr("Its value is %1 of the analysis “%2”: what is stated here is not used.")
                    .arg(to_qt(symbol_to_unicode(link.output.symbol)),
                         to_qt(from && !from->name.empty() ? from->name : link.output.analysis));
        }
    }
    if (taken == taken_) return;
    taken_ = std::move(taken);
    if (rowCount() > 0 && columnCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1),
                         {Qt::ToolTipRole, Qt::ForegroundRole});
}

SetupTableModel::CellPosition SetupTableModel::position_of_path(const std::string& path) const {
    constexpr std::string_view prefix = "/rows/";
    if (!path.starts_with(prefix) || !field()) return {-1, -1};
    const std::string rest = path.substr(prefix.size());
    const std::size_t slash = rest.find('/');
    const int row = to_int(std::string_view(rest).substr(0, slash));
    if (slash == std::string::npos) return {row, -1};
    const std::string name = rest.substr(slash + 1);
    const std::size_t by_key = SetupSchema::column(*field(), name);
    return {row, by_key < field()->columns.size() ? static_cast<int>(by_key) : to_int(name)};
}

QModelIndex SetupTableModel::index_of_path(const std::string& path) const {
    const CellPosition at = position_of_path(path);
    return index(at.first, std::max(0, at.second));
}

void SetupTableModel::set_unit(int column_index, const Unit& next) {
    const Unit before = unit(column_index);
    if (!(before.dimension() == next.dimension())) return;
    const auto at = static_cast<std::size_t>(column_index);
    write(tr("Change unit in %1").arg(core_text(field()->title)), [&](SetupTable& table) {
        table.units[at] = next;
        for (auto& row : table.rows)
            if (double* number = std::get_if<double>(&row[at])) *number = converted(*number, before, next);
    });
}

void SetupTableModel::replace_table(const SetupTable& table, const QString& text) {
    rejected_.clear();
    remember_rejected();
    document_.apply(text, [&](Project& project) {
        if (Setup* setup = find_setup(project, address_)) setup->values[field_] = table;
    });
}

void SetupTableModel::embed() {
    SetupTable embedded = table_;
    embedded.csv_file.clear();
    embedded.csv_columns.clear();
    replace_table(embedded, tr("Take %1 into the project").arg(core_text(field()->title)));
}

}  // namespace covaria::ui
