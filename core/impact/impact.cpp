#include "core/impact/impact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <system_error>

#include "core/base/file_io.h"
#include "core/base/guarded.h"
#include "core/base/in_quotes.h"
#include "core/base/sha256.h"
#include "core/base/small_letters.h"
#include "core/carried/carried_project.h"
#include "core/carried/report_data.h"
#include "core/made/load_project.h"
#include "core/pdf/pdf_archive.h"
#include "core/project/stated_requirements.h"
#include "core/propagation/parallel_blocks.h"
#include "core/propagation/requirements.h"
#include "core/views/result_statement.h"

namespace covaria {

namespace {

namespace fs = std::filesystem;

double ratio_of(double change, double to) {
    if (change == 0.0) return 0.0;
    return to > 0.0 ? change / to : std::copysign(infinity, change);
}

bool is_project_or_pdf(const fs::path& file) {
    const std::string ending = in_small_letters(file.extension().string());
    return ending == ".covaria" || ending == ".pdf";
}

/// The answer of one file.
struct FileImpact {
    bool is_ours = false, is_using = false;
    std::string number = {}, digest = {};  ///< of the document, as others cite it
    std::vector<AssetCertificate> cited = {};
    std::vector<ImpactRow> rows = {};
    std::vector<Message> causes = {};  ///< why the file, or an analysis of it, has no rows
};

/// The project of a file; nothing where a PDF carries no project.
Result<std::optional<LoadedProject>> project_in(const fs::path& file) {
    if (file.extension() == ".covaria") return load_project(file);
    const auto bytes = read_file(file);
    if (!bytes) return fail(bytes.error());
    if (!is_pdf(*bytes)) return std::nullopt;
    const auto files = files_in_pdf(*bytes);
    if (!files) return fail(files.error());
    const bool carries = std::any_of(files->begin(), files->end(), [](const AttachedFile& attached) {
        return attached.name == carried::project;
    });
    if (!carries) return std::nullopt;
    return load_carried(file, *files);
}

/// Ids of the analyses that rest on one of the holders, in the order of the project.
std::vector<std::string> reached(const MadeProject& made, const std::vector<CertificateHolder>& holders) {
    const Project& project = made.project();
    std::set<std::size_t> numbers;
    for (const CertificateHolder& holder : holders)
        numbers.insert(holder.is_asset ? holder.entry : made.graph().number_of_analysis(holder.entry));
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < project.analyses.size(); ++i) {
        const std::size_t own = made.graph().number_of_analysis(i);
        const auto used = made.graph().used_by(own);
        if (numbers.contains(own) ||
            std::any_of(used.begin(), used.end(), [&](std::size_t one) { return numbers.contains(one); }))
            ids.push_back(project.analyses[i].id);
    }
    return ids;
}

const std::string& number_of(const Project& project) {
    return project.certificate.number.empty() ? project.number : project.certificate.number;
}

class FileQuestion {
public:
    FileQuestion(const ImpactQuestion& question, const fs::path& file, const RunControl& control)
        : question_(question), file_(file), control_(control) {}

    FileImpact answer() {
        auto loaded = project_in(file_);
        if (!loaded)
            say(loaded.error().message);
        else if (*loaded)
            of_project(**loaded);
        return std::move(impact_);
    }

private:
    void say(Message cause) { impact_.causes.push_back(std::move(cause)); }

    void of_project(const LoadedProject& loaded) {
        impact_.is_ours = true;
        take_citations(loaded);
        // Nobody knows which figures a text that is no project used.
        if (!loaded.made) return say(first_error(loaded.problems, tell<"it is no project">()));
        const Project& project = loaded.made->project();
        const auto holders = holders_of(project, question_.old_figures);
        impact_.is_using = !holders.empty();
        if (holders.empty()) {
            if (!loaded.is_whole && loaded.problems.has_errors())
                say(first_error(loaded.problems, tell<"it has errors">()));
            return;
        }
        if (!question_.figures) return;
        auto changed = with_new_figures(project, holders, *question_.figures);
        if (!changed) return say(changed.error().message);
        const auto before = question_.asked ? question_.asked(loaded.made) : loaded.made;
        const auto made_after = MadeProject::make(*std::move(changed), loaded.made);
        const auto after = question_.asked ? question_.asked(made_after) : made_after;
        for (const std::string& id : reached(*before, holders)) compare(*before, *after, id);
    }

