#!/usr/bin/env python3
"""drawings.py [--check]: makes the drawings of the handbook, student/drawings/*.svg, or says which of them differ from what it
makes. They are computed from the formulas that they show, and follow the reader's choice of a light or a dark page."""
import math
import os
import random
import sys

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../student/drawings")
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


def camera_window():
    d = Drawing(640, 330, "The window in front of the camera")

    def at(x, y, z):  # seen from the right of the camera, which looks along -z
        return (120 - 235 * z + 62 * x, 190 - 105 * y + 44 * x)

    eye, width, height = at(0, 0, 0), 1, 0.75
    corners = [at(x, y, -1) for x, y in ((-width, -height), (width, -height), (width, height), (-width, height))]
    for corner in corners:
        d.line(eye, corner, "t")
    d.polygon(corners, "p")
    d.lines(corners + corners[:1])
    center = at(0, 0, -1)
    d.line(eye, center, "t d")
    d.text((mix(eye, center, 0.6)[0], eye[1] + 17), "1", anchor="middle")
    for end, name, shift in ((at(0.75, 0, 0), "x", (6, 12)), (at(0, 0.8, 0), "y", (-14, 4)), (at(0, 0, 0.36), "z", (-14, 5))):
        d.arrow(eye, end)
        d.text((end[0] + shift[0], end[1] + shift[1]), name, "m")
    d.arrow(center, at(width, 0, -1), "a")
    d.text((center[0] + 70, center[1] + 62), "half width = tan(hfov / 2)", "la s")
    d.arrow(center, at(0, height, -1), "c")
    d.text((center[0] + 66, center[1] - 66), "half height = tan(vfov / 2)", "lc s")
    x, y = 0.3, 0.86
    point = at((2 * x - 1) * width, (2 * y - 1) * height, -1)
    d.arrow(eye, mix(eye, point, 1.9), "b")
    d.dot(point, "lb")
    d.text((point[0] - 12, point[1] - 10), "(x, y)", "lb m", "end")
    d.dot(eye)
    d.text((eye[0] - 30, eye[1] + 24), "eye")
    d.text((corners[0][0] - 8, corners[0][1] + 22), "(0, 0)", "s", "end")
    d.text((corners[1][0] + 6, corners[1][1] + 16), "(1, 0)", "s")
    d.text((corners[2][0] + 8, corners[2][1] - 2), "(1, 1)", "s")
    return d


def barycentric():
    d = Drawing(600, 350, "Barycentric coordinates")
    p0, p1, p2 = (150, 265), (450, 300), (270, 60)

    def at(b1, b2):
        return (p0[0] + b1 * (p1[0] - p0[0]) + b2 * (p2[0] - p0[0]), p0[1] + b1 * (p1[1] - p0[1]) + b2 * (p2[1] - p0[1]))

    d.polygon([p0, p1, p2], "p")
    for b0, words in ((0.5, "b0 = 1/2"), (0, "b0 = 0"), (-0.25, "b0 = -1/4")):
        ends = [at(1 - b0 + 0.06, -0.06), at(-0.06, 1 - b0 + 0.06)]
        d.line(ends[0], ends[1], "t d")
        d.text((ends[0][0] + 4, ends[0][1] + 14), words, "lt s")
    d.lines([p0, p1, p2, p0])
    b1, b2 = 0.5, 0.3
    turn, point = at(b1, 0), at(b1, b2)
    d.arrow(p0, turn, "a")
    d.arrow(turn, point, "c")
    d.text((turn[0] - 90, turn[1] + 20), "b1 (p1 - p0)", "la s")
    d.text((mix(turn, point, 0.5)[0] + 8, mix(turn, point, 0.5)[1] + 12), "b2 (p2 - p0)", "lc s")
    d.dot(point, "lb")
    d.line(point, (462, 140), "t")
    d.text((468, 138), "b0 = 0.2", "lb s")
    d.text((468, 156), "b1 = 0.5", "lb s")
    d.text((468, 174), "b2 = 0.3", "lb s")
    for p, words, shift in ((p0, "p0:  b0 = 1", (-100, 14)), (p1, "p1:  b1 = 1", (14, -2)), (p2, "p2:  b2 = 1", (12, -4))):
        d.dot(p)
        d.text((p[0] + shift[0], p[1] + shift[1]), words)
    return d


