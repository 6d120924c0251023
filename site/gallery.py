"""Makes the pages of the gallery: one for each case, of its README, its files and its numbers, and one that shows them all."""
import html
import re
import tomllib

from dialect import translate
from staging import shown

# In the order of docs/README.md: what fibers do, what becomes of fields, what is measured.
GROUPS = {
    "shear_cell": "Fibers in a sheared cell", "cluster": "Packed fibers", "rheometer": "Viscosity of fibers in melt", "orientation": "Orientation at a point",
    "attrition": "Lengths at a point", "properties": "Stiffness", "measurement": "Measured fibers",
    "calibration": "Calibration", "molding": "Parts that fill",
}
IMAGE = re.compile(r"!\[(?P<text>[^]]*)\]\((?P<file>[^)]+)\)")


def cases(root):
    """Returns the folders of the gallery, in its order."""
    return sorted(file.parent for file in (root / "cases").glob("*/case.toml"))


def read(folder, name):
    """Returns a TOML file of a case, or nothing where there is none."""
    file = folder / name
    return tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}


def split(text):
    """Returns the title of a page and what follows it."""
    title, _, body = text.partition("\n")
    return title.removeprefix("# ").strip(), body


def short_name(folder):
    """Tells what the test runs: the variant that shortens a case, or the case itself."""
    return "the variant `short`" if "short" in read(folder, "variants.toml") else "the case"


def expectations(folder):
    """Returns the table of the numbers that a test expects."""
    rows = [f"| `{key}` | {value:.6g} | {tolerance:.2g} |" for key, (value, tolerance) in read(folder, "expected.toml").items()]
    if not rows:
        return ""
    return "\n".join(["\n## Expected numbers\n", f"A test runs {short_name(folder)} and finds these keys of `summary.json`:\n",
                      "| key | value | tolerance |", "| --- | --- | --- |", *rows, ""])


def files(stage, folder):
    """Returns the sections that show the files of a case, and a list of those that stand on pages of their own."""
    text = f"\n## The case\n\n`case.toml`\n\n{shown(folder / 'case.toml')}"
    if (folder / "variants.toml").exists():
        text += f"\n## Its variants\n\n`variants.toml`, for `--variant NAME`:\n\n{shown(folder / 'variants.toml')}"
    others = [file for file in sorted(folder.iterdir()) if file.suffix in {".py", ".csv", ".toml"} and file.name not in
              {"case.toml", "variants.toml", "expected.toml"}]
    links = [f"[{file.name}]({stage.add_file(file.relative_to(stage.root).as_posix(), file.name)})" for file in others]
    return text + (f"\n## Its other files\n\n{', '.join(links)}\n" if links else "")


def add_case(stage, folder, picture):
    """Adds the page of a case; picture is its file and what it shows, or nothing."""
    title, body = split((folder / "README.md").read_text(encoding="utf-8"))
    name = f"cases/{folder.name}/README.md"
    head = f"# {title}\n"
    if picture:
        head += f"\n![{picture.shows}](../../pictures/{picture.file.name})\n\n*{picture.shows}*\n{{ .caption }}\n"
    body = stage.with_links(name, body)
    text = head + f"\n`fiberfate new {folder.name}` copies this case.\n" + body
    stage.write(name, translate(text + expectations(folder) + files(stage, folder)))
    return title


def first_sentence(body):
    """Returns the first sentence of a page as plain text."""
    paragraph = next(block for block in body.strip().split("\n\n") if not block.startswith(("!", "|", "    ")))
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", " ".join(paragraph.split())).replace("`", "").replace("**", "")
    return re.split(r"(?<=[a-z0-9)])[.:] (?=[A-Z])", plain)[0].rstrip(".:") + "."


def card(folder, picture):
    """Returns the card of a case: its picture, its title, its first sentence."""
    title, body = split((folder / "README.md").read_text(encoding="utf-8"))
    own = IMAGE.search(body)
    is_fit = read(folder, "case.toml")["study"] == "calibration"
    if own and (is_fit or not picture):
        source = f"{folder.name}/{own['file']}"
    else:
        source = f"../pictures/{picture.file.name}" if picture else ""
    image = f'<img src="{source}" alt="" loading="lazy">' if source else ""
    return (f'<a class="card" href="{folder.name}/index.html">{image}<strong>{html.escape(title)}</strong>'
            f"<span>{html.escape(first_sentence(body))}</span></a>")


def by_group(folders):
    """Yields the title of every group of studies and its cases."""
    for study, title in GROUPS.items():
        yield title, [folder for folder in folders if read(folder, "case.toml")["study"] == study]


def gallery(folders, pictures):
    """Returns the page that shows all cases."""
    text = ("# Gallery\n\nEvery case is an example, a test and a page at once: `fiberfate new NAME` copies it, and a test runs it, "
            "shortened, against its numbers. Most pictures are drawn from these short runs.\n")
    for title, members in by_group(folders):
        cards = "\n".join(card(folder, pictures.get(folder.name)) for folder in members)
        text += f'\n## {title}\n\n<div class="cards">\n{cards}\n</div>\n'
    return text
