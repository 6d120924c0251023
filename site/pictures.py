"""Draws a picture of every case of the gallery, from a short run."""
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile

import draw_curves
import draw_fibers
import draw_part
from gallery import cases, read

FEW_FIBERS = 9  # of so few the components of their orientation tell more than a picture of them


@dataclasses.dataclass
class Picture:
    """A picture of a case and what it shows."""
    file: pathlib.Path
    shows: str


def command(program, folder, out):
    """Returns the command that runs a case for its picture: its short variant; of a fit to moldings, one of them."""
    case, options = folder / "case.toml", []
    if (folder / "plaque.toml").exists():
        case = folder / "plaque.toml"
    elif "short" in read(folder, "variants.toml"):
        options = ["--variant", "short"]
    elif read(folder, "case.toml")["study"] == "calibration":
        options = ["--set", "fit.profiles=none"]
    return [program, "run", case, "--out", out, "--progress", "none", "--threads", "1", *options]


def draw(root, folder):
    """Returns the picture of a result and what it shows."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    if summary["study"] == "molding":
        return draw_part.draw(folder)
    if summary["study"] in ("cluster", "shear_cell") and summary["fibers"] > FEW_FIBERS:
        return draw_fibers.draw(root, folder, summary)
    return draw_curves.draw(folder, summary)


def run(program, folder, out):
    """Runs a case; a program that has no threads for it says so, and runs it without."""
    words = command(program, folder, out)
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode == 2 and "--threads" in done.stderr:
        at = words.index("--threads")
        done = subprocess.run(words[:at] + words[at + 2:], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{folder.name}: exit status {done.returncode}\n{done.stderr}")


def is_newer(file, others):
    """Tells whether a file is there and newer than all others."""
    return file.exists() and all(file.stat().st_mtime > other.stat().st_mtime for other in others)


def picture(root, program, folder, pictures):
    """Draws the picture of a case, unless it is there and newer than what it shows."""
    file, words = pictures / f"{folder.name}.svg", pictures / f"{folder.name}.txt"
    causes = [pathlib.Path(program), *folder.glob("*.toml"), *pathlib.Path(__file__).parent.glob("draw*.py")]
    if not (is_newer(file, causes) and words.exists()):
        with tempfile.TemporaryDirectory() as scratch:
            out = pathlib.Path(scratch) / "result"
            run(program, folder, out)
            sheet, shows = draw(root, out)
        shows += ", in plaque.toml" if (folder / "plaque.toml").exists() else ""
        words.write_text(shows, encoding="utf-8")
        file.write_text(sheet.svg(), encoding="utf-8")
    return Picture(file, words.read_text(encoding="utf-8"))


def draw_all(root, program, pictures):
    """Draws the pictures of all cases; returns them by the names of the cases."""
    pictures.mkdir(parents=True, exist_ok=True)
    folders = cases(root)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        drawn = pool.map(lambda folder: picture(root, program, folder, pictures), folders)
        return {folder.name: one for folder, one in zip(folders, drawn)}
