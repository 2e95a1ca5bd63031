#include "ui/scene_view/scene_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/name.h"
#include "core/model/has_layout.h"
#include "core/project/stated_requirements.h"
#include "ui/models/number_words.h"
#include "ui/run/result_words.h"
#include "ui/scene_view/layers_button.h"
#include "ui/scene_view/trial_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "viz/scene/analysis_scene.h"
#include "viz/scene/asset_scene.h"
#include "viz/scene/context_meshes.h"
#include "viz/vtk/scene_fonts.h"

namespace covaria::ui {
namespace {

constexpr int usual_probability = 2;  // index in the list: 95 %

/// While a field is wrong the last picture of the analysis stays, faint.
bool keeps_last_picture(SceneView& view, const QString& analysis, const AnalysisStatus& status) {
    constexpr char of_analysis[] = "of_analysis";
    const bool refused = !analysis.isEmpty() && is_refused(status);
    view.setProperty(is_faint, refused);
    view.update();
    if (!refused) view.setProperty(of_analysis, analysis);
    return refused && view.scene() && view.property(of_analysis).toString() == analysis;
}

/// "0.021 0.034 0.012 mm"
QString triple(const Eigen::Vector3d& v, const LengthUnit& unit) {
    const auto number = [&](int i) { return localized(format_significant(v[i] * unit.per_metre, 2)); };
    return QStringLiteral("%1  %2  %3 %4")
        .arg(number(0), number(1), number(2), QString::fromStdString(unit.text));
}

/// Coordinates with digits to match their uncertainties, else to 10 um.
QString coordinates(const Eigen::Vector3d& v, const std::optional<Eigen::Vector3d>& U,
                    const LengthUnit& unit) {
    const int decimals = std::max(0, static_cast<int>(std::lround(std::log10(1e5 / unit.per_metre))));
    const auto number = [&](int i) {
        const double value = v[i] * unit.per_metre;
        return to_qt(grouped_digits(U && (*U)[i] > 0.0 ? format_to_match(value, (*U)[i] * unit.per_metre)
                                                       : format_decimals(value, decimals),
                                    user_numbers()));
    };
    return QStringLiteral("(%1; %2; %3) %4")
        .arg(number(0), number(1), number(2), QString::fromStdString(unit.text));
}

}  // namespace

ScenePanel::ScenePanel(AnalysisRunner& runner, QWidget* parent)
    : QWidget(parent), runner_(runner), jobs_(Execution::threads) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    toolbar_ = new QToolBar(this);
    view_ = new SceneView(this);
    flat_ = new QSplitter(Qt::Vertical, this);
    flat_->setChildrenCollapsible(false);
    equations_ = new EquationsView;
    flat_->addWidget(equations_);
    picked_ = new QLabel(this);
    picked_->setContentsMargins(8, 3, 8, 3);
    picked_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    picked_->setWordWrap(true);
    picked_->setAutoFillBackground(true);
    picked_->hide();
    line_ = new QWidget(this);
    follow_font(*picked_, [this] { line_->setFixedHeight(picked_->fontMetrics().height() + 6); });
    section_ = new SectionTool(*view_, this);
    column->addWidget(toolbar_);
    column->addWidget(section_->bar());
    column->addWidget(view_, 1);
    column->addWidget(line_);
    column->addWidget(flat_, 1);
    flat_->hide();
    measuring_ = new MeasureTool(*view_, this);
    connect(measuring_, &MeasureTool::changed, this, &ScenePanel::show_words);
    make_toolbar();
    view_->set_empty_text(tr("Select an analysis in the project tree to see its layout here."));
    connect(view_, &SceneView::item_picked, this, &ScenePanel::take_pick);
    connect(view_, &SceneView::drag_finished, this, &ScenePanel::refresh);  // nothing is held any more
    const auto refresh_if_shown = [this](const QString& id) {
        if (id == analysis_) refresh();
    };
    connect(&runner_, &AnalysisRunner::result_changed, this, refresh_if_shown);
    connect(&runner_, &AnalysisRunner::state_changed, this, refresh_if_shown);
    connect(&runner_.kept(), &KeptStates::changed, this, refresh_if_shown);
    connect(&runner_, &AnalysisRunner::made_changed, this, &ScenePanel::take_context);
}

