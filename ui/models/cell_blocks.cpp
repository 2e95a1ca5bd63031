// Reading and writing blocks of cells.
#include "ui/models/cell_blocks.h"

#include <QAbstractItemModel>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text/numbers.h"
#include "ui/models/roles.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

QChar separator_of(const QString& text, const QLocale& locale) {
    if (text.contains('\t')) return '\t';
    if (text.contains(';')) return ';';
    return locale.decimalPoint() == QStringLiteral(",") ? QChar('\t') : QChar(',');
}

/// Splits at separators and line ends outside of quotes; a doubled quote is a quote.
class BlockParser {
public:
    explicit BlockParser(QChar separator) : separator_(separator) {}

    void take(QChar c, QChar next) {
        if (skip_) {
            skip_ = false;
        } else if (quoted_ && c == '"' && next == '"') {
            cell_ += c;
            skip_ = true;
        } else if (c == '"' && (quoted_ || cell_.isEmpty())) {
            quoted_ = !quoted_;
        } else if (!quoted_ && c == separator_) {
            end_cell();
        } else if (!quoted_ && c == '\n') {
            end_row();
        } else {
            cell_ += c;
        }
    }
    std::vector<QStringList> finish() {
        if (!cell_.isEmpty() || !row_.isEmpty()) end_row();
        return std::move(rows_);
    }

private:
    void end_cell() {
        row_ << cell_;
        cell_.clear();
    }
    void end_row() {
        end_cell();
        rows_.push_back(std::exchange(row_, {}));
    }

    QChar separator_;
    bool quoted_ = false;
    bool skip_ = false;
    QString cell_;
    QStringList row_;
    std::vector<QStringList> rows_;
};

QString quoted_if_needed(QString cell) {
    if (!cell.contains('\t') && !cell.contains('\n') && !cell.contains('"')) return cell;
    return '"' + cell.replace("\"", "\"\"") + '"';
}

/// A number with the locale's decimal mark and all its digits; what was typed and is typeset, as it was typed
/// (V_in); any other text as it is.
QString cell_for_programs(const QModelIndex& cell, const QLocale& locale) {
    const QVariant exact = cell.data(exact_role);
    const bool is_typed = cell.flags() & Qt::ItemIsEditable;
    if (!exact.isValid() && is_typed && cell.data(typeset_role).isValid())
        return cell.data(Qt::EditRole).toString();
    if (exact.typeId() == QMetaType::QString) return exact.toString();
    if (!exact.isValid() || !std::isfinite(exact.toDouble())) return cell.data().toString();
    return to_qt(format_exact(exact.toDouble())).replace('.', locale.decimalPoint());
}

}  // namespace

std::vector<QStringList> parse_block(const QString& text, const QLocale& locale) {
    QString plain = text;
    plain.replace("\r\n", "\n").replace('\r', '\n');
    BlockParser parser(separator_of(plain, locale));
    for (qsizetype i = 0; i < plain.size(); ++i)
        parser.take(plain[i], i + 1 < plain.size() ? plain[i + 1] : QChar());
    return parser.finish();
}

QString block_text(const QModelIndexList& cells, bool heads) {
    if (cells.isEmpty()) return {};
    std::map<int, std::map<int, QString>> rows;
    std::map<int, QString> columns;
    const QLocale locale;
    const QAbstractItemModel* model = cells.front().model();
    for (const QModelIndex& cell : cells) {
        rows[cell.row()][cell.column()] = cell_for_programs(cell, locale);
        columns[cell.column()] = model->headerData(cell.column(), Qt::Horizontal).toString();
    }
    QStringList lines;
    const auto add_line = [&](const std::map<int, QString>& texts) {
        QStringList line;
        for (const auto& [column, head] : columns) {
            const auto text = texts.find(column);
            line << (text == texts.end() ? QString() : quoted_if_needed(text->second));
        }
        lines << line.join('\t');
    };
    if (heads) add_line(columns);
    for (const auto& [row, texts] : rows) add_line(texts);
    return lines.join('\n') + '\n';
}

/// Two heads tell it: those behind them may have the unit of another result.
QString without_heads(const QString& text, const QAbstractItemModel& model) {
    QString begin;
    for (int column = 0; column < std::min(2, model.columnCount()); ++column)
        begin += quoted_if_needed(model.headerData(column, Qt::Horizontal).toString()) + QLatin1Char('\t');
    if (model.columnCount() < 2 || !text.startsWith(begin)) return text;
    const qsizetype end = text.indexOf(QLatin1Char('\n'));
    return end < 0 ? QString() : text.sliced(end + 1);
}

}  // namespace covaria::ui
