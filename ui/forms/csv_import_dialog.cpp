// Reading is that of core/project, so that import and linked files agree.
#include "ui/forms/csv_import_dialog.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/symbol.h"
#include "ui/document/quantity_text.h"
#include "ui/document/setup_cells.h"
#include "ui/document/strings.h"

namespace covaria::ui {

namespace {

constexpr int preview_rows = 200;
constexpr int shown_problems = 8;

}  // namespace

CsvImportDialog::CsvImportDialog(const FieldSpec& field, std::vector<Unit> units, const QString& file,
                                 QWidget* parent)
    : QDialog(parent),
      field_(field),
      units_(std::move(units)),
      separator_(new QComboBox(this)),
      preview_(new QTableWidget(this)),
      summary_(new QLabel(this)) {
    setWindowTitle(tr("Import %1 into %2").arg(QFileInfo(file).fileName(), to_qt(field.title)));
    QFile source(file);
    if (source.open(QIODevice::ReadOnly))
        text_ = source.readAll();
    else
        read_failure_ = tr("%1 cannot be read: %2.").arg(file, source.errorString());
    separator_->addItem(tr("found by itself"), QString());
    separator_->addItem(tr("comma"), QString(","));
    separator_->addItem(tr("semicolon"), QString(";"));
    separator_->addItem(tr("tab"), QString("\t"));
    preview_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    preview_->setAccessibleName(tr("Preview"));
    summary_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    accept_ = buttons->button(QDialogButtonBox::Ok);
    accept_->setText(tr("Import"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Separator of cells"), separator_);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(preview_, 1);
    layout->addWidget(summary_);
    layout->addWidget(buttons);
    resize(720, 480);
    connect(separator_, &QComboBox::currentIndexChanged, this, &CsvImportDialog::read);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    read();
}

void CsvImportDialog::read() {
    imported_ = {};
    QString failure = read_failure_;
    const QString chosen = separator_->currentData().toString();
    const std::optional<char> separator =
        chosen.isEmpty() ? std::nullopt : std::optional<char>(chosen.at(0).toLatin1());
    if (const auto csv =
            read_csv(std::string_view(text_.data(), static_cast<std::size_t>(text_.size())), separator);
        !csv)
        failure = csv.error().line > 0
                      ? tr("Line %1: %2").arg(csv.error().line).arg(to_qt(csv.error().message))
                      : to_qt(csv.error().message);
    else
        imported_ = has_header(*csv, field_) ? table_from_csv(*csv, field_)
                                             : table_from_csv_rows(*csv, field_, units_);
    show_preview();
    show_summary(failure);
}

void CsvImportDialog::show_preview() {
    const SetupTable& table = imported_.table;
    const int rows = std::min(preview_rows, static_cast<int>(table.rows.size()));
    preview_->clear();
    preview_->setColumnCount(static_cast<int>(field_.columns.size()));
    preview_->setRowCount(rows);
    for (std::size_t c = 0; c < field_.columns.size(); ++c) {
        const Unit unit = c < table.units.size() ? table.units[c] : field_.columns[c].unit;
        const QString title = with_unit(to_qt(symbol_to_unicode(field_.columns[c].title)), unit);
        preview_->setHorizontalHeaderItem(static_cast<int>(c), new QTableWidgetItem(title));
        for (int r = 0; r < rows; ++r) {
            const auto& row = table.rows[static_cast<std::size_t>(r)];
            const QString text = c < row.size() ? cell_text(field_.columns[c], row[c], locale()) : QString();
            preview_->setItem(r, static_cast<int>(c), new QTableWidgetItem(text));
        }
    }
}

void CsvImportDialog::show_summary(const QString& failure) {
    QStringList lines;
    const auto& problems = imported_.problems.items();
    if (failure.isEmpty()) {
        lines << tr("%n row(s).", nullptr, static_cast<int>(imported_.table.rows.size()));
        for (const Problem& problem : problems) {
            if (lines.size() > shown_problems) break;
            lines << (problem.line > 0 ? tr("Line %1: %2").arg(problem.line).arg(to_qt(problem.message))
                                       : to_qt(problem.message));
        }
        if (problems.size() > shown_problems)
            lines << tr("%n more problem(s).", nullptr, static_cast<int>(problems.size()) - shown_problems);
    } else {
        lines << failure;
    }
    summary_->setText(lines.join('\n'));
    accept_->setEnabled(failure.isEmpty() && !imported_.problems.has_errors() &&
                        !imported_.table.rows.empty());
}

}  // namespace covaria::ui