void ScenePanel::take_context() {
    if (analysis_.isEmpty()) refresh();  // for the asset
    std::vector<LayoutMesh> context = context_meshes(*runner_.made());
    if (std::ranges::equal(context, context_, &LayoutMesh::looks_like)) return;
    context_ = std::move(context);
    refresh();
}

void ScenePanel::put_below_equations(QWidget* page, QWidget& tools) {
    below_ = page;
    equations_->put_tools(tools);
    flat_->addWidget(page);
    for (const int part : {0, 1}) flat_->setStretchFactor(part, part);
}

void ScenePanel::make_toolbar() {
    toolbar_->setIconSize({18, 18});
    group_ = new QComboBox(this);
    group_->setToolTip(tr("Which pose or group of outputs to show"));
    group_->setAccessibleName(tr("Group"));
    group_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    toolbar_->addWidget(group_);
    iso_ = new QAction(icon(QStringLiteral("view-iso")), tr("Iso"), this);
    connect(iso_, &QAction::triggered, view_, [this] { view_->set_view(StandardView::iso); });
    before_fit_ = toolbar_->addAction(icon(QStringLiteral("fit")), tr("Fit"), view_, &SceneView::fit);
    before_fit_->setToolTip(tr("Everything in the picture (F)"));
    toolbar_->addSeparator();
    measuring_->add_to(*toolbar_);
    toolbar_->addSeparator();
    toolbar_->addWidget(layers_button(*view_, this));
    section_->add_to(*toolbar_);
    magnification_ = new QComboBox(this);
    magnification_->setToolTip(tr("Magnification of the uncertainty; it is always written in the picture"));
    magnification_->setAccessibleName(tr("Magnification of the uncertainty"));
    magnification_->addItem(tr("× auto"));
    for (int factor : {1, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000})
        magnification_->addItem(tr("× %1").arg(factor), factor);
    toolbar_->addWidget(magnification_);
    probability_ = new QComboBox(this);
    probability_->setToolTip(tr("Coverage probability of the ellipsoids"));
    probability_->setAccessibleName(tr("Coverage probability of the ellipsoids"));
    for (double p : {0.6827, 0.90, 0.95, 0.9545, 0.99, 0.9973})
        probability_->addItem(tr("p = %1 %").arg(localized(format_typed(100 * p))), p);
    probability_->setCurrentIndex(usual_probability);
    toolbar_->addWidget(probability_);
    for (QComboBox* combo : {magnification_, probability_})
        connect(combo, &QComboBox::currentIndexChanged, this, &ScenePanel::refresh);
    connect(group_, &QComboBox::currentIndexChanged, this, [this] {
        refresh();
        emit group_changed(group());
    });
}

void ScenePanel::offer_views(QMenu& menu) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(iso_);
    button->setToolTip(
        tr("View from the front right, from above (1); beside it standard and saved views, orthographic or "
           "perspective"));
    button->setAccessibleName(tr("Views"));
    button->setMenu(&menu);
    button->setPopupMode(QToolButton::MenuButtonPopup);
    toolbar_->insertWidget(before_fit_, button);
}

void ScenePanel::show_analysis(const QString& id) {
    if (id == analysis_) return;
    analysis_ = id;
    drawn_magnification_.reset();
    measuring_->put_away();
    view_->set_visibility({});
    section_->show_section_of(id);
    view_->forget_trial();
    say_nothing();
    refresh();
}

void ScenePanel::show_asset(const std::string& id) {
    if (std::exchange(asset_, id) != id && analysis_.isEmpty()) refresh();
}

QString ScenePanel::group() const {
    return group_->currentData().toString();
}

void ScenePanel::show_group(const QString& group) {
    const int index = group_->findData(group);
    if (index >= 0) group_->setCurrentIndex(index);
}

void ScenePanel::start_over() {
    const QSignalBlocker quiet[] = {QSignalBlocker(magnification_), QSignalBlocker(probability_)};
    magnification_->setCurrentIndex(0);
    probability_->setCurrentIndex(usual_probability);
    study_.reset();
    design_.reset();
    source_asset_.clear();
    source_.clear();
    measuring_->put_away();
    say_nothing();
    view_->forget_trial();
    view_->start_over();
    section_->start_over();
    drawn_magnification_.reset();
    refresh();
}

