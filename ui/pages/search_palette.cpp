#include "ui/pages/search_palette.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t most_shown = 60;

/// How well one word fits a text: 0 where its letters are not in the text in order.
int fit(const QString& word, const QString& text) {
    const auto at = text.indexOf(word, 0, Qt::CaseInsensitive);
    const auto begins = [&](qsizetype i) { return i == 0 || !text[i - 1].isLetterOrNumber(); };
    if (at >= 0) return text.size() == word.size() ? 100 : begins(at) ? 60 : 30;
    qsizetype from = 0, starts = 0;
    for (const QChar letter : word) {
        const auto next = text.indexOf(letter, from, Qt::CaseInsensitive);
        if (next < 0) return 0;
        starts += begins(next);
        from = next + 1;
    }
    return 1 + static_cast<int>(10 * starts / word.size());
}

}  // namespace

std::optional<int> match(const QString& typed, const Findable& findable) {
    const QStringList words = typed.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    int sum = 0;
    for (const QString& word : words) {
        const int best = std::max(
            {3 * fit(word, findable.name), 2 * fit(word, findable.english), fit(word, findable.kind)});
        if (best == 0) return std::nullopt;
        sum += best;
    }
    // The shorter one of two that fit alike is meant.
    return 100 * (sum - (findable.behind ? 150 : 0)) -
           static_cast<int>(std::min<qsizetype>(findable.name.size(), 99));
}

SearchPalette::SearchPalette(QWidget* parent)
    : QDialog(parent, Qt::Popup),
      field_(new QLineEdit),
      found_(new QTreeView),
      model_(new QStandardItemModel(0, 2, this)) {
    setObjectName(QStringLiteral("search_palette"));
    setAccessibleName(tr("Find anything"));
    field_->setObjectName(QStringLiteral("search_field"));
    field_->setPlaceholderText(tr("Analyses, quantities, results, fields, commands, help"));
    field_->setAccessibleName(tr("Find anything"));
    field_->setClearButtonEnabled(true);
    field_->installEventFilter(this);
    found_->setObjectName(QStringLiteral("search_found"));
    found_->setAccessibleName(tr("What was found"));
    found_->setModel(model_);
    found_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    found_->header()->hide();
    found_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    found_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    found_->header()->setStretchLastSection(false);
    found_->setRootIsDecorated(false);
    found_->setUniformRowHeights(true);
    found_->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(field_);
    layout->addWidget(found_);
    connect(field_, &QLineEdit::textChanged, this, &SearchPalette::show_found);
    connect(found_, &QTreeView::clicked, this, &SearchPalette::go);
}

void SearchPalette::search(std::vector<Findable> findables) {
    findables_ = std::move(findables);
    field_->clear();
    show_found();
    const QWidget& above = *parentWidget();
    const int wide = std::min(above.width() - 40, 46 * fontMetrics().averageCharWidth() + 260);
    setGeometry(QRect(above.mapToGlobal(QPoint((above.width() - wide) / 2, 48)),
                      QSize(wide, std::min(above.height() - 96, 30 * fontMetrics().height()))));
    show();
    field_->setFocus();
}

void SearchPalette::show_found() {
    std::vector<std::pair<int, std::size_t>> ranked;
    for (std::size_t i = 0; i < findables_.size(); ++i)
        if (const auto score = match(field_->text(), findables_[i])) ranked.emplace_back(-*score, i);
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    model_->setRowCount(0);
    shown_.clear();
    for (const auto& [score, i] : ranked) {
        if (shown_.size() == most_shown) break;
        shown_.push_back(i);
        auto* name = new QStandardItem(findables_[i].name);
        auto* kind = new QStandardItem(findables_[i].kind);
        name->setToolTip(findables_[i].name);
        kind->setForeground(palette().brush(QPalette::PlaceholderText));
        model_->appendRow({name, kind});
    }
    choose(0);
}

void SearchPalette::choose(int row) {
    if (model_->rowCount() > 0)
        found_->setCurrentIndex(model_->index(std::clamp(row, 0, model_->rowCount() - 1), 0));
}

void SearchPalette::go() {
    const int row = found_->currentIndex().row();
    if (row < 0) return;
    // Closed first: what is gone to takes the focus.
    const auto chosen = findables_[shown_[static_cast<std::size_t>(row)]].go;
    hide();
    chosen();
}

bool SearchPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    auto* key = static_cast<QKeyEvent*>(event);
    switch (key->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            go();
            return true;
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown: {
            const int step = key->key() == Qt::Key_Up       ? -1
                             : key->key() == Qt::Key_Down   ? 1
                             : key->key() == Qt::Key_PageUp ? -10
                                                            : 10;
            choose(found_->currentIndex().row() + step);
            return true;
        }
        default:
            return QDialog::eventFilter(watched, event);
    }
}

}  // namespace covaria::ui
