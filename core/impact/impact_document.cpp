#include "core/impact/impact_document.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/name.h"
#include "core/report/certificate_words.h"
#include "core/views/result_words.h"

namespace covaria {

namespace {

const char* word_of(std::optional<bool> met) {
    return !met ? "none" : *met ? "met" : "not met";
}

/// The columns of a table of rows; print and files choose among them by their keys.
class ImpactColumns {
public:
    explicit ImpactColumns(const std::vector<ImpactRow>& rows) : rows_(rows) { table_.rows = rows.size(); }

    Table make() {
        add("file", [](const ImpactRow& row) -> Cell { return row.file; }).print("File");
        add("project", [](const ImpactRow& row) -> Cell { return row.project; }).print("Project");
        add("number", [](const ImpactRow& row) -> Cell { return row.number; }).print("Number");
        add("analysis", [](const ImpactRow& row) -> Cell { return row.analysis; });
        add("analysis name", [](const ImpactRow& row) -> Cell {
            return row.analysis_name;
        }).print("Analysis");
        add("group", [](const ImpactRow& row) -> Cell {
            return said_name(row.quantity.group);
        }).print("Group");
        add("symbol", [](const ImpactRow& row) -> Cell { return Symbols{row.quantity.symbol}; })
            .print("Quantity")
            .of_symbols();
        add("unit", [](const ImpactRow& row) -> Cell { return row.quantity.unit; }).print("Unit");
        both("estimate", "y", &ImpactLine::estimate, true);
        both("u", "u", &ImpactLine::standard_uncertainty, false);
        both("U", "U", &ImpactLine::expanded_uncertainty, false);
        part("change in u", "Change in u", &ImpactRow::change_in_u);
        part("change in U", "Change in U", &ImpactRow::change_in_U);
        part("change of U", "Change of U in %", &ImpactRow::change_of_U).percent(1);
        verdict("verdict before", "Verdict before", &ImpactRow::before);
        verdict("verdict after", "Verdict after", &ImpactRow::after);
        add("to amend", [](const ImpactRow& row) -> Cell {
            return Answer{row.is_to_amend()};
        }).print("To amend");
        return std::move(table_);
    }

private:
    template <class Get>
    Column& add(const std::string& key, Get get) {
        return table_.add(key, [&rows = rows_, get](std::size_t row) -> Cell { return get(rows[row]); });
    }

    void both(const std::string& key, const std::string& symbol, double ImpactLine::*number, bool value) {
        const auto cell = [=](const ImpactRow& row, const ImpactLine& line) -> Cell {
            return value ? result_words::value_in(row.quantity.unit, line.*number)
                         : result_words::interval_in(row.quantity.unit, line.*number);
        };
        Column& before = add(key + " before", [=](const ImpactRow& row) {
                             return cell(row, row.before);
                         }).print(symbol + " before");
        value ? before.estimate_of("U before") : before.uncertainty();
        Column& after = add(key + " after", [=](const ImpactRow& row) {
                            return cell(row, row.after);
                        }).print(symbol + " after");
        value ? after.estimate_of("U after") : after.uncertainty();
    }

    Column& part(const std::string& key, const std::string& head, double (ImpactRow::*number)() const) {
        return add(key, [=](const ImpactRow& row) -> Cell { return Measured{(row.*number)()}; })
            .print(head)
            .fixed(2);
    }

    void verdict(const std::string& key, const std::string& head, ImpactLine ImpactRow::*line) {
        add(key, [=](const ImpactRow& row) -> Cell { return std::string(word_of((row.*line).met)); })
            .print(head)
            .of_own_words({"met", "not met", "none"});
    }

    const std::vector<ImpactRow>& rows_;
    Table table_{"impact", "Results before and after"};
};

std::string joined(const std::vector<std::string>& texts, const std::string& between) {
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : between) + text;
    return all;
}

bool is_changed(const ImpactRow& row) {
    return row.is_to_amend() || row.change() != 0.0 || row.change_of_U() != 0.0;
}

/// The columns that stand beside each other on a printed page.
Table printed_table(const std::vector<ImpactRow>& rows, const DocumentLanguage& in) {
    const Table all = ImpactColumns(rows).make();
    Table table{"impact-results", in.say(tell<"Results that change, the largest change first">())};
    table.rows = rows.size();
    table.add("file", [&rows](std::size_t row) -> Cell { return file_in_folder(rows[row].file); });
    table.columns.back().title = Text(in.say(tell<"File">()));
    const auto column = [&](const char* key, const Message& head) {
        Column& added = table.add(all[key]);
        added.title = Text(in.say(head));
    };
    column("symbol", tell<"Quantity">());
    column("unit", tell<"Unit">());
    column("estimate before", tell<"y before">());
    column("estimate after", tell<"y after">());
    column("U before", tell<"U before">());
    column("U after", tell<"U after">());
    column("change in U", tell<"Change in U">());
    const auto verdict = [&](const char* key, const Message& head) {
        const Column& from = all[key];
        table.add(key, [cell = from.cell, &in](std::size_t row) -> Cell {
            return in.say(Message::declared(std::get<std::string>(cell(row))));
        });
        table.columns.back().title = Text(in.say(head));
    };
    verdict("verdict before", tell<"Verdict before">());
    verdict("verdict after", tell<"Verdict after">());
    return table;
}

}  // namespace

