#!/usr/bin/env python3
"""Completions and manual agree with the help of every command, and work in real shells and in man.

Called by ctest: completion_test.py PROGRAM. Shells and groff that are not installed are left out, with a message.
"""
import re
import shutil
import subprocess
import sys
import tempfile

program = sys.argv[1]
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)


def output(*arguments, **more):
    done = subprocess.run(arguments, capture_output=True, text=True, timeout=100, **more)
    check(done.returncode == 0, f"{arguments}: status {done.returncode}, {done.stderr}")
    return done.stdout


class Help:
    """Content of a page of help, read from its text."""

    def __init__(self, *command):
        text = output(program, *command, "--help")
        self.options = {}  # name: words that its value can be, None for a flag
        for line in text.splitlines():
            entry = re.match(r"  (-[-\w,]+)(.*)", line)
            if not entry:
                continue
            words = re.search(r"\{([^}]*)\}", entry[2].split("  ")[0])
            for name in entry[1].split(","):
                self.options[name] = words[1].split(",") if words else []
        self.commands = re.findall(r"^  (\w+) ", text.split("Subcommands:")[1], re.M) if "Subcommands:" in text else []


top = Help()
helps = {}
for whole in top.commands:
    helps[whole] = Help(whole)
    for part in helps[whole].commands:
        helps[f"{whole} {part}"] = Help(whole, part)
check(len(helps) > 15, f"only {len(helps)} commands were found in the help")
check(sum(len(h.options) for h in helps.values()) > 60, "hardly an option was found in the help")
check("--json" not in helps["step"].options, "a hidden option is in the help")

scripts = {shell: output(program, "completion", shell) for shell in ("bash", "zsh", "fish")}
folder = tempfile.TemporaryDirectory()
paths = {}
for shell, text in scripts.items():
    paths[shell] = f"{folder.name}/completion.{shell}"
    with open(paths[shell], "w") as file:
        file.write(text)


def bash(*words):
    """Proposals of a real bash for the last of the words."""
    quoted = " ".join(f"'{word}'" for word in words)
    script = (f"source {paths['bash']}; complete -p jointwise >/dev/null || exit 3; COMP_WORDS=({quoted}); "
              f"COMP_CWORD={len(words) - 1}; _jointwise; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    return set(output("bash", "--norc", "-euc", script).split())


def proposals_are_right(complete, shell):
    """@param complete  words -> proposals for the last one"""
    check(complete("jointwise", "") >= set(top.commands), f"{shell} does not propose all commands")
    check(complete("jointwise", "ins") == {"inspect"}, f"{shell} does not complete 'ins'")
    check(complete("jointwise", "completion", "") >= {"bash", "zsh", "fish"}, f"{shell}: shells are not proposed")
    check(complete("jointwise", "render", "x", "--fp") == {"--fps"}, f"{shell} does not complete --fp")
    check(complete("jointwise", "inspect", "--coordinates", "omega-l") == {"omega-local"},
          f"{shell} does not complete a choice: {complete('jointwise', 'inspect', '--coordinates', 'omega-l')}")


proposals_are_right(bash, "bash")
check(bash("jointwise", "") == set(top.commands), "bash proposes what is no command")
check(bash("jointwise", "-") == set(top.options), f"bash proposes other options than the help: {bash('jointwise', '-')}")
check(bash("jointwise", "step", "fi") == set(), "bash proposes words where a file is expected")
check(bash("jointwise", "render", "x", "--out", "") == set(), "bash proposes words where a folder is expected")
check(bash("jointwise", "--language", "en", "step", "--u") == {"--until"}, "an option before the command irritates bash")
for command, page in helps.items():
    expected = set(page.options) | set(top.options) - {"--version"}
    proposed = bash("jointwise", *command.split(), "-") - {"--version"}
    if page.commands:
        check(bash("jointwise", command, "") == set(page.commands), f"bash, {command}: not its parts")
    check(proposed == expected, f"bash, {command}: {proposed ^ expected}")
    for name, words in page.options.items():
        if words:
            check(bash("jointwise", *command.split(), name, "") == set(words), f"bash, {command} {name}: not its words")

for shell in ("zsh", "fish"):
    if shutil.which(shell):
        output(shell, "-n", paths[shell])
    else:
        print(f"{shell} is not there: its script is not run")
if shutil.which("fish"):
    def fish(*words):
        quoted = " ".join(word or "" for word in words)
        text = output("fish", "--no-config", "-c", f"source {paths['fish']}; complete -C \"{quoted}\"", cwd=folder.name)
        return {line.split("\t")[0] for line in text.splitlines()}
    proposals_are_right(fish, "fish")

manual = output(program, "manual")
plain = manual.replace("\\-", "-").replace("\\fB", "").replace("\\fR", "").replace("\\fI", "")
for command, page in {"": top, **helps}.items():
    section = plain
    if command:
        check(f".SS {command}\n" in plain, f"manual: no section {command}")
        section = plain.split(f".SS {command}\n")[1].split("\n.S")[0]
        branch = re.search(rf"^ +{command.split()[-1]}\) _arguments((?:.|\n)*?)(?: ;;|; then case .*)$", scripts["zsh"], re.M)
        check(branch, f"zsh: no branch {command}")
    for name, words in page.options.items():
        check(re.search(rf"^{name}\b|, {name}\b", section, re.M), f"manual: {command} {name} is missing")
        if not command:
            continue
        check(branch and f"'{name}[" in branch[1].replace("'*", "'"), f"zsh: {command} {name} is missing")
        flag = f"-l {name[2:]} " if name.startswith("--") else f"-s {name[1:]} "
        lines = [line for line in scripts["fish"].splitlines() if f"from {command.replace(' ', '; and __fish_seen_subcommand_from ')}'" in line and flag in line]
        check(len(lines) == 1, f"fish: {command} {name} is there {len(lines)} times")
        for word in words:
            check(word in section, f"manual: {command} {name} {word} is missing")
            check(lines and re.search(rf"[' ]{re.escape(word)}[' ]", lines[0]), f"fish: {command} {name} {word} is missing")

if shutil.which("groff"):
    def warnings(page):
        done = subprocess.run(["groff", "-man", "-Tutf8", "-Kutf8", "-ww", "-z"], input=page, capture_output=True, text=True)
        return done.stderr
    check(warnings(manual) == "", f"groff warns: {warnings(manual)}")
    check(warnings(manual + "\\fX\n.nosuch\n") != "", "groff warns of nothing at all")
else:
    print("groff is not there: the manual is not set")
wrong = subprocess.run([program, "completion", "tcsh"], capture_output=True, text=True)
check(wrong.returncode == 2 and "bash" in wrong.stderr and not wrong.stdout, f"tcsh: {wrong.stderr}")

for failure in failures:
    print(f"completion test: {failure}")
if not failures:
    print("completions and manual know every option")
sys.exit(1 if failures else 0)
