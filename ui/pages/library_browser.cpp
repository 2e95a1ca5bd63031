#include "ui/pages/library_browser.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollBar>
#include <QShowEvent>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/made/examples.h"
#include "core/made/library.h"
#include "ui/models/category_icon.h"
#include "ui/pages/example_card.h"
#include "ui/pages/library_menu.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr QSize card_picture(160, 100);
constexpr int entry_role = Qt::UserRole;
constexpr int least_collections_width = 200;

QString icon_of_category(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    return category_icon(kind ? kind->category : AssetCategory::artefact);
}

/// The picture in a frame; an icon in the middle of it where there is none.
QPixmap card_pixmap(const QString& file, const QString& icon_name, const QPalette& palette, double ratio) {
    QPixmap card(card_picture * ratio);
    card.setDevicePixelRatio(ratio);
    card.fill(Qt::transparent);
    QPainter painter(&card);
    painter.setRenderHints(QPainter::SmoothPixmapTransform | QPainter::Antialiasing);
    const QRectF area = QRect(QPoint(), card_picture);
    QPainterPath frame;
    frame.addRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 5.0, 5.0);
    painter.setClipPath(frame);
    painter.fillRect(area, palette.color(QPalette::AlternateBase));
    if (const QPixmap picture(file); !picture.isNull())
        paint_card_picture(painter, area, picture, palette);
    else
        icon(icon_name).paint(&painter, area.toRect().adjusted(54, 24, -54, -24));
    painter.setClipping(false);
    painter.setPen(mix(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.2));
    painter.drawPath(frame);
    return card;
}

/// `has_words` knows the case of ASCII letters only.
std::string without_case(const QString& text) {
    return to_std(text.toCaseFolded());
}

QListWidget* make_collections() {
    auto* list = new QListWidget;
    list->setObjectName(QStringLiteral("library_collections"));
    list->setAccessibleName(LibraryBrowser::tr("Collections"));
    return list;
}

QListWidget* make_cards() {
    auto* list = new QListWidget;
    list->setObjectName(QStringLiteral("library_cards"));
    list->setAccessibleName(LibraryBrowser::tr("Templates, examples and assets"));
    list->setViewMode(QListView::IconMode);
    list->setMovement(QListView::Static);
    list->setResizeMode(QListView::Adjust);
    list->setWordWrap(true);
    list->setIconSize(card_picture);
    list->setSpacing(6);
    list->setGridSize(
        {card_picture.width() + 16, card_picture.height() + 3 * list->fontMetrics().lineSpacing()});
    list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    return list;
}

}  // namespace

LibraryBrowser::LibraryBrowser(QWidget* parent)
    : QDialog(parent),
      search_(new QLineEdit),
      collections_(make_collections()),
      cards_(make_cards()),
      details_(new QTextBrowser),
      take_(new QPushButton) {
    setWindowTitle(tr("Library and Examples"));
    setObjectName(QStringLiteral("library_browser"));
    resize(1120, 680);
    search_->setPlaceholderText(tr("Search: name, kind, source"));
    search_->setAccessibleName(tr("Search in the library"));
    search_->setClearButtonEnabled(true);
    details_->setOpenExternalLinks(true);
    details_->setFrameShape(QFrame::NoFrame);
    details_->setAccessibleName(tr("What is selected"));
    details_->setFixedWidth(280);
    take_->setDefault(true);
    auto* right = new QVBoxLayout;
    right->addWidget(details_, 1);
    right->addWidget(take_);
    auto* row = new QHBoxLayout;
    row->addWidget(collections_);
    row->addWidget(cards_, 1);
    row->addLayout(right);
    auto* column = new QVBoxLayout(this);
    column->addWidget(search_);
    column->addLayout(row, 1);
    connect(search_, &QLineEdit::textChanged, this, &LibraryBrowser::refresh_cards);
    connect(collections_, &QListWidget::currentRowChanged, this, &LibraryBrowser::refresh_cards);
    connect(cards_, &QListWidget::currentRowChanged, this, &LibraryBrowser::refresh_details);
    connect(cards_, &QListWidget::itemDoubleClicked, this, &LibraryBrowser::take);
    connect(take_, &QPushButton::clicked, this, &LibraryBrowser::take);
    fill();
}

QString LibraryBrowser::templates_title() {
    return tr("New analysis");
}

QString LibraryBrowser::examples_title() {
    return tr("Examples");
}

