// The results that hang on a certificate: asks for new figures and places, shows the results that they
// change, and writes them. A window of its own, which stays while one looks at the files.
#pragma once

#include <QDialog>
#include <memory>

#include "core/impact/impact.h"
#include "ui/export/report_export.h"
#include "ui/jobs/latest_job.h"
#include "ui/main_window/dialogs.h"
#include "ui/models/impact_table_model.h"

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace covaria::ui {

class ImpactForm;
class SortableTable;

class ImpactDialog : public QDialog {
    Q_OBJECT
public:
    ImpactDialog(const Dialogs& dialogs, QWidget* parent = nullptr);

    ImpactForm& form() { return *form_; }
    SortableTable& table() { return *table_; }
    /// Evaluates what the form asks for.
    void evaluate();
    /// Ends what is being evaluated; what is shown stays.
    void stop();
    void reject() override;
    bool is_busy() const { return job_.is_busy(); }
    void write_document(const QString& file, ReportFormat format);
    void write_text(const QString& file, const std::string& text);

signals:
    void file_wanted(const QString& file);
    void finished_writing(const QString& file);

protected:
    /// Escape ends an evaluation first, then closes.
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLayout* make_run_row();
    QLayout* make_foot();
    void fill_save_menu(QMenu& menu);
    void refresh();
    void show_impact(std::shared_ptr<const Impact> impact, bool is_evaluated);
    void show_failure(const Error& error);
    void end_run();
    QString ask_file(const QString& title, const QString& ending, const QString& filter);
    void finish_writing(const QString& file, const Result<void>& written);

    const Dialogs& dialogs_;
    ImpactForm* form_;
    ImpactTableModel model_;
    SortableTable* table_;
    QLabel *answer_, *sentences_;
    QListWidget* failures_;
    QProgressBar* progress_;
    QPushButton *evaluate_, *stop_, *save_;
    QList<QAction*> of_results_;  ///< saved where something was evaluated
    bool is_evaluated_ = false;
    ImpactWords asked_;
    std::shared_ptr<const Impact> impact_;
    Inbox inbox_;    ///< progress of the job
    LatestJob job_;  ///< last member: its thread ends first
};

}  // namespace covaria::ui