std::string file_in_folder(const std::string& path) {
    const std::filesystem::path file(path);
    return (file.parent_path().filename() / file.filename()).string();
}

std::string file_list(const std::vector<std::string>& files) {
    std::string list;
    for (const std::string& file : files) list += file + "\n";
    return list;
}

Message follower_words(const ImpactFollower& follower) {
    return tell<"%1 has figures of %2 (%3)">(follower.file, follower.number, file_in_folder(follower.of));
}

Table impact_table(const Impact& impact) {
    return ImpactColumns(impact.rows).make();
}

std::vector<Message> impact_sentences(const Impact& impact) {
    const auto count = [&](auto is) { return std::count_if(impact.rows.begin(), impact.rows.end(), is); };
    std::vector<Message> sentences{tell<"%1 projects and reports were looked at; %2 use the figures.">(
        impact.looked_at, impact.using_it.size())};
    if (!impact.rows.empty())
        sentences.push_back(
            tell<"Of %1 results %2 change, %3 of them in what is stated; verdicts that change: %4.">(
                impact.rows.size(), count(is_changed),
                count([](const ImpactRow& r) { return r.is_to_amend(); }),
                count([](const ImpactRow& r) { return r.verdict_changes(); })));
    if (!impact.followers.empty())
        sentences.push_back(
            tell<"%1 more have figures of a document among these: they follow when it is amended.">(
                impact.followers.size()));
    if (!impact.failures.empty())
        sentences.push_back(tell<"%1 could not be evaluated.">(impact.failures.size()));
    return sentences;
}

ReportDocument build_impact(const ImpactWords& words, const Impact& impact, const DocumentLanguage& in) {
    ReportDocument document;
    document.title = in.say(tell<"Impact of new figures">());
    document.running_head = document.title;
    document.over = in.say(tell<"Results that rest on a certificate">());
    document.language = in.code();
    document.page_words = in.say(certificate_words::page);
    auto& blocks = document.blocks;
    blocks.push_back(
        FactsBlock{{{in.say(tell<"Replaced">()), words.old_figures},
                    {in.say(tell<"By">()), words.new_figures},
                    {in.say(tell<"Looked for in">()), joined(words.folders, ", ")},
                    {in.say(tell<"Evaluated">()),
                     in.say(words.is_first_order ? tell<"before and after by the law of propagation">()
                                                 : tell<"before and after as each project says">())}},
                   true});
    for (const Message& sentence : impact_sentences(impact))
        blocks.push_back(ParagraphBlock{in.say(sentence)});
    std::vector<ImpactRow> changed;
    std::copy_if(impact.rows.begin(), impact.rows.end(), std::back_inserter(changed), is_changed);
    if (!changed.empty()) {
        blocks.push_back(HeadingBlock{1, in.say(tell<"Results">())});
        blocks.push_back(TableBlock{file_table(printed_table(changed, in)), {{}, 2, in}});
        blocks.push_back(ParagraphBlock{
            in.say(tell<"The change of the value is given in units of the expanded uncertainty before.">()),
            true});
    }
    if (const auto amend = impact.to_amend(); !amend.empty()) {
        blocks.push_back(HeadingBlock{1, in.say(tell<"Documents to amend">())});
        blocks.push_back(ListBlock{amend});
    }
    if (!impact.followers.empty()) {
        blocks.push_back(HeadingBlock{1, in.say(tell<"Documents that follow">())});
        ListBlock list;
        for (const ImpactFollower& one : impact.followers) list.items.push_back(in.say(follower_words(one)));
        blocks.push_back(std::move(list));
    }
    if (!impact.failures.empty()) {
        blocks.push_back(HeadingBlock{1, in.say(tell<"Not evaluated">())});
        ListBlock list;
        for (const ImpactFailure& failure : impact.failures)
            list.items.push_back(failure.file + ": " + in.say(failure.cause));
        blocks.push_back(std::move(list));
    }
    return document;
}

}  // namespace covaria
