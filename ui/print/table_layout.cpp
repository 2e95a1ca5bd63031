// Tables of a printed report: column widths, rows as flow items, heads repeated on every page.
#include "ui/print/table_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "core/text/symbol.h"
#include "ui/print/number_text.h"
#include "ui/print/rich_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t largest_whole_group = 8;  // rows under a sub-head that a page break does not part
constexpr double most_lines = 4.0;              // lines of a long text in a cell, where there is room
constexpr std::array font_scales = {1.0, 0.93, 0.86};  // the least: 6.5 pt
constexpr std::size_t most_keys = 2;                   // columns that every part of a wide table has

/// A cell: a number set to the decimal point, or a text set to the column's width.
struct Cell {
    std::optional<NumberText> number = {};
    std::optional<RichText> text = {};
};

struct Column {
    double x = 0.0, width = 0.0;
    double before_point = 0.0, after_point = 0.0;  ///< widest parts of its numbers
    bool numeric = false;
};

using ColumnIndices = std::vector<std::size_t>;

std::string cell_html(const TableBlock& block, std::size_t row, std::size_t column) {
    return to_html(written(block.table, block.table.columns[column], row, block.view));
}

/// The head on a further page: below words that say which table goes on.
RepeatedHead continued(const RepeatedHead& head, const TableBlock& block, const PageStyle& style,
                       double available) {
    if (block.continued.empty()) return head;
    RichText words(style, TextRole::caption, to_qt(to_html(running_text(block.continued))));
    words.set_width(available);
    const double above = words.height() + style.points(3.0);
    return {above + head.height, [words, above, paint = head.paint](QPainter& painter, QPointF at) {
                words.paint(painter, at);
                paint(painter, at + QPointF(0.0, above));
            }};
}

class TableLayout {
public:
    TableLayout(const TableBlock& block, const PageStyle& style, double width, ColumnIndices shown,
                double scale)
        : block_(block),
          style_(style),
          fonts_(style.with_fonts(scale)),
          available_(width),
          pad_(style.points(1.6)),
          shown_(std::move(shown)) {
        make_cells();
        place_columns();
    }

    /// Width of the columns with the least gaps: texts at their longest word, or wide enough to be read.
    double least_width(bool comfortable) const {
        double width = least_gap() * static_cast<double>(count() - 1);
        for (std::size_t c = 0; c < count(); ++c) width += least_width_of(c, comfortable);
        return width;
    }
    double least_width_of(std::size_t c, bool comfortable) const {
        const ColumnWish wish = wish_of(c, false);
        const double read = std::min(wish.natural / most_lines, 0.3 * available_);
        return comfortable && !wish.numeric ? std::max(wish.narrowest, read) : wish.narrowest;
    }
    double least_gap() const { return style_.mm(2.2); }
    bool is_numeric(std::size_t c) const { return columns_[c].numeric; }

    void append(std::vector<FlowItem>& items, bool first, bool last) {
        if (first) append_caption(items);
        const RepeatedHead here = make_head();
        const auto head = std::make_shared<RepeatedHead>(continued(here, block_, style_, available_));
        const double before = style_.mm(!first ? 3.5 : block_.table.title.empty() ? 2.5 : 0.0);
        items.push_back({here.height, before, true, here.paint, {}});
        for (std::size_t r = 0; r < cells_.size(); ++r) items.push_back(row_item(r, head, last));
        if (last) append_notes(items);
    }

private:
    std::size_t count() const { return shown_.size(); }
    bool is_subhead(std::size_t row) const { return block_.table.is_subhead(row); }

    void make_cells() {
        for (const std::size_t column : shown_) {
            const bool numeric = has_only_numbers(block_.table, block_.table.columns[column]);
            columns_.push_back({.numeric = numeric});
            heads_.emplace_back(fonts_, TextRole::table_head,
                                to_qt(to_html(head_written(block_.table.columns[column], block_.view))),
                                numeric ? Qt::AlignRight : Qt::AlignLeft);
        }
        for (std::size_t r = 0; r < block_.table.rows; ++r) {
            cells_.emplace_back();
            for (std::size_t c = 0; c < (is_subhead(r) ? 1 : count()); ++c)
                cells_[r].push_back(make_cell(r, c));
        }
    }

    Cell make_cell(std::size_t r, std::size_t c) {
        const std::string html = cell_html(block_, r, shown_[c]);
        Cell cell;
        if (html.empty()) return cell;
        if (is_subhead(r)) {
            cell.text.emplace(fonts_, TextRole::table_head, "<b>" + to_qt(html) + "</b>");
        } else if (columns_[c].numeric) {
            cell.number.emplace(fonts_, QString::fromStdString(html), block_.view.language.numbers());
            columns_[c].before_point = std::max(columns_[c].before_point, cell.number->before_point());
            columns_[c].after_point = std::max(columns_[c].after_point, cell.number->after_point());
        } else {
            cell.text.emplace(fonts_, TextRole::table, to_qt(html));
        }
        return cell;
    }