def sphere_quadratic():
    d = Drawing(740, 262, "The two solutions of a sphere's quadratic equation")
    radius = 46
    for i, (name, start, height) in enumerate((("from outside", -72, 16), ("from inside", -14, 16), ("sphere behind", 62, 16), ("beside it", -72, 58))):
        center = (94 + 184 * i, 102)
        origin = (center[0] + start, center[1] - height)
        d.circle(center, radius)
        d.line((center[0] - 84, origin[1]), (center[0] + 84, origin[1]), "t d")
        d.arrow(origin, (center[0] + 84, origin[1]), "a")
        d.dot(origin, "la")
        d.text((center[0], 20), name, anchor="middle")
        axis = 206
        d.arrow((center[0] - 84, axis), (center[0] + 84, axis), "t", 7)
        d.line((origin[0], axis - 6), (origin[0], axis + 6), "a")
        d.text((origin[0], axis + 24), "t = 0", "la s", "middle")
        if abs(height) >= radius:
            d.text((center[0] + 20, axis - 8), "no solution", "lt s", "middle")
            continue
        half = math.sqrt(radius ** 2 - height ** 2)
        hits = [center[0] - half, center[0] + half]
        first = next((x for x in hits if x >= origin[0]), None)
        for x in hits:
            d.line((x, origin[1]), (x, axis), "t d")
            for y in (origin[1], axis):
                d.circle((x, y), 4.5, "lb" if x == first else "l h")
    return d


def slabs():
    d = Drawing(620, 400, "A ray and the slabs of a box")

    def at(x, y):
        return (70 + 115 * x, 270 - 110 * y)

    (x0, x1), (y0, y1), slope = (1, 3), (0.7, 1.7), 0.5
    d.box(at(x0, -0.1), at(x1, 2.25), "fa")
    d.box(at(-0.2, y0), at(3.7, y1), "fc")
    for x, words in ((x0, "min.x"), (x1, "max.x")):
        d.line(at(x, -0.1), at(x, 2.25), "a")
        d.text((at(x, 0)[0] + 5, at(0, -0.1)[1] - 5), words, "la s")
    for y, words in ((y0, "min.y"), (y1, "max.y")):
        d.line(at(-0.2, y), at(3.7, y), "c")
        d.text((at(3.7, y)[0] + 4, at(0, y)[1] + 5), words, "lc s")
    d.polygon([at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)], "l")
    d.arrow(at(0, 0), at(3.75, 3.75 * slope), "b")
    d.dot(at(0, 0), "lb")
    tx, ty = (x0, x1), (y0 / slope, y1 / slope)
    for t in tx + ty:
        d.dot(at(t, slope * t))
    for row, (begin, end), style, words in ((312, tx, "a", "in the x slab"), (337, ty, "c", "in the y slab"),
                                            (362, (max(tx[0], ty[0]), min(tx[1], ty[1])), "b", "in the box")):
        d.line((at(begin, 0)[0], row), (at(end, 0)[0], row), style)
        for t in (begin, end):
            d.line((at(t, 0)[0], row - 6), (at(t, 0)[0], row + 6), style)
        d.text((at(3.6, 0)[0], row + 5), words, f"l{style} s")
    d.arrow((at(0, 0)[0], 386), (at(3.75, 0)[0], 386), "t", 7)
    d.text((at(3.75, 0)[0] + 6, 391), "t", "m")
    return d


