// The line above the picture while there is a section: where its plane is, to be slid and typed.
#pragma once

#include <QWidget>

#include "core/base/unit.h"
#include "viz/scene/section.h"

class QAction;
class QLabel;
class QLineEdit;
class QSlider;

namespace covaria::ui {

class SectionBar : public QWidget {
    Q_OBJECT
public:
    /// Buttons of the actions stand at its end.
    SectionBar(const QList<QAction*>& actions, QWidget* parent);

    /// Shows where the plane is, in the unit of the scene.
    void show_section(const SectionPlane& section, const Scene& scene);

signals:
    void moved(double at);  ///< m
    void left();            ///< Escape

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take_typed();
    void write_position();

    QLabel* across_;
    QSlider* slider_;
    QLineEdit* typed_;
    double at_ = 0.0;
    SectionSteps steps_;
    Unit unit_;
};

}  // namespace covaria::ui
