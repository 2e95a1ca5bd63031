// Contents of the report: analyses, chapters, long tables.
#pragma once

#include <QCheckBox>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "ui/document/document.h"

class QLabel;

namespace covaria::ui {

/// A box for each part, ticked where it goes in; every click is one undo step.
class ReportForm : public QWidget {
    Q_OBJECT
public:
    explicit ReportForm(Document& document, QWidget* parent = nullptr);

private:
    using Keys = std::vector<std::string> ReportContents::*;
    struct Box {
        QCheckBox* box;
        std::string key;
    };
    void add_head(const QString& title);
    QCheckBox* make_box(const QString& name, const QString& help);
    QCheckBox* make_box(Keys keys, const std::string& key, const QString& title);
    void rebuild_analyses();
    void refresh();

    Document& document_;
    QVBoxLayout* column_;
    QVBoxLayout* analyses_column_;
    std::vector<Box> analyses_, chapters_;
    QLabel* language_ = nullptr;
    QCheckBox* annex_;
};

}  // namespace covaria::ui
