#include "core/manual/manual.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/base/version.h"
#include "core/manual/help_page.h"
#include "core/manual/markdown.h"

namespace covaria {
namespace {

namespace fs = std::filesystem;

/// Folder of the guides: beside projects and resources in the source tree, else share/doc/covaria.
fs::path guides_directory() {
    std::error_code ignored;
    const fs::path here = data_directory() / "docs";
    return fs::exists(here, ignored) ? here : data_directory().parent_path() / "doc" / "covaria";
}

class Manual {
public:
    void part(const std::string& title) {
        blocks.push_back(HeadingBlock{1, title, "part-" + anchor_words(title), true});
    }

    /// Adds a page one level lower: its title is one of the part.
    void page(const HelpPage& page) { append(page.blocks); }

    Result<void> guide(const std::string& name) {
        const fs::path folder = guides_directory();
        const auto text = read_file(folder / (name + ".md"));
        if (!text) return fail(text.error());
        std::vector<ReportBlock> guide = blocks_of_markdown(*text, "guide-" + name, folder);
        for (ReportBlock& block : guide)
            if (auto* picture = std::get_if<PictureBlock>(&block))
                if (auto found = find(*picture); !found) return found;
        append(std::move(guide));
        return {};
    }

    void command(const CommandWords& command) {
        const std::string anchor = "command-" + command.name;
        blocks.push_back(HeadingBlock{2, "covaria " + command.name, anchor});
        blocks.push_back(ParagraphBlock{command.description});
        for (const auto& [name, words] : command.options)
            blocks.push_back(ProseBlock{{{.text = name, .code = true}, {.text = ": " + words}}, "–"});
        if (!command.examples.empty()) blocks.push_back(CodeBlock{command.examples});
    }

    /// Links to what is in the manual go there, those to other files are words.
    void mend_links() {
        std::set<std::string> anchors;
        for (const ReportBlock& block : blocks) {
            if (const auto* heading = std::get_if<HeadingBlock>(&block)) anchors.insert(heading->anchor);
            if (const auto* prose = std::get_if<ProseBlock>(&block)) anchors.insert(prose->anchor);
        }
        for (ReportBlock& block : blocks)
            if (auto* prose = std::get_if<ProseBlock>(&block))
                for (ProseSpan& span : prose->spans) span.link = mended(span.link, anchors);
    }

    std::vector<ReportBlock> blocks;

private:
    void append(std::vector<ReportBlock> more) {
        for (ReportBlock& block : more) {
            if (auto* heading = std::get_if<HeadingBlock>(&block)) ++heading->level;
            blocks.push_back(std::move(block));
        }
    }

    /// Finds a picture: those of examples are not beside the guides of an installed program.
    static Result<void> find(PictureBlock& picture) {
        std::error_code ignored;
        const std::string path = picture.file.generic_string();
        const std::size_t projects = path.rfind("/projects/");
        if (!fs::exists(picture.file, ignored) && projects != std::string::npos)
            picture.file = data_directory() / path.substr(projects + 1);
        if (fs::exists(picture.file, ignored)) return {};
        return fail(ErrorCode::not_found, "a picture of the manual is missing: " + picture.file.string());
    }

    static std::string mended(const std::string& link, const std::set<std::string>& anchors) {
        if (link.empty() || link.starts_with("https://") || link.starts_with("http://")) return link;
        if (link.starts_with("#")) return anchors.contains(link.substr(1)) ? link : "";
        const std::string stem = fs::path(link.substr(0, link.find('#'))).stem().string();
        const std::size_t section = link.find('#');
        for (const std::string& page : {stem, "guide-" + stem, "model-" + stem}) {
            const std::string whole =
                section == std::string::npos ? page : page + "-" + link.substr(section + 1);
            if (anchors.contains(whole)) return "#" + whole;
        }
        return {};
    }
};

}  // namespace

Result<ReportDocument> build_manual(const std::vector<CommandWords>& commands) {
    const auto pages = help_pages();
    if (!pages) return fail(pages.error());
    Manual manual;
    manual.blocks = {ParagraphBlock{"Measurement uncertainty of robots and large-scale metrology. This "
                                    "manual is made from the pages of help, "
                                    "the fields of the models and assets, and the words of the command line "
                                    "of this version; its pictures were "
                                    "drawn by Covaria."},
                     HeadingBlock{1, "Contents"}, ContentsBlock{2, true}};
    const auto add = [&](const std::string& title, const std::string& prefix) {
        manual.part(title);
        for (const HelpPage& page : *pages)
            if (page.id.starts_with(prefix)) manual.page(page);
    };
    manual.part("Analyses and results");
    for (const HelpPage& page : *pages)
        if (!page.id.starts_with("model-") && !page.id.starts_with("asset-") && page.id != "glossary")
            manual.page(page);
    manual.part("Guides");
    for (const char* name :
         {"budget-to-certificate", "design-a-measurement", "design-tracker", "design-poses", "design-points",
          "project-file", "results", "many-machines", "python"})
        if (auto added = manual.guide(name); !added) return fail(added.error());
    add("Measurement models", "model-");
    add("Artefacts, instruments and robots", "asset-");
    manual.part("Examples");
    if (auto added = manual.guide("examples"); !added) return fail(added.error());
    manual.part("Command line");
    if (auto added = manual.guide("command-line"); !added) return fail(added.error());
    for (const CommandWords& command : commands) manual.command(command);
    add("Glossary", "glossary");
    manual.mend_links();
    const std::string title = std::string("Covaria ") + version() + ": manual";
    return ReportDocument{title, title, std::move(manual.blocks), "Measurement uncertainty"};
}

}  // namespace covaria
