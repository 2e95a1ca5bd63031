// The measuring tool of the scene: places are picked one after the other, the last makes the measurement.
#pragma once

#include <QObject>
#include <functional>
#include <string>
#include <vector>

#include "ui/run/run_backend.h"
#include "ui/scene_view/measure_words.h"

class QAction;
class QToolBar;

namespace covaria::ui {

class SceneView;

/// A measurement follows its places: with new results its value and u change. Picking once more begins anew;
/// Escape, or its button again, puts the tool away.
class MeasureTool : public QObject {
    Q_OBJECT
public:
    MeasureTool(SceneView& view, QObject* parent);

    void add_to(QToolBar& toolbar);
    bool is_active() const { return wanted_ > 0; }
    /// Picks a place; what is no item of the scene is ignored.
    void add_place(const QString& item_id);
    /// The result that the view's scene shows; null: none.
    void set_result(const ResultPointer& result);
    void put_away();
    /// Words of the measurement, else which place to pick next; empty while the tool is not in use.
    QString words() const;

    std::function<MeasureStyle()> style = [] { return MeasureStyle{}; };
    /// Writes the measurement anew: in other units, or after a change of the scene.
    void update();

signals:
    void changed();

private:
    QAction* make_action(const char* picture, const QString& text, const QString& tip, std::size_t places);
    std::optional<Measurement> measurement() const;

    SceneView& view_;
    QAction* distance_;
    QAction* angle_;
    std::size_t wanted_ = 0;  ///< places that a measurement needs; 0: the tool is not in use
    std::vector<std::string> ids_;
    ResultPointer result_;
};

}  // namespace covaria::ui
