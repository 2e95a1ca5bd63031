// Reading is that of core/readers, so that the window and `covaria import` agree.
#include "ui/forms/import_dialog.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHash>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/file_io.h"
#include "core/made/import_reading.h"
#include "core/made/made_project.h"
#include "core/readers/proposal_text.h"
#include "core/readers/text_encoding.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {

// Roles of the head of a row.
constexpr int left_out_role = Qt::UserRole;
constexpr int row_role = Qt::UserRole + 1;

/// Message with the line of the error, as the command line prints it.
QString words_of(const Error& error) {
    const QString message = to_qt(error.message);
    return error.line > 0 ? ImportDialog::tr("Line %1: %2").arg(error.line).arg(message) : message;
}

/// First error of a project made of the proposals; empty if it may be evaluated.
QString contradictions(const Proposals& proposals) {
    Project project;
    add_to_project(project, proposals);
    const Problems problems = MadeProject::make(std::move(project))->problems();
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error)
            return ImportDialog::tr("What the file says contradicts itself: %1").arg(to_qt(problem.message));
    return {};
}

}  // namespace

ImportDialog::ImportDialog(const QString& file, QWidget* parent)
    : QDialog(parent),
      file_(file),
      readers_(new QComboBox(this)),
      sheets_(new QComboBox(this)),
      unit_(new QComboBox(this)),
      sheets_label_(new QLabel(tr("&Sheet"), this)),
      table_label_(new QLabel(tr("Columns of the file and what each is read as"), this)),
      summary_(new QLabel(this)),
      units_(new QTableWidget(0, 2, this)),
      units_label_(new QLabel(tr("Units that the &file does not state"), this)),
      table_(new QTableWidget(this)),
      leave_out_(new QPushButton(tr("&Leave Out or Read the Row"), this)),
      preview_(new QPlainTextEdit(this)),
      stamp_(new QCheckBox(tr("&Note the file with its size, time and SHA-256 in what is added"), this)) {
    setWindowTitle(tr("Import %1").arg(QFileInfo(file).fileName()));
    if (auto read = read_file(to_path(file))) {
        bytes_ = static_cast<qint64>(read->size());
        hash_ = QString::fromLatin1(
            QCryptographicHash::hash(QByteArray::fromRawData(read->data(), static_cast<qsizetype>(bytes_)),
                                     QCryptographicHash::Sha256)
                .toHex());
        text_ = text_for_readers(std::move(*read));
    } else {
        failure_ = to_qt(read.error().message);
    }
    for (const char* unit : {"", "mm", "m", "cm", "in", "ft"})
        unit_->addItem(*unit ? QString::fromLatin1(unit) : tr("as the file says, else mm"),
                       QString::fromLatin1(unit));
    readers_->setObjectName(QStringLiteral("reader"));
    sheets_->setObjectName(QStringLiteral("sheet"));
    unit_->setObjectName(QStringLiteral("unit"));
    table_->setObjectName(QStringLiteral("table"));
    preview_->setObjectName(QStringLiteral("preview"));
    stamp_->setObjectName(QStringLiteral("stamp"));
    summary_->setObjectName(QStringLiteral("summary"));
    units_->setObjectName(QStringLiteral("units"));
    stamp_->setChecked(true);
    make_layout();
    offer_readers();
    connect(readers_, &QComboBox::currentIndexChanged, this, [this] {
        reader_chosen_ = true;
        change_reader();
    });
    connect(sheets_, &QComboBox::currentIndexChanged, this, &ImportDialog::change_reader);
    connect(unit_, &QComboBox::currentIndexChanged, this, &ImportDialog::read);
    connect(units_, &QTableWidget::cellChanged, this, &ImportDialog::read);
    connect(table_, &QTableWidget::cellChanged, this, &ImportDialog::read);
    connect(leave_out_, &QPushButton::clicked, this, [this] { leave_out_row(table_->currentRow()); });
    change_reader();
}

