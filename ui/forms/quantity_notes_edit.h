// The notes that people write about one input quantity.
#pragma once

#include <QPlainTextEdit>
#include <string>

#include "ui/document/document.h"

namespace covaria::ui {

class QuantityNotesEdit : public QPlainTextEdit {
    Q_OBJECT
public:
    QuantityNotesEdit(Document& document, std::string analysis, QWidget* parent = nullptr);
    /// Empty: no quantity.
    void set_quantity(const std::string& symbol);

private:
    void refresh();

    Document& document_;
    std::string analysis_;
    std::string symbol_;
};

}  // namespace covaria::ui
