// The 3D pane of the window: the scene of the analysis being looked at, and what to show of it.
#pragma once

#include <QWidget>
#include <atomic>
#include <map>
#include <memory>
#include <vector>

#include "ui/document/setup_address.h"
#include "ui/jobs/job_queue.h"
#include "ui/run/analysis_runner.h"
#include "ui/scene_view/equations_view.h"
#include "ui/scene_view/measure_tool.h"
#include "ui/scene_view/scene_view.h"
#include "ui/scene_view/section_tool.h"
#include "viz/scene/build_scene.h"
#include "viz/scene/design_scene.h"
#include "viz/scene/study_scene.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QSplitter;
class QToolBar;

namespace covaria::ui {

/// Scenes are built in a worker thread from the runner's immutable snapshots; the latest wins.
class ScenePanel : public QWidget {
    Q_OBJECT
public:
    explicit ScenePanel(AnalysisRunner& runner, QWidget* parent = nullptr);

    /// Shows the scene of this analysis; empty = none.
    void show_analysis(const QString& id);
    const QString& analysis() const { return analysis_; }
    /// Shows this asset by itself as long as no analysis is shown.
    void show_asset(const std::string& id);
    void show_group(const QString& group);
    QString group() const;
    void set_dark(bool dark);
    /// Sets the units in which lengths are written.
    void set_units(const DisplayUnits& units);
    /// Begins anew with another project: nothing of what was looked at stays.
    void start_over();
    /// Shows the map of a study in place of the analysis' result; null: the result again.
    void show_study(std::shared_ptr<const StudyResult> study, const StudySceneOptions& wanted);
    /// Shows the findings of a design in the same way; `remark` is written below the picture.
    void show_design(std::shared_ptr<const DesignResult> design, const QString& remark);

    /// Marks the item that comes from a field (JSON pointer relative to the set-up) of an asset (empty: of
    /// the analysis), or none.
    void select_source(const std::string& asset, const std::string& path);

    /// The entry in whose set-up the shown layout is written.
    SetupAddress address_in(const std::string& asset) const;

    /// Adds a button with these views to the tool bar.
    void offer_views(QMenu& menu);
    /// Puts a page below the equations, and its buttons beside them; it hides without content.
    void put_below_equations(QWidget* page, QWidget& tools);

    SceneView& view() { return *view_; }
    MeasureTool& measuring() { return *measuring_; }
    SectionTool& section() { return *section_; }
    bool is_building() const { return refresh_due_ || building_ > 0; }

signals:
    void group_changed(const QString& group);
    /// The user picked an item: where its position is written (empty: nowhere), relative to the set-up of an
    /// asset (empty: of the analysis).
    void source_picked(const QString& asset, const QString& path);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void make_toolbar();
    void take_context();
    void refresh();
    void build_scene();
    void show_asset_alone();
    void show_scene(std::shared_ptr<const Scene> scene);
    std::function<Result<Scene>()> scene_to_build(const AnalysisStatus& status) const;
    void give_equations_room();
    void show_in_space(bool in_space);
    void refresh_groups();
    /// The result whose points the scene shows; null: it shows none, or a map.
    ResultPointer shown_result(const AnalysisStatus& status) const;
    void take_scene(quint64 number, const std::shared_ptr<Result<Scene>>& scene, const ResultPointer& result);
    void show_item(const QString& id);
    bool show_source();
    bool is_selected_source(const SceneItem& item) const;
    void show_trial(std::uint64_t trial);
    void say(const QString& words, const QString& shorter = {});
    void place_words();
    void say_nothing();
    void describe_item(const QString& id);
    void show_words();
    void take_pick(const QString& id);
    SceneOptions options() const;

    AnalysisRunner& runner_;
    QString analysis_;
    std::string asset_;     ///< id of the one selected last
    QString equations_of_;  ///< the analysis whose equations are shown
    std::shared_ptr<const StudyResult> study_;
    StudySceneOptions study_options_;
    std::vector<LayoutMesh> context_;  ///< meshes of the project beside those of the analysis
    std::shared_ptr<const DesignResult> design_;
    QString design_remark_;
    DisplayUnits units_;
    std::optional<double> drawn_magnification_;  ///< scale of the last scene that drew uncertainty
    std::string source_asset_, source_;          ///< the selected set-up field
    std::map<std::string, std::string> groups_;  ///< in which each source is shown
    QToolBar* toolbar_ = nullptr;
    QAction* iso_ = nullptr;
    QAction* before_fit_ = nullptr;  ///< in the tool bar, behind the views
    QComboBox* group_ = nullptr;
    QComboBox* magnification_ = nullptr;
    QComboBox* probability_ = nullptr;
    SceneView* view_ = nullptr;
    EquationsView* equations_ = nullptr;
    QSplitter* flat_ = nullptr;  ///< the equations and what is below them
    QWidget* below_ = nullptr;
    MeasureTool* measuring_ = nullptr;
    SectionTool* section_ = nullptr;
    QWidget* line_ = nullptr;  ///< below the picture, for what is said of it
    QLabel* picked_ = nullptr;
    std::atomic<quint64> number_ = 0;
    quint64 shown_number_ = 0;
    int building_ = 0;
    bool refresh_due_ = false;
    JobQueue jobs_;  ///< last member: its thread ends first
};

}  // namespace covaria::ui