void ImportDialog::make_layout() {
    table_->setAccessibleName(table_label_->text());
    table_->horizontalHeader()->hide();
    leave_out_->setObjectName(QStringLiteral("leave_out"));
    preview_->setAccessibleName(tr("What becomes of the file"));
    preview_->setReadOnly(true);
    preview_->setLineWrapMode(QPlainTextEdit::NoWrap);
    preview_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    summary_->setWordWrap(true);
    sheets_label_->setBuddy(sheets_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    accept_ = buttons->button(QDialogButtonBox::Ok);
    accept_->setText(tr("Import"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Read as"), readers_);
    form->addRow(sheets_label_, sheets_);
    form->addRow(tr("&Unit of lengths"), unit_);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(table_label_);
    layout->addWidget(table_, 1);
    layout->addWidget(leave_out_, 0, Qt::AlignLeft);
    units_label_->setBuddy(units_);
    units_->setHorizontalHeaderLabels({tr("Quantity"), tr("Unit")});
    units_->horizontalHeader()->setStretchLastSection(true);
    units_->verticalHeader()->hide();
    units_->setMaximumHeight(120);
    units_->hide();
    units_label_->hide();
    layout->addWidget(units_label_);
    layout->addWidget(units_);
    layout->addWidget(new QLabel(tr("What becomes of it, and what is not taken over"), this));
    layout->addWidget(preview_, 2);
    layout->addWidget(summary_);
    layout->addWidget(stamp_);
    layout->addWidget(buttons);
    resize(900, 720);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// Lists readers that recognise the file first; none is chosen where several do.
void ImportDialog::offer_readers() {
    const RecognisedReaders found = recognise_reader(text_, to_std(QFileInfo(file_).fileName()));
    readers_->addItem(found.readers.empty() ? tr("no reader recognises it: choose one")
                                            : tr("several readers recognise it: choose one"));
    std::vector<const Reader*> listed = found.readers;
    listed.insert(listed.end(), found.others.begin(), found.others.end());
    const std::size_t known = listed.size();
    for (const Reader& reader : reader_registry())
        if (std::find(listed.begin(), listed.end(), &reader) == listed.end()) listed.push_back(&reader);
    for (std::size_t i = 0; i < listed.size(); ++i)
        readers_->addItem(
            i < known ? tr("%1 (recognised)").arg(core_text(listed[i]->title)) : core_text(listed[i]->title),
            to_qt(listed[i]->name));
    readers_->setCurrentIndex(found.readers.size() == 1 ? 1 : 0);
}

const Reader* ImportDialog::reader() const {
    return find_reader(to_std(readers_->currentData().toString()));
}

ReadChoice ImportDialog::choice() const {
    ReadChoice choice{.file_name = to_std(QFileInfo(file_).fileName()),
                      .chosen = reader_chosen_,
                      .beside = neighbours_of(to_path(file_))};
    if (const QString unit = unit_->currentData().toString(); !unit.isEmpty())
        choice.length_unit = Unit::of(to_std(unit));
    for (int row = 0; row < units_->rowCount(); ++row) {
        if (const auto unit = Unit::parse(to_std(units_->item(row, 1)->text())))
            choice.units.insert_or_assign(to_std(units_->item(row, 0)->data(Qt::UserRole).toString()), *unit);
    }
    choice.sheet = to_std(sheets_->currentData().toString());
    for (int column = 0; table_chosen_ && column < table_->columnCount(); ++column) {
        const auto* box = qobject_cast<QComboBox*>(table_->cellWidget(0, column));
        const std::string word = box ? to_std(box->currentData().toString()) : std::string();
        choice.columns.push_back(word.empty() ? shown_.unknown : word);
    }
    take_mended_cells(choice);
    return choice;
}

/// Takes the cells that were typed over in the table, and the rows that were left out.
void ImportDialog::take_mended_cells(ReadChoice& choice) const {
    for (std::size_t row = 0; row < shown_.row_numbers.size(); ++row) {
        const int number = shown_.row_numbers[row], in_table = static_cast<int>(row) + 1;
        const QTableWidgetItem* head = table_->verticalHeaderItem(in_table);
        if (head && head->data(left_out_role).toBool()) choice.rows_left_out.insert(number);
        for (std::size_t column = 0; column < shown_.letters.size(); ++column) {
            const QTableWidgetItem* item = table_->item(in_table, static_cast<int>(column));
            const std::string text = item ? to_std(item->text()) : std::string();
            if (text != shown_.rows[row][column])
                choice.cells[shown_.letters[column] + std::to_string(number)] = text;
        }
    }
}

void ImportDialog::clear_marks() {
    const QSignalBlocker quiet(table_);
    for (int row = 1; row < table_->rowCount(); ++row)
        for (int column = 0; column < table_->columnCount(); ++column)
            if (QTableWidgetItem* item = table_->item(row, column)) item->setBackground(QBrush());
}

/// Marks the row that could not be read, and brings it into sight.
void ImportDialog::mark_line(int line) {
    const auto found = std::find(shown_.row_numbers.begin(), shown_.row_numbers.end(), line);
    if (found == shown_.row_numbers.end()) return;
    const int row = static_cast<int>(found - shown_.row_numbers.begin()) + 1;
    const QSignalBlocker quiet(table_);
    for (int column = 0; column < table_->columnCount(); ++column)
        if (QTableWidgetItem* item = table_->item(row, column)) item->setBackground(refused_ground());
    if (QTableWidgetItem* first = table_->item(row, 0)) table_->scrollToItem(first);
}

void ImportDialog::leave_out_row(int row) {
    QTableWidgetItem* head = row > 0 ? table_->verticalHeaderItem(row) : nullptr;
    if (!head) return;
    const bool out = !head->data(left_out_role).toBool();
    const QSignalBlocker quiet(table_);
    head->setData(left_out_role, out);
    QFont font = head->font();
    font.setStrikeOut(out);
    head->setFont(font);
    head->setText(out ? tr("%1, left out").arg(head->data(row_role).toInt())
                      : QString::number(head->data(row_role).toInt()));
    for (int column = 0; column < table_->columnCount(); ++column)
        if (QTableWidgetItem* item = table_->item(row, column)) item->setFont(font);
    read();
}

void ImportDialog::change_reader() {
    table_chosen_ = false;
    {
        const QSignalBlocker quiet(units_);
        units_->setRowCount(0);
    }
    show_table();
    read();
}

void ImportDialog::show_table() {
    const Reader* chosen = reader();
    auto table = chosen && chosen->table ? chosen->table(text_, choice())
                                         : Result<SourceTable>(fail(ErrorCode::not_found, ""));
    const QSignalBlocker quiet(sheets_);
    sheets_->clear();
    for (const std::string& sheet : table ? table->sheets : std::vector<std::string>())
        sheets_->addItem(to_qt(sheet), to_qt(sheet));
    if (table) sheets_->setCurrentIndex(sheets_->findData(to_qt(table->sheet)));
    for (QWidget* widget : std::initializer_list<QWidget*>{sheets_, sheets_label_})
        widget->setVisible(sheets_->count() > 0);
    shown_ = table ? *table : SourceTable();
    const bool mendable = !shown_.row_numbers.empty();
    table_->setVisible(table.has_value());
    table_label_->setVisible(table.has_value());
    table_label_->setText(mendable ? tr("What each column is read as; cells can be typed over")
                                   : tr("Columns of the file and what each is read as"));
    table_->setAccessibleName(table_label_->text());
    table_->setEditTriggers(mendable ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                                           QAbstractItemView::AnyKeyPressed
                                     : QAbstractItemView::EditTriggers(QAbstractItemView::NoEditTriggers));
    table_->verticalHeader()->setVisible(mendable);
    leave_out_->setVisible(mendable);
    if (table) offer_columns(*table);
}

void ImportDialog::offer_columns(const SourceTable& table) {
    const QSignalBlocker quiet(table_);
    table_->clear();
    table_->setColumnCount(static_cast<int>(table.columns.size()));
    table_->setRowCount(static_cast<int>(table.rows.size()) + 1);
    for (int column = 0; column < table_->columnCount(); ++column) {
        const std::string& word = table.columns[static_cast<std::size_t>(column)];
        auto* box = new QComboBox;
        box->setObjectName(QStringLiteral("column-%1").arg(column + 1));
        box->setAccessibleName(tr("Column %1 is read as").arg(column + 1));
        box->addItem(word.empty() ? tr("unknown: choose") : tr("as it is named"), to_qt(word));
        for (const SourceTable::Word& other : table.words) {
            box->addItem(core_text(other.title), to_qt(other.key));
            if (other.key == word) box->setCurrentIndex(box->count() - 1);
        }
        table_->setCellWidget(0, column, box);
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            table_chosen_ = true;
            read();
        });
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (const auto& cells = table.rows[row]; static_cast<std::size_t>(column) < cells.size())
                table_->setItem(static_cast<int>(row) + 1, column,
                                new QTableWidgetItem(to_qt(cells[static_cast<std::size_t>(column)])));
    }
    auto* top = new QTableWidgetItem;
    table_->setVerticalHeaderItem(0, top);
    for (std::size_t row = 0; row < table.row_numbers.size(); ++row) {
        auto* head = new QTableWidgetItem(QString::number(table.row_numbers[row]));
        head->setData(row_role, table.row_numbers[row]);
        table_->setVerticalHeaderItem(static_cast<int>(row) + 1, head);
    }
    table_->resizeColumnsToContents();
}

void ImportDialog::read() {
    proposals_.reset();
    preview_->clear();
    clear_marks();
    QString failure = failure_;
    const Reader* chosen = reader();
    if (failure.isEmpty() && !chosen) failure = tr("Choose what the file is read as.");
    if (failure.isEmpty()) {
        const ReadChoice stated = choice();
        if (auto read = read_proposals(*chosen, text_, stated)) {
            proposals_ = std::move(*read);
        } else {
            failure = words_of(read.error());
            mark_line(read.error().line);
        }
    }
    if (proposals_) show_units();
    for (int row = 0; row < units_->rowCount() && failure.isEmpty(); ++row)
        if (const auto unit = Unit::parse(to_std(units_->item(row, 1)->text())); !unit)
            failure = to_qt(unit.error().message);
    if (proposals_ && failure.isEmpty()) {
        preview_->setPlainText(to_qt(text_of(*chosen, *proposals_, true, language_of_window())));
        failure = contradictions(*proposals_);
        if (failure.isEmpty())
            summary_->setText(tr("%1 assets and %2 analyses are added, in one step that can be undone.")
                                  .arg(proposals_->assets.size())
                                  .arg(proposals_->analyses.size()));
    }
    if (!failure.isEmpty()) summary_->setText(failure);
    accept_->setEnabled(failure.isEmpty());
}

/// Units that were typed stay, unreadable ones too.
void ImportDialog::show_units() {
    const QSignalBlocker quiet(units_);
    QHash<QString, QString> typed;
    for (int row = 0; row < units_->rowCount(); ++row)
        typed[units_->item(row, 0)->data(Qt::UserRole).toString()] = units_->item(row, 1)->text();
    units_->setRowCount(static_cast<int>(proposals_->unstated.size()));
    for (int row = 0; row < units_->rowCount(); ++row) {
        const UnstatedUnit& unit = proposals_->unstated[static_cast<std::size_t>(row)];
        const QString key = to_qt(unit.key);
        auto* name = new QTableWidgetItem(
            unit.title.empty() || unit.title == unit.key ? key : tr("%1 (%2)").arg(key, to_qt(unit.title)));
        name->setFlags(Qt::ItemIsEnabled);
        name->setData(Qt::UserRole, key);
        units_->setItem(row, 0, name);
        units_->setItem(row, 1, new QTableWidgetItem(typed.value(key, to_qt(unit.taken.text()))));
    }
    units_->resizeColumnToContents(0);
    for (QWidget* widget : std::initializer_list<QWidget*>{units_, units_label_})
        widget->setVisible(units_->rowCount() > 0);
}

QString ImportDialog::stamp() const {
    const QFileInfo info(file_);
    return tr("Imported from %1, %2 bytes, of %3, SHA-256 %4.")
        .arg(info.fileName())
        .arg(bytes_)
        .arg(info.lastModified().toUTC().toString(Qt::ISODate))
        .arg(hash_);
}

Proposals ImportDialog::proposals() const {
    Proposals taken = proposals_.value_or(Proposals());
    if (!stamp_->isChecked()) return taken;
    const std::string words = to_std(stamp());
    const auto note = [&](std::string& notes) { notes += (notes.empty() ? "" : "\n") + words; };
    for (AssetEntry& asset : taken.assets) note(asset.notes);
    for (AnalysisEntry& analysis : taken.analyses) note(analysis.notes);
    return taken;
}

}  // namespace covaria::ui