def tree():
    d = Drawing(680, 300, "A tree of boxes over shapes")
    shapes = [(40, 200, 26), (88, 236, 18), (60, 126, 20), (118, 150, 16), (190, 78, 22), (236, 122, 18), (212, 214, 24), (276, 232, 16)]

    def bounds(some):
        return (min(x - r for x, y, r in some), min(y - r for x, y, r in some)), (max(x + r for x, y, r in some), max(y + r for x, y, r in some))

    styles = ["l", "a", "c"]
    def node(first, count, depth, x, width):
        low, high = bounds(shapes[first:first + count])
        pad = 9 - 3 * depth
        low, high = (low[0] - pad, low[1] - pad), (high[0] + pad, high[1] + pad)
        if depth < 3:
            d.lines([low, (high[0], low[1]), high, (low[0], high[1]), low], styles[depth])
        y = 60 + 70 * depth
        half = count // 2
        if count > 2:
            for side in (0, 1):
                d.line((x, y + 13), (x + (side - 0.5) * width, y + 57), "t")
                node(first + side * half, half, depth + 1, x + (side - 0.5) * width, width / 2)
        else:
            for side in (0, 1):
                leaf = (x + (side - 0.5) * 36, y + 56)
                d.line((x, y + 13), (leaf[0], leaf[1] - 12), "t")
                d.circle(leaf, 12, "p")
                d.text((leaf[0], leaf[1] + 5), str(first + side), "s", "middle")
        d.box((x - 22, y - 13), (x + 22, y + 13), "h")
        d.lines([(x - 22, y - 13), (x + 22, y - 13), (x + 22, y + 13), (x - 22, y + 13), (x - 22, y - 13)], styles[depth])
        d.text((x, y + 5), f"{first} .. {first + count - 1}", "s", "middle")

    for i, (x, y, r) in enumerate(shapes):
        d.circle((x, y), r, "p")
        d.text((x, y + 5), str(i), "s", "middle")
    node(0, 8, 0, 500, 170)
    d.text((500, 36), "root", anchor="middle")
    return d


def hemisphere():
    d = Drawing(620, 320, "Directions over a hemisphere")
    p, radius, theta = (270, 262), 200, 38
    d.ellipse(p, radius, 34, "p")
    d.ellipse(p, radius, 34, "t")
    d.arc(p, radius, 0, 180)
    top = around(p, radius + 34, 90)
    d.arrow(p, top, "l")
    d.text((top[0] + 8, top[1] + 12), "normal (z)")
    tip = around(p, radius, 90 - theta)
    d.polygon([p] + [around(p, radius, 90 - theta + a) for a in (-6, -3, 0, 3, 6)], "fa")
    center = around(p, radius, 90 - theta)
    d.parts.append(f'<ellipse cx="{n(center[0])}" cy="{n(center[1])}" rx="21" ry="9" transform="rotate({theta} {n(center[0])} {n(center[1])})" class="fa"/>')
    d.arrow(p, tip, "a")
    d.text((tip[0] + 18, tip[1] - 10), "dwi, a small solid angle", "la")
    d.text((mix(p, tip, 0.62)[0] + 12, mix(p, tip, 0.62)[1] + 16), "wi", "la m")
    d.arc(p, 62, 90, 90 - theta, "l")
    d.text(around((p[0] - 3, p[1]), 74, 90 - theta / 2), "θ", "m")
    d.line(tip, (p[0], tip[1]), "c d")
    d.line(p, (p[0], tip[1]), "c")
    d.text((p[0] - 10, mix(p, (0, tip[1]), 0.6)[1]), "cos θ", "lc", "end")
    eye = around(p, radius - 62, 142)
    d.arrow(p, eye, "b")
    d.text((eye[0] - 6, eye[1] - 8), "wo", "lb m", "end")
    d.dot(p)
    d.text((p[0] - 6, p[1] + 22), "p", "m", "end")
    d.text((p[0] + radius + 8, p[1] - 30), "radius 1", "s")
    return d


