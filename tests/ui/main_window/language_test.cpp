// The window in a language of which only the texts are known: every text is its English one in brackets,
// longer by a third. What has no brackets goes through no catalogue; what is asked for and is in none was not
// extracted.
#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QTabBar>
#include <QTableView>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolButton>
#include <QTranslator>
#include <QXmlStreamReader>

#include "core/base/name.h"
#include "core/kinds/registries.h"
#include "core/made/library.h"
#include "core/project/study_target.h"
#include "core/text/symbol.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/distribution_edit.h"
#include "ui/forms/import_dialog.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/search_actions.h"
#include "ui/models/roles.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/evaluation_view.h"
#include "ui/pages/library_browser.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/page_list.h"
#include "ui/pages/search_palette.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/start_page.h"
#include "ui/theme/core_text.h"
#include "ui/theme/languages.h"

namespace covaria::ui::language_test {
namespace {

const QChar opening(0x27e6), closing(0x27e7);  // ⟦ ⟧

using Key = std::pair<QString, QString>;  // context, source

QSet<Key> texts_of_catalogue(const QString& code) {
    QFile file(QStringLiteral(COVARIA_SOURCE_DIR "/resources/translations/covaria_%1.ts").arg(code));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader in(&file);
    QSet<Key> all;
    QString context;
    while (!in.atEnd()) {
        if (in.readNext() != QXmlStreamReader::StartElement) continue;
        if (in.name() == QLatin1String("name")) context = in.readElementText();
        if (in.name() == QLatin1String("source")) all.insert({context, in.readElementText()});
    }
    EXPECT_GT(all.size(), 1000);
    return all;
}

class Brackets : public QTranslator {
public:
    Brackets() : known_(texts_of_catalogue(QStringLiteral("de"))) {}
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char*, int) const override {
        const QString of = QString::fromUtf8(context), text = QString::fromUtf8(source);
        if (known_.contains({of, text})) return opening + text + closing;
        const bool has_words = text.contains(QRegularExpression(QStringLiteral("[a-z]{3}")));  // "u" has none
        if (!has_words) return {};
        if (of.startsWith(QLatin1String("covaria::ui")) || of == QLatin1String("QObject"))
            unknown_.insert(of + QStringLiteral(": ") + text);
        else if (of != QLatin1String(core_context))  // through which names go, too
            of_others_.insert(text);
        return {};
    }
    /// Qt asked for it: it has catalogues of its own.
    bool is_of_qt(const QString& text) const { return of_others_.contains(text); }
    QStringList unknown() const { return unknown_.values(); }

private:
    QSet<Key> known_;
    mutable QSet<QString> unknown_, of_others_;
};

class Languages : public Session {
protected:
    Languages() {
        QCoreApplication::installTranslator(&brackets_);
        window_->close();
        make_window();
    }
    ~Languages() override { QCoreApplication::removeTranslator(&brackets_); }

