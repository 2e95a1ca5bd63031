#include "ui/forms/design_reduction_list.h"

#include <QFormLayout>
#include <QLabel>
#include <limits>

#include "ui/forms/form_labels.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

DesignReductionList::DesignReductionList(Choices choices, QWidget* parent)
    : QGroupBox(tr("Reductions"), parent), choices_(std::move(choices)) {
    column_ = new QVBoxLayout(this);
    auto* note = new QLabel(tr("Each has a price; they take the place of variables and rows."));
    note->setWordWrap(true);
    note->setEnabled(false);
    auto* add = new QPushButton(tr("Add Reduction"));
    add->setObjectName(QStringLiteral("add_reduction"));
    add->setToolTip(tr("One more uncertainty that can be made smaller for money"));
    column_->addWidget(add, 0, Qt::AlignLeft);
    column_->addWidget(note);
    connect(add, &QPushButton::clicked, this, &DesignReductionList::add_reduction);
}

/// Adds the first number that uncertainties are proportional to and that is not reduced yet.
void DesignReductionList::add_reduction() {
    emit edited(
        [choices = choices_()](std::vector<DesignReduction>& reductions) {
            for (const StudyTargetChoice& choice : choices) {
                if (choice.target.kind != StudyTarget::Kind::component &&
                    choice.target.kind != StudyTarget::Kind::components)
                    continue;
                const bool used = std::ranges::any_of(reductions, [&](const DesignReduction& reduction) {
                    return reduction.number.asset == choice.axis.asset &&
                           reduction.number.target == choice.axis.target;
                });
                if (used) continue;
                DesignReduction reduction;
                reduction.number.asset = choice.axis.asset;
                reduction.number.target = choice.axis.target;
                reductions.push_back(reduction);
                return;
            }
        },
        {});
}

void DesignReductionList::change(std::size_t number, const std::function<void(DesignReduction&)>& how,
                                 const QString& field) {
    emit edited(
        [number, how](std::vector<DesignReduction>& reductions) {
            if (number < reductions.size()) how(reductions[number]);
        },
        QStringLiteral("reduction-%1-%2").arg(number).arg(field));
}

void DesignReductionList::add_row() {
    const std::size_t number = rows_.size();
    const auto name = [number](const char* what) {
        return QStringLiteral("reduction_%1_%2").arg(number).arg(QLatin1String(what));
    };
    Row row;
    row.whole = new QWidget;
    auto* form = new QFormLayout(row.whole);
    form->setContentsMargins(0, 0, 0, 6);
    row.target = new TargetBox(choices_);
    row.target->setObjectName(name("target"));
    row.least = new QuantityEdit;
    row.least->setObjectName(name("least"));
    row.least->setAccessibleName(tr("Smallest factor"));
    row.least->set_help(tr("The smallest factor that can be had, between 0 and 1"));
    row.price = new QuantityEdit;
    row.price->setObjectName(name("price"));
    row.price->setAccessibleName(tr("Price of the first halving"));
    row.price->set_range({0.0, std::numeric_limits<double>::infinity()});
    for (QuantityEdit* edit : {row.least, row.price}) {
        keep_letters(*edit);
        edit->set_optional(false);
    }
    row.law = new QComboBox;
    row.law->setObjectName(name("law"));
    row.law->setAccessibleName(tr("Law of the price"));
    may_be_narrow(*row.law);
    row.law->addItem(tr("price (1/f − 1)"), int(PriceLaw::inverse));
    row.law->addItem(tr("price (1/f² − 1)/3: further readings"), int(PriceLaw::repeats));
    row.law->addItem(tr("price log₂(1/f): every halving the same"), int(PriceLaw::logarithmic));
    auto* remove = new QPushButton(tr("Remove Reduction"));
    remove->setObjectName(name("remove"));
    form->addRow(tr("Reduced"), row.target);
    form->addRow(tr("Least factor"), row.least);
    form->addRow(tr("First halving"), row.price);
    form->addRow(tr("A factor f costs"), row.law);
    form->addRow(QString(), remove);
    connect_row(number, row, remove);
    column_->insertWidget(int(number), row.whole);
    rows_.push_back(row);
}

void DesignReductionList::connect_row(std::size_t number, const Row& row, QPushButton* remove) {
    connect(row.target, &TargetBox::chosen, this, [this, number](const StudyAxis& chosen) {
        change(
            number,
            [chosen](DesignReduction& reduction) {
                reduction.number.asset = chosen.asset;
                reduction.number.target = chosen.target;
            },
            QStringLiteral("target"));
    });
    const auto connect_number = [&](QuantityEdit* edit, const QString& field,
                                    const std::function<void(DesignReduction&, double)>& set) {
        connect(edit, &QuantityEdit::quantity_edited, this,
                [this, number, field, set](const std::optional<Quantity>& quantity) {
                    if (quantity)
                        change(
                            number, [&](DesignReduction& reduction) { set(reduction, quantity->value); },
                            field);
                });
    };
    connect_number(row.least, QStringLiteral("least"),
                   [](DesignReduction& reduction, double value) { reduction.number.from = value; });
    connect_number(row.price, QStringLiteral("price"),
                   [](DesignReduction& reduction, double value) { reduction.price = value; });
    connect(row.law, &QComboBox::activated, this, [this, number, laws = row.law](int index) {
        const auto law = static_cast<PriceLaw>(laws->itemData(index).toInt());
        change(
            number, [law](DesignReduction& reduction) { reduction.law = law; }, QStringLiteral("law"));
    });
    connect(remove, &QPushButton::clicked, this, [this, number] {
        emit edited(
            [number](std::vector<DesignReduction>& reductions) {
                if (number < reductions.size()) reductions.erase(reductions.begin() + std::ptrdiff_t(number));
            },
            {});
    });
}

void DesignReductionList::show_reductions(const std::vector<DesignReduction>& reductions,
                                          const std::vector<QString>& titles, UnreadTexts& unread,
                                          const TextPlace& place) {
    while (rows_.size() < reductions.size()) add_row();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        const std::string here = place.part + "/" + std::to_string(i);
        row.whole->setVisible(i < reductions.size());
        if (i >= reductions.size()) {
            unread.replace_under(place.entry, here + "/", {});
            continue;
        }
        const DesignReduction& reduction = reductions[i];
        row.target->set_place(unread, {place.entry, here + "/target"});
        row.target->show_title(titles[i].isEmpty() ? tr("choose what is reduced") : titles[i]);
        row.least->set_place(unread, {place.entry, here + "/least"});
        row.least->set_quantity(Quantity{reduction.number.from, {}});
        row.price->set_place(unread, {place.entry, here + "/price"});
        row.price->set_quantity(Quantity{reduction.price, {}});
        row.law->setCurrentIndex(row.law->findData(int(reduction.law)));
    }
}

}  // namespace covaria::ui
