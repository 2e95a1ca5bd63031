#include "core/manual/help_page.h"

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/manual/markdown.h"
#include "core/project/certificate.h"
#include "core/project/option_fields.h"
#include "core/setup/field_words.h"

namespace covaria {
namespace {

using Blocks = std::vector<ReportBlock>;

Result<Blocks> blocks_of_file(const std::string& file, const std::string& page) {
    const std::filesystem::path folder = data_directory() / "resources" / "help";
    const auto text = read_file(folder / file);
    if (!text) return fail(text.error());
    return blocks_of_markdown(*text, page, folder);
}

std::string title_of(const Blocks& blocks) {
    for (const ReportBlock& block : blocks)
        if (const auto* heading = std::get_if<HeadingBlock>(&block)) return heading->text;
    return {};
}

/// "number, mm, [0, 1), default 3 mm, optional".
std::string facts_of(FieldKind kind, const Unit& unit, const Range& range, const SetupValue& preset,
                     bool optional) {
    std::string facts = kind_words(kind);
    if (kind == FieldKind::number && !(unit == Unit())) facts += ", " + unit.text();
    if (const std::string words = range_words(range, unit); !words.empty()) facts += ", " + words;
    if (const std::string words = value_words(preset); !words.empty()) facts += ", default " + words;
    return facts + (optional ? ", optional" : "");
}

ProseBlock stated(const std::string& title, const std::string& key, const std::string& facts,
                  const std::string& help) {
    ProseBlock block;
    block.spans = {{.text = title, .strong = true},
                   {.text = " "},
                   {.text = key, .code = true},
                   {.text = " (" + facts + ")"},
                   {.text = help.empty() ? "" : ": " + help}};
    return block;
}

void add_choices(Blocks& blocks, const std::vector<Choice>& choices) {
    std::string words;
    for (const Choice& choice : choices) words += (words.empty() ? "" : "; ") + choice.title;
    if (!words.empty())
        blocks.push_back(ProseBlock{{{.text = "Choices: ", .emphasis = true}, {.text = words + "."}}, "–"});
}

void add_field(Blocks& blocks, const std::string& page, const FieldSpec& field) {
    ProseBlock block = stated(
        field.title, field.key,
        facts_of(field.kind, field.unit, field.range, field.default_value, field.optional), field.help);
    block.anchor = field_anchor(page, field.key);
    blocks.push_back(std::move(block));
    add_choices(blocks, field.choices);
    for (const ColumnSpec& column : field.columns) {
        ProseBlock item =
            stated(column.title, column.key,
                   facts_of(column.kind, column.unit, column.range, {}, column.optional), column.help);
        item.mark = "–";
        item.anchor = field_anchor(page, field.key, column.key);
        blocks.push_back(std::move(item));
        add_choices(blocks, column.choices);
    }
}

void add_fields(Blocks& blocks, const std::string& page, const SetupSchema& schema) {
    blocks.push_back(HeadingBlock{2, "Fields of the set-up", page + "-fields-of-the-set-up"});
    std::string section;
    for (const FieldSpec& field : schema.fields()) {
        if (field.section != section)
            blocks.push_back(
                HeadingBlock{3, section = field.section, page + "-section-" + anchor_words(section)});
        add_field(blocks, page, field);
    }
}

void add_list(Blocks& blocks, const std::string& page, const std::string& title,
              const std::vector<std::string>& items) {
    if (items.empty()) return;
    blocks.push_back(HeadingBlock{2, title, page + "-about-" + anchor_words(title)});
    blocks.push_back(ListBlock{items});
}

std::vector<std::string> texts_of(const std::vector<Reference>& references) {
    std::vector<std::string> texts;
    for (const Reference& reference : references) texts.push_back(reference.text);
    return texts;
}

}  // namespace

std::string field_anchor(const std::string& page, const std::string& field, const std::string& column) {
    return page + "-field-" + field + (column.empty() ? "" : "-" + column);
}

Result<HelpPage> help_page(const ModelDescriptor& model) {
    const std::string id = "model-" + model.id;
    auto blocks = blocks_of_file(model.help_page, id);
    if (!blocks) return fail(blocks.error());
    HelpPage page{id, title_of(*blocks), std::move(*blocks)};
    if (!model.equations.empty())
        page.blocks.push_back(HeadingBlock{2, "Equations as evaluated", id + "-equations-as-evaluated"});
    for (const ModelEquation& equation : model.equations)
        page.blocks.push_back(EquationBlock{equation.text, equation.source, equation.formula});
    add_fields(page.blocks, id, model.schema);
    add_list(page.blocks, id, "Notes", model.notes);
    add_list(page.blocks, id, "References", texts_of(model.references));
    return page;
}

HelpPage help_page(const AssetDescriptor& asset) {
    const std::string id = "asset-" + asset.kind;
    HelpPage page{id, asset.title, {HeadingBlock{1, asset.title, id}, ParagraphBlock{asset.summary}}};
    add_fields(page.blocks, id, asset.schema);
    add_list(page.blocks, id, "Notes", asset.notes);
    add_list(page.blocks, id, "References", texts_of(asset.references));
    return page;
}

HelpPage options_page() {
    HelpPage page{"options", "Options of the evaluation", {}};
    page.blocks.push_back(HeadingBlock{1, page.title, page.id});
    for (const OptionField& field : option_fields()) {
        ProseBlock block;
        block.spans = {{.text = field.title, .strong = true},
                       {.text = " "},
                       {.text = field.key, .code = true},
                       {.text = std::string(": ") + field.help}};
        block.anchor = field_anchor(page.id, field.key);
        page.blocks.push_back(std::move(block));
        add_choices(page.blocks, field.choices);
    }
    return page;
}

HelpPage certificate_page() {
    HelpPage page{"certificate", "Certificate", {}};
    page.blocks.push_back(HeadingBlock{1, page.title, page.id});
    page.blocks.push_back(
        ParagraphBlock{"What a calibration certificate says beside its results, with the clause of "
                       "ISO/IEC 17025:2017 that asks for it."});
    for (const CertificateSection& section : certificate_sections()) {
        page.blocks.push_back(HeadingBlock{2, section.title, page.id + "-" + anchor_words(section.title)});
        for (const CertificateField& field : section.fields) {
            const std::string clause =
                *field.clause ? std::string(field.required ? "required by " : "asked for by ") + field.clause
                              : "optional";
            ProseBlock block = stated(field.title, field.key, clause, field.help);
            block.anchor = field_anchor(page.id, anchor_words(pointer_of(field)));
            page.blocks.push_back(std::move(block));
        }
    }
    return page;
}

Result<HelpPage> shipped_page(const std::string& id) {
    auto blocks = blocks_of_file(id + ".md", id);
    if (!blocks) return fail(blocks.error());
    const std::string title = title_of(*blocks);
    return HelpPage{id, title, std::move(*blocks)};
}

Result<std::vector<HelpPage>> help_pages() {
    std::vector<HelpPage> pages;
    const auto add = [&](Result<HelpPage> page) -> Result<void> {
        if (!page) return fail(page.error());
        pages.push_back(std::move(*page));
        return {};
    };
    for (const char* id : {"first-steps", "analysis", "results", "scene"})
        if (auto added = add(shipped_page(id)); !added) return fail(added.error());
    pages.push_back(options_page());
    pages.push_back(certificate_page());
    for (const ModelDescriptor& model : model_registry())
        if (auto added = add(help_page(model)); !added) return fail(added.error());
    for (const AssetDescriptor& asset : asset_registry()) pages.push_back(help_page(asset));
    if (auto added = add(shipped_page("glossary")); !added) return fail(added.error());
    return pages;
}

}  // namespace covaria
