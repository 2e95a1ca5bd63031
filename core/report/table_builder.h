// Grows a table of a document out of columns of the tables of a result and its own.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/document/report_document.h"
#include "core/result/uncertainty_result.h"
#include "core/text/document_language.h"
#include "core/views/result_words.h"

namespace covaria::report_parts {

/// Grows a table of the document, in a language that outlives it: heads are said as they are added.
class TableBuilder {
public:
    TableBuilder(std::string id, const Message& title,
                 const DocumentLanguage& in = DocumentLanguage::english());
    Column& text(const Message& head, bool symbol_cells = false);
    /// Adds a column of numbers; its role is set on the column that is returned. `key` is the key by which
    /// the rules of others find it.
    Column& number(const Message& head, const std::string& key = {});
    Column& symbol(const std::string& head, const std::string& key = {});
    Column& fixed(const Message& head, int decimals);
    /// Adds those columns of a table as print has them, with all that the rules of their numbers read.
    void columns(const Table& table, const std::vector<std::string>& keys);
    /// Adds a row of the table that the columns are from.
    void row_of(const Table& table, std::size_t row);
    /// Adds those columns of a table and all its rows.
    void all_of(const Table& table, const std::vector<std::string>& keys);
    /// Adds those columns of the table of results, and the rows of these outputs under sub-heads of their
    /// groups.
    void results(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                 const std::vector<std::string>& keys);
    void row(std::vector<Cell> cells) { block_.table.row(std::move(cells)); }
    /// Adds a row that has cells only in the columns of these keys.
    void row_with(std::map<std::string, Cell> cells);
    void subhead(const Message& text) { block_.table.subhead(in_.say(text)); }
    void note(const Message& text) { block_.table.notes.push_back(in_.say(text)); }
    TableBlock take() { return std::move(block_); }

private:
    Column& add(const std::string& key, Text head);
    const DocumentLanguage& in_;
    TableBlock block_;
};

}  // namespace covaria::report_parts
