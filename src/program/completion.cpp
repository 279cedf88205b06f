// SPDX-License-Identifier: GPL-3.0-or-later
// What the options and their choices are, for a shell and for the manual: read from the parser that takes them.
#include "commands.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace meridian {
namespace program {

namespace {

// A choice of an option, as `add_choice()` writes it into its help: a line with a name and what it means.
struct Listed_choice
{
  std::string name, meaning;
};

std::vector<Listed_choice> choices_of(const CLI::Option& option)
{
  std::vector<Listed_choice> choices;
  std::istringstream help(option.get_description());
  std::string line;
  std::getline(help, line); // what the option is for
  while (std::getline(help, line))
  {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) { choices.push_back({line.substr(2, colon - 2), line.substr(colon + 2)}); }
  }
  return choices;
}

std::string long_name(const CLI::Option& option)
{
  return option.get_lnames().empty() ? "" : "--" + option.get_lnames().front();
}

void print_bash(const CLI::App& app)
{
  std::ostringstream commands, options, values;
  for (const CLI::App* command : app.get_subcommands({}))
  {
    if (command->get_group().empty()) { continue; }
    commands << ' ' << command->get_name();
    options << "    " << command->get_name() << ") words=\"";
    for (const CLI::Option* option : command->get_options())
    {
      if (long_name(*option).empty()) { continue; }
      options << long_name(*option) << ' ';
      const auto choices = choices_of(*option);
      if (choices.empty()) { continue; }
      values << "    \"" << command->get_name() << ' ' << long_name(*option) << "\") words=\"";
      for (const Listed_choice& c : choices) { values << c.name << ' '; }
      values << "\" ;;\n";
    }
    options << "\" ;;\n";
  }
  std::cout
    << "# bash completion of meridian: source <(meridian completion)\n"
       "_meridian()\n{\n"
       "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=\n"
       "  if [ \"$COMP_CWORD\" = 1 ]; then words=\""
    << commands.str().substr(1)
    << "\"; fi\n"
       "  case \"$command $before\" in\n"
    << values.str()
    << "  esac\n"
       "  if [ -z \"$words\" ]; then case \"$word\" in -*) case \"$command\" in\n"
    << options.str()
    << "  esac ;; esac; fi\n"
       "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
       "}\n"
       "complete -o default -F _meridian meridian\n";
}

// A table for each option that has choices; options that several commands share stand once.
void print_markdown(const CLI::App& app)
{
  std::vector<std::string> titles, tables; // in the order of the first command that has them
  for (const CLI::App* command : app.get_subcommands({}))
    for (const CLI::Option* option : command->get_options())
    {
      std::ostringstream table;
      for (const Listed_choice& c : choices_of(*option))
      {
        table << "| `" << c.name << '`' << (c.name == option->get_default_str() ? " (otherwise)" : "") << " | "
              << c.meaning << " |\n";
      }
      if (table.str().empty()) { continue; }
      const std::string title = '`' + long_name(*option) + "` of ", name = '`' + command->get_name() + '`';
      std::size_t known = 0;
      while (known < tables.size() && (tables[known] != table.str() || titles[known].rfind(title, 0) != 0)) { ++known; }
      if (known < tables.size()) { titles[known] += ", " + name; }
      else
      {
        titles.push_back(title + name);
        tables.push_back(table.str());
      }
    }
  for (std::size_t i = 0; i < tables.size(); ++i)
  {
    std::cout << "| " << titles[i] << " | |\n|---|---|\n" << tables[i] << '\n';
  }
}

} // namespace

Command add_completion(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("completion", "print a script that completes options in bash");
  command->group(""); // for those who install the program
  const auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "print the choices of all options as tables instead");
  return {command, [&app, markdown] {
            if (*markdown) { print_markdown(app); }
            else { print_bash(app); }
            return VERIFIED;
          }};
}

} // namespace program
} // namespace meridian
