#include "ui/pages/recent_card.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <string_view>

#include "ui/pages/example_card.h"
#include "ui/theme/fonts.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr int height_of_picture = 156, below_picture = 8;  // px
constexpr QSize kept_picture(544, 312);
constexpr std::array<std::string_view, 3> kinds{"met", "not met", "neutral"};

/// One file for each project: the facts are texts of the picture.
QString file_of_facts(const QString& project) {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent");
    const QByteArray name =
        QCryptographicHash::hash(QFileInfo(project).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
    return folder + QLatin1Char('/') + QString::fromLatin1(name.toHex()) + QStringLiteral(".png");
}

}  // namespace

RecentFacts recent_facts(const QString& file) {
    RecentFacts facts;
    const QString kept = file_of_facts(file);
    if (!QFileInfo::exists(kept) || !facts.picture.load(kept)) return facts;
    facts.title = facts.picture.text(QStringLiteral("title"));
    facts.answer = facts.picture.text(QStringLiteral("answer"));
    facts.verdict = facts.picture.text(QStringLiteral("verdict"));
    const std::string said = to_std(facts.picture.text(QStringLiteral("kind")));
    const auto kind = std::ranges::find(kinds, std::string_view(said));
    if (kind != kinds.end()) facts.kind = static_cast<Chip::Kind>(kind - kinds.begin());
    facts.seen = QFileInfo(file).lastModified();
    return facts;
}

void keep_recent_facts(const QString& file, const RecentFacts& facts) {
    if (facts.picture.isNull()) return;
    QImage kept =
        facts.picture.scaled(kept_picture, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    kept = kept.copy(
        QRect(QPoint((kept.width() - kept_picture.width()) / 2, (kept.height() - kept_picture.height()) / 2),
              kept_picture));
    kept.setText(QStringLiteral("title"), facts.title);
    kept.setText(QStringLiteral("answer"), facts.answer);
    kept.setText(QStringLiteral("verdict"), facts.verdict);
    kept.setText(QStringLiteral("kind"),
                 QString::fromLatin1(kinds[static_cast<std::size_t>(facts.kind)].data()));
    const QString to = file_of_facts(file);
    if (QDir().mkpath(QFileInfo(to).path())) kept.save(to);
}

QImage picture_of_shares(const std::vector<double>& shares) {
    constexpr std::size_t most = 5;
    constexpr double left = 0.2, widest = 0.66, step = 0.12, thick = 0.078, first = 0.2;
    QImage picture(kept_picture, QImage::Format_RGB32);
    const Tokens& t = Theme::light().tokens();
    picture.fill(t.panel);
    QPainter painter(&picture);
    const double w = kept_picture.width(), h = kept_picture.height();
    const double largest = shares.empty() ? 0.0 : shares.front();
    for (std::size_t i = 0; i < std::min(most, shares.size()) && largest > 0.0; ++i) {
        const double y = (first + step * static_cast<double>(i)) * h;
        painter.fillRect(QRectF(0.08 * w, y, 0.09 * w, thick * h), t.line2);
        painter.fillRect(QRectF(left * w, y, widest * w * shares[i] / largest, thick * h), t.orange);
    }
    return picture;
}

RecentCard::RecentCard(const QString& file, QWidget* parent)
    : QAbstractButton(parent), facts_(recent_facts(file)), verdict_(new Chip(this)) {
    folder_ = QDir::toNativeSeparators(QFileInfo(file).path());
    if (folder_.startsWith(QDir::homePath())) folder_.replace(0, QDir::homePath().size(), QLatin1Char('~'));
    setText(facts_.title.isEmpty() ? QFileInfo(file).completeBaseName() : facts_.title);
    setToolTip(QDir::toNativeSeparators(file));
    setAccessibleName(text());
    setAccessibleDescription(facts_.answer.isEmpty() ? folder_
                                                     : facts_.answer + QLatin1Char(' ') + facts_.verdict);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    verdict_->setAttribute(Qt::WA_TransparentForMouseEvents);
    verdict_->show_words(facts_.kind, Text(to_std(facts_.verdict)));
}

QSize RecentCard::sizeHint() const {
    return {200, height_of_picture + below_picture + 2 * fontMetrics().lineSpacing() + 12};
}

void RecentCard::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens_of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame(0.5, 0.5, width() - 1.0, height_of_picture - 1.0);
    QPainterPath shape;
    shape.addRoundedRect(frame, 6.0, 6.0);
    painter.save();
    painter.setClipPath(shape);
    painter.fillRect(frame, t.panel);
    if (!facts_.picture.isNull())
        paint_card_picture(painter, frame, QPixmap::fromImage(facts_.picture), palette());
    painter.restore();
    const bool marked = hasFocus() || underMouse();
    painter.setPen(QPen(marked ? t.blue : t.line2, hasFocus() ? 2.0 : 1.0));
    painter.drawPath(shape);
    paint_words(painter, QRect(0, height_of_picture + below_picture, width(),
                               height() - height_of_picture - below_picture));
}

QString RecentCard::day() const {
    return facts_.seen.isValid() ? QLocale().toString(facts_.seen.date(), QLocale::ShortFormat) : QString();
}

void RecentCard::paint_words(QPainter& painter, const QRect& area) const {
    const Tokens& t = tokens_of(palette());
    const int line = fontMetrics().lineSpacing();
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    const QSize chip = facts_.verdict.isEmpty() ? QSize(0, 0) : verdict_->sizeHint();
    verdict_->setGeometry(QRect(QPoint(width() - chip.width(), area.top() - 2), chip));
    painter.setFont(bold);
    painter.setPen(t.ink);
    const int room = area.width() - chip.width() - 8;
    painter.drawText(QRect(area.left(), area.top(), room, line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, room));
    const QFont small = sized(font(), TextSize::small);
    const int for_day = QFontMetrics(small).horizontalAdvance(day());
    const QRect second(area.left(), area.top() + line + 4, area.width(), line);
    painter.setFont(small);
    painter.setPen(t.ink3);
    painter.drawText(second, Qt::AlignRight | Qt::AlignVCenter, day());
    painter.setFont(font());
    painter.setPen(t.ink2);
    const QString said = facts_.answer.isEmpty() ? folder_ : facts_.answer;
    painter.drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(said, Qt::ElideRight, area.width() - for_day - 8));
}

}  // namespace covaria::ui
