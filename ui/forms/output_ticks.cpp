#include "ui/forms/output_ticks.h"

#include <QSignalBlocker>
#include <algorithm>

#include "ui/theme/core_text.h"
#include "ui/theme/label_text.h"
#include "ui/theme/output_words.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

OutputTicks::OutputTicks(QWidget* parent) : QListWidget(parent) {
    setItemDelegate(new TypesetDelegate(this));
    setMinimumHeight(8 * fontMetrics().height());
    connect(this, &QListWidget::itemChanged, this, &OutputTicks::take);
}

void OutputTicks::show_outputs(const std::vector<OutputQuantity>& all,
                               const std::vector<StudyOutput>& ticked) {
    const QSignalBlocker blocker(this);
    outputs_.clear();
    while (count() > int(all.size())) delete takeItem(count() - 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        outputs_.push_back({all[i].group, all[i].symbol});
        if (count() <= int(i)) addItem(QString());
        QListWidgetItem* shown = item(int(i));
        const Text of = output_words(all[i].symbol, all[i].group);
        shown->setText(to_qt(to_unicode(of)));
        shown->setData(typeset_role, QVariant::fromValue(of));
        shown->setToolTip(to_qt(all[i].name));
        shown->setFlags(shown->flags() | Qt::ItemIsUserCheckable);
        const bool is_ticked = std::ranges::count(ticked, outputs_.back()) > 0;
        shown->setCheckState(is_ticked ? Qt::Checked : Qt::Unchecked);
    }
}

void OutputTicks::take() {
    std::vector<StudyOutput> ticked;
    for (std::size_t i = 0; i < outputs_.size() && int(i) < count(); ++i)
        if (item(int(i))->checkState() == Qt::Checked) ticked.push_back(outputs_[i]);
    emit ticks_edited(ticked);
}

}  // namespace covaria::ui