void LibraryBrowser::fill() {
    entries_.clear();
    add_templates();
    add_examples({}, examples_title());
    add_examples("gum", tr("GUM and its supplements"));
    add_assets();
    for (Entry& entry : entries_) {
        // A search looks for the words shown beside the English ones.
        for (const QString& shown : {entry.title, entry.collection, entry.summary})
            entry.texts.push_back(to_std(shown));
        for (std::string& text : entry.texts) text = without_case(to_qt(text));
    }
    const QString shown = collections_->currentItem() ? collections_->currentItem()->text() : QString();
    const QSignalBlocker quiet(collections_);
    collections_->clear();
    collections_->addItem(tr("Everything"));
    for (const Entry& entry : entries_)
        if (collections_->findItems(entry.collection, Qt::MatchExactly).isEmpty())
            collections_->addItem(entry.collection);
    collections_->setFixedWidth(std::max(least_collections_width,
                                         collections_->sizeHintForColumn(0) + 2 * collections_->frameWidth() +
                                             collections_->verticalScrollBar()->sizeHint().width()));
    show_collection(shown);
    refresh_cards();
}

void LibraryBrowser::show_collection(const QString& title) {
    const auto found = collections_->findItems(title, Qt::MatchExactly);
    collections_->setCurrentRow(found.isEmpty() ? 0 : collections_->row(found.front()));
}

/// Opened again it looks for nothing yet.
void LibraryBrowser::showEvent(QShowEvent* event) {
    if (!event->spontaneous()) search_->clear();
    QDialog::showEvent(event);
}

void LibraryBrowser::add_templates() {
    const QString folder = from_path(data_directory() / "projects") + QLatin1Char('/');
    for (const AnalysisTemplate& known : analysis_templates()) {
        Entry entry{core_text(known.title),
                    templates_title(),
                    core_text(known.question),
                    {},
                    folder + to_qt(known.example) + QStringLiteral(".png"),
                    QStringLiteral("analysis")};
        entry.notes =
            tr("It comes with what it needs and has results at once. Assets of the same kind that the "
               "project has already stand in the place of its own.");
        entry.analysis = &known;
        entry.texts = {known.title, known.question};
        entries_.push_back(std::move(entry));
    }
}

void LibraryBrowser::add_examples(const std::string& subfolder, const QString& collection) {
    for (const Example& example : shipped_examples(subfolder)) {
        Entry entry{core_text(example.title),   collection,
                    core_text(example.summary), tr("Opens as a new project."),
                    from_path(example.picture), QStringLiteral("project")};
        entry.example = from_path(example.file);
        entry.texts = {example.title, example.summary, example.file.stem().string()};
        entries_.push_back(std::move(entry));
    }
}

void LibraryBrowser::add_assets() {
    for (const LibraryItem& item : load_library().items) {
        const AssetDescriptor* kind = find_asset_kind(item.asset.kind);
        Entry entry{
            to_qt(item.asset.name),  collection_title(item),  kind ? core_text(kind->title) : QString(),
            to_qt(item.asset.notes), from_path(item.picture), icon_of_category(item.asset)};
        entry.asset = item.asset;
        entry.texts = searched_texts(item);
        entries_.push_back(std::move(entry));
    }
}

void LibraryBrowser::refresh_cards() {
    const QSignalBlocker quiet(cards_);
    cards_->clear();
    const QString collection =
        collections_->currentRow() > 0 ? collections_->currentItem()->text() : QString();
    const std::string wanted = without_case(search_->text());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        if (!collection.isEmpty() && entry.collection != collection) continue;
        if (!has_words(entry.texts, wanted)) continue;
        auto* card =
            new QListWidgetItem(QIcon(card_pixmap(entry.picture, entry.icon, palette(), devicePixelRatioF())),
                                entry.title, cards_);
        card->setData(entry_role, int(i));
        card->setToolTip(entry.title);
        card->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    }
    if (cards_->count() > 0) cards_->setCurrentRow(0);
    refresh_details();
}

const LibraryBrowser::Entry* LibraryBrowser::current() const {
    const QListWidgetItem* card = cards_->currentItem();
    return card ? &entries_[std::size_t(card->data(entry_role).toInt())] : nullptr;
}

void LibraryBrowser::refresh_details() {
    const Entry* entry = current();
    take_->setEnabled(entry != nullptr);
    if (!entry) {
        take_->setText(tr("Add to the Project"));
        details_->setHtml(tr("<p>Nothing here has these words.</p>"));
        return;
    }
    take_->setText(!entry->example.isEmpty() ? tr("Open as a New Project")
                   : entry->analysis         ? tr("Add This Analysis")
                                             : tr("Add to the Project"));
    details_->setHtml(
        QStringLiteral("<h3>%1</h3><p><i>%2</i></p><p>%3</p>")
            .arg(entry->title.toHtmlEscaped(), entry->summary.toHtmlEscaped(), entry->notes.toHtmlEscaped()));
}

void LibraryBrowser::take() {
    const Entry* entry = current();
    if (!entry) return;
    const Entry taken = *entry;  // a copy: a receiver may fill the lists anew
    if (!taken.example.isEmpty()) {
        accept();
        emit example_wanted(taken.example);
    } else if (taken.analysis) {
        accept();
        emit template_wanted(*taken.analysis);
    } else if (taken.asset) {
        emit asset_wanted(*taken.asset);  // several may be wanted
    }
}

}  // namespace covaria::ui
