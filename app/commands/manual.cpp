// covaria manual: the command line described by itself, for man and for bash. What is packaged is made by it.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "core/base/version.h"

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

std::string options_in_troff(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        const std::vector<std::string> names = names_of(*option);
        const std::string value =
            option->get_items_expected_max() > 0 && !names.empty() ? " " + option->get_type_name() : "";
        const std::string head = names.empty() ? option->get_name(true) : joined(names, ", ") + value;
        text += ".TP\n.B " + troff(head) + "\n" + troff(option->get_description()) + "\n";
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
                options_in_troff(*command);
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

}  // namespace

Command manual_command(CLI::App& app) {
    static const std::map<std::string, std::function<std::string(const CLI::App&)>> forms = {
        {"man-page", man_page}, {"bash-completion", bash_completion}};
    CLI::App* command =
        app.add_subcommand("manual", "Print the command line as a man page or as a completion for bash");
    std::vector<std::string> names;
    for (const auto& [name, form] : forms) names.push_back(name);
    auto wanted = std::make_shared<std::string>();
    command->add_option("FORM", *wanted, joined(names, " or "))->required()->check(CLI::IsMember(names));
    return {command, [&app, wanted](const std::stop_token&) {
                std::fputs(forms.at(*wanted)(app).c_str(), stdout);
                return exit_success;
            }};
}

}  // namespace covaria
