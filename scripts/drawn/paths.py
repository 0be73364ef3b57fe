"""The drawings of parts 4 and 5."""
import math
import random

from drawn.canvas import Drawing, mix


def path():
    d = Drawing(424, 360, "A path and its throughput")
    left, right, top, bottom = 84, 340, 40, 290
    d.lines([(left, bottom), (right, bottom), (right, top), (left, top)])
    lamp = (204, top)
    d.box((lamp[0] - 45, top), (lamp[0] + 45, top + 8), "lb")
    d.text((lamp[0], top - 12), "lamp", "lb", "middle")
    points = [(244, bottom), (right, 150), (116, bottom)]
    eye = (26, 130)
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
    d.text((156, 108), "shadow rays", "lb s", "end")
    d.text((44, 346), "sum  =  D(x1)  +  w1 D(x2)  +  w1 w2 D(x3)  +  ...")
    return d


def roulette():
    d = Drawing(410, 250, "Russian roulette")
    x = [36, 138, 240, 342]
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
            end = (x[i] + 40, y + 92)
            d.arrow(mix((x[i], y), end, 0.22), end, "t")
            d.text((x[i] + 28, y + 46), "1 - q", "lt m")
            d.text((end[0], end[1] + 18), "ends: 0", "lt s", "middle")
    d.arrow((x[3] + 22, y), (x[3] + 64, y), "a")
    d.text((20, 232), "mean  =  q · (value / q)  +  (1 - q) · 0  =  value")
    return d


def interval():
    d = Drawing(410, 320, "The interval around the mean of a pixel")
    numbers, tolerance, batch, sums, places = random.Random(4), 0.05, 32, [0, 0, 0], []
    while not places or not places[-1][2]:
        for _ in range(batch):
            value = 0.25 - 0.33 * math.log(1 - numbers.random()) if numbers.random() < 0.6 else 0.45
            sums = [sums[0] + 1, sums[1] + value, sums[2] + value * value]
        mean = sums[1] / sums[0]
        width = 1.96 * math.sqrt((sums[2] - sums[1] * mean) / (sums[0] - 1) / sums[0])
        places.append((mean, width, width < tolerance * mean))
    top, low, high = 36, min(m - w for m, w, _ in places), max(m + w for m, w, _ in places)

    def at(i, value):
        return (54 + 340 * i / len(places), top + 220 * (high - value) / (high - low))

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
            d.text((at(i + 0.5, 0)[0], 290), str(batch * (i + 1)), "s", "middle")
    d.arrow((48, 272), (402, 272), "t", 7)
    d.text((224, 312), "samples", "s", "middle")
    first, last = places[0], places[-1]
    d.text((at(0.5, 0)[0] - 14, at(0, first[0])[1] + 5), "mu", "lb m", "end")
    d.text((at(0.5, 0)[0] - 14, at(0, first[0] + first[1])[1] + 5), "mu + I", "lb s", "end")
    d.text((at(0.5, 0)[0] - 14, at(0, first[0] - first[1])[1] + 5), "mu - I", "lb s", "end")
    d.text((at(len(places) - 0.5, 0)[0], at(0, last[0] + last[1])[1] - 12), "done", "lc", "middle")
    d.text((402, at(0, last[0] * (1 - tolerance))[1] + 66), "green: mu ± tolerance · mu", "lc s", "end")
    return d
