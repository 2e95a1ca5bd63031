// The tool that cuts the scene at a plane: a button with its menu, a line with the position, keys.
#pragma once

#include <QObject>
#include <map>
#include <optional>

#include "viz/scene/section.h"

class QAction;
class QActionGroup;
class QToolBar;
class QWidget;

namespace covaria::ui {

class SceneView;
class SectionBar;

/// Every analysis keeps its section while the project is open; results that come change nothing of it. In the
/// picture S begins and ends it, Shift+S cuts away the other side, Shift+wheel and Page Up, Page Down move
/// it, Escape ends it.
class SectionTool : public QObject {
    Q_OBJECT
public:
    SectionTool(SceneView& view, QObject* parent);

    void add_to(QToolBar& toolbar);
    /// The line above the picture; it hides without a section.
    QWidget* bar() const;
    /// Takes the section of this thing; what it showed before keeps its own.
    void show_section_of(const QString& thing);
    void start_over();
    /// The view shows another scene, or none.
    void take_scene();
    const std::optional<SectionPlane>& section() const { return section_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction* make_action(const QString& text, const QString& tip);
    /// Cuts across an axis through the middle; one that is there already moves its plane to it.
    void cut_across(int axis);
    void begin();
    void set(const std::optional<SectionPlane>& section, bool moving = false);
    void move_to(double at);
    void move_by(int steps);
    void flip();
    bool take_key(int key, Qt::KeyboardModifiers modifiers);

    SceneView& view_;
    QAction *toggle_, *flip_, *off_;
    QActionGroup* choices_;
    SectionBar* bar_ = nullptr;
    std::optional<SectionPlane> section_;
    QString thing_;
    int turned_ = 0;                            ///< by the wheel, of a notch
    std::map<QString, SectionPlane> sections_;  ///< of things by name
};

}  // namespace covaria::ui
