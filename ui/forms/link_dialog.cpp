#include "ui/forms/link_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/text/symbol.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

QString output_text(const std::string& symbol, const Name& group) {
    const QString text = to_qt(symbol_to_unicode(symbol));
    return group.empty() ? text : QStringLiteral("%1: %2").arg(to_qt(said_name(group)), text);
}

}  // namespace

LinkDialog::LinkDialog(const std::string& symbol, std::vector<LinkChoice> choices,
                       const std::optional<InputLink>& now, QWidget* parent)
    : QDialog(parent),
      symbol_(symbol),
      choices_(std::move(choices)),
      analyses_(new QComboBox(this)),
      outputs_(new QComboBox(this)),
      linearised_(new QCheckBox(tr("&Linearised: faster, exact to first order only"), this)) {
    build();
    for (const LinkChoice& choice : choices_) analyses_->addItem(to_qt(choice.name));
    if (now) {
        const auto chosen = std::find_if(choices_.begin(), choices_.end(), [&](const LinkChoice& choice) {
            return choice.analysis == now->output.analysis;
        });
        if (chosen != choices_.end()) analyses_->setCurrentIndex(static_cast<int>(chosen - choices_.begin()));
        linearised_->setChecked(now->linearised);
    }
    list_outputs();
    const int row = analyses_->currentIndex();
    if (!now || row < 0) return;
    const auto& outputs = choices_[static_cast<std::size_t>(row)].outputs;
    const auto found = std::find(outputs.begin(), outputs.end(), now->output);
    outputs_->setCurrentIndex(found == outputs.end() ? 0 : static_cast<int>(found - outputs.begin()));
}

void LinkDialog::build() {
    setWindowTitle(tr("Take %1 From an Analysis").arg(to_qt(symbol_to_unicode(symbol_))));
    analyses_->setAccessibleName(tr("Analysis"));
    outputs_->setAccessibleName(tr("Result"));
    auto* words = new QLabel(
        choices_.empty() ? tr("No other analysis has a result of this dimension.")
                         : tr("Both analyses are then evaluated together, as one model: the result is "
                              "not carried over as a number with an uncertainty."));
    words->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("&Analysis"), analyses_);
    form->addRow(tr("&Result"), outputs_);
    form->addRow(QString(), linearised_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(!choices_.empty());
    auto* column = new QVBoxLayout(this);
    column->addWidget(words);
    column->addLayout(form);
    column->addWidget(buttons);
    connect(analyses_, &QComboBox::currentIndexChanged, this, &LinkDialog::list_outputs);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void LinkDialog::list_outputs() {
    outputs_->clear();
    const int row = analyses_->currentIndex();
    if (row < 0 || row >= static_cast<int>(choices_.size())) return;
    const LinkChoice& choice = choices_[static_cast<std::size_t>(row)];
    for (std::size_t i = 0; i < choice.outputs.size(); ++i)
        outputs_->addItem(output_text(choice.outputs[i].symbol, i < choice.groups.size()
                                                                    ? choice.groups[i]
                                                                    : Name(choice.outputs[i].group)));
}

std::optional<InputLink> LinkDialog::link() const {
    const int row = analyses_->currentIndex(), output = outputs_->currentIndex();
    if (row < 0 || output < 0) return {};
    return InputLink{symbol_,
                     choices_[static_cast<std::size_t>(row)].outputs[static_cast<std::size_t>(output)],
                     linearised_->isChecked()};
}

}  // namespace covaria::ui
