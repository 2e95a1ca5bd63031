// covaria manual: the manual as one document, and the command line described by itself, for man and for bash.
// Packages contain its output.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/application.h"
#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/version.h"
#include "core/document/document_writers.h"
#include "core/manual/manual.h"
#include "ui/print/pdf_report.h"

namespace covaria {
namespace {

std::vector<const CLI::App*> subcommands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

/// Text as troff reads it: no line is a request, hyphens can be copied.
std::string troff(const std::string& text) {
    std::string out;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\' || c == '-') out += '\\';
        out += c == '\\' ? 'e' : c;
        begins = c == '\n';
    }
    return out;
}

/// Lines as they stand, without filling.
std::string preformatted(const std::string& text) {
    return ".nf\n" + troff(text) + "\n.fi\n";
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

/// "-o, --output FILE".
std::string option_head(const CLI::Option& option) {
    const std::vector<std::string> names = names_of(option);
    if (names.empty()) return option.get_name(true);
    return joined(names, ", ") + (option.get_items_expected_max() > 0 ? " " + option.get_type_name() : "");
}

std::string options_in_troff(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        text += ".TP\n.B " + troff(option_head(*option)) + "\n" + troff(option->get_description()) + "\n";
    }
    return text;
}

std::string man_page(const CLI::App& app) {
    std::string text =
        std::string(".TH COVARIA 1 \"\" \"Covaria ") + version() + "\" \"User Commands\"\n.SH NAME\n" +
        "covaria \\- measurement uncertainty of robots and large\\-scale metrology\n.SH SYNOPSIS\n" +
        ".B covaria\n[\\fIFILE\\fR]\n.br\n.B covaria\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" +
        troff(app.get_description()) + "\n.SH OPTIONS\n" + options_in_troff(app) + ".SH COMMANDS\n";
    for (const CLI::App* command : subcommands_of(app))
        text += ".SS " + troff(command->get_name()) + "\n" + troff(command->get_description()) + "\n" +
                options_in_troff(*command) +
                (command->get_footer().empty() ? "" : ".P\n" + preformatted(command->get_footer()));
    return text + ".SH NOTES\n" + preformatted(app.get_footer());
}

/// Words that a command completes; files where none fits.
std::string completion_words(const CLI::App& app) {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : names_of(*option)) words.push_back(name);
    for (const CLI::App* command : subcommands_of(app)) words.push_back(command->get_name());
    return joined(words, " ");
}

std::string bash_completion(const CLI::App& app) {
    std::string cases;
    for (const CLI::App* command : subcommands_of(app))
        cases += "        " + command->get_name() + ") words='" + completion_words(*command) + "' ;;\n";
    return "# bash completion of covaria " + std::string(version()) +
           "\n_covaria() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} words=\n"
           "    case ${COMP_WORDS[1]} in\n" +
           cases + "        *) [ \"$COMP_CWORD\" -eq 1 ] && words='" + completion_words(app) +
           "' ;;\n"
           "    esac\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\") $(compgen -f -- \"$current\"))\n"
           "}\n"
           "complete -o filenames -F _covaria covaria\n";
}

std::vector<CommandWords> command_words(const CLI::App& app) {
    std::vector<CommandWords> all;
    for (const CLI::App* command : subcommands_of(app)) {
        all.push_back({command->get_name(), command->get_description(), {}, command->get_footer()});
        for (const CLI::Option* option : command->get_options())
            all.back().options.emplace_back(option_head(*option), option->get_description());
    }
    return all;
}

Result<std::string> manual(const CLI::App& app, const std::string& form) {
    const auto document = build_manual(command_words(app));
    if (!document) return fail(document.error());
    if (form == "html") return to_html(*document);
    const auto application = make_application(Platform::offscreen);
    return ui::pdf_bytes(*document, {});
}

struct ManualArguments {
    std::string form, output;
};

Result<void> write_form(const CLI::App& app, const ManualArguments& wanted) {
    const bool whole = wanted.form == "html" || wanted.form == "pdf";
    const auto text = whole                       ? manual(app, wanted.form)
                      : wanted.form == "man-page" ? Result<std::string>(man_page(app))
                                                  : Result<std::string>(bash_completion(app));
    if (!text) return fail(text.error());
    if (!whole && wanted.output.empty()) {
        std::fputs(text->c_str(), stdout);
        return {};
    }
    const std::string file = wanted.output.empty() ? "covaria-manual." + wanted.form : wanted.output;
    if (auto written = write_file_atomically(file, *text); !written) return written;
    std::printf("the %s is in %s\n", whole ? "manual" : wanted.form.c_str(), file.c_str());
    return {};
}

}  // namespace

Command manual_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "manual",
        "Write the manual as HTML or PDF; print the command line as a man page or as a completion for bash");
    add_examples(*command, {{"manual html -o manual.html"},
                            {"manual bash-completion -o completion", "to be read by bash"}});
    const std::vector<std::string> forms = {"html", "pdf", "man-page", "bash-completion"};
    auto wanted = std::make_shared<ManualArguments>();
    command->add_option("FORM", wanted->form, "html, pdf, man-page or bash-completion")
        ->required()
        ->check(CLI::IsMember(forms));
    command
        ->add_option("-o,--output", wanted->output,
                     "file to write; without it covaria-manual.html or .pdf here, and the others are printed")
        ->type_name("FILE");
    return {command, [&app, wanted](const std::stop_token&) {
                const auto written = write_form(app, *wanted);
                if (written) return int(exit_success);
                print_error(written.error());
                return exit_status_of(written.error());
            }};
}

}  // namespace covaria