def area_to_solid_angle():
    d = Drawing(600, 340, "From area to solid angle")
    p, q, tilt = (170, 300), (330, 92), 24
    along = (math.cos(math.radians(tilt)), math.sin(math.radians(tilt)))
    lamp = [(q[0] + s * along[0], q[1] + s * along[1]) for s in (-140, 140)]
    piece = [(q[0] + s * along[0], q[1] + s * along[1]) for s in (-24, 24)]
    d.line((60, p[1]), (500, p[1]))
    d.arc(p, 90, 0, 180, "t")
    d.text((p[0] - 92, p[1] - 66), "radius 1", "lt s", "end")
    angles = [math.degrees(math.atan2(p[1] - end[1], end[0] - p[0])) for end in piece]
    d.polygon([p] + piece, "fa")
    d.arc(p, 90, angles[1], angles[0], "b")
    d.text((around(p, 104, angles[1])[0] + 10, around(p, 104, angles[1])[1] + 14), "dw = dA cos θ' / d²", "lb")
    d.line(lamp[0], lamp[1])
    d.line(piece[0], piece[1], "c")
    for end in piece:
        d.line((end[0] + 7 * along[1], end[1] - 7 * along[0]), (end[0] - 7 * along[1], end[1] + 7 * along[0]), "c")
    d.text((q[0] + 10, q[1] - 16), "dA", "lc m")
    d.text((lamp[1][0] + 6, lamp[1][1] + 8), "lamp, area A")
    normal = (q[0] - 96 * along[1], q[1] + 96 * along[0])
    d.arrow(q, normal)
    d.text((normal[0] - 6, normal[1] + 20), "n'", "m")
    d.line(p, q, "t d")
    d.text((mix(p, q, 0.68)[0] - 22, mix(p, q, 0.68)[1]), "d", "m")
    down, back = math.degrees(math.atan2(q[1] - normal[1], normal[0] - q[0])), math.degrees(math.atan2(q[1] - p[1], p[0] - q[0]))
    d.arc(q, 56, back, down)
    d.text(around((q[0] - 6, q[1] + 5), 70, (back + down) / 2), "θ'", "m")
    d.arrow(p, (p[0], p[1] - 140), "l")
    d.text((p[0] - 8, p[1] - 128), "n", "m", "end")
    d.dot(p)
    d.text((p[0] - 4, p[1] + 24), "p", "m")
    return d


def path():
    d = Drawing(700, 360, "A path and its throughput")
    left, right, top, bottom = 150, 590, 40, 290
    d.lines([(left, bottom), (right, bottom), (right, top), (left, top)])
    lamp = (330, top)
    d.box((lamp[0] - 45, top), (lamp[0] + 45, top + 8), "lb")
    d.text((lamp[0], top - 12), "lamp", "lb", "middle")
    points = [(420, bottom), (right, 150), (210, bottom)]
    eye = (50, 130)
    for begin, end in zip([eye] + points, points):
        d.arrow(begin, end, "a")
    d.dot(eye)
    d.text((eye[0] - 6, eye[1] - 14), "eye", anchor="middle")
    for i, (point, shift, words) in enumerate(zip(points, ((-20, 26), (12, 5), (-40, 26)), ("D(x1)", "w1 D(x2)", "w1 w2 D(x3)"))):
        d.arrow(point, (lamp[0] + (10, 30, -20)[i], top + 8), "b d", 8)
        d.dot(point)
        d.text((point[0] + shift[0], point[1] + shift[1]), words)
    for begin, end, words, shift in ((points[0], points[1], "w1", (10, 16)), (points[1], points[2], "w2", (-6, -10))):
        middle = mix(begin, end, 0.4)
        d.text((middle[0] + shift[0], middle[1] + shift[1]), words, "la m")
    d.text((262, 108), "shadow rays", "lb s", "end")
    d.text((70, 346), "sum  =  D(x1)  +  w1 D(x2)  +  w1 w2 D(x3)  +  ...")
    return d


def roulette():
    d = Drawing(660, 250, "Russian roulette")
    x = [60, 205, 370, 535]
    y = 80
    for i, (paths, weight) in enumerate((("all paths", "1"), ("all paths", "1"), ("q of them", "1 / q"), ("q² of them", "1 / q²"))):
        d.circle((x[i], y), 20, "p")
        d.circle((x[i], y), 20)
        d.text((x[i], y + 5), f"x{i + 1}", "m", "middle")
        d.text((x[i], y - 52), paths, "s", "middle")
        d.text((x[i], y - 32), f"counts {weight}", "lb s", "middle")
        if i < 3:
            d.arrow((x[i] + 22, y), (x[i + 1] - 22, y), "a")
            d.text(((x[i] + x[i + 1]) / 2, y - 10), "always" if i == 0 else "q", "la" if i == 0 else "la m", "middle")
        if i > 0:
            end = (x[i] + 58, y + 92)
            d.arrow(mix((x[i], y), end, 0.22), end, "t")
            d.text((x[i] + 42, y + 46), "1 - q", "lt m")
            d.text((end[0], end[1] + 18), "ends: 0", "lt s", "middle")
    d.arrow((x[3] + 22, y), (x[3] + 86, y), "a")
    d.text((20, 232), "mean  =  q · (value / q)  +  (1 - q) · 0  =  value")
    return d


