#include "core/project/release.h"

#include <algorithm>
#include <filesystem>

#include "core/base/dates.h"
#include "core/base/in_quotes.h"
#include "core/base/sha256.h"
#include "core/project/asides.h"
#include "core/project/entry_names.h"
#include "core/project/linked_files.h"
#include "core/project/project_file.h"

namespace covaria {

namespace {

constexpr std::size_t digits_of_part = 16;
constexpr const char *figures_end = "/setup", *asides_end = "/texts";

/// A logo elsewhere is carried by no report (core/carried).
bool lies_elsewhere(const std::string& file) {
    const auto path = std::filesystem::path(file).lexically_normal();
    return path.is_absolute() || (!path.empty() && *path.begin() == "..");
}

/// The project without what a report does not carry and without the record of its release.
Project content_of(Project project) {
    project.kept.clear();
    unlink_tables(project);
    for (AnalysisEntry& analysis : project.analyses) analysis.views.clear();
    if (lies_elsewhere(project.certificate.logo)) project.certificate.logo.clear();
    project.review.digest.clear();
    project.review.parts.clear();
    project.review.log.clear();
    return project;
}

std::string part_digest(const Project& part) {
    return sha256_of(project_text(part)).substr(0, digits_of_part);
}

/// Parts of a project that change alone, taken from what is released of it.
class PartList {
public:
    explicit PartList(const Project& content) : content_(content) {
        take("/title", &Project::title);
        take("/notes", &Project::notes);
        take("/author", &Project::author);
        take("/number", &Project::number);
        take("/certificate", &Project::certificate);
        take("/amendment", &Project::amendment);
        take("/report", &Project::report);
        take("/results", &Project::results);
        take("/review", &Project::review);
        take_order();
        for (const AssetEntry& asset : content.assets) take_entry(asset, &Project::assets, "/assets/");
        for (const AnalysisEntry& analysis : content.analyses)
            take_entry(analysis, &Project::analyses, "/analyses/");
    }
    std::vector<ReleasedPart> parts = {};

private:
    template <class M>
    void take(const char* place, M Project::*member) {
        Project part;
        part.*member = content_.*member;
        parts.push_back({place, "", part_digest(part)});
    }

    void take_order() {
        Project order;
        for (const AssetEntry& asset : content_.assets) order.assets.push_back({.id = asset.id});
        for (const AnalysisEntry& analysis : content_.analyses) order.analyses.push_back({.id = analysis.id});
        parts.push_back({"/order", "", part_digest(order)});
    }

    /// Takes the entry's figures, and what no number depends on: its texts, requirements, certificates.
    template <class Entry>
    void take_entry(const Entry& entry, std::vector<Entry> Project::*list, const char* place) {
        const std::string name = name_among(content_.*list, entry);
        Entry figures = entry, asides;
        take_asides(figures, {});
        take_asides(asides, entry);
        for (const auto& [part, end] : {std::pair(&figures, figures_end), std::pair(&asides, asides_end)}) {
            Project alone;
            (alone.*list).push_back(*part);
            parts.push_back({place + entry.id + end, name, part_digest(alone)});
        }
    }

    const Project& content_;
};

/// The part in words: "asset 'Plate'", "texts and requirements of analysis 'Pose'".
Message name_of(const ReleasedPart& part) {
    static const std::vector<std::pair<std::string, Message>> of_project{
        {"/title", tell<"the title">()},
        {"/notes", tell<"the notes of the project">()},
        {"/author", tell<"the author">()},
        {"/number", tell<"the number of the project">()},
        {"/certificate", tell<"the texts of the certificate">()},
        {"/amendment", tell<"what the replaced certificate stated">()},
        {"/report", tell<"what goes into the report">()},
        {"/results", tell<"how results are stated">()},
        {"/review", tell<"the names and dates of the review">()},
        {"/order", tell<"which assets and analyses there are, or their order">()}};
    for (const auto& [place, words] : of_project)
        if (part.place == place) return words;
    const std::string name = in_quotes(part.name);
    const bool of_asset = part.place.starts_with("/assets/");
    if (part.place.ends_with(figures_end))
        return of_asset ? tell<"asset %1">(name) : tell<"analysis %1">(name);
    return of_asset ? tell<"texts or certificates of asset %1">(name)
                    : tell<"texts, requirements or designs of analysis %1">(name);
}

const ReleasedPart* find_part(const std::vector<ReleasedPart>& parts, const std::string& place) {
    const auto found = std::ranges::find(parts, place, &ReleasedPart::place);
    return found == parts.end() ? nullptr : &*found;
}

/// The parts that differ. An entry that came or went is named once.
std::vector<Message> differences(const std::vector<ReleasedPart>& then,
                                 const std::vector<ReleasedPart>& now) {
    std::vector<Message> changes;
    for (const ReleasedPart& part : now) {
        const ReleasedPart* before = find_part(then, part.place);
        if (before && before->digest != part.digest) changes.push_back(name_of(part));
        if (!before && !part.place.ends_with(asides_end))
            changes.push_back(tell<"%1, which is new">(name_of(part)));
    }
    for (const ReleasedPart& part : then)
        if (!find_part(now, part.place) && !part.place.ends_with(asides_end))
            changes.push_back(tell<"%1, which is no longer there">(name_of(part)));
    return changes;
}

Message by_and_on(const ReviewStep& step) {
    return tell<"%1 on %2">(step.name, step.date);
}

std::string digest_of(const Project& content) {
    return sha256_of(project_text(content));
}

}  // namespace

std::string release_digest(const Project& project) {
    return digest_of(content_of(project));
}

ReleaseStatus release_status(const Project& project) {
    const Review& review = project.review;
    if (review.digest.empty()) return {review.empty() ? ReleaseState::unreviewed : ReleaseState::draft, {}};
    const Project content = content_of(project);
    if (digest_of(content) == review.digest) return {ReleaseState::released, {}};
    ReleaseStatus status{ReleaseState::changed, differences(review.parts, PartList(content).parts)};
    if (status.changes.empty()) status.changes.push_back(tell<"the record of the release">());
    return status;
}

Message list_of_changes(const ReleaseStatus& status) {
    Message list;
    for (const Message& change : status.changes) {
        if (!list.empty()) list += Message(", ");
        list += change;
    }
    return list;
}

Message words_of(const ReleaseStatus& status, const Review& review) {
    switch (status.state) {
        case ReleaseState::unreviewed:
        case ReleaseState::draft:
            return tell<"draft: it was not released">();
        case ReleaseState::released:
            return tell<"released by %1, digest %2">(by_and_on(review.released), review.digest);
        case ReleaseState::changed:
            break;
    }
    return tell<"draft again: changed since it was released by %1: %2">(by_and_on(review.released),
                                                                        list_of_changes(status));
}

Result<void> release(Project& project) {
    for (const ReviewStepField& field : review_steps()) {
        const ReviewStep& step = project.review.*field.member;
        if (is_blank(step.name) || !date_of(step.date))
            return fail(ErrorCode::bad_input,
                        tell<"it is not released: '%1' needs a name and a date of the form 2026-04-17">(
                            Message::declared(field.title)),
                        std::string("/review/") + field.key);
    }
    const Project content = content_of(project);
    Review& review = project.review;
    review.digest = digest_of(content);
    review.parts = PartList(content).parts;
    review.log.push_back({review.released.date, review.released.name,
                          "Released, digest " + review.digest.substr(0, digits_of_part) + "..."});
    return {};
}

}  // namespace covaria
