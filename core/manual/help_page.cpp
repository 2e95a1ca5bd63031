#include "core/manual/help_page.h"

#include <algorithm>
#include <filesystem>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/manual/help_words.h"
#include "core/manual/markdown.h"
#include "core/project/certificate.h"
#include "core/project/option_fields.h"
#include "core/setup/field_words.h"
#include "core/verification/dossier.h"

namespace covaria {
namespace {

namespace words = help_words;

using Blocks = std::vector<ReportBlock>;

/// Headings of a translation have the anchors of what they translate: links and F1 find them.
void take_anchors(Blocks& translated, const Blocks& english) {
    auto from = english.begin();
    for (ReportBlock& block : translated) {
        auto* heading = std::get_if<HeadingBlock>(&block);
        if (!heading) continue;
        from = std::find_if(from, english.end(), [](const ReportBlock& other) {
            return std::holds_alternative<HeadingBlock>(other);
        });
        if (from == english.end()) return;
        heading->anchor = std::get<HeadingBlock>(*from++).anchor;
    }
}

Result<Blocks> blocks_of_file(const std::string& file, const std::string& page, const DocumentLanguage& in) {
    const std::filesystem::path folder = data_directory() / "resources" / "help";
    const auto text = read_file(folder / file);
    if (!text) return fail(text.error());
    Blocks english = blocks_of_markdown(*text, page, folder);
    std::error_code ignored;
    const std::filesystem::path other = folder / in.code() / file;
    if (!std::filesystem::exists(other, ignored)) return english;
    const auto translation = read_file(other);
    if (!translation) return fail(translation.error());
    Blocks translated = blocks_of_markdown(*translation, page, folder);
    take_anchors(translated, english);
    return translated;
}

std::string title_of(const Blocks& blocks) {
    for (const ReportBlock& block : blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block)) return heading->text;
    return {};
}

/// The blocks of a page from the registries.
class FieldWords {
public:
    FieldWords(Blocks& blocks, std::string page, const DocumentLanguage& in)
        : blocks_(blocks), page_(std::move(page)), in_(in) {}

    void fields(const SetupSchema& schema) {
        heading(2, in_.say(words::fields_of_set_up), "fields-of-the-set-up");
        std::string section;
        for (const FieldSpec& field : schema.fields()) {
            if (field.section != section) {
                section = field.section;
                heading(3, in_.say_declared(section), "section-" + anchor_words(section));
            }
            add(field);
        }
    }

    void options() {
        for (const OptionField& field : option_fields()) {
            ProseBlock block = stated(field.title, field.key, "", field.help);
            block.anchor = field_anchor(page_, field.key);
            blocks_.push_back(std::move(block));
            choices(field.choices);
        }
    }

    void certificate() {
        for (const CertificateSection& section : certificate_sections()) {
            heading(2, in_.say_declared(section.title), anchor_words(section.title));
            for (const CertificateField& field : section.fields) {
                ProseBlock block = stated(field.title, field.key, clause_words(field), field.help);
                block.anchor = field_anchor(page_, anchor_words(pointer_of(field)));
                blocks_.push_back(std::move(block));
                if (field.kind == CertificateText::site) choices(sites());
            }
        }
    }

    void heading(int level, const std::string& text, const std::string& anchor) {
        blocks_.push_back(HeadingBlock{level, text, page_ + "-" + anchor});
    }

    void list(const Phrase& title, const std::vector<std::string>& items) {
        if (items.empty()) return;
        heading(2, in_.say(title), "about-" + anchor_words(title.english()));
        ListBlock list;
        for (const std::string& item : items) list.items.push_back(in_.say_declared(item));
        blocks_.push_back(std::move(list));
    }

private:
    std::string clause_words(const CertificateField& field) const {
        if (!*field.clause) return in_.say(words::optional);
        return in_.say(field.required                  ? words::required_by
                       : field.required_for_conformity ? words::required_for_conformity
                                                       : words::asked_for_by,
                       {field.clause});
    }

    static std::vector<Choice> sites() {
        std::vector<Choice> all;
        for (const CertificateSite& site : certificate_sites()) all.push_back({site.key, site.words});
        return all;
    }

    /// "number, mm, [0, 1), default 3 mm, optional".
    std::string facts_of(FieldKind kind, const Unit& unit, const Range& range, const SetupValue& preset,
                         bool optional) const {
        std::string facts = in_.say_declared(kind_words(kind));
        if (kind == FieldKind::number && !(unit == Unit())) facts += ", " + unit.text();
        if (const std::string words = range_words(range, unit); !words.empty()) facts += ", " + words;
        if (const std::string words = value_words(preset); !words.empty())
            facts += ", " + in_.say(words::default_value, {words});
        return facts + (optional ? ", " + in_.say(words::optional) : "");
    }

    ProseBlock stated(const std::string& title, const std::string& key, const std::string& facts,
                      const std::string& help) const {
        ProseBlock block;
        block.spans = {{.text = in_.say_declared(title), .strong = true},
                       {.text = " "},
                       {.text = key, .code = true},
                       {.text = facts.empty() ? "" : " (" + facts + ")"},
                       {.text = help.empty() ? "" : ": " + in_.say_declared(help)}};
        return block;
    }

