// One of the five questions of the start page: a drawing, what is asked, and what it takes.
#pragma once

#include <QAbstractButton>

class QMenu;

namespace covaria::ui {

class QuestionTile : public QAbstractButton {
    Q_OBJECT
public:
    enum class Drawing { equation, points, pose, robot, file };
    /// `menu`: what the question can begin with; opened by a click, Return or Space.
    QuestionTile(Drawing drawing, const QString& title, const QString& words, QMenu* menu,
                 QWidget* parent = nullptr);
    QMenu& menu() { return *menu_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QFont title_font() const;

    Drawing drawing_;
    QString words_;
    QMenu* menu_;
};

}  // namespace covaria::ui
