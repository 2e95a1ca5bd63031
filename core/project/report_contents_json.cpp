#include "core/project/report_contents_json.h"

namespace covaria {

namespace {

std::vector<std::string> read_texts(ObjectReader& reader, const char* key) {
    std::vector<std::string> texts;
    const Json* list = reader.list(key);
    for (std::size_t i = 0; list && i < list->size(); ++i) {
        const Json& item = (*list)[i];
        if (item.is_string())
            texts.push_back(item.get<std::string>());
        else
            reader.problems().error(reader.path_of(key) + "/" + std::to_string(i),
                                    "a text is needed here, not " + json_words(item));
    }
    return texts;
}

void write_texts(JsonWriter& out, const char* key, const std::vector<std::string>& texts) {
    if (texts.empty()) return;
    out.key(key);
    out.begin_list(JsonWriter::Style::one_line);
    for (const std::string& text : texts) out.text(text);
    out.end();
}

}  // namespace

ReportContents report_contents_from_json(const Json& value, const std::string& path, Problems& problems) {
    ReportContents contents;
    ObjectReader reader(value, path, "the contents of the report", problems);
    contents.without_analyses = read_texts(reader, "withoutAnalyses");
    contents.without_chapters = read_texts(reader, "withoutChapters");
    contents.annex = reader.flag("annex").value_or(false);
    reader.refuse_unknown_keys();
    return contents;
}

void write_report_contents(JsonWriter& out, const ReportContents& contents) {
    out.begin_object();
    write_texts(out, "withoutAnalyses", contents.without_analyses);
    write_texts(out, "withoutChapters", contents.without_chapters);
    if (contents.annex) {
        out.key("annex");
        out.boolean(true);
    }
    out.end();
}

}  // namespace covaria
