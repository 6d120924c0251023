"""Pictures as SVG: a sheet of shapes, colours, and charts with axes."""
import html
import math

WIDTH, HEIGHT = 640, 400
INK, MUTED, GRID = "#1b1f24", "#59616b", "#e6e8eb"
SERIES = ["#0055a5", "#c64300", "#00b377", "#ad5c94", "#e28500", "#4185eb", "#4c4878", "#7a244e"]  # those of the report
MAPS = {
    "viridis": ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"],
    "tide": ["#f0b440", "#a9bf4e", "#4fae7b", "#2a8f9e", "#3277b5", "#4a57b4"],
}


def colour(name, fraction, fog=0.0):
    """Returns the colour of a fraction in [0, 1], mixed with as much white as fog says."""
    stops = MAPS[name]
    place = min(1.0, max(0.0, fraction)) * (len(stops) - 1)
    below = min(int(place), len(stops) - 2)
    share = place - below
    pair = [[int(stop[at:at + 2], 16) for at in (1, 3, 5)] for stop in stops[below:below + 2]]
    mixed = [a + share * (b - a) for a, b in zip(*pair)]
    return "#" + "".join(f"{round(one + fog * (255 - one)):02x}" for one in mixed)


class Sheet:
    """A white sheet on which shapes are put one over the other."""

    def __init__(self, width=WIDTH, height=HEIGHT):
        self.width, self.height, self.shapes = width, height, []

    def path(self, points, style):
        """Draws a line through points."""
        places = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self.shapes.append(f'<path d="M{places}" {style}/>')

    def polygon(self, points, style):
        """Fills a polygon."""
        self.shapes.append(f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in points)}Z" {style}/>')

    def dot(self, x, y, fill):
        """Puts a dot with a white rim."""
        self.shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{fill}" stroke="#fff"/>')

    def box(self, x, y, width, height, fill):
        """Fills a rectangle."""
        self.shapes.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{fill}"/>')

    def text(self, x, y, words, style='text-anchor="middle"'):
        """Writes words."""
        self.shapes.append(f'<text x="{x:.1f}" y="{y:.1f}" {style}>{html.escape(words)}</text>')

    def svg(self):
        """Returns the file."""
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" font-family="sans-serif" '
                f'font-size="14" fill="{MUTED}" stroke-linecap="round" stroke-linejoin="round">\n'
                f'<rect width="{self.width}" height="{self.height}" fill="#fff"/>\n' + "\n".join(self.shapes) + "\n</svg>\n")


def ticks(low, high, count=5):
    """Returns round numbers between two."""
    raw = (high - low) / count
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(one * power for one in (1, 2, 5, 10) if one * power >= raw * 0.999)
    return [number * step for number in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


class Chart:
    """Two axes, and what is drawn between them."""

    LEFT, RIGHT, TOP, BOTTOM = 66, WIDTH - 16, 40, HEIGHT - 52

    def __init__(self, across, up, labels):
        """Takes the ranges of the axes and the words at them."""
        self.sheet, self.across, self.up = Sheet(), widened(across), widened(up)
        self.used = 0
        for value in ticks(*self.up):
            y = self.place(self.across[0], value)[1]
            self.sheet.path([(self.LEFT, y), (self.RIGHT, y)], f'stroke="{GRID}"')
            self.sheet.text(self.LEFT - 8, y + 5, f"{value:.6g}", 'text-anchor="end"')
        for value in ticks(*self.across):
            self.sheet.text(self.place(value, 0)[0], self.BOTTOM + 20, f"{value:.6g}")
        self.sheet.text((self.LEFT + self.RIGHT) / 2, HEIGHT - 10, labels[0])
        self.sheet.text(self.LEFT - 50, 20, labels[1], 'text-anchor="start"')

    def place(self, x, y):
        """Returns where a point lies on the sheet."""
        share = [(value - low) / (high - low) for value, (low, high) in ((x, self.across), (y, self.up))]
        return (self.LEFT + share[0] * (self.RIGHT - self.LEFT), self.BOTTOM - share[1] * (self.BOTTOM - self.TOP))

    def name(self, words, fill):
        """Adds a name to the legend, before those that it has."""
        x = self.RIGHT - 90 * (1 + self.used)
        self.sheet.box(x, 11, 12, 12, fill)
        self.sheet.text(x + 17, 22, words, f'text-anchor="start" fill="{INK}"')
        self.used += 1

    def line(self, points, fill):
        """Draws a curve."""
        self.sheet.path([self.place(x, y) for x, y in points], f'fill="none" stroke="{fill}" stroke-width="2.5"')

    def dots(self, points, fill):
        """Puts a dot at every point."""
        for x, y in points:
            self.sheet.dot(*self.place(x, y), fill)

    def bars(self, bars, fill):
        """Draws bars: (from, to, height)."""
        for low, high, height in bars:
            x, y = self.place(low, height)
            self.sheet.box(x, y, max(0.5, self.place(high, 0)[0] - x - 1), self.BOTTOM - y, fill)


def widened(extent):
    """Returns a range that is not empty."""
    low, high = extent
    return (low, high) if high - low > 1e-12 * max(abs(low), abs(high), 1e-300) else (low - 0.5 * abs(low) - 1e-9, high + 0.5 * abs(high) + 1e-9)
