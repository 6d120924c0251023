"""Completions of the command line for bash, zsh and fish."""
import re

# What the values of an option or argument are: of these the shells know files and folders by themselves.
FILES = {"CASE.toml"}
FOLDERS = {"DIR", "LEGACY_DIR"}


def words_of(text):
    """Reads the values that a text lists: "auto, line (for a terminal), log, none"."""
    listed = re.sub(r"\([^)]*\)", "", text.rpartition(":")[2])
    words = re.split(r",| or ", listed)
    return [word.strip() for word in words if re.fullmatch(r"\s*[a-z_]+\s*", word)]


class Values:
    """Tells what may stand for a value."""

    def __init__(self, keys, studies, gallery):
        self.keys, self.names = keys, studies + gallery
        self.topics = studies + keys

    def of(self, option):
        """Gives a kind ("file", "folder", "words", "key=") and words."""
        if option.value in FILES:
            return "file", []
        if option.value in FOLDERS:
            return "folder", []
        if option.value == "KEY":
            return "words", self.topics
        if option.value == "STUDY|CASE":
            return "words", self.names
        if option.value.startswith("KEY="):
            return "key=", [f"{key}=" for key in self.keys]
        if option.value in ("KIND", "FORMAT"):
            return "words", words_of(option.text)
        return "", []


def long_names(option):
    return [name for name in option.names if name.startswith("--")]


def bash_value(kind, words):
    if kind == "file":
        return 'COMPREPLY=($(compgen -f -X "!*.toml" -- "$current") $(compgen -d -- "$current")); compopt -o filenames'
    if kind == "folder":
        return 'COMPREPLY=($(compgen -d -- "$current")); compopt -o filenames'
    if kind in ("words", "key="):
        space = "; compopt -o nospace" if kind == "key=" else ""
        return f'COMPREPLY=($(compgen -W "{" ".join(words)}" -- "$current")){space}'
    return "COMPREPLY=()"


def bash_command(command, values):
    options = " ".join(name for option in command.options for name in long_names(option))
    lines = [f"    {command.name})", '      case "$previous" in']
    for option in command.options:
        if option.value:
            names = "|".join(long_names(option))
            lines.append(f"        {names}) {bash_value(*values.of(option))}; return ;;")
    lines += ["      esac", '      if [[ $current == -* ]]; then', f'        COMPREPLY=($(compgen -W "{options}" -- "$current"))',
              "        return", "      fi"]
    if command.arguments:
        lines.append(f"      {bash_value(*values.of(command.arguments[0]))}")
    return lines + ["      ;;"]


def bash(commands, values):
    names = " ".join(command.name for command in commands)
    lines = ["# Completion of fiberfate for bash.", "_fiberfate() {",
             "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}",
             "  if ((COMP_CWORD == 1)); then", f'    COMPREPLY=($(compgen -W "{names} --help --version" -- "$current"))',
             "    return", "  fi", '  case "${COMP_WORDS[1]}" in']
    for command in commands:
        lines += bash_command(command, values)
    return "\n".join(lines + ["  esac", "}", "complete -F _fiberfate fiberfate"]) + "\n"


def zsh_quoted(text):
    return re.sub(r"([\[\]:'])", r"\\\1", text.replace("'", "’"))


def zsh_value(kind, words):
    if kind == "file":
        return "_files -g '*.toml'"
    if kind == "folder":
        return "_files -/"
    if kind == "key=":
        return f"compadd -S '' -- {' '.join(words)}"
    return f"({' '.join(words)})" if kind == "words" else ""


def zsh_command(command, values):
    lines = [f"    {command.name})", "      _arguments \\"]
    for option in command.options:
        for name in long_names(option):
            value = f":{option.value.lower()}:{zsh_value(*values.of(option))}" if option.value else ""
            lines.append(f'        "{name}[{zsh_quoted(option.text)}]{value}" \\')
    for place, argument in enumerate(command.arguments, 1):
        lines.append(f'        "{place}:{argument.names[0]}:{zsh_value(*values.of(argument))}" \\')
    return lines + ["        && return 0", "      ;;"]


def zsh(commands, values):
    lines = ["#compdef fiberfate", "# Completion of fiberfate for zsh.", "_fiberfate() {", "  if ((CURRENT == 2)); then",
             "    local -a commands=("]
    lines += [f"      '{command.name}:{zsh_quoted(command.summary)}'" for command in commands]
    lines += ["    )", "    _describe 'command' commands", "    return", "  fi", "  local command=$words[2]",
              "  shift words", "  ((CURRENT--))", '  case "$command" in']
    for command in commands:
        lines += zsh_command(command, values)
    return "\n".join(lines + ["  esac", "}", "_fiberfate \"$@\""]) + "\n"


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_value(kind, words):
    if kind == "file":
        return "-r -F"
    if kind == "folder":
        return "-x -a '(__fish_complete_directories)'"
    return f"-x -a {fish_quoted(' '.join(words))}" if words else "-x"


def fish(commands, values):
    lines = ["# Completion of fiberfate for fish.", "complete -c fiberfate -f"]
    for command in commands:
        lines.append(f"complete -c fiberfate -n __fish_use_subcommand -a {command.name} -d {fish_quoted(command.summary)}")
        there = f"complete -c fiberfate -n '__fish_seen_subcommand_from {command.name}'"
        for option in command.options:
            value = f" {fish_value(*values.of(option))}" if option.value else ""
            lines += [f"{there} -l {name[2:]}{value} -d {fish_quoted(option.text)}" for name in long_names(option)]
        for argument in command.arguments[:1]:
            lines.append(f"{there} {fish_value(*values.of(argument)).replace('-x', '-f')}")
    return "\n".join(lines) + "\n"