    /// `whole_heads`: heads on one line; else they may wrap.
    ColumnWish wish_of(std::size_t c, bool whole_heads) const {
        const Column& column = columns_[c];
        const double whole = heads_[c].natural_width();
        const double head = whole_heads ? whole : std::max(heads_[c].narrowest_width(), 0.34 * whole);
        if (column.numeric) {
            const double numbers = std::max(head, column.before_point + column.after_point);
            return {numbers, numbers, true};
        }
        ColumnWish wish{head, heads_[c].narrowest_width(), false};
        for (std::size_t r = 0; r < cells_.size(); ++r) {
            if (is_subhead(r) || c >= cells_[r].size() || !cells_[r][c].text) continue;
            wish.natural = std::max(wish.natural, cells_[r][c].text->natural_width());
            wish.narrowest = std::max(wish.narrowest, cells_[r][c].text->narrowest_width());
        }
        wish.narrowest = std::min(wish.narrowest, wish.natural);
        return wish;
    }

    void place_columns() {
        double wanted = 0.0;
        const auto wish_all = [&](bool whole_heads) {
            std::vector<ColumnWish> wishes;
            wanted = 0.0;
            for (std::size_t c = 0; c < count(); ++c) wishes.push_back(wish_of(c, whole_heads));
            for (const ColumnWish& wish : wishes) wanted += wish.natural;
            return wishes;
        };
        const double gaps = std::max(1.0, static_cast<double>(count() - 1));
        std::vector<ColumnWish> wishes = wish_all(true);
        if (wanted + gaps * style_.mm(3.2) > available_) wishes = wish_all(false);
        gap_ = std::clamp((available_ - wanted) / gaps, least_gap(), style_.mm(7.5));
        const std::vector<double> widths =
            share_width(wishes, available_ - gap_ * static_cast<double>(count() - 1));
        double x = 0.0;
        for (std::size_t c = 0; c < count(); ++c) {
            columns_[c].x = x;
            columns_[c].width = widths[c];
            x += widths[c] + gap_;
            heads_[c].set_width(widths[c]);
            for (std::size_t r = 0; r < cells_.size(); ++r) {
                if (c >= cells_[r].size() || !cells_[r][c].text) continue;
                cells_[r][c].text->set_width(is_subhead(r) ? available_ : widths[c]);
            }
        }
        width_ = x - gap_;
    }

    void append_caption(std::vector<FlowItem>& items) const {
        if (block_.table.title.empty()) return;
        RichText caption(style_, TextRole::caption, to_qt(to_html(running_text(block_.table.title))));
        caption.set_width(available_);
        items.push_back({caption.height() + style_.points(3.0),
                         style_.mm(4.5),
                         true,
                         [caption](QPainter& painter, QPointF at) { caption.paint(painter, at); },
                         {}});
    }

    RepeatedHead make_head() const {
        double height = 0.0;
        for (const RichText& head : heads_) height = std::max(height, head.height());
        const double pad = style_.points(2.2), thick = style_.points(0.8), thin = style_.points(0.5);
        const auto paint = [heads = heads_, columns = columns_, height, pad, thick, thin, width = width_](
                               QPainter& painter, QPointF at) {
            painter.fillRect(QRectF(at.x(), at.y(), width, thick), PageStyle::ink());
            for (std::size_t c = 0; c < heads.size(); ++c)
                heads[c].paint(painter, at + QPointF(columns[c].x, pad + height - heads[c].height()));
            painter.fillRect(QRectF(at.x(), at.y() + height + 1.6 * pad, width, thin), PageStyle::ink());
        };
        return {height + 2.2 * pad, paint};
    }

    double row_height(std::size_t r) const {
        double height = QFontMetricsF(fonts_.font(TextRole::table), style_.device()).height();
        for (const Cell& cell : cells_[r])
            if (cell.text) height = std::max(height, cell.text->height());
        return height + 2.0 * pad_;
    }

    FlowItem row_item(std::size_t r, const std::shared_ptr<const RepeatedHead>& head, bool last_part) const {
        const bool subhead = is_subhead(r);
        const bool last = r + 1 == cells_.size();
        const double height = row_height(r);
        const double line = style_.points(last ? 0.8 : 0.4);
        const auto paint = [cells = cells_[r], columns = columns_, subhead, last, height, line, pad = pad_,
                            width = width_, baseline = baseline()](QPainter& painter, QPointF at) {
            const QPointF inside = at + QPointF(0.0, pad);
            for (std::size_t c = 0; c < cells.size(); ++c) {
                const Column& column = columns[c];
                if (cells[c].text) cells[c].text->paint(painter, inside + QPointF(column.x, 0.0));
                const double point = column.x + column.width - column.after_point;
                if (cells[c].number) cells[c].number->paint(painter, inside + QPointF(point, baseline));
            }
            if (last || subhead)
                painter.fillRect(QRectF(at.x(), at.y() + height - line, width, line),
                                 last ? PageStyle::ink() : PageStyle::rule());
        };
        return {height, subhead && r > 0 ? style_.points(2.0) : 0.0, keeps_with_next(r, last_part), paint,
                head};
    }