void ScenePanel::set_dark(bool dark) {
    view_->set_palette_kind(dark ? ScenePalette::dark : ScenePalette::light);
}

void ScenePanel::set_units(const DisplayUnits& units) {
    if (std::exchange(units_, units).chosen() != units.chosen()) refresh();
}

void ScenePanel::show_study(std::shared_ptr<const StudyResult> study, const StudySceneOptions& wanted) {
    if (!study && !study_) return;
    study_ = std::move(study);
    study_options_ = wanted;
    refresh();
}

void ScenePanel::show_design(std::shared_ptr<const DesignResult> design, const QString& remark) {
    if (design == design_ && remark == design_remark_) return;
    design_ = std::move(design);
    design_remark_ = remark;
    refresh();
}

SceneOptions ScenePanel::options() const {
    SceneOptions options;
    options.group = to_std(group());
    if (const QVariant factor = magnification_->currentData(); factor.isValid())
        options.magnification = factor.toDouble();
    if (view_->is_dragging()) options.held_magnification = drawn_magnification_;
    options.probability = probability_->currentData().toDouble();
    options.language = scene_language(language_of_window());
    options.context = context_;
    options.units = units_;
    return options;
}

void ScenePanel::refresh_groups() {
    QStringList groups, words;
    if (const auto& prepared = runner_.status(analysis_).prepared)
        for (const Name& group : groups_of(prepared->model->outputs())) {
            groups << to_qt(group);
            words << to_qt(said_name(group));
        }
    QStringList shown;
    for (int i = 0; i < group_->count(); ++i) shown << group_->itemData(i).toString();
    if (groups == shown) return;
    const QSignalBlocker blocker(group_);
    const QString before = group();
    group_->clear();
    for (qsizetype i = 0; i < groups.size(); ++i) group_->addItem(words[i], groups[i]);
    group_->setCurrentIndex(std::max(0, int(groups.indexOf(before))));
    emit group_changed(group());
}

/// Builds the scene when present events are done: a change and its first results come together.
void ScenePanel::refresh() {
    refresh_groups();
    if (std::exchange(refresh_due_, true)) return;
    QMetaObject::invokeMethod(this, &ScenePanel::build_scene, Qt::QueuedConnection);
}

void ScenePanel::build_scene() {
    refresh_due_ = false;
    const AnalysisStatus& status = runner_.status(analysis_);
    if (keeps_last_picture(*view_, analysis_, status)) return;
    if (!status.prepared) {
        const bool of_equations = flat_->isVisibleTo(this) && equations_of_ == analysis_;
        if (of_equations || (below_ && !below_->isHidden())) {
            show_in_space(false);
            equations_->show_equations(unprepared_words(status), {});
            if (!of_equations) give_equations_room();
            return;
        }
        show_in_space(true);
        shown_number_ = ++number_;
        if (analysis_.isEmpty()) return show_asset_alone();
        view_->set_empty_text(unprepared_words(status));
        show_scene(nullptr);
        return;
    }
    const bool in_space = has_layout(*status.prepared->model, status.prepared->inputs);
    show_in_space(in_space);
    if (!in_space) {
        shown_number_ = ++number_;
        show_scene(nullptr);
        std::vector<ModelEquation> equations = status.prepared->model->formulas();
        if (equations.empty()) equations = status.prepared->descriptor->equations;
        equations_->show_equations(to_qt(status.prepared->name), std::move(equations));
        if (std::exchange(equations_of_, analysis_) != analysis_) give_equations_room();
        return;
    }
    ++building_;
    const quint64 number = ++number_;
    jobs_.push(
        [this, number, prepared = status.prepared, result = shown_result(status),
         build = scene_to_build(status)]() -> JobQueue::Delivery {
            if (number != number_) return [this] { --building_; };  // a newer scene is wanted already
            auto scene = std::make_shared<Result<Scene>>(build());
            return [this, number, scene, result, groups = groups_of_sources(*prepared)] {
                groups_ = groups;
                take_scene(number, scene, result);
            };
        },
        [this, number](const Error& error) {
            take_scene(number, std::make_shared<Result<Scene>>(fail(error)), nullptr);
        });
}

