// The question "which results hang on this certificate?": its figures, those that come in their place, and
// where to look.
#pragma once

#include <QWidget>

#include "core/impact/impact.h"
#include "core/project/project.h"
#include "ui/document/setup_address.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace covaria::ui {

class ImpactForm : public QWidget {
    Q_OBJECT
public:
    explicit ImpactForm(QWidget* parent = nullptr);

    /// Offers the certificates of the project, those of the entry first. What was typed elsewhere stays.
    void offer(const Project& project, const SetupAddress& entry);
    /// Asks about the figures of this certificate.
    void ask_about(const QString& certificate);

    ImpactWords words() const;
    void set_new_figures(const QString& file);
    void add_place(const QString& folder);
    QPushButton& figures_button() { return *figures_button_; }
    QPushButton& place_button() { return *place_button_; }

signals:
    void changed();

private:
    QComboBox* certificate_;
    QLineEdit* figures_;
    QPlainTextEdit* places_;
    QCheckBox* first_order_;
    QPushButton *figures_button_, *place_button_;
};

}  // namespace covaria::ui
