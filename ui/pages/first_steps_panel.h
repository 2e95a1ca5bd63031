// One of the first steps at a time: title, two sentences, whether it was done, and where to go.
#pragma once

#include <QWidget>
#include <array>

#include "ui/pages/first_steps.h"

class QLabel;
class QPushButton;

namespace covaria::ui {

class FirstStepsPanel : public QWidget {
    Q_OBJECT
public:
    explicit FirstStepsPanel(QWidget* parent = nullptr);

    int step() const { return step_; }
    void go_to(int step);
    void set_done(int step, bool done);
    bool is_done(int step) const { return done_[std::size_t(step)]; }
    /// Writes under the text why something cannot be shown yet.
    void set_remark(const QString& words);

signals:
    void step_changed(int step);
    void show_wanted(int step);
    void close_wanted();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    /// Texts are broken into lines: how high the panel must be depends on how wide it is.
    void take_height();

    int step_ = 0;
    std::array<bool, 10> done_{};
    QLabel* progress_;
    QLabel* tick_;
    QLabel* state_;
    QLabel* title_;
    QLabel* text_;
    QLabel* remark_;
    QPushButton* show_;
    QPushButton* back_;
    QPushButton* next_;
};

}  // namespace covaria::ui