    void take_citations(const LoadedProject& loaded) {
        if (!loaded.made) return;
        const Project& project = loaded.made->project();
        impact_.number = number_of(project);
        if (const auto bytes = read_file(file_)) impact_.digest = sha256_of(*bytes);
        const auto take = [&](const auto& entries) {
            for (const auto& entry : entries)
                impact_.cited.insert(impact_.cited.end(), entry.certificates.begin(),
                                     entry.certificates.end());
        };
        take(project.assets);
        take(project.analyses);
    }

    Result<UncertaintyResult> evaluate(const MadeProject& made, const std::string& id) const {
        const auto prepared = made.analysis(id);
        if (!prepared)
            return fail(ErrorCode::bad_input,
                        first_error(made.problems_of_analysis(id), tell<"it cannot be made">()));
        auto ran = guarded([&] { return run_analysis(*prepared, {control_.stop, {}, 1, nullptr}); });
        if (!ran) return fail(ran.error());
        return std::move(*ran);
    }

    void compare(const MadeProject& before, const MadeProject& after, const std::string& id) {
        const AnalysisEntry& entry = *before.project().find_analysis(id);
        const std::string name = in_quotes(entry.name.empty() ? id : entry.name);
        const auto was = evaluate(before, id);
        if (!was) return say(tell<"%1, with the old figures: %2">(name, was.error().message));
        const auto is = evaluate(after, id);
        if (!is) return say(tell<"%1, with the new figures: %2">(name, is.error().message));
        const auto verdicts_before = judge(*was, entry),
                   verdicts_after = judge(*is, *after.project().find_analysis(id));
        for (std::size_t i = 0; i < was->outputs.size(); ++i) {
            const OutputQuantity& quantity = was->outputs[i].quantity;
            if (quantity.role != OutputRole::measurand) continue;
            const auto other = std::find_if(is->outputs.begin(), is->outputs.end(), [&](const auto& output) {
                return output.quantity.symbol == quantity.symbol && output.quantity.group == quantity.group;
            });
            if (other == is->outputs.end()) {
                say(tell<"%1: with the new figures there is no %2">(name, quantity.symbol));
                continue;
            }
            const auto k = static_cast<std::size_t>(other - is->outputs.begin());
            add_row(before.project(), entry, quantity,
                    line_of(was->outputs[i], *was, before, id, are_met(verdicts_before, i)),
                    line_of(*other, *is, after, id, are_met(verdicts_after, k)));
        }
    }

    static ImpactLine line_of(const OutputResult& output, const UncertaintyResult& result,
                              const MadeProject& made, const std::string& id, std::optional<bool> met) {
        const ResultStyle& style = made.analysis(id)->style;
        return {output.estimate, output.standard_uncertainty, output.expanded_uncertainty,
                result_statement(output, result, {}, style.units, style.digits.value_or(2)), met};
    }

    void add_row(const Project& project, const AnalysisEntry& entry, const OutputQuantity& quantity,
                 ImpactLine before, ImpactLine after) {
        impact_.rows.push_back({file_.string(), project.title, number_of(project), entry.id, entry.name,
                                quantity, std::move(before), std::move(after)});
    }

    const ImpactQuestion& question_;
    const fs::path& file_;
    const RunControl& control_;
    FileImpact impact_;
};

/// The project with all analyses to first order.
MadeProject::Pointer to_first_order(const MadeProject::Pointer& made) {
    Project project = made->project();
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    return MadeProject::make(std::move(project), made);
}

/// The name that old figures are called by: the digest of a file.
std::string called(const std::string& old) {
    std::error_code failure;
    if (!fs::is_regular_file(old, failure)) return old;
    const auto bytes = read_file(old);
    return bytes ? sha256_of(*bytes) : old;
}

/// The larger change of a row, as a part of U; infinite where it is not a number (the result is no longer
/// there), so that such a row comes before all others.
double size_of(const ImpactRow& row) {
    const double value = std::abs(row.change_in_U()), spread = std::abs(row.change_of_U());
    return std::isnan(value) || std::isnan(spread) ? infinity : std::max(value, spread);
}

/// The answers of all files, each at its place.
std::vector<FileImpact> answers(const ImpactQuestion& question, const RunControl& control) {
    std::vector<FileImpact> files(question.files.size());
    detail::RunMonitor monitor(control, files.size());
    detail::run_each(files.size(), monitor, [&](std::uint64_t i) {
        auto answer = guarded([&] { return FileQuestion(question, question.files[i], control).answer(); });
        if (answer)
            files[i] = *std::move(answer);
        else
            files[i].causes.push_back(answer.error().message);
        monitor.advance(1);
    });
    return files;
}

/// Files that follow from those that change, each once.
std::vector<ImpactFollower> followers_of(const std::vector<FileImpact>& files, std::vector<bool> changes,
                                         const std::vector<fs::path>& names) {
    std::multimap<std::string, std::size_t> citing;  // files by numbers and digests, in small letters
    for (std::size_t i = 0; i < files.size(); ++i)
        for (const AssetCertificate& certificate : files[i].cited)
            for (const std::string& name : {certificate.number, certificate.digest})
                if (!name.empty()) citing.emplace(in_small_letters(name), i);
    std::vector<ImpactFollower> followers;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (changes[i]) open.push_back(i);
    for (std::size_t next = 0; next < open.size(); ++next) {
        const std::size_t document = open[next];
        for (const std::string& name : {files[document].number, files[document].digest}) {
            const auto [begin, end] = citing.equal_range(in_small_letters(name));
            for (auto at = begin; at != end; ++at) {
                const std::size_t i = at->second;
                if (changes[i]) continue;
                changes[i] = true;
                open.push_back(i);
                followers.push_back({names[i].string(), name, names[document].string()});
            }
        }
    }
    return followers;
}

}  // namespace

