#include "ui/main_window/recent_recorder.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "ui/pages/answer_strip.h"
#include "ui/pages/recent_card.h"
#include "ui/scene_view/scene_view.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui {
namespace {

constexpr int picture_is_drawn_after = 1500;  // ms

std::vector<double> shares_of(const UncertaintyResult& result) {
    std::vector<double> shares;
    if (result.budget.rows.empty()) return shares;
    for (const BudgetRow& row : result.budget.rows.front()) shares.push_back(row.contribution);
    std::ranges::sort(shares, std::greater<>());
    return shares;
}

}  // namespace

RecentRecorder::RecentRecorder(const Seen& seen, QObject* parent) : QObject(parent), seen_(seen) {
    later_.setSingleShot(true);
    later_.setInterval(picture_is_drawn_after);
    connect(&later_, &QTimer::timeout, this, &RecentRecorder::record);
    connect(&seen_.runner, &AnalysisRunner::idle, &later_, qOverload<>(&QTimer::start));
    connect(&seen_.document, &Document::modified_changed, &later_, qOverload<>(&QTimer::start));
}

void RecentRecorder::record() {
    const QString& file = seen_.document.file();
    const AnalysisStatus& status = seen_.runner.status(seen_.selection.analysis());
    if (file.isEmpty() || seen_.document.is_modified() || !status.is_current()) return;
    RecentFacts facts;
    facts.title = to_qt(seen_.document.project().title);
    facts.answer = to_qt(to_unicode(seen_.answer.value().text()));
    facts.kind = seen_.answer.verdict().kind();
    facts.verdict = to_qt(to_unicode(seen_.answer.verdict().words()));
    facts.picture = seen_.scene.scene() ? seen_.scene.image() : picture_of_shares(shares_of(*status.result));
    keep_recent_facts(file, facts);
    emit recorded(file);
}

}  // namespace covaria::ui