    /// Words that stand in no brackets.
    static QString untranslated(QString text) {
        static const QRegularExpression in_brackets(QStringLiteral("\u27e6[^\u27e6\u27e7]*\u27e7")),
            markup(QStringLiteral("<[^<>]*>|&[a-z]+;|\\((Ctrl|Alt|Shift)[^()]*\\)")),
            word(QStringLiteral("[a-z]{3,}"));
        for (QString before; before != text;) {
            before = text;
            text.remove(in_brackets);
        }
        return word.match(text.remove(markup)).hasMatch() ? text.trimmed() : QString();
    }
    /// Remembers names that people, files and models gave: those of the project, its results, examples.
    void learn(const QString& text) {
        for (const QString& one : text.split(QRegularExpression(QStringLiteral("[\"\n]")))) data_.insert(one);
    }
    void learn_project() {
        learn(to_qt(project_text(window_->document().project())));
        for (const AnalysisEntry& analysis : window_->document().project().analyses)
            if (const auto& prepared = window_->runner().status(to_qt(analysis.id)).prepared) {
                for (const OutputQuantity& output : prepared->model->outputs()) learn_output(output);
                for (const UncertaintyComponent& component : prepared->inputs.components)
                    learn(to_qt(component.id));
            }
    }
    void learn_output(const OutputQuantity& output) {
        for (const std::string& text : {name_given_by_people(output.group), output.symbol})
            learn(to_qt(text) + QLatin1Char('\n') + to_qt(symbol_to_unicode(text)));
        if (const std::string group = name_given_by_people(output.group); !group.empty())
            learn(to_qt(symbol_to_unicode(output.symbol) + " (" + group + ")"));
    }
    /// Empty for a group that the program names.
    static std::string name_given_by_people(const Name& group) {
        return said_name(group).in([](const std::string&) { return std::string(); });
    }
    bool is_data(const QString& words) const {
        const QStringList lines = words.split(QLatin1Char('\n'));
        return std::ranges::all_of(lines, [this](const QString& line) { return is_line_of_data(line); });
    }
    /// A name, with a symbol or a unit, or names parted by commas.
    bool is_line_of_data(QString line) const {
        static const QRegularExpression symbol_or_unit(QStringLiteral("\\w_[\\w,]+|/ \\w+$| \\(\\w+\\)$|:$"),
                                                       QRegularExpression::UseUnicodePropertiesOption);
        if (data_.contains(line)) return true;
        line = untranslated(line.remove(symbol_or_unit));
        if (line.isEmpty() || data_.contains(line)) return true;
        const QStringList parts = line.split(QStringLiteral(", "));
        return std::ranges::all_of(parts, [this](const QString& part) {
            const QString name = untranslated(part);
            return name.isEmpty() || data_.contains(name);
        });
    }
    void look_at(const QString& place, const QString& text) {
        const QString words = untranslated(text);
        if (!words.isEmpty() && !brackets_.is_of_qt(words) && !is_data(words))
            found_.insert(place + QStringLiteral(": ") + words);
    }
    void look_at_head(const QAbstractItemModel& model, const QString& place) {
        for (int c = 0; c < model.columnCount(); ++c)
            for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
                look_at(place, model.headerData(c, Qt::Horizontal, role).toString());
    }
    void look_at(QWidget& widget) {
        const QString place =
            QString::fromLatin1(widget.metaObject()->className()) + QLatin1Char(' ') + widget.objectName();
        look_at(place + QStringLiteral(" tip"), widget.toolTip());
        look_at(place + QStringLiteral(" name"), widget.accessibleName());
        if (auto* label = qobject_cast<QLabel*>(&widget)) look_at(place, label->text());
        if (auto* button = qobject_cast<QAbstractButton*>(&widget)) look_at(place, button->text());
        if (auto* group = qobject_cast<QGroupBox*>(&widget)) look_at(place, group->title());
        if (auto* line = qobject_cast<QLineEdit*>(&widget)) look_at(place, line->placeholderText());
        if (auto* box = qobject_cast<QComboBox*>(&widget))
            for (int i = 0; i < box->count(); ++i) look_at(place, box->itemText(i));
        if (auto* bar = qobject_cast<QTabBar*>(&widget))
            for (int i = 0; i < bar->count(); ++i) look_at(place, bar->tabText(i));
        if (auto* table = qobject_cast<QTableView*>(&widget); table && table->model())
            look_at_head(*table->model(), place);
        for (QAction* action : widget.actions()) {
            look_at(place + QStringLiteral(" action"), action->text());
            look_at(place + QStringLiteral(" action tip"), action->toolTip());
        }
    }
    void look_at_cells(const QAbstractItemModel& model, const QString& place, const QModelIndex& below = {}) {
        for (int r = 0; r < std::min(model.rowCount(below), 60); ++r)
            for (int c = 0; c < model.columnCount(below); ++c)
                look_at(place + QStringLiteral(" cell"), model.index(r, c, below).data().toString());
    }
    void look_at_chart(const PlotSpecification& plot) {
        const QString place = QStringLiteral("chart ") + to_qt(plot.id);
        std::vector<Text> texts{plot.title, plot.x.title, plot.y.title};
        for (const PlotSeries& series : plot.series) texts.push_back(series.name);
        for (const PlotMark& mark : plot.marks) texts.push_back(mark.label);
        for (const PlotBand& band : plot.bands) texts.push_back(band.label);
        for (const auto& categories : {plot.x.categories, plot.y.categories})
            texts.insert(texts.end(), categories.begin(), categories.end());
        for (const Text& text : texts) look_at(place, to_qt(to_unicode(text)));
    }
    /// Looks at contents: cells of tables and lists, and a chart that says why it is empty.
    void look_at_contents(QWidget& top) {
        for (auto* view : top.findChildren<QAbstractItemView*>()) {
            const QString place = QString::fromLatin1(view->metaObject()->className()) + QLatin1Char(' ') +
                                  view->objectName() + QLatin1Char(' ') + view->accessibleName();
            const bool is_head = qobject_cast<QHeaderView*>(view) != nullptr;
            const bool is_of_report = qobject_cast<PageList*>(view) != nullptr;  // in its own language
            if (view->model() && !is_head && !is_of_report) look_at_cells(*view->model(), place);
        }
        for (auto* chart : top.findChildren<ChartView*>()) look_at_chart(chart->plot());
        for (auto* view : top.findChildren<EvaluationView*>())
            for (QTextFrame* frame : view->text().document()->rootFrame()->childFrames())
                if (auto* table = qobject_cast<QTextTable*>(frame))
                    for (int c = 0; c < table->columns(); ++c)
                        look_at(QStringLiteral("head of a table to read"),
                                table->cellAt(0, c).firstCursorPosition().block().text());
    }
    void look_at_tabs(QTabWidget& tabs) {
        for (int i = 0; i < tabs.count(); ++i) {
            if (!tabs.isTabVisible(i)) continue;
            tabs.setCurrentIndex(i);
            settle();
            look_at_all(*tabs.widget(i));
            look_at_contents(*tabs.widget(i));
        }
    }
    void look_at_groups() {
        for (FoldGroups* groups : window_->properties().findChildren<FoldGroups*>())
            for (int i = 0; i < groups->count(); ++i) groups->open(i);
        settle();
        look_at_all(window_->properties());
        look_at_contents(window_->properties());
    }
    void look_at_all(QWidget& top) {
        look_at(top);
        for (QWidget* widget : top.findChildren<QWidget*>()) look_at(*widget);
    }