double ImpactRow::change_in_u() const {
    return ratio_of(change(), before.standard_uncertainty);
}

double ImpactRow::change_in_U() const {
    return ratio_of(change(), before.expanded_uncertainty);
}

double ImpactRow::change_of_U() const {
    return ratio_of(after.expanded_uncertainty - before.expanded_uncertainty, before.expanded_uncertainty);
}

std::vector<std::string> Impact::to_amend() const {
    std::set<std::string> files;
    for (const ImpactRow& row : rows)
        if (row.is_to_amend()) files.insert(row.file);
    return {files.begin(), files.end()};
}

Result<std::vector<fs::path>> files_below(const std::vector<std::string>& folders) {
    std::set<fs::path> files;
    for (const std::string& folder : folders) {
        std::error_code failure;
        if (!fs::is_directory(folder, failure)) {
            if (!fs::exists(folder, failure))
                return fail(ErrorCode::not_found, tell<"there is no folder or file %1">(in_quotes(folder)));
            files.insert(folder);
            continue;
        }
        // Folders that may not be read are passed over, as the files of others are.
        auto at =
            fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, failure);
        for (; !failure && at != fs::recursive_directory_iterator(); at.increment(failure))
            if (std::error_code gone; at->is_regular_file(gone) && is_project_or_pdf(at->path()))
                files.insert(at->path());
        if (failure)
            return fail(ErrorCode::io,
                        tell<"the folder %1 cannot be read: %2">(in_quotes(folder), failure.message()));
    }
    return std::vector<fs::path>(files.begin(), files.end());
}

Result<ImpactQuestion> question_of(const ImpactWords& words) {
    ImpactQuestion question;
    question.old_figures = called(words.old_figures);
    if (!words.new_figures.empty()) {
        auto figures = new_figures(words.new_figures);
        if (!figures) return fail(figures.error());
        question.figures = *std::move(figures);
    }
    auto files = files_below(words.folders);
    if (!files) return fail(files.error());
    question.files = *std::move(files);
    if (words.is_first_order) question.asked = to_first_order;
    return question;
}

Result<Impact> impact_of(const ImpactQuestion& question, const RunControl& control) {
    std::vector<FileImpact> files = answers(question, control);
    if (control.stop.stop_requested())
        return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
    Impact impact;
    std::vector<bool> changes;
    for (const FileImpact& one : files)
        changes.push_back(question.figures ? std::ranges::any_of(one.rows, &ImpactRow::is_to_amend)
                                           : one.is_using);
    impact.followers = followers_of(files, changes, question.files);
    for (std::size_t i = 0; i < files.size(); ++i) {
        FileImpact& one = files[i];
        const std::string name = question.files[i].string();
        impact.looked_at += one.is_ours;
        if (one.is_using) impact.using_it.push_back(name);
        for (Message& cause : one.causes) impact.failures.push_back({name, std::move(cause)});
        impact.rows.insert(impact.rows.end(), std::make_move_iterator(one.rows.begin()),
                           std::make_move_iterator(one.rows.end()));
    }
    std::stable_sort(impact.rows.begin(), impact.rows.end(), [](const ImpactRow& a, const ImpactRow& b) {
        if (a.verdict_changes() != b.verdict_changes()) return a.verdict_changes();
        return size_of(a) > size_of(b);
    });
    return impact;
}

}  // namespace covaria
