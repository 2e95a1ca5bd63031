#include "ui/pages/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/resource_path.h"
#include "core/project/project_file.h"
#include "ui/document/strings.h"

namespace covaria::ui {
namespace {

constexpr QSize thumbnail_size(320, 200);
constexpr int examples_in_a_row = 3;

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.25);
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    return label;
}

QString first_sentence(const QString& text) {
    const qsizetype end = text.indexOf(QStringLiteral(". "));
    return end < 0 ? text : text.left(end + 1);
}

QPushButton* link_button(const QString& text, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setToolTip(tip);
    button->setFlat(true);
    button->setStyleSheet(QStringLiteral("text-align: left; padding: 3px 6px;"));
    return button;
}

}  // namespace

std::vector<Example> shipped_examples() {
    std::vector<Example> examples;
    const QDir folder(from_path(data_directory() / "projects"));
    for (const QFileInfo& info :
         folder.entryInfoList({QStringLiteral("*.covaria")}, QDir::Files, QDir::Name)) {
        const LoadedProject loaded = load_project(to_path(info.absoluteFilePath()));
        if (loaded.problems.has_errors()) continue;
        examples.push_back({info.absoluteFilePath(), to_qt(loaded.project.title),
                            first_sentence(to_qt(loaded.project.notes)),
                            folder.filePath(info.completeBaseName() + QStringLiteral(".png"))});
    }
    return examples;
}

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    auto* inner = new QWidget;
    auto* row = new QHBoxLayout(inner);
    row->setContentsMargins(48, 40, 48, 40);
    row->setSpacing(48);
    row->addWidget(make_actions(), 0, Qt::AlignTop);
    row->addWidget(make_examples(), 1, Qt::AlignTop);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(inner);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(scroll);
}

QWidget* StartPage::make_actions() {
    auto* box = new QWidget;
    box->setMinimumWidth(240);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    auto* name = heading(tr("Covaria"));
    QFont font = name->font();
    font.setPointSizeF(font.pointSizeF() * 1.5);
    name->setFont(font);
    column->addWidget(name);
    column->addWidget(new QLabel(tr("Measurement uncertainty of robots\nand large-scale metrology")));
    column->addSpacing(20);
    auto* new_project = new QPushButton(tr("New Project"));
    auto* open = new QPushButton(tr("Open …"));
    connect(new_project, &QPushButton::clicked, this, &StartPage::new_wanted);
    connect(open, &QPushButton::clicked, this, &StartPage::open_wanted);
    column->addWidget(new_project);
    column->addWidget(open);
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
    auto* grid = new QGridLayout;
    grid->setSpacing(16);
    int index = 0;
    for (const Example& example : shipped_examples()) {
        auto* button = new QToolButton;
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setIcon(QIcon(example.picture));
        button->setIconSize(thumbnail_size);
        button->setText(fontMetrics().elidedText(example.title, Qt::ElideRight, thumbnail_size.width()));
        button->setToolTip(example.title + QStringLiteral("\n\n") + example.summary);
        button->setAccessibleName(example.title);
        button->setAutoRaise(true);
        connect(button, &QToolButton::clicked, this,
                [this, file = example.file] { emit example_wanted(file); });
        grid->addWidget(button, index / examples_in_a_row, index % examples_in_a_row);
        ++index;
    }
    grid->setColumnStretch(examples_in_a_row, 1);
    column->addLayout(grid);
    return box;
}

void StartPage::set_recent_files(const QStringList& files) {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const QString& file : files) {
        QPushButton* button = link_button(QFileInfo(file).completeBaseName(), QDir::toNativeSeparators(file));
        connect(button, &QPushButton::clicked, this, [this, file] { emit file_wanted(file); });
        recent_->addWidget(button);
    }
    if (files.isEmpty()) {
        auto* none = new QLabel(tr("Projects that you open are listed here."));
        none->setEnabled(false);
        recent_->addWidget(none);
    }
}

}  // namespace covaria::ui