    Brackets brackets_;
    QSet<QString> data_;  ///< whole texts
    QSet<QString> found_;
};

// An asset that its owner called "Robot" is not translated, though the word is in the catalogue.
TEST_F(Languages, NamesInAProjectStayAsTheyAre) {
    open(project_copy(QStringLiteral("ballbar-tcp")));
    const AnalysisEntry& analysis = window_->document().project().analyses.front();
    select(SetupOwner::analysis, analysis.id);
    int references = 0;
    const SetupSchema& schema = find_model(analysis.model)->schema;
    for (const FieldSpec& spec : schema.fields()) {
        if (spec.kind != FieldKind::reference) continue;
        const auto* id = std::get_if<std::string>(&value_of(spec, analysis.setup));
        const auto* box = window_->properties().findChild<QComboBox*>(to_qt(spec.key));
        if (!id || !box) continue;
        EXPECT_EQ(box->currentText(), to_qt(window_->document().project().find_asset(*id)->name));
        ++references;
    }
    EXPECT_GE(references, 2);
}

TEST_F(Languages, ADistributionIsShownByItsTitle) {
    DistributionEdit edit;
    edit.set_component({.name = "limits", .distribution = "rectangular", .parameters = {-1.0, 1.0}});
    const auto* box = edit.findChild<QComboBox*>(QStringLiteral("distribution"));
    ASSERT_TRUE(box);
    EXPECT_EQ(box->currentData().toString(), QStringLiteral("rectangular"));
    EXPECT_TRUE(box->currentText().startsWith(opening)) << box->currentText().toStdString();
}

TEST_F(Languages, TheSameColumnsAreHidden) {
    open(project_copy());
    wait_until_idle();
    select(SetupOwner::analysis, window_->document().project().analyses.front().id);
    const SortableTable& table = window_->results().outputs().table();
    ASSERT_TRUE(wait_for([&] { return table.model()->columnCount() > 0; }));
    QStringList hidden;
    for (int c = 0; c < table.model()->columnCount(); ++c)
        if (table.isColumnHidden(c))
            hidden << table.model()->headerData(c, Qt::Horizontal, id_role).toString();
    EXPECT_TRUE(hidden.contains(QStringLiteral("Group"))) << hidden.join(QLatin1Char(' ')).toStdString();
}

TEST_F(Languages, EveryTextOfTheWindowIsInTheCatalogues) {
    learn(QStringLiteral("mm\nrad\nmrad\nµrad\ngon\nlbf\nthou\n"));
    look_at_all(*window_);
    PreferenceStore store;
    PreferencesDialog preferences(store);
    for (const Language& language : all_languages()) learn(language.name);
    const auto* families = preferences.findChild<QComboBox*>(QStringLiteral("font_family"));
    for (int i = 1; i < families->count(); ++i) learn(families->itemText(i));
    look_at_all(preferences);
    for (const char* name :
         {"stewart-platform", "chain", "lsm-network", "force-moment-sensor", "ballbar-design"}) {
        learn(QString::fromLatin1(name));
        const QString file = project_copy(QString::fromLatin1(name));
        learn(file);
        open(file);
        wait_until_idle();
        learn_project();
        const Project& project = window_->document().project();
        for (const AnalysisEntry& analysis : project.analyses) {
            select(SetupOwner::analysis, analysis.id);
            settle();
            look_at_all(*window_);
        }
        for (const AssetEntry& asset : project.assets) {
            select(SetupOwner::asset, asset.id);
            settle();
            look_at_all(*window_);
        }
    }
    for (const QString& one : found_.values()) ADD_FAILURE() << one.toStdString();
    EXPECT_EQ(brackets_.unknown(), QStringList());
}

// Results, what was kept, studies and designs when they are there.
TEST_F(Languages, EveryTextAboutResultsIsInTheCatalogues) {
    for (const auto& [name, id] :
         {std::pair("lsm-network", "recommended"), std::pair("ballbar-design", "")}) {
        const QString file = project_copy(QString::fromLatin1(name));
        learn(QStringLiteral("mm\nrad\nmrad\nµrad\nthou\n") + file);
        open(file);
        wait_until_idle();
        learn_project();
        const AnalysisEntry& analysis = *id ? *window_->document().project().find_analysis(id)
                                            : window_->document().project().analyses.front();
        select(SetupOwner::analysis, analysis.id);
        look_at_tabs(window_->results().tabs());
        window_->runner().run_all();
        const QString of = to_qt(analysis.id);
        for (const Study& study : analysis.studies) window_->runner().studies().run(of, to_qt(study.id));
        for (const Design& design : analysis.designs) window_->runner().designs().run(of, to_qt(design.id));
        wait_until_idle();
        ASSERT_TRUE(wait_for([&] {
            return std::ranges::all_of(
                       analysis.studies,
                       [&](const Study& study) {
                           return window_->runner().studies().status(of, to_qt(study.id)).is_current();
                       }) &&
                   std::ranges::all_of(analysis.designs, [&](const Design& design) {
                       return window_->runner().designs().status(of, to_qt(design.id)).is_current();
                   });
        }));
        learn_project();
        window_->results().compare_tab().findChild<QAction*>(QStringLiteral("keep_before"))->trigger();
        window_->selection().select_output(0);
        look_at_tabs(window_->results().tabs());
        look_at_groups();
    }
    for (const QString& one : found_.values()) ADD_FAILURE() << one.toStdString();
    EXPECT_EQ(brackets_.unknown(), QStringList());
}

TEST_F(Languages, EveryTextOfLibraryImportAndSearchIsInTheCatalogues) {
    for (const LibraryItem& item : load_library().items) learn(to_qt(item.asset.name));
    LibraryBrowser& library = window_->library();
    library.show();
    look_at_all(library);
    look_at_contents(library);
    learn(QStringLiteral("Cover\nBudget"));  // sheets of the workbook
    for (const char* file : {"budget.xlsx", "traverse.obs"}) {
        ImportDialog import(QStringLiteral(COVARIA_SOURCE_DIR "/tests/data/readers/") + QLatin1String(file));
        look_at_all(import);
    }
    open(project_copy());
    wait_until_idle();
    learn_project();
    trigger(QStringLiteral("\u27e6Find Anything …\u27e7"));
    QTest::keyClicks(&window_->search().palette().field(), QStringLiteral("pose"));
    look_at_contents(window_->search().palette());
    for (const QString& one : found_.values()) ADD_FAILURE() << one.toStdString();
    EXPECT_EQ(brackets_.unknown(), QStringList());
}

}  // namespace
}  // namespace covaria::ui::language_test
