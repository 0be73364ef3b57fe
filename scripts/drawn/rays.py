"""The drawings of part 1."""
import math
import random

from drawn.canvas import Drawing, mix


def pixel_samples():
    d = Drawing(400, 392, "A pixel is a square of the picture, and its samples are random points of it")
    width, height, x, y, cell, size = 6, 4, 2, 1, 24, 196
    numbers, corner, square = random.Random(7), (16, 124), (40, 336)

    def edge(x):  # the shape is below this line
        return 1.25 + 0.6 * (x - 2)

    def small(x, y):
        return (corner[0] + cell * x, corner[1] - cell * y)

    def large(a, b):
        return (square[0] + size * a, square[1] - size * b)

    d.polygon([small(0, edge(0)), small(width, edge(width)), small(width, 0), small(0, 0)], "fa")
    for i in range(width + 1):
        d.line(small(i, 0), small(i, height), "t")
    for i in range(height + 1):
        d.line(small(0, i), small(width, i), "t")
    for end in (0, 1):
        d.line(small(x + end, y), large(end, 1), "t d")
    d.polygon([large(0, 0), large(0, 1), large(1, 1), large(1, 0)], "h")
    d.polygon([large(0, edge(x) - y), large(1, edge(x + 1) - y), large(1, 0), large(0, 0)], "fa")
    d.lines([small(x, y), small(x + 1, y), small(x + 1, y + 1), small(x, y + 1), small(x, y)], "b")
    d.lines([large(0, 0), large(1, 0), large(1, 1), large(0, 1), large(0, 0)], "b")
    inside = 0
    for _ in range(16):
        a, b = numbers.random(), numbers.random()
        is_in = y + b < edge(x + a)
        inside += is_in
        d.circle(large(a, b), 4.5, "la" if is_in else "l h")
    d.circle(large(0.5, 0.5), 8, "c")
    d.text((corner[0], 18), "the picture", "s")
    d.text((small(width, 0)[0] + 8, small(0, y + 1)[1] + 5), "pixel (2, 1)", "lb s")
    right = square[0] + size
    d.text((right + 8, large(0, 1)[1] + 5), "(y + 1) / height", "s")
    d.text((right + 8, square[1] + 4), "y / height", "s")
    d.text((square[0] - 6, square[1] + 18), "x / width", "s")
    d.text((right, square[1] + 18), "(x + 1) / width", "s", "end")
    d.text((right + 22, large(0, 0.5)[1] + 5), "the centre", "lc s")
    d.line((large(0.5, 0)[0] + 8, large(0, 0.5)[1]), (right + 18, large(0, 0.5)[1]), "t d")
    d.text((34, 380), f"{inside} of 16 samples see the blue shape", "la s")
    return d


def camera_window():
    d = Drawing(390, 330, "The window in front of the camera")

    def at(x, y, z):  # seen from the right of the camera, which looks along -z
        return (72 - 150 * z + 62 * x, 190 - 105 * y + 44 * x)

    eye, width, height = at(0, 0, 0), 1, 0.75
    corners = [at(x, y, -1) for x, y in ((-width, -height), (width, -height), (width, height), (-width, height))]
    for corner in corners:
        d.line(eye, corner, "t")
    d.polygon(corners, "p")
    d.lines(corners + corners[:1])
    center = at(0, 0, -1)
    d.line(eye, center, "t d")
    d.text((mix(eye, center, 0.46)[0], eye[1] + 17), "1", anchor="middle")
    for end, name, shift in ((at(0.6, 0, 0), "x", (-14, 12)), (at(0, 0.8, 0), "y", (-14, 4)), (at(0, 0, 0.36), "z", (-14, 5))):
        d.arrow(eye, end)
        d.text((end[0] + shift[0], end[1] + shift[1]), name, "m")
    d.arrow(center, at(width, 0, -1), "a")
    d.text((center[0] + 70, center[1] + 46), "half width", "la s")
    d.text((center[0] + 70, center[1] + 63), "= tan(hfov / 2)", "la s")
    d.arrow(center, at(0, height, -1), "c")
    d.text((center[0] + 70, center[1] - 74), "half height", "lc s")
    d.text((center[0] + 70, center[1] - 57), "= tan(vfov / 2)", "lc s")
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
    d = Drawing(428, 345, "Barycentric coordinates")
    p0, p1, p2 = (50, 265), (294, 300), (148, 60)

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
    d.text((turn[0] - 72, turn[1] + 28), "b1 (p1 - p0)", "la s")
    d.text((mix(turn, point, 0.2)[0] + 10, mix(turn, point, 0.2)[1] + 4), "b2 (p2 - p0)", "lc s")
    d.dot(point, "lb")
    d.line(point, (330, 118), "t")
    d.text((336, 104), "b0 = 0.2", "lb s")
    d.text((336, 122), "b1 = 0.5", "lb s")
    d.text((336, 140), "b2 = 0.3", "lb s")
    for p, words, shift in ((p0, "p0:  b0 = 1", (-46, 27)), (p1, "p1:  b1 = 1", (14, -2)), (p2, "p2:  b2 = 1", (12, -4))):
        if p == p1:  # a dashed line would cross the words
            d.box((p[0] + 12, p[1] - 15), (p[0] + 98, p[1] + 3), "h")
        d.dot(p)
        d.text((p[0] + shift[0], p[1] + shift[1]), words)
    return d


def sphere_quadratic():
    d = Drawing(400, 490, "The two solutions of a sphere's quadratic equation")
    radius = 46
    for i, (name, start, height) in enumerate((("from outside", -72, 16), ("from inside", -14, 16), ("sphere behind", 62, 16), ("beside it", -72, 58))):
        column, top = i % 2, 246 * (i // 2)
        center = (100 + 200 * column, top + 102)
        origin = (center[0] + start, center[1] - height)
        d.circle(center, radius)
        d.line((center[0] - 84, origin[1]), (center[0] + 84, origin[1]), "t d")
        d.arrow(origin, (center[0] + 84, origin[1]), "a")
        d.dot(origin, "la")
        d.text((center[0], top + 20), name, anchor="middle")
        axis = top + 206
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
