// Output quantities to be ticked: those that a study or a design looks at.
#pragma once

#include <QListWidget>
#include <vector>

#include "core/model/output_quantity.h"
#include "core/project/study.h"

namespace covaria::ui {

class OutputTicks : public QListWidget {
    Q_OBJECT
public:
    explicit OutputTicks(QWidget* parent = nullptr);
    void show_outputs(const std::vector<OutputQuantity>& all, const std::vector<StudyOutput>& ticked);

signals:
    void ticks_edited(const std::vector<covaria::StudyOutput>& ticked);

private:
    void take();
    std::vector<StudyOutput> outputs_;
};

}  // namespace covaria::ui
