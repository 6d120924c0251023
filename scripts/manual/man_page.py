"""The manual page fiberfate(1) in troff."""
import textwrap

WIDTH = 72


def escaped(text):
    """Makes text safe for troff: backslashes, hyphens of options, and lines that begin with a control character."""
    safe = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in safe.split("\n"))


def literal(lines):
    """Shows lines as they are, but for long lists."""
    shown = [part for line in lines
             for part in (textwrap.wrap(line, WIDTH, subsequent_indent="  ") if ", " in line else [line])]
    return [".PP", ".nf", ".RS 4", *map(escaped, shown), ".RE", ".fi"]


def option_lines(option):
    names = ", ".join(f"\\fB{escaped(name)}\\fR" for name in option.names)
    value = f" \\fI{escaped(option.value)}\\fR" if option.value else ""
    return [".TP", names + value, escaped(option.text)]


def command_lines(command):
    words = " ".join(f"\\fI{escaped(one.value or one.names[0])}\\fR" for one in command.arguments)
    lines = [f".SS \"fiberfate {command.name}\"", f"\\fBfiberfate {command.name}\\fR [\\fIOPTIONS\\fR] {words}", ".PP",
             escaped(command.summary) + "."]
    for option in command.options:
        if "--help" not in option.names:
            lines += option_lines(option)
    return lines + (literal(command.footer.split("\n")) if command.footer else [])


def man_page(commands, overview, statuses, version):
    """Writes the page; `overview` is what the program says of itself, `statuses` are pairs of an exit status and what it means."""
    title, *session = overview
    lines = [f".TH FIBERFATE 1 \"\" \"fiberfate {version}\" \"User Commands\"", ".SH NAME",
             "fiberfate \\- predict what becomes of the fibers when a fiber composite is processed", ".SH SYNOPSIS",
             "\\fBfiberfate\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]", ".SH DESCRIPTION", escaped(title)]
    lines += literal([line for line in session if line.strip()])
    lines += [".SH COMMANDS"]
    for command in commands:
        lines += command_lines(command)
    lines += [".SH EXIT STATUS"]
    for status, meaning in statuses:
        lines += [".TP", f"\\fB{status}\\fR", meaning]
    lines += [".SH SEE ALSO", "The pages and worked cases below \\fI/usr/share/doc/fiberfate\\fR, and"
              " \\fBfiberfate explain\\fR."]
    return "\n".join(lines) + "\n"
