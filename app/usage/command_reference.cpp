#include "app/usage/command_reference.h"

#include "app/cli/command_definition.h"

namespace limitgauge::app {

OptionReference CommandDefinition::reference(const CLI::Option& option) const {
  OptionReference said;
  said.positional = option.get_positional();
  if (said.positional) said.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) said.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) said.names.push_back("--" + name);
  said.required = option.get_required();
  const bool has_value = option.get_items_expected_max() > 0;
  said.repeatable = has_value && option.get_items_expected_max() > 1;
  if (has_value) said.value = option.get_type_name();
  said.summary = option.get_description();
  if (const auto found = hints_.find(&option); found != hints_.end()) said.hint = found->second;
  return said;
}

CommandReference CommandDefinition::reference(const CLI::App& app) const {
  CommandReference said{app.get_name(), app.get_description(), {}, {}};
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) said.options.push_back(reference(*option));
  const auto subs = app.get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* sub : subs) said.commands.push_back(reference(*sub));
  return said;
}

CommandReference CommandDefinition::reference() const {
  return reference(app_);
}

CommandReference command_reference() {
  return CommandDefinition().reference();
}

}  // namespace limitgauge::app
