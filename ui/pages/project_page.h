// Statements about a project as a whole: title, notes, number, author, and how the results of all its
// analyses are stated.
#pragma once

#include <QWidget>

#include "ui/document/document.h"

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace covaria::ui {

class QuantityEdit;
class UnitChoices;

class ProjectPage : public QWidget {
    Q_OBJECT
public:
    explicit ProjectPage(Document& document, QWidget* parent = nullptr);
    /// False: the path names no field of this page.
    bool focus_field(const std::string& path);

private:
    QLineEdit* add_text(QFormLayout& form, const QString& title, const char* name, const QString& help,
                        std::string Project::*member);
    void add_results(QFormLayout& form);
    void refresh();
    void refresh_problems();

    Document& document_;
    QLineEdit *number_ = nullptr, *author_ = nullptr;
    UnitChoices* units_ = nullptr;
    QComboBox* digits_ = nullptr;
    QuantityEdit* factor_ = nullptr;
};

}  // namespace covaria::ui
