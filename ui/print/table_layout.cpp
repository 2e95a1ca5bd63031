// Tables of a printed report: column widths, rows as flow items, heads repeated on every page.
#include "ui/print/table_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <optional>

#include "core/report/table_text.h"
#include "core/text/symbol.h"
#include "ui/print/number_text.h"
#include "ui/print/rich_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t largest_whole_group = 8;  // rows under a sub-head that a page break does not part

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

class TableLayout {
public:
    TableLayout(const TableBlock& block, const PageStyle& style, double width)
        : block_(block), style_(style), available_(width), pad_(style.points(1.6)) {
        make_cells();
        place_columns();
    }

    void append(std::vector<FlowItem>& items) {
        append_caption(items);
        const auto head = std::make_shared<RepeatedHead>(make_head());
        const double before = block_.table.title.empty() ? style_.mm(2.5) : 0.0;
        items.push_back({head->height, before, true, head->paint, {}});
        for (std::size_t r = 0; r < cells_.size(); ++r) items.push_back(row_item(r, head));
        append_notes(items);
    }

private:
    std::size_t count() const { return block_.table.columns.size(); }

    void make_cells() {
        for (std::size_t c = 0; c < count(); ++c) {
            columns_.push_back({});
            columns_[c].numeric = is_numeric_column(block_, c);
            const auto align = columns_[c].numeric ? Qt::AlignRight : Qt::AlignLeft;
            heads_.emplace_back(style_, TextRole::table_head,
                                to_qt(to_html(head_text(block_.table.columns[c]))), align);
        }
        for (std::size_t r = 0; r < block_.table.rows.size(); ++r) {
            cells_.emplace_back();
            for (std::size_t c = 0; c < block_.table.rows[r].size() && c < count(); ++c)
                cells_[r].push_back(make_cell(r, c));
        }
    }

    Cell make_cell(std::size_t r, std::size_t c) {
        const std::string html = to_html(cell_typeset(block_, r, c));
        Cell cell;
        if (html.empty()) return cell;
        if (is_subhead(block_, r)) {
            cell.text.emplace(style_, TextRole::table_head, "<b>" + to_qt(html) + "</b>");
        } else if (columns_[c].numeric) {
            cell.number.emplace(style_, QString::fromStdString(html));
            columns_[c].before_point = std::max(columns_[c].before_point, cell.number->before_point());
            columns_[c].after_point = std::max(columns_[c].after_point, cell.number->after_point());
        } else {
            cell.text.emplace(style_, TextRole::table, to_qt(html));
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
            if (is_subhead(block_, r) || c >= cells_[r].size() || !cells_[r][c].text) continue;
            wish.natural = std::max(wish.natural, cells_[r][c].text->natural_width());
            wish.narrowest = std::max(wish.narrowest, cells_[r][c].text->narrowest_width());
        }
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
        gap_ = std::clamp((available_ - wanted) / gaps, style_.mm(2.2), style_.mm(7.5));
        const std::vector<double> widths =
            share_width(wishes, available_ - gap_ * static_cast<double>(count() - 1));
        double x = 0.0;
        for (std::size_t c = 0; c < count(); ++c) {
            columns_[c].x = x;
            columns_[c].width = widths[c];
            x += widths[c] + gap_;
            heads_[c].set_width(widths[c]);
            for (std::size_t r = 0; r < cells_.size(); ++r)
                if (!is_subhead(block_, r) && c < cells_[r].size() && cells_[r][c].text)
                    cells_[r][c].text->set_width(widths[c]);
        }
        width_ = x - gap_;
    }

    void append_caption(std::vector<FlowItem>& items) const {
        if (block_.table.title.empty()) return;
        RichText caption(style_, TextRole::caption, to_qt(escape_html(block_.table.title)));
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
        const double pad = style_.points(2.2);
        const double thick = style_.points(0.8), thin = style_.points(0.5);
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
        double height = QFontMetricsF(style_.font(TextRole::table), style_.device()).height();
        for (const Cell& cell : cells_[r])
            if (cell.text) height = std::max(height, cell.text->height());
        return height + 2.0 * pad_;
    }

    FlowItem row_item(std::size_t r, const std::shared_ptr<const RepeatedHead>& head) const {
        const bool subhead = is_subhead(block_, r);
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
        return {height, subhead && r > 0 ? style_.points(2.0) : 0.0, keeps_with_next(r), paint, head};
    }

    /// No single row is left behind or sent on, small groups under a sub-head stay whole, notes stay with the
    /// table.
    bool keeps_with_next(std::size_t r) const {
        const std::size_t rows = cells_.size();
        if (r + 1 == rows) return !block_.table.notes.empty();
        if (is_subhead(block_, r) || r == 0 || r + 2 == rows) return true;
        if (is_subhead(block_, r + 1)) return false;
        std::size_t first = r, last = r;
        while (first > 0 && !is_subhead(block_, first)) --first;
        while (last + 1 < rows && !is_subhead(block_, last + 1)) ++last;
        return is_subhead(block_, first) && last - first <= largest_whole_group;
    }

    /// Of the first line of a text cell: numbers stand on the same line.
    double baseline() const { return QFontMetricsF(style_.font(TextRole::table), style_.device()).ascent(); }

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
    double available_, pad_, gap_ = 0.0, width_ = 0.0;
    std::vector<Column> columns_;
    std::vector<RichText> heads_;
    std::vector<std::vector<Cell>> cells_;
};

}  // namespace

std::vector<double> share_width(const std::vector<ColumnWish>& wishes, double available) {
    double natural = 0.0, fixed = 0.0, narrowest = 0.0;
    for (const ColumnWish& wish : wishes) {
        natural += wish.natural;
        (wish.numeric ? fixed : narrowest) +=
            wish.numeric ? wish.natural : std::min(wish.narrowest, wish.natural);
    }
    const double slack = natural - fixed - narrowest;
    const double factor =
        natural <= available || slack <= 0.0 ? 1.0 : std::max(0.0, (available - fixed - narrowest) / slack);
    std::vector<double> widths;
    double total = 0.0;
    for (const ColumnWish& wish : wishes) {
        const double least = std::min(wish.narrowest, wish.natural);
        widths.push_back(wish.numeric ? wish.natural : least + factor * (wish.natural - least));
        total += widths.back();
    }
    if (total > available)  // even the longest words do not fit: words will break
        for (double& width : widths) width *= available / total;
    return widths;
}

void append_table(std::vector<FlowItem>& items, const TableBlock& block, const PageStyle& style,
                  double width) {
    if (block.table.columns.empty()) return;
    TableLayout(block, style, width).append(items);
}

}  // namespace covaria::ui
