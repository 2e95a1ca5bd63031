// The properties of what is selected, in groups that fold: title, certificate and report of the project, an
// asset's set-up and evaluation, or an analysis' set-up, inputs, correlations and options. Every form comes
// from a schema or from the model's input quantities.
#pragma once

#include <QLabel>
#include <QPointer>
#include <QWidget>
#include <memory>

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/pages/group_summaries.h"
#include "ui/run/analysis_runner.h"

class QStackedLayout;
class QScrollArea;

namespace covaria::ui {

class CertificateForm;
class FieldHelp;
class FigureSourcesForm;
class FoldGroups;
class InputsPage;
class InspectorHead;
class OptionsForm;
class ProjectPage;
class ReviewForm;
class RequirementsForm;
class DesignsForm;
class StudiesForm;
class SetupForm;

class PropertiesPane : public QWidget {
    Q_OBJECT
public:
    PropertiesPane(Document& document, AnalysisRunner& runner, Selection& selection,
                   QWidget* parent = nullptr);

    void show_group(int group);
    void show_inputs() { show_group(inputs_group); }  ///< shows those of an analysis
    void show_studies() { show_group(studies_group); }
    void show_designs() { show_group(designs_group); }
    /// Makes the forms anew: numbers are written in another form.
    void start_over() { rebuild(); }
    /// Brings the field that a JSON pointer into the project names into view and gives it the focus.
    void focus_field(const QString& path);
    SetupForm* setup_form() const { return forms_.setup; }
    FoldGroups& groups() const { return *groups_; }
    /// Names what is selected, and leads to the entries before and after it: the pane's title.
    InspectorHead& head() { return *head_; }
    /// Sets the units of requirements and of what is said of them.
    void set_units(const DisplayUnits& units);
    /// Gives the focus to the first field of the set-up, where one begins to fill it in.
    void go_to_first_field();

signals:
    /// A place elsewhere in the project is wanted: a JSON pointer into it.
    void place_wanted(const QString& path);
    /// Somebody asks for the results that rest on the certificate of this number.
    void impact_wanted(const QString& certificate);

private:
    /// The forms of what is selected; null where it has none of the kind.
    struct Forms {
        SetupForm* setup = nullptr;
        CertificateForm* certificate = nullptr;
        ProjectPage* project = nullptr;
        ReviewForm* review = nullptr;
        InputsPage* inputs = nullptr;
        OptionsForm* options = nullptr;
        StudiesForm* studies = nullptr;
        DesignsForm* designs = nullptr;
        RequirementsForm* requirements = nullptr;
        FigureSourcesForm* sources = nullptr;
    };
    void summarise();
    void start_help();
    void go_to_field(const QString& path);
    void scroll_to_focus();
    void rebuild();
    void add_project_pages();
    void add_entry_pages(const SetupAddress& entry);
    void add_analysis_pages(const SetupAddress& entry);
    void discard_if_gone();
    void follow_field(const QString& field);
    void show_forecast(const QString& analysis);

    Document& document_;
    AnalysisRunner& runner_;
    Selection& selection_;
    FieldHelp* help_ = nullptr;
    InspectorHead* head_;
    QScrollArea* area_ = nullptr;
    FoldGroups* groups_ = nullptr;
    QPointer<QLabel> hint_;  ///< shown where no entry is selected
    Forms forms_;
    DisplayUnits units_;
    bool following_ = false;  ///< the selection's field is being set or followed
};

}  // namespace covaria::ui
