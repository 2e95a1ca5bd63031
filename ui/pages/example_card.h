// An example on the start page: its picture, title and what it is about, as one button.
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace covaria::ui {

class ExampleCard : public QAbstractButton {
    Q_OBJECT
public:
    /// Without a picture file a quiet drawing in the window's colours stands in.
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

}  // namespace covaria::ui
