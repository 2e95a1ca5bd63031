#include "ui/main_window/search_actions.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>
#include <map>

#include "core/manual/help_page.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/main_window/help_actions.h"
#include "ui/main_window/pane_keys.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/search_palette.h"
#include "ui/pages/stage.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/languages.h"
#include "ui/theme/output_words.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// Quantities of an analysis that can be searched; a network of 1,000 targets has 90,000.
constexpr std::size_t most_quantities = 2000;

QString without_mnemonic(QString text) {
    return text.remove(QLatin1Char('&')).remove(QStringLiteral(" …"));
}

QString quantity_words(const std::string& symbol, const Name& group, const Message& name) {
    const QString words = to_qt(to_unicode(output_words(symbol, group)));
    return name.empty() || name == symbol ? words : words + QStringLiteral(": ") + to_qt(name);
}

/// Headings that a search can lead to.
std::vector<const HeadingBlock*> headings_of(const HelpPage& page) {
    std::vector<const HeadingBlock*> headings;
    for (const ReportBlock& block : page.blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block); heading && !heading->anchor.empty())
            headings.push_back(heading);
    return headings;
}

/// English headings by their anchors, which all languages share; none where the window speaks English.
std::map<std::string, QString> english_headings() {
    std::map<std::string, QString> headings;
    if (spoken_language() == QLatin1String("en")) return headings;
    const Result<std::vector<HelpPage>> pages = help_pages();
    if (!pages) return headings;
    for (const HelpPage& page : *pages)
        for (const HeadingBlock* heading : headings_of(page))
            headings[heading->anchor] = to_qt(heading->text);
    return headings;
}

}  // namespace

SearchActions::SearchActions(QMainWindow& window, Document& document, Selection& selection,
                             ResultsPane& results, PropertiesPane& properties, HelpActions& help,
                             std::function<void(const QString& path)> go_to)
    : QObject(&window),
      window_(window),
      document_(document),
      selection_(selection),
      results_(results),
      properties_(properties),
      help_(help),
      go_to_(std::move(go_to)),
      palette_(new SearchPalette(&window)) {}

void SearchActions::add_to(QMenu& menu) {
    menu.addAction(tr("&Find Anything …"), QKeySequence(Qt::CTRL | Qt::Key_K), this,
                   [this] { palette_->search(findables()); });
}

std::vector<Findable> SearchActions::findables() {
    std::vector<Findable> all;
    const Project& project = document_.project();
    for (const AnalysisEntry& entry : project.analyses) {
        const std::string& name = entry.name.empty() ? entry.id : entry.name;
        add_entry({SetupOwner::analysis, entry.id}, name, tr("analysis"), all);
        add_quantities(entry.id, to_qt(name), all);
    }
    for (const AssetEntry& entry : project.assets)
        add_entry({SetupOwner::asset, entry.id}, entry.name.empty() ? entry.id : entry.name, tr("asset"),
                  all);
    add_tabs(all);
    for (const QAction* action : window_.menuBar()->actions())
        if (action->menu()) add_commands(*action->menu(), all);
    add_help(all);
    return all;
}

void SearchActions::add_commands(const QMenu& menu, std::vector<Findable>& all) const {
    const QString of = tr("command, menu %1").arg(without_mnemonic(menu.title()));
    for (QAction* action : menu.actions()) {
        if (action->menu() && action->isEnabled()) add_commands(*action->menu(), all);
        if (action->isSeparator() || action->menu() || !action->isEnabled() || action->text().isEmpty())
            continue;
        all.push_back({without_mnemonic(action->text()), of, [action] { action->trigger(); }});
    }
}

/// Adds the entry and the fields of its set-up.
void SearchActions::add_entry(const SetupAddress& entry, const std::string& name, const QString& kind,
                              std::vector<Findable>& all) const {
    all.push_back({to_qt(name), kind, [this, entry] {
                       selection_.select_entry(entry);
                       properties_.go_to_first_field();
                   }});
    const SetupSchema* schema = find_schema(document_.project(), entry);
    const Setup* setup = find_setup(document_.project(), entry);
    if (!schema || !setup) return;
    const QString path = to_qt(setup_path(document_.project(), entry)) + QLatin1Char('/');
    for (const FieldSpec& field : schema->fields())
        if (is_shown(*schema, field, *setup))
            all.push_back({core_text(field.title), tr("field of %1").arg(to_qt(name)),
                           [this, place = path + to_qt(field.key)] { go_to_(place); }, false,
                           to_qt(field.title)});
}

void SearchActions::add_quantities(const std::string& analysis, const QString& name,
                                   std::vector<Findable>& all) const {
    const auto made = document_.maker().made() ? document_.maker().made()->analysis(analysis) : nullptr;
    if (!made) return;
    const SetupAddress entry{SetupOwner::analysis, analysis};
    const auto& outputs = made->model->outputs();
    for (std::size_t j = 0; j < std::min(outputs.size(), most_quantities); ++j)
        all.push_back({quantity_words(outputs[j].symbol, outputs[j].group, outputs[j].name),
                       tr("result of %1").arg(name), [this, entry, group = to_qt(outputs[j].group), j] {
                           selection_.select_entry(entry);
                           selection_.select_group(group);
                           selection_.select_output(static_cast<int>(j));
                           results_.stage().show_view(&results_.outputs());
                       }});
    const auto& inputs = made->inputs.quantities;
    const QString of = to_qt(setup_path(document_.project(), entry));
    for (std::size_t i = 0; i < std::min(inputs.size(), most_quantities); ++i)
        all.push_back({quantity_words(inputs[i].symbol, inputs[i].group, inputs[i].name),
                       tr("input quantity of %1").arg(name),
                       [this, entry, place = of + to_qt(inputs[i].source), has = !inputs[i].source.empty()] {
                           if (has) return go_to_(place);
                           selection_.select_entry(entry);
                           properties_.show_inputs();
                       }});
}

void SearchActions::add_tabs(std::vector<Findable>& all) const {
    const auto go_into = [](QWidget& page) {
        if (QWidget* place = place_for_keys(page)) place->setFocus();
    };
    QTabWidget& tabs = results_.tabs();
    for (int i = 0; i < tabs.count(); ++i)
        all.push_back({without_mnemonic(tabs.tabText(i)), tr("tab"), [&tabs, i, go_into] {
                           tabs.setCurrentIndex(i);
                           go_into(*tabs.currentWidget());
                       }});
    FoldGroups& groups = properties_.groups();
    for (int i = 0; i < groups.count(); ++i)
        if (!groups.title(i).isEmpty())
            all.push_back({groups.title(i), tr("group"), [this, &groups, i, go_into] {
                               properties_.show_group(i);
                               go_into(*groups.page(i));
                           }});
}

void SearchActions::add_help(std::vector<Findable>& all) const {
    static const Result<std::vector<HelpPage>> pages = help_pages(language_of_window());
    static const std::map<std::string, QString> english = english_headings();
    if (!pages) return;
    for (const HelpPage& page : *pages)
        for (const HeadingBlock* heading : headings_of(page)) {
            const bool is_page = heading->anchor == page.id;
            const auto in_english = english.find(heading->anchor);
            all.push_back({to_qt(heading->text), is_page ? tr("help") : tr("help: %1").arg(to_qt(page.title)),
                           [this, place = to_qt(heading->anchor)] { help_.show_place(place); }, true,
                           in_english == english.end() ? QString() : in_english->second});
        }
}

}  // namespace covaria::ui
