"""A drawing as SVG. Its colours follow the reader's choice of a light or a dark page."""
import math

STYLE = """text{font:15px sans-serif;fill:#1f2328}.m{font-style:italic}.s{font-size:13px}
.l{stroke:#1f2328;stroke-width:1.6;fill:none}.t{stroke:#848d97;stroke-width:1;fill:none}.d{stroke-dasharray:5 4}
.a{stroke:#0a62c9;stroke-width:2;fill:none}.b{stroke:#c4320a;stroke-width:2;fill:none}.c{stroke:#1a7f37;stroke-width:2;fill:none}
.la{fill:#0a62c9}.lb{fill:#c4320a}.lc{fill:#1a7f37}.lt{fill:#6b737c}.k{fill:#1f2328}.p{fill:#848d97;fill-opacity:.16}
.fa{fill:#0a62c9;fill-opacity:.18}.fb{fill:#c4320a;fill-opacity:.2}.fc{fill:#1a7f37;fill-opacity:.2}.h{fill:#fff}
@media (prefers-color-scheme:dark){text,.k{fill:#e6edf3}.l{stroke:#e6edf3}.a{stroke:#6cb6ff}.b{stroke:#ff8c66}.c{stroke:#57c26b}
.la{fill:#6cb6ff}.lb{fill:#ff8c66}.lc{fill:#57c26b}.lt{fill:#9aa4ae}.fa{fill:#6cb6ff;fill-opacity:.25}.fb{fill:#ff8c66;fill-opacity:.25}
.fc{fill:#57c26b;fill-opacity:.25}.h{fill:#0d1117}}
@media print{text,.k{fill:#000}}"""


def n(value):
    return f"{value:.1f}".rstrip("0").rstrip(".") if "." in f"{value:.1f}" else str(value)


def mix(p, q, s):
    return (p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]))


class Drawing:
    def __init__(self, width, height, title):
        self.width, self.height, self.title, self.parts = width, height, title, []

    def polygon(self, points, style):
        self.parts.append(f'<polygon points="{" ".join(n(x) + "," + n(y) for x, y in points)}" class="{style}"/>')

    def line(self, p, q, style="l"):
        self.parts.append(f'<path d="M{n(p[0])},{n(p[1])}L{n(q[0])},{n(q[1])}" class="{style}"/>')

    def lines(self, points, style="l"):
        self.parts.append(f'<path d="M{"L".join(n(x) + "," + n(y) for x, y in points)}" class="{style}"/>')

    def arrow(self, p, q, style="l", size=9):
        length = math.dist(p, q)
        u = ((q[0] - p[0]) / length, (q[1] - p[1]) / length)
        base = (q[0] - size * u[0], q[1] - size * u[1])
        self.line(p, base, style)
        side = (-0.42 * size * u[1], 0.42 * size * u[0])
        head = {"l": "k", "t": "lt"}.get(style[0], "l" + style[0])
        self.polygon([q, (base[0] + side[0], base[1] + side[1]), (base[0] - side[0], base[1] - side[1])], head)

    def circle(self, p, radius, style="l"):
        self.parts.append(f'<circle cx="{n(p[0])}" cy="{n(p[1])}" r="{n(radius)}" class="{style}"/>')

    def dot(self, p, style="k"):
        self.circle(p, 4, style)

    def ellipse(self, p, rx, ry, style):
        self.parts.append(f'<ellipse cx="{n(p[0])}" cy="{n(p[1])}" rx="{n(rx)}" ry="{n(ry)}" class="{style}"/>')

    def arc(self, center, radius, begin, end, style="l"):
        """Angles in degrees, anticlockwise from the right."""
        steps = [begin + (end - begin) * i / 24 for i in range(25)]
        self.lines([around(center, radius, angle) for angle in steps], style)

    def box(self, p, q, style):
        self.polygon([p, (q[0], p[1]), q, (p[0], q[1])], style)

    def text(self, p, words, style="", anchor="start"):
        words = words.replace("&", "&amp;").replace("<", "&lt;")
        self.parts.append(f'<text x="{n(p[0])}" y="{n(p[1])}" class="{style}" text-anchor="{anchor}">{words}</text>')

    def svg(self):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
                f'viewBox="0 0 {self.width} {self.height}" role="img"><title>{self.title}</title>\n<style>{STYLE}</style>\n'
                + "\n".join(self.parts) + "\n</svg>\n")


def around(center, radius, degrees):
    angle = math.radians(degrees)
    return (center[0] + radius * math.cos(angle), center[1] - radius * math.sin(angle))