    void choices(const std::vector<Choice>& choices) {
        std::string words;
        for (const Choice& choice : choices)
            words += (words.empty() ? "" : "; ") + in_.say_declared(choice.title);
        if (words.empty()) return;
        blocks_.push_back(
            ProseBlock{{{.text = in_.say(words::choices), .emphasis = true}, {.text = words + "."}}, "–"});
    }

    void add(const FieldSpec& field) {
        ProseBlock block = stated(
            field.title, field.key,
            facts_of(field.kind, field.unit, field.range, field.default_value, field.optional), field.help);
        block.anchor = field_anchor(page_, field.key);
        blocks_.push_back(std::move(block));
        choices(field.choices);
        for (const ColumnSpec& column : field.columns) {
            ProseBlock item =
                stated(column.title, column.key,
                       facts_of(column.kind, column.unit, column.range, {}, column.optional), column.help);
            item.mark = "–";
            item.anchor = field_anchor(page_, field.key, column.key);
            blocks_.push_back(std::move(item));
            choices(column.choices);
        }
    }

    Blocks& blocks_;
    std::string page_;
    const DocumentLanguage& in_;
};

std::vector<std::string> texts_of(const std::vector<Reference>& references) {
    std::vector<std::string> texts;
    for (const Reference& reference : references) texts.push_back(reference.text);
    return texts;
}

Result<HelpPage> page_of_model(const ModelDescriptor& model, const DocumentLanguage& in) {
    const std::string id = "model-" + model.id;
    auto blocks = blocks_of_file(model.help_page, id, in);
    if (!blocks) return fail(blocks.error());
    HelpPage page{id, title_of(*blocks), std::move(*blocks)};
    FieldWords page_words(page.blocks, id, in);
    if (!model.equations.empty()) page_words.heading(2, in.say(words::equations), "equations-as-evaluated");
    for (const ModelEquation& equation : model.equations)
        page.blocks.push_back(
            EquationBlock{in.say(equation.text), in.say(equation.source), equation.formula});
    page_words.fields(model.schema);
    page_words.list(words::notes, model.notes);
    page_words.list(words::references, texts_of(model.references));
    if (const auto scope = model_scope(model.id); scope && in.code() == "en") {  // the dossier is in English
        page_words.list(words::covered, scope->covered);
        page_words.list(words::not_covered, scope->not_covered);
        page.blocks.push_back(ProseBlock{{{.text = "The evidence for this model is in the dossier: "},
                                          {.text = "covaria verify --dossier dossier.pdf", .code = true},
                                          {.text = "."}}});
    }
    return page;
}

HelpPage page_of_asset(const AssetDescriptor& asset, const DocumentLanguage& in) {
    const std::string id = "asset-" + asset.kind, title = in.say_declared(asset.title);
    HelpPage page{id, title, {HeadingBlock{1, title, id}, ParagraphBlock{in.say_declared(asset.summary)}}};
    FieldWords page_words(page.blocks, id, in);
    page_words.fields(asset.schema);
    page_words.list(words::notes, asset.notes);
    page_words.list(words::references, texts_of(asset.references));
    return page;
}

HelpPage options_page(const DocumentLanguage& in) {
    HelpPage page{"options", in.say(words::options), {}};
    page.blocks.push_back(HeadingBlock{1, page.title, page.id});
    FieldWords(page.blocks, page.id, in).options();
    return page;
}

HelpPage certificate_page(const DocumentLanguage& in) {
    HelpPage page{"certificate", in.say(words::certificate), {}};
    page.blocks = {HeadingBlock{1, page.title, page.id}, ParagraphBlock{in.say(words::about_certificate)}};
    FieldWords(page.blocks, page.id, in).certificate();
    return page;
}

}  // namespace

std::string field_anchor(const std::string& page, const std::string& field, const std::string& column) {
    return page + "-field-" + field + (column.empty() ? "" : "-" + column);
}

Result<HelpPage> shipped_page(const std::string& id, const DocumentLanguage& in) {
    auto blocks = blocks_of_file(id + ".md", id, in);
    if (!blocks) return fail(blocks.error());
    const std::string title = title_of(*blocks);
    return HelpPage{id, title, std::move(*blocks)};
}

Result<std::vector<HelpPage>> help_pages(const DocumentLanguage& in) {
    std::vector<HelpPage> pages;
    const auto add = [&](Result<HelpPage> page) -> Result<void> {
        if (!page) return fail(page.error());
        pages.push_back(std::move(*page));
        return {};
    };
    for (const char* id : {"first-steps", "analysis", "results", "release", "scene"})
        if (auto added = add(shipped_page(id, in)); !added) return fail(added.error());
    pages.push_back(options_page(in));
    pages.push_back(certificate_page(in));
    for (const ModelDescriptor& model : model_registry())
        if (auto added = add(page_of_model(model, in)); !added) return fail(added.error());
    for (const AssetDescriptor& asset : asset_registry()) pages.push_back(page_of_asset(asset, in));
    if (auto added = add(shipped_page("glossary", in)); !added) return fail(added.error());
    return pages;
}

}  // namespace covaria