void ScenePanel::show_scene(std::shared_ptr<const Scene> scene) {
    view_->show_scene(std::move(scene));
    section_->take_scene();
}

/// The body of the selected asset, while there is no analysis to be shown.
void ScenePanel::show_asset_alone() {
    const AssetLibrary::Entry* entry = runner_.made() ? runner_.made()->assets().find(asset_) : nullptr;
    section_->show_section_of(QLatin1Char('/') + to_qt(asset_));
    auto scene = entry && entry->asset ? asset_scene(*entry->asset, options()) : std::nullopt;
    view_->set_empty_text(tr("Select an analysis in the project tree to see its layout here."));
    show_scene(scene ? std::make_shared<const Scene>(*std::move(scene)) : nullptr);
}

ResultPointer ScenePanel::shown_result(const AnalysisStatus& status) const {
    return !design_ && !study_ && status.is_of_present() ? status.result : nullptr;
}

/// Pictures are copied and saved: each says itself when it does not show the result.
std::function<Result<Scene>()> ScenePanel::scene_to_build(const AnalysisStatus& status) const {
    const auto remarked = [](Scene scene, const std::string& remark) {
        if (!remark.empty()) scene.caption += "; " + remark;
        return scene;
    };
    if (design_)
        return [=, design = design_, wanted = options(), remark = to_std(design_remark_)]() -> Result<Scene> {
            return remarked(design_scene(*design, wanted), remark);
        };
    const auto prepared = status.prepared;
    if (study_)
        return [prepared, study = study_, of_study = study_options_, wanted = options()]() -> Result<Scene> {
            return study_scene(*prepared, *study, of_study, wanted);
        };
    const ResultPointer result = shown_result(status);
    const ResultPointer before = runner_.kept().before(analysis_, result);
    return [=, made = runner_.made(), id = to_std(analysis_), wanted = options(),
            said = to_std(reservation(status))]() -> Result<Scene> {
        std::optional<ResultComparison> compared;
        if (before && result) compared = compare_results(before, result);
        SceneOptions with_verdicts = wanted;
        if (result) with_verdicts.verdicts = judge(*result, made->project(), id);
        auto scene = analysis_scene(*prepared, result.get(), with_verdicts, compared ? &*compared : nullptr);
        if (!scene || !result) return scene;
        return remarked(*std::move(scene), said);
    };
}

/// Gives the equations the height that they need: the rest is the budget's.
void ScenePanel::give_equations_room() {
    const int wanted = std::min(equations_->height_wanted(width()), height() / 2);
    flat_->setSizes({wanted, height() - wanted});
}

/// Shows the scene with its tools; else the equations.
void ScenePanel::show_in_space(bool in_space) {
    toolbar_->setVisible(in_space);
    view_->setVisible(in_space);
    flat_->setVisible(!in_space);
    setFocusProxy(in_space || !below_ ? view_ : below_);
    line_->setVisible(in_space);
    if (!in_space) say_nothing();
}

void ScenePanel::take_scene(quint64 number, const std::shared_ptr<Result<Scene>>& scene,
                            const ResultPointer& result) {
    --building_;
    // While something is dragged there is always a newer one to come; this one is shown until then.
    if (number < shown_number_) return;
    shown_number_ = number;
    if (*scene) {
        if (draws_uncertainty(**scene)) drawn_magnification_ = (*scene)->magnification;
        show_scene(std::make_shared<const Scene>(std::move(**scene)));
        measuring_->set_result(result);
        view_->forget_trial();
        if (!show_source()) describe_item(view_->selected());
        return;
    }
    view_->set_empty_text(to_qt(scene->error().message));
    show_scene(nullptr);
}

void ScenePanel::show_item(const QString& id) {
    if (id != view_->selected()) view_->forget_trial();
    view_->select(id);
    describe_item(id);
}

/// Shows the words of the tool in use, else of the selected item.
void ScenePanel::show_words() {
    const QString words = measuring_->words();
    if (words.isEmpty()) return describe_item(view_->selected());
    say(words);
}

