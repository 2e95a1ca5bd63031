// A file of others before it enters the project: its reader, the meaning of its columns, what becomes of it,
// and the parts that are left out. One dialog for all readers.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <optional>
#include <string>

#include "core/readers/readers.h"

namespace covaria::ui {

class ImportDialog : public QDialog {
    Q_OBJECT
public:
    explicit ImportDialog(const QString& file, QWidget* parent = nullptr);

    /// The entries to take over, with the stamp of the file in their notes if that is wanted.
    Proposals proposals() const;

private:
    void make_layout();
    void offer_readers();
    const Reader* reader() const;
    ReadChoice choice() const;
    void change_reader();
    void show_table();
    void offer_columns(const SourceTable& table);
    void take_mended_cells(ReadChoice& choice) const;
    void clear_marks();
    void mark_line(int line);
    void leave_out_row(int row);
    void read();
    void show_units();
    QString stamp() const;

    QString file_, failure_, hash_;
    qint64 bytes_ = 0;
    std::string text_;            ///< the file's text, as readers take it
    bool reader_chosen_ = false;  ///< not only recognised
    bool table_chosen_ = false;   ///< people said what a column is
    SourceTable shown_;           ///< the table as the file has it
    std::optional<Proposals> proposals_;
    QComboBox *readers_, *sheets_, *unit_;
    QLabel *sheets_label_, *table_label_, *summary_;
    QTableWidget* units_;  ///< the quantities for which the file states no unit, and the unit that is typed
    QLabel* units_label_;
    QTableWidget* table_;  ///< row 0: what each column is read as
    QPushButton* leave_out_;
    QPlainTextEdit* preview_;
    QCheckBox* stamp_;
    QPushButton* accept_;
};

}  // namespace covaria::ui
