"""Draws a campaign's one figure as SVG: dots along rows, or bars."""
from html import escape

COLOURS = ["#3b6fb6", "#c8553d", "#4a9a6c", "#8b62a8", "#b08a2e", "#5a5a5a", "#2aa3a3", "#a33a6b"]
WIDTH, LEFT, ROW, TOP = 760, 190, 24, 56


def text(x, y, words, anchor="start", size=12):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}">{escape(str(words))}</text>'


def fitting(title):
    """The size in which a title is as wide as the figure, or 14."""
    return min(14, 1.8 * (WIDTH - 24) / max(len(title), 1))


def write(path, title, height, parts):
    path.parent.mkdir(parents=True, exist_ok=True)
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" '
            'font-family="sans-serif" fill="#222"><rect width="100%" height="100%" fill="white"/>')
    path.write_text("\n".join([head, text(12, 22, title, size=f"{fitting(title):.1f}"), *parts, "</svg>", ""]), encoding="utf-8")


def legend(kinds):
    parts, x = [], LEFT
    for number, kind in enumerate(kinds):
        parts += [f'<circle cx="{x}" cy="40" r="4" fill="{COLOURS[number % len(COLOURS)]}"/>', text(x + 8, 44, kind, size=11)]
        x += 22 + 6.3 * len(kind)
    return parts


def dots(path, title, label, points):
    """Draws points (row, share from 0 to 1, kind), rows and kinds in the order of their first points."""
    rows = list(dict.fromkeys(row for row, _, _ in points))
    kinds = list(dict.fromkeys(kind for _, _, kind in points))
    span = WIDTH - LEFT - 30
    parts = legend(kinds)
    for number, row in enumerate(rows):
        y = TOP + ROW * number + ROW / 2
        parts += [text(LEFT - 10, y + 4, row, "end"), f'<line x1="{LEFT}" y1="{y}" x2="{LEFT + span}" y2="{y}" stroke="#ddd"/>']
    for number, (row, share, kind) in enumerate(points):
        y = TOP + ROW * rows.index(row) + ROW / 2 + (number % 5 - 2) * 2.5  # apart where they would cover each other
        colour = COLOURS[kinds.index(kind) % len(COLOURS)]
        parts.append(f'<circle cx="{LEFT + span * min(max(share, 0), 1):.1f}" cy="{y:.1f}" r="3" fill="{colour}" fill-opacity="0.7"/>')
    bottom = TOP + ROW * len(rows)
    for share in (0, 0.25, 0.5, 0.75, 1):
        parts.append(text(LEFT + span * share, bottom + 14, f"{share:g}", "middle", 11))
    parts.append(text(LEFT + span / 2, bottom + 32, label, "middle"))
    write(path, title, bottom + 42, parts)


def bars(path, title, counts):
    """Draws stacked bars: {row: {kind: count}}."""
    kinds = list(dict.fromkeys(kind for row in counts.values() for kind in row))
    longest = max((sum(row.values()) for row in counts.values()), default=1) or 1
    span = WIDTH - LEFT - 60
    parts = legend(kinds)
    for number, (name, row) in enumerate(counts.items()):
        y, x = TOP + ROW * number, LEFT
        parts.append(text(LEFT - 10, y + ROW / 2 + 4, name, "end"))
        for kind, count in row.items():
            wide = span * count / longest
            parts.append(f'<rect x="{x:.1f}" y="{y + 4}" width="{wide:.1f}" height="{ROW - 8}" fill="{COLOURS[kinds.index(kind) % len(COLOURS)]}"/>')
            x += wide
        parts.append(text(x + 6, y + ROW / 2 + 4, sum(row.values()), size=11))
    write(path, title, TOP + ROW * len(counts) + 12, parts)


def curves(path, title, across, up, lines):
    """Draws curves {name: [(x from 0 to 1, y)]} over one another."""
    span, height = WIDTH - LEFT - 30, 260
    top = 1.1 * max((y for points in lines.values() for _, y in points), default=1)
    parts = legend(list(lines))
    for number in range(5):
        y = TOP + height * (1 - number / 4)
        parts += [f'<line x1="{LEFT}" y1="{y}" x2="{LEFT + span}" y2="{y}" stroke="#ddd"/>', text(LEFT - 8, y + 4, f"{top * number / 4:.3g}", "end", 11)]
    for number, points in enumerate(lines.values()):
        kept = points[::max(1, len(points) // 200)]
        way = " ".join(f"{LEFT + span * x:.1f},{TOP + height * (1 - y / top):.1f}" for x, y in kept)
        parts.append(f'<polyline points="{way}" fill="none" stroke="{COLOURS[number % len(COLOURS)]}" stroke-width="1.5"/>')
    parts += [text(LEFT + span / 2, TOP + height + 30, across, "middle"), text(LEFT - 60, TOP + height / 2, up, "end")]
    write(path, title, TOP + height + 44, parts)