/// Writes in the line below the picture, which keeps its size: the shorter words where there is no room for
/// all; longer ones grow over it.
void ScenePanel::say(const QString& words, const QString& shorter) {
    picked_->setText(words);
    if (!shorter.isEmpty() && picked_->heightForWidth(width()) > line_->height()) picked_->setText(shorter);
    picked_->show();
    place_words();
}

void ScenePanel::place_words() {
    const int height = std::max(line_->height(), picked_->heightForWidth(width()));
    picked_->setGeometry(0, line_->geometry().bottom() + 1 - height, width(), height);
    picked_->raise();
    view_->set_covered(picked_->isHidden() ? 0 : height - line_->height());
}

void ScenePanel::say_nothing() {
    picked_->hide();
    view_->set_covered(0);
}

void ScenePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Queued: until the layout has placed the line.
    QMetaObject::invokeMethod(this, &ScenePanel::place_words, Qt::QueuedConnection);
}

void ScenePanel::describe_item(const QString& id) {
    if (measuring_->is_active()) return;
    const SceneItem* item = view_->scene() ? find_item(*view_->scene(), id.toStdString()) : nullptr;
    picked_->setToolTip({});
    if (!item) return say_nothing();
    const LengthUnit& unit = view_->scene()->unit;
    const QString place = tr("<b>%1</b>  at %2")
                              .arg(to_qt(name_of(*item)).toHtmlEscaped(),
                                   coordinates(item->stated.value_or(item->position), item->U, unit));
    const QString u = item->u ? tr(",  u = %1").arg(triple(*item->u, unit)) : QString();
    QString U = item->U ? tr(",  U = %1").arg(triple(*item->U, unit)) : QString();
    if (item->stated)
        for (const std::string& note : view_->scene()->notes)
            U += QStringLiteral("; ") + to_qt(note).toHtmlEscaped();
    say(place + u + U, place + U);
}

/// Tells the inputs of a trial, made again as the run had them.
void ScenePanel::show_trial(std::uint64_t trial) {
    const AnalysisStatus& status = runner_.status(analysis_);
    if (measuring_->is_active() || !status.prepared || !status.is_of_present()) return;
    const TrialWords words = trial_words(*status.prepared, to_std(group()), trial);
    if (words.line.isEmpty()) return;
    say(words.line);
    picked_->setToolTip(words.all);
}

/// The user picked an item, or nothing.
void ScenePanel::take_pick(const QString& id) {
    const SceneItem* item = view_->scene() ? find_item(*view_->scene(), to_std(id)) : nullptr;
    emit source_picked(item ? to_qt(item->source.asset) : QString(),
                       item ? to_qt(item->source.path) : QString());
    describe_item(id);  // last: what is selected elsewhere describes itself, too
    if (const auto trial = view_->picked_trial()) show_trial(*trial);
}

bool ScenePanel::is_selected_source(const SceneItem& item) const {
    return item.source.path == source_ && item.source.asset == source_asset_;
}

void ScenePanel::select_source(const std::string& asset, const std::string& path) {
    source_asset_ = asset;
    source_ = path;
    if (show_source()) return measuring_->add_place(view_->selected());
    const auto group = asset.empty() ? groups_.find(path) : groups_.end();
    if (group != groups_.end() && to_qt(group->second) != this->group())
        return show_group(to_qt(group->second));
    // An item that no field states, a plate, say, stays selected.
    const SceneItem* selected =
        view_->scene() ? find_item(*view_->scene(), to_std(view_->selected())) : nullptr;
    if (!selected || !is_selected_source(*selected)) show_item({});
}

SetupAddress ScenePanel::address_in(const std::string& asset) const {
    return asset.empty() ? SetupAddress{SetupOwner::analysis, to_std(analysis_)}
                         : SetupAddress{SetupOwner::asset, asset};
}

/// Marks an item of the selected field; false when the scene has none.
bool ScenePanel::show_source() {
    const Scene* scene = view_->scene();
    if (!scene || source_.empty()) return false;
    const SceneItem* selected = find_item(*scene, to_std(view_->selected()));
    const SceneItem* shown = selected && is_selected_source(*selected) ? selected : nullptr;
    for (const ScenePoint& point : scene->points)
        if (!shown && is_selected_source(point.item)) shown = &point.item;
    if (shown) show_item(to_qt(shown->id));
    return shown != nullptr;
}

}  // namespace covaria::ui
