#include "ui/pages/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/made/examples.h"
#include "ui/pages/question_tile.h"
#include "ui/pages/recent_card.h"
#include "ui/theme/core_text.h"
#include "ui/theme/fonts.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int gap = 20, page_margin = 32, widest_page = 1160 + 2 * page_margin, in_a_row = 4;

QLabel* heading(const QString& text, TextSize size = TextSize::title) {
    auto* label = new QLabel(text);
    label->setFont(sized(label->font(), size));
    return label;
}

QLabel* quiet(const QString& text) {
    auto* label = new QLabel(text);
    label->setEnabled(false);
    return label;
}

QGridLayout* grid() {
    auto* lines = new QGridLayout;
    lines->setHorizontalSpacing(gap);
    lines->setVerticalSpacing(2);
    for (int column = 0; column < in_a_row; ++column) lines->setColumnStretch(column, 1);
    return lines;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Start page"));
    auto* inner = new QWidget;
    inner->setMaximumWidth(widest_page);
    auto* page = new QVBoxLayout(inner);
    page->setContentsMargins(page_margin, page_margin + 8, page_margin, page_margin);
    page->setSpacing(12);
    page->addLayout(make_head());
    page->addLayout(make_tiles());
    page->addSpacing(gap);
    page->addLayout(make_head_of_recent());
    page->addLayout(recent_ = grid());
    page->addSpacing(gap);
    add_examples(*page);
    page->addStretch(1);
    set_recent_files({});
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    auto* centred = new QWidget;
    centred->setAutoFillBackground(true);
    centred->setBackgroundRole(QPalette::Base);
    auto* middle = new QHBoxLayout(centred);
    middle->setContentsMargins(0, 0, 0, 0);
    middle->addWidget(inner, 1);
    scroll->setWidget(centred);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll);
    setFocusProxy(tiles_.front());
}

QHBoxLayout* StartPage::make_head() {
    auto* row = new QHBoxLayout;
    row->addWidget(heading(tr("What do you want to know?"), TextSize::answer), 1);
    const auto add = [&](const char* picture, const QString& text, void (StartPage::*wanted)()) {
        auto* button = new QPushButton(icon(QLatin1String(picture)), text);
        connect(button, &QPushButton::clicked, this, wanted);
        row->addWidget(button);
        return button;
    };
    add("new", tr("New Project"), &StartPage::new_wanted);
    add("open", tr("Open …"), &StartPage::open_wanted);
    add("layers", tr("Library …"), &StartPage::library_wanted);
    QPushButton* steps = add("help", tr("First Steps"), &StartPage::first_steps_wanted);
    steps->setObjectName(QStringLiteral("first_steps"));
    steps->setToolTip(tr("A budget from nothing to a PDF, in ten steps beside the window"));
    return row;
}

QHBoxLayout* StartPage::make_head_of_recent() {
    all_recent_ = new QToolButton;
    all_recent_->setAutoRaise(true);
    all_recent_->setPopupMode(QToolButton::InstantPopup);
    all_recent_->setMenu(new QMenu(all_recent_));
    auto* row = new QHBoxLayout;
    row->addWidget(heading(tr("Recent")), 1);
    row->addWidget(all_recent_);
    return row;
}

QHBoxLayout* StartPage::make_tiles() {
    using Topic = AnalysisTemplate::Topic;
    using Drawing = QuestionTile::Drawing;
    auto* row = new QHBoxLayout;
    row->setSpacing(gap);
    add_tile(*row, new QuestionTile(Drawing::equation, tr("A quantity by an equation"),
                                    tr("Type y = f(x), state each input, get the budget."),
                                    menu_of(Topic::equation)));
    add_tile(*row,
             new QuestionTile(Drawing::points, tr("Points by instruments"),
                              tr("Tracker, total station, camera; one or many."), menu_of(Topic::points)));
    add_tile(*row,
             new QuestionTile(Drawing::pose, tr("The pose of an object"),
                              tr("A frame from its points, in the frame of another."), menu_of(Topic::pose)));
    add_tile(*row,
             new QuestionTile(Drawing::robot, tr("A robot"),
                              tr("Where its tool is, and what its parameters are."), menu_of(Topic::robot)));
    add_tile(*row, new QuestionTile(Drawing::file, tr("A file I have"),
                                    tr("Excel budget, points, measurement report."), menu_of_files()));
    return row;
}

