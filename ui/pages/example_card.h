// An example on the start page: its picture, title and what it is about, as one button.
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace covaria::ui {

class ExampleCard : public QAbstractButton {
    Q_OBJECT
public:
    /// `picture`: a file; where there is none, a quiet drawing in the window's colours stands in.
    ExampleCard(const QString& title, const QString& summary, const QString& picture,
                QWidget* parent = nullptr);
    QSize sizeHint() const override;
    bool has_picture() const { return !picture_.isNull(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paint_words(QPainter& painter, const QRect& area) const;

    QString summary_;
    QPixmap picture_;
};

/// A shipped picture, which is light: its middle fills the area; in a dark window it is dimmed.
void paint_card_picture(QPainter& painter, const QRectF& area, const QPixmap& picture,
                        const QPalette& palette);

}  // namespace covaria::ui