def interval():
    d = Drawing(620, 310, "The interval around the mean of a pixel")
    numbers, tolerance, batch, sums, places = random.Random(4), 0.05, 32, [0, 0, 0], []
    while not places or not places[-1][2]:
        for _ in range(batch):
            value = 0.25 - 0.33 * math.log(1 - numbers.random()) if numbers.random() < 0.6 else 0.45
            sums = [sums[0] + 1, sums[1] + value, sums[2] + value * value]
        mean = sums[1] / sums[0]
        width = 1.96 * math.sqrt((sums[2] - sums[1] * mean) / (sums[0] - 1) / sums[0])
        places.append((mean, width, width < tolerance * mean))
    top, low, high = 30, min(m - w for m, w, _ in places), max(m + w for m, w, _ in places)

    def at(i, value):
        return (100 + 440 * i / len(places), top + 220 * (high - value) / (high - low))

    band = [at(i + 0.5, m + tolerance * m) for i, (m, _, _) in enumerate(places)] + [at(i + 0.5, m - tolerance * m) for i, (m, _, _) in reversed(list(enumerate(places)))]
    d.polygon(band, "fc")
    d.lines([at(i + 0.5, m) for i, (m, _, _) in enumerate(places)], "t d")
    for i, (mean, width, done) in enumerate(places):
        style = "c" if done else "b"
        d.line(at(i + 0.5, mean - width), at(i + 0.5, mean + width), style)
        for end in (mean - width, mean + width):
            x, y = at(i + 0.5, end)
            d.line((x - 7, y), (x + 7, y), style)
        d.dot(at(i + 0.5, mean), "l" + style)
        if (i % 2 == 0 and i != len(places) - 2) or done:
            d.text((at(i + 0.5, 0)[0], 284), str(batch * (i + 1)), "s", "middle")
    d.arrow((90, 266), (566, 266), "t", 7)
    d.text((330, 304), "samples", "s", "middle")
    first, last = places[0], places[-1]
    d.text((at(0.5, 0)[0] - 14, at(0, first[0])[1] + 5), "mu", "lb m", "end")
    d.text((at(0.5, 0)[0] - 14, at(0, first[0] + first[1])[1] + 5), "mu + I", "lb s", "end")
    d.text((at(0.5, 0)[0] - 14, at(0, first[0] - first[1])[1] + 5), "mu - I", "lb s", "end")
    d.text((at(len(places) - 0.5, 0)[0] + 8, at(0, last[0] * (1 + tolerance))[1] - 8), "done", "lc")
    d.text((at(len(places) - 2, 0)[0] - 60, at(0, last[0] * (1 + tolerance))[1] - 34), "mu ± tolerance · mu", "lc s")
    return d


DRAWINGS = (camera_window, barycentric, sphere_quadratic, slabs, tree, hemisphere, area_to_solid_angle, path, roulette, interval)


def main():
    names, differing = {f"{make.__name__}.svg": make().svg() for make in DRAWINGS}, []
    for name, text in names.items():
        file = os.path.join(FOLDER, name)
        if "--check" not in sys.argv[1:]:
            os.makedirs(FOLDER, exist_ok=True)
            with open(file, "w", encoding="utf-8") as out:
                out.write(text)
        elif not os.path.exists(file) or open(file, encoding="utf-8").read() != text:
            differing.append(name)
    differing += [name for name in os.listdir(FOLDER) if name not in names]
    for name in differing:
        print(f"student/drawings/{name} is not what scripts/drawings.py makes: change the script, and call it")
    return len(differing) > 0


if __name__ == "__main__":
    sys.exit(main())
