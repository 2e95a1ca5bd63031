// The reductions of a design: what is reduced, how far it can be, what the first halving costs and by which
// law.
#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <functional>
#include <vector>

#include "core/project/design.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/target_box.h"

namespace covaria::ui {

class DesignReductionList : public QGroupBox {
    Q_OBJECT
public:
    using Choices = std::function<std::vector<StudyTargetChoice>()>;
    using Edit = std::function<void(std::vector<DesignReduction>&)>;
    explicit DesignReductionList(Choices choices, QWidget* parent = nullptr);

    /// `titles`: of what each reduces, empty where it does not exist. `place` of the list in the project.
    void show_reductions(const std::vector<DesignReduction>& reductions, const std::vector<QString>& titles,
                         UnreadTexts& unread, const TextPlace& place);

signals:
    void edited(const covaria::ui::DesignReductionList::Edit& edit, const QString& field);

private:
    struct Row {
        QWidget* whole = nullptr;
        TargetBox* target = nullptr;
        QuantityEdit *least = nullptr, *price = nullptr;
        QComboBox* law = nullptr;
    };
    void add_reduction();
    void add_row();
    void connect_row(std::size_t number, const Row& row, QPushButton* remove);
    void change(std::size_t number, const std::function<void(DesignReduction&)>& how, const QString& field);

    Choices choices_;
    QVBoxLayout* column_ = nullptr;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
