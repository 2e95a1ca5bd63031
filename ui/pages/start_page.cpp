#include "ui/pages/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/made/examples.h"
#include "ui/pages/example_card.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int gap = 20;
constexpr int widest_page = 1500;

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.25);
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    return label;
}

QLabel* quiet(const QString& text) {
    auto* label = new QLabel(text);
    label->setEnabled(false);
    return label;
}

/// A recent file: its name, and under it the folder.
class RecentButton : public QToolButton {
public:
    explicit RecentButton(const QString& file) : folder_(QDir::toNativeSeparators(QFileInfo(file).path())) {
        if (folder_.startsWith(QDir::homePath()))
            folder_.replace(0, QDir::homePath().size(), QLatin1Char('~'));
        setText(QFileInfo(file).completeBaseName());
        setToolTip(QDir::toNativeSeparators(file));
        setAccessibleName(text());
        setAccessibleDescription(folder_);
        setAutoRaise(true);
        setCursor(Qt::PointingHandCursor);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override { return {200, 2 * fontMetrics().lineSpacing() + 8}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QStylePainter painter(this);
        QStyleOptionToolButton option;
        initStyleOption(&option);
        option.text.clear();
        painter.drawComplexControl(QStyle::CC_ToolButton, option);
        const QRect area = rect().adjusted(6, 4, -6, -4);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(area, Qt::AlignLeft | Qt::AlignTop,
                         fontMetrics().elidedText(text(), Qt::ElideRight, area.width()));
        painter.setPen(mix(palette().color(QPalette::Window), palette().color(QPalette::Text), 0.6));
        painter.drawText(area, Qt::AlignLeft | Qt::AlignBottom,
                         fontMetrics().elidedText(folder_, Qt::ElideMiddle, area.width()));
    }

private:
    QString folder_;
};

QPushButton* action_button(const QString& picture, const QString& text) {
    auto* button = new QPushButton(icon(picture), text);
    button->setMinimumHeight(34);
    return button;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Start page"));
    auto* inner = new QWidget;
    inner->setMaximumWidth(widest_page);
    auto* row = new QHBoxLayout(inner);
    row->setContentsMargins(48, 40, 48, 40);
    row->setSpacing(56);
    row->addWidget(make_actions(), 0, Qt::AlignTop);
    row->addWidget(make_examples(), 1, Qt::AlignTop);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    auto* centred = new QWidget;
    auto* middle = new QHBoxLayout(centred);
    middle->setContentsMargins(0, 0, 0, 0);
    middle->addWidget(inner, 0, Qt::AlignTop);
    scroll->setWidget(centred);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll);
}

QWidget* StartPage::make_actions() {
    auto* box = new QWidget;
    box->setFixedWidth(260);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    auto* name = heading(tr("Covaria"));
    QFont font = name->font();
    font.setPointSizeF(font.pointSizeF() * 1.5);
    name->setFont(font);
    column->addWidget(name);
    column->addWidget(new QLabel(tr("Measurement uncertainty of robots\nand large-scale metrology")));
    column->addSpacing(20);
    auto* new_project = action_button(QStringLiteral("new"), tr("New Project"));
    auto* open = action_button(QStringLiteral("open"), tr("Open …"));
    connect(new_project, &QPushButton::clicked, this, &StartPage::new_wanted);
    connect(open, &QPushButton::clicked, this, &StartPage::open_wanted);
    column->addWidget(new_project);
    column->addWidget(open);
    auto* library = action_button(QStringLiteral("layers"), tr("Library and Examples …"));
    connect(library, &QPushButton::clicked, this, &StartPage::library_wanted);
    column->addWidget(library);
    auto* steps = action_button(QStringLiteral("help"), tr("First Steps"));
    steps->setObjectName(QStringLiteral("first_steps"));
    steps->setToolTip(tr("A budget from nothing to a PDF, in ten steps beside the window"));
    connect(steps, &QPushButton::clicked, this, &StartPage::first_steps_wanted);
    column->addWidget(steps);
    column->addSpacing(20);
    column->addWidget(heading(tr("Recent")));
    recent_ = new QVBoxLayout;
    recent_->setSpacing(0);
    column->addLayout(recent_);
    set_recent_files({});
    return box;
}

QWidget* StartPage::make_examples() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(heading(tr("Examples")));
    column->addWidget(quiet(tr("They open as new projects; the shipped files stay as they are.")));
    column->addSpacing(8);
    examples_ = new QGridLayout;
    examples_->setSpacing(gap);
    for (const Example& example : shipped_examples()) {
        auto* card =
            new ExampleCard(core_text(example.title), core_text(example.summary), from_path(example.picture));
        connect(card, &ExampleCard::clicked, this,
                [this, file = from_path(example.file)] { emit example_wanted(file); });
        cards_ << card;
    }
    column->addLayout(examples_);
    place_cards(3);
    column->addSpacing(20);
    add_worked_examples(*column);
    return box;
}

/// The standards' own examples, as plain lines.
void StartPage::add_worked_examples(QVBoxLayout& column) {
    const std::vector<Example> examples = shipped_examples("gum");
    if (examples.empty()) return;
    column.addWidget(heading(tr("Worked examples of the GUM and its supplements")));
    auto* lines = new QGridLayout;
    lines->setHorizontalSpacing(gap);
    lines->setVerticalSpacing(0);
    const int rows = (int(examples.size()) + 1) / 2;
    for (int i = 0; i < int(examples.size()); ++i) {
        const Example& example = examples[std::size_t(i)];
        auto* button = new QToolButton;
        button->setText(core_text(example.title));
        button->setToolTip(core_text(example.summary));
        button->setAutoRaise(true);
        button->setCursor(Qt::PointingHandCursor);
        connect(button, &QToolButton::clicked, this,
                [this, file = from_path(example.file)] { emit example_wanted(file); });
        lines->addWidget(button, i % rows, i / rows, Qt::AlignLeft);
    }
    lines->setColumnStretch(2, 1);
    column.addLayout(lines);
}

void StartPage::place_cards(int in_a_row) {
    if (in_a_row == in_a_row_) return;
    in_a_row_ = in_a_row;
    for (qsizetype i = 0; i < cards_.size(); ++i)
        examples_->addWidget(cards_[i], int(i) / in_a_row, int(i) % in_a_row, Qt::AlignLeft | Qt::AlignTop);
    for (int column = 0; column <= cards_.size(); ++column)
        examples_->setColumnStretch(column, column == in_a_row ? 1 : 0);
}

void StartPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (cards_.isEmpty()) return;
    const int room = std::min(width(), widest_page) - 2 * 48 - 260 - 56;
    place_cards(std::max(1, (room + gap) / (cards_.front()->sizeHint().width() + gap)));
}

void StartPage::set_recent_files(const QStringList& files) {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const QString& file : files) {
        auto* button = new RecentButton(file);
        connect(button, &QToolButton::clicked, this, [this, file] { emit file_wanted(file); });
        recent_->addWidget(button);
    }
    if (files.isEmpty()) {
        QLabel* hint = quiet(tr("Projects that you open are listed here."));
        hint->setWordWrap(true);
        recent_->addWidget(hint);
    }
}

}  // namespace covaria::ui
