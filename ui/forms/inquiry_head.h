// The choice of a study or design of an analysis: a list of them, and buttons to add, copy, remove and run.
#pragma once

#include <QComboBox>
#include <QPushButton>
#include <QWidget>

#include "ui/document/inquiry_edits.h"
#include "ui/theme/strings.h"

class QLabel;

namespace covaria::ui {

class InquiryHead : public QWidget {
    Q_OBJECT
public:
    struct Words {
        QString object;                       ///< for the buttons' names: "study" ("add_study")
        QString list;                         ///< for the list's name: "studies"
        QString title;                        ///< "Study"
        QString add, duplicate, remove, run;  ///< tooltips
        QString hint;                         ///< while there is none
    };
    explicit InquiryHead(const Words& words, QWidget* parent = nullptr);

    template <class Item>
    void show_items(const std::vector<Item>* items, const QString& selected) {
        QList<std::pair<QString, QString>> shown;
        if (items)
            for (const Item& item : *items)
                shown.push_back({to_qt(item.id), to_qt(item.name.empty() ? item.id : item.name)});
        show_list(shown, selected);
    }

signals:
    void chosen(const QString& id);
    void add_wanted();
    void duplicate_wanted();
    void remove_wanted();
    void run_wanted();

private:
    void show_list(const QList<std::pair<QString, QString>>& items, const QString& selected);

    QComboBox* list_;
    QPushButton *add_, *duplicate_, *remove_, *run_;
    QLabel* hint_;
};

}  // namespace covaria::ui
