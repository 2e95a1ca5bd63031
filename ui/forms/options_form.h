// The form of an analysis' evaluation options.
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QWidget>
#include <functional>
#include <vector>

#include "core/project/option_fields.h"
#include "ui/document/document.h"
#include "ui/forms/quantity_edit.h"

namespace covaria::ui {

class OptionsForm : public QWidget {
    Q_OBJECT
public:
    OptionsForm(Document& document, std::string analysis, QWidget* parent = nullptr);
    /// `path`: "/analyses/0/options/trials", or relative: "/trials".
    bool focus_field(const std::string& path);
    /// Sets how many trials the adaptive procedure needs, in words; empty: not known.
    void set_forecast(const QString& words);

private:
    struct Row {
        const OptionField* field;
        QWidget* editor;
        std::function<void(const EvaluationOptions&)> show;
        std::function<void(const QString&)> complain;
    };
    void add(const OptionField& field);
    Row choice_row(const OptionField& field, const ChosenOption& member);
    Row flag_row(const OptionField& field, bool EvaluationOptions::*member);
    Row quantity_row(const OptionField& field);
    void add_forecast();
    void change(const OptionField& field, const std::function<void(EvaluationOptions&)>& edit);
    TextPlace place_of(const OptionField& field) const;
    const EvaluationOptions* options() const;
    void refresh();
    void refresh_problems();

    Document& document_;
    std::string analysis_;
    QFormLayout* layout_;
    QLabel* forecast_ = nullptr;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
