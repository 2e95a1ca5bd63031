// A recent project on the start page: picture, name, answer and verdict as they were when it was last open.
#pragma once

#include <QAbstractButton>
#include <QDateTime>
#include <QImage>
#include <vector>

#include "ui/theme/chip.h"

namespace covaria::ui {

/// Facts on a project for its card, kept beside its file in the cache folder, which may be deleted.
struct RecentFacts {
    QImage picture;  ///< its scene, or its budget; null: nothing is remembered
    QString title, answer, verdict;
    Chip::Kind kind = Chip::Kind::neutral;
    QDateTime seen = {};
};

RecentFacts recent_facts(const QString& file);
void keep_recent_facts(const QString& file, const RecentFacts& facts);
/// Bars of the largest contributions, for a budget without a scene.
QImage picture_of_shares(const std::vector<double>& shares);

class RecentCard : public QAbstractButton {
    Q_OBJECT
public:
    explicit RecentCard(const QString& file, QWidget* parent = nullptr);
    const RecentFacts& facts() const { return facts_; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paint_words(QPainter& painter, const QRect& area) const;
    QString day() const;

    RecentFacts facts_;
    QString folder_;
    Chip* verdict_;
};

}  // namespace covaria::ui
