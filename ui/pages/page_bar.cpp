#include "ui/pages/page_bar.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/pages/page_view.h"
#include "ui/theme/icons.h"

namespace covaria::ui {
namespace {

constexpr double fit_width = -1.0, fit_page = -2.0;  // among the factors

QString percent(double factor) {
    return PageBar::tr("%1 %").arg(QLocale().toString(int(std::lround(100.0 * factor))));
}

QToolButton* button_of(QAction* action, const char* name) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action->text());
    return button;
}

QAction* action_of(QWidget& owner, const QString& picture, const QString& text,
                   const QList<QKeySequence>& keys) {
    auto* action = new QAction(icon(picture), text, &owner);
    action->setShortcuts(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(text, keys.front().toString(QKeySequence::NativeText)));
    owner.addAction(action);
    return action;
}

}  // namespace

PageBar::PageBar(PageView& view, QWidget& owner) : view_(view), page_(new QSpinBox), zoom_(new QComboBox) {
    make_actions(owner);
    page_->setObjectName(QStringLiteral("report_page"));
    page_->setAccessibleName(tr("Page"));
    page_->setToolTip(tr("Number of the page that is shown"));
    page_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    page_->setKeyboardTracking(false);
    page_->setAlignment(Qt::AlignCenter);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(button_of(previous_, "previous_page"));
    row->addWidget(page_);
    row->addWidget(button_of(next_, "next_page"));
    row->addSpacing(8);
    row->addWidget(button_of(smaller_, "smaller_pages"));
    row->addWidget(make_zoom_box());
    row->addWidget(button_of(larger_, "larger_pages"));
    connect(page_, &QSpinBox::valueChanged, this, [this](int page) { view_.go_to_page(page - 1); });
    connect(&view_, &PageView::current_page_changed, this, &PageBar::show_page);
    connect(&view_, &PageView::zoom_changed, this, &PageBar::show_zoom);
    take_pages();
    show_zoom();
}

void PageBar::make_actions(QWidget& owner) {
    previous_ = action_of(owner, QStringLiteral("previous"), tr("Previous page"),
                          {QKeySequence(Qt::ALT | Qt::Key_Up), QKeySequence(Qt::ALT | Qt::Key_PageUp)});
    next_ = action_of(owner, QStringLiteral("next"), tr("Next page"),
                      {QKeySequence(Qt::ALT | Qt::Key_Down), QKeySequence(Qt::ALT | Qt::Key_PageDown)});
    smaller_ = action_of(owner, QStringLiteral("smaller"), tr("Smaller"),
                         {QKeySequence(Qt::CTRL | Qt::Key_Minus), QKeySequence(Qt::Key_Minus)});
    larger_ = action_of(owner, QStringLiteral("add"), tr("Larger"),
                        {QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal),
                         QKeySequence(Qt::Key_Plus)});
    connect(previous_, &QAction::triggered, this, [this] { view_.go_to_page(view_.current_page() - 1); });
    connect(next_, &QAction::triggered, this, [this] { view_.go_to_page(view_.current_page() + 1); });
    connect(smaller_, &QAction::triggered, this, [this] { view_.step_zoom(-1); });
    connect(larger_, &QAction::triggered, this, [this] { view_.step_zoom(1); });
}

/// Fits and factors to choose from; another factor can be typed.
QWidget* PageBar::make_zoom_box() {
    zoom_->setObjectName(QStringLiteral("report_zoom"));
    zoom_->setAccessibleName(tr("Size of the pages"));
    zoom_->setToolTip(tr("Size of the pages: fitted, or in per cent of the paper (Ctrl with the wheel)"));
    zoom_->setEditable(true);
    zoom_->setInsertPolicy(QComboBox::NoInsert);
    zoom_->addItem(tr("Fit Width"), fit_width);
    zoom_->addItem(tr("Fit Page"), fit_page);
    for (const double factor : PageView::offered_factors()) zoom_->addItem(percent(factor), factor);
    zoom_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(zoom_, &QComboBox::activated, this, [this](int index) {
        const double chosen = zoom_->itemData(index).toDouble();
        if (chosen > 0.0) return view_.set_zoom({PageZoom::Fit::none, chosen});
        view_.set_zoom({chosen == fit_width ? PageZoom::Fit::width : PageZoom::Fit::page});
    });
    connect(zoom_->lineEdit(), &QLineEdit::editingFinished, this, &PageBar::take_zoom_text);
    return zoom_;
}

/// "130", "130 %"; anything else leaves the pages as they are.
void PageBar::take_zoom_text() {
    if (zoom_->findText(zoom_->currentText()) < 0) {
        static const QRegularExpression number(QStringLiteral("^\\s*(\\d+)\\s*%?\\s*$"));
        const auto found = number.match(zoom_->currentText());
        if (found.hasMatch()) view_.set_zoom({PageZoom::Fit::none, found.captured(1).toDouble() / 100.0});
    }
    show_zoom();
}

void PageBar::take_pages() {
    const QSignalBlocker quiet(page_);
    const int pages = view_.page_count();
    page_->setRange(std::min(1, pages), pages);
    page_->setSuffix(tr(" of %1", "page 3 of 17").arg(pages));
    page_->setEnabled(pages > 0);
    page_->setFixedWidth(page_->sizeHint().width() + 8);
    for (QAction* action : {smaller_, larger_}) action->setEnabled(pages > 0);
    zoom_->setEnabled(pages > 0);
    show_page(view_.current_page());
}

void PageBar::show_page(int page) {
    const QSignalBlocker quiet(page_);
    page_->setValue(page + 1);
    previous_->setEnabled(page > 0);
    next_->setEnabled(page >= 0 && page + 1 < view_.page_count());
}

/// A fitted size says how large that is in its tooltip.
void PageBar::show_zoom() {
    const PageZoom zoom = view_.zoom();
    const QString words = zoom.fit == PageZoom::Fit::width  ? tr("Fit Width")
                          : zoom.fit == PageZoom::Fit::page ? tr("Fit Page")
                                                            : percent(zoom.factor);
    const QSignalBlocker quiet(zoom_);
    zoom_->setCurrentIndex(zoom_->findText(words));
    zoom_->setEditText(words);
    const double scale = view_.scale();
    larger_->setEnabled(view_.page_count() > 0 && scale < PageView::offered_factors().back() - 0.005);
    smaller_->setEnabled(view_.page_count() > 0 && scale > PageView::offered_factors().front() + 0.005);
}

}  // namespace covaria::ui