    /// No single row is left behind or sent on, small groups under a sub-head stay whole, notes stay with the
    /// table.
    bool keeps_with_next(std::size_t r, bool last_part) const {
        const std::size_t rows = cells_.size();
        if (r + 1 == rows) return last_part && !block_.table.notes.empty();
        if (is_subhead(r) || r == 0 || r + 2 == rows) return true;
        if (is_subhead(r + 1)) return false;
        std::size_t first = r, last = r;
        while (first > 0 && !is_subhead(first)) --first;
        while (last + 1 < rows && !is_subhead(last + 1)) ++last;
        return is_subhead(first) && last - first <= largest_whole_group;
    }

    /// Baseline of the first line of a text cell: numbers stand on the same line.
    double baseline() const { return QFontMetricsF(fonts_.font(TextRole::table), style_.device()).ascent(); }

    void append_notes(std::vector<FlowItem>& items) const {
        for (const Message& note : block_.table.notes) {
            RichText text(style_, TextRole::note, to_qt(to_html(running_text(note.english()))));
            text.set_width(available_);
            items.push_back(
                {text.height(),
                 style_.points(2.5),
                 false,
                 [text](QPainter& painter, QPointF at) { text.paint(painter, at, PageStyle::quiet()); },
                 {}});
        }
    }

    const TableBlock& block_;
    const PageStyle& style_;
    const PageStyle fonts_;
    double available_, pad_, gap_ = 0.0, width_ = 0.0;
    ColumnIndices shown_;
    std::vector<Column> columns_;
    std::vector<RichText> heads_;
    std::vector<std::vector<Cell>> cells_;
};

ColumnIndices all_columns(const TableBlock& block) {
    ColumnIndices all(block.table.shown_columns());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

/// The columns of each part of a table that is too wide: its first ones of text, and as many others as fit.
std::vector<ColumnIndices> parts_of(const TableLayout& whole, std::size_t columns, double available) {
    const auto width_of = [&](std::size_t c) { return whole.least_width_of(c, true) + whole.least_gap(); };
    ColumnIndices keys{0};
    double key_width = width_of(0);
    while (keys.size() < std::min(most_keys, columns) && !whole.is_numeric(keys.size()) &&
           key_width + width_of(keys.size()) < 0.3 * available) {
        key_width += width_of(keys.size());
        keys.push_back(keys.size());
    }
    std::vector<ColumnIndices> parts;
    double width = 0.0;
    for (std::size_t c = keys.size(); c < columns; ++c) {
        const bool begins = parts.empty() || width + width_of(c) > available + whole.least_gap();
        if (begins) {
            parts.push_back(keys);
            width = key_width;
        }
        parts.back().push_back(c);
        width += width_of(c);
    }
    return parts;
}

}  // namespace

std::vector<double> share_width(const std::vector<ColumnWish>& wishes, double available) {
    double natural = 0.0, least = 0.0;
    const auto least_of = [](const ColumnWish& wish) {
        return wish.numeric ? wish.natural : std::min(wish.narrowest, wish.natural);
    };
    for (const ColumnWish& wish : wishes) {
        natural += wish.natural;
        least += least_of(wish);
    }
    const double slack = natural - least;
    const double factor =
        natural <= available || slack <= 0.0 ? 1.0 : std::max(0.0, (available - least) / slack);
    std::vector<double> widths;
    for (const ColumnWish& wish : wishes)
        widths.push_back(least_of(wish) + factor * (wish.natural - least_of(wish)));
    return widths;
}

void append_table(std::vector<FlowItem>& items, const TableBlock& block, const PageStyle& style,
                  double width) {
    const ColumnIndices all = all_columns(block);
    if (all.empty()) return;
    for (const bool comfortable : {true, false})
        for (const double scale : font_scales) {
            TableLayout whole(block, style, width, all, scale);
            if (whole.least_width(comfortable) <= width) return whole.append(items, true, true);
        }
    const TableLayout whole(block, style, width, all, 1.0);
    const std::vector<ColumnIndices> parts = parts_of(whole, all.size(), width);
    for (std::size_t i = 0; i < parts.size(); ++i)
        TableLayout(block, style, width, parts[i], 1.0).append(items, i == 0, i + 1 == parts.size());
}

}  // namespace covaria::ui