void StartPage::add_tile(QHBoxLayout& row, QuestionTile* tile) {
    tiles_ << tile;
    row.addWidget(tile, 1);
}

/// The first of them is the usual one: a click, and Return.
QMenu* StartPage::menu_of(AnalysisTemplate::Topic topic) {
    auto* menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    for (const AnalysisTemplate& known : analysis_templates()) {
        if (known.topic != topic) continue;
        menu->addAction(core_text(known.title), this, [this, &known] { emit template_wanted(known); })
            ->setToolTip(core_text(known.question));
    }
    return menu;
}

QMenu* StartPage::menu_of_files() {
    auto* menu = new QMenu(this);
    menu->addAction(tr("Budget, Points or Report …"), this, &StartPage::import_wanted);
    menu->addAction(tr("Robot (URDF) …"), this, &StartPage::urdf_wanted);
    menu->addAction(tr("Project …"), this, &StartPage::open_wanted);
    return menu;
}

/// Three where their longest names stand beside each other, else two.
int StartPage::columns_of(const QList<QWidget*>& buttons) {
    constexpr int most = 3;
    std::array<int, most> widest{};
    for (int at = 0; at < buttons.size(); ++at)
        widest[std::size_t(at % most)] =
            std::max(widest[std::size_t(at % most)], buttons[at]->sizeHint().width());
    const int needed = widest[0] + widest[1] + widest[2] + (most - 1) * gap;
    return needed <= widest_page - 2 * page_margin ? most : most - 1;
}

/// Adds the examples as plain lines; the library shows them with their pictures.
void StartPage::add_examples(QVBoxLayout& column) {
    auto* head = new QHBoxLayout;
    head->addWidget(heading(tr("Examples")));
    head->addWidget(quiet(tr("They open as new projects; the shipped files stay as they are.")), 1);
    column.addLayout(head);
    QGridLayout* lines = grid();
    QList<QWidget*> buttons;
    for (const char* folder : {"", "gum"})
        for (const Example& example : shipped_examples(folder)) {
            auto* button = new QToolButton;
            button->setText(core_text(example.title));
            button->setToolTip(button->text() + QStringLiteral("\n\n") + core_text(example.summary));
            button->setAutoRaise(true);
            button->setCursor(Qt::PointingHandCursor);
            button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
            connect(button, &QToolButton::clicked, this,
                    [this, file = from_path(example.file)] { emit example_wanted(file); });
            buttons << button;
        }
    const int columns = columns_of(buttons);
    for (int at = 0; at < buttons.size(); ++at)
        lines->addWidget(buttons[at], at / columns, at % columns, Qt::AlignLeft);
    column.addLayout(lines);
}

/// Shows one row of cards; all files are in the list at the right of the heading.
void StartPage::set_recent_files(const QStringList& files) {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const int shown = std::min(in_a_row, int(files.size()));
    for (int i = 0; i < shown; ++i) {
        auto* card = new RecentCard(files[i]);
        connect(card, &RecentCard::clicked, this, [this, file = files[i]] { emit file_wanted(file); });
        recent_->addWidget(card, 0, i);
    }
    if (files.isEmpty())
        recent_->addWidget(quiet(tr("Projects that you open are listed here.")), 0, 0, 1, in_a_row);
    all_recent_->setVisible(files.size() > shown);
    all_recent_->setText(tr("Show All %1").arg(files.size()));
    QMenu* menu = all_recent_->menu();
    menu->clear();
    for (const QString& file : files)
        menu->addAction(QDir::toNativeSeparators(file), this, [this, file] { emit file_wanted(file); });
}

/// 1 to 5 open the tiles, the arrow keys go from one to the next.
void StartPage::keyPressEvent(QKeyEvent* event) {
    const int number = event->key() - Qt::Key_1;
    const auto now = std::ranges::find_if(tiles_, [](const QuestionTile* tile) { return tile->hasFocus(); });
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (number >= 0 && number < tiles_.size())
        tiles_[number]->click();
    else if (step != 0 && now != tiles_.end())
        tiles_[(now - tiles_.begin() + step + tiles_.size()) % tiles_.size()]->setFocus(Qt::TabFocusReason);
    else
        QWidget::keyPressEvent(event);
}

}  // namespace covaria::ui
