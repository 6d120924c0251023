"""The order of the site's pages: first steps, guide, gallery, keys, formats, theory, validation, development."""
import re

from gallery import by_group

GUIDE = ["case_files", "molding", "materials", "process_level", "library"]
DEVELOP = ["building", "architecture", "the_way_of_a_number", "reliability", "performance", "attempts"]
LINK = re.compile(r"\]\(([\w/]+\.md)\)")


def in_order(root, folder, first=()):
    """Returns the pages of a folder of docs/ in the order in which docs/README.md links to them, those of first before."""
    linked = LINK.findall((root / "docs/README.md").read_text(encoding="utf-8"))
    names = [f"{folder}/{name}.md" for name in first]
    names += [name for name in linked if name.startswith(f"{folder}/") and name not in names]
    names += sorted(f"{folder}/{page.name}" for page in (root / "docs" / folder).glob("*.md"))
    return [f"docs/{name}" for name in dict.fromkeys(names)]


def navigation(root, folders):
    """Returns the navigation as mkdocs takes it."""
    gallery = [{title: [f"cases/{folder.name}/README.md" for folder in members]} for title, members in by_group(folders) if members]
    guide = [page for page in in_order(root, "guide", ["first_steps", *GUIDE]) if not page.endswith("case_keys.md")]
    develop = [page for page in in_order(root, "develop", DEVELOP) if not page.endswith("/validation.md")]
    return [
        {"Home": ["index.md", {"All pages": "docs/README.md"}]},
        {"Guide": guide},
        {"Gallery": ["cases/index.md", *gallery]},
        {"Keys": "docs/guide/case_keys.md"},
        {"Formats": in_order(root, "formats")},
        {"Theory": in_order(root, "theory")},
        {"Validation": "docs/develop/validation.md"},
        {"Development": [*develop, "CONTRIBUTING.md", "CHANGELOG.md"]},
    ]
