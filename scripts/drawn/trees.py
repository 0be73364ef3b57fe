"""The drawings of part 2."""
from drawn.canvas import Drawing


def slabs():
    d = Drawing(420, 400, "A ray and the slabs of a box")

    def at(x, y):
        return (24 + 88 * x, 270 - 110 * y)

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
        d.text((at(3.53, 0)[0], row + 5), words, f"l{style} s")
    d.arrow((at(0, 0)[0], 386), (at(3.75, 0)[0], 386), "t", 7)
    d.text((at(3.75, 0)[0] + 6, 391), "t", "m")
    return d


def tree():
    d = Drawing(380, 486, "A tree of boxes over shapes")
    shapes = [(72, 166, 26), (120, 202, 18), (92, 92, 20), (150, 116, 16), (222, 44, 22), (268, 88, 18), (244, 180, 24), (308, 198, 16)]

    def bounds(some):
        return (min(x - r for x, y, r in some), min(y - r for x, y, r in some)), (max(x + r for x, y, r in some), max(y + r for x, y, r in some))

    styles = ["l", "a", "c"]
    def node(first, count, depth, x, width):
        low, high = bounds(shapes[first:first + count])
        pad = 9 - 3 * depth
        low, high = (low[0] - pad, low[1] - pad), (high[0] + pad, high[1] + pad)
        if depth < 3:
            d.lines([low, (high[0], low[1]), high, (low[0], high[1]), low], styles[depth])
        y = 272 + 70 * depth
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
    node(0, 8, 0, 190, 180)
    d.text((220, 277), "root")
    return d


def tree_walk():
    d = Drawing(420, 452, "A walk down a tree with a ray that becomes shorter")
    shapes = [(74, 50, 20), (130, 36, 14), (72, 178, 13), (130, 150, 20), (262, 132, 18), (318, 152, 20), (256, 44, 18), (330, 60, 22)]
    height, start = 146, 14

    def corners(first, count, pad):
        some = shapes[first:first + count]
        return (min(x - r for x, y, r in some) - pad, min(y - r for x, y, r in some) - pad,
                max(x + r for x, y, r in some) + pad, max(y + r for x, y, r in some) + pad)

    def entry(first, count, pad):
        x0, y0, _, y1 = corners(first, count, pad)
        return x0 if y0 <= height <= y1 else None

    for i, (x, y, r) in enumerate(shapes):
        d.circle((x, y), r, "p")
        d.text((x, y + 5), str(i), "s", "middle")
    for first, count, pad, style in ((0, 8, 12, "l"), (0, 4, 8, "a"), (4, 4, 8, "a"), (0, 2, 3, "c"), (2, 2, 3, "c"), (4, 2, 3, "c"), (6, 2, 3, "c")):
        x0, y0, x1, y1 = corners(first, count, pad)
        d.lines([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], style)
    x, y, r = shapes[3]
    hit = x - (r * r - (height - y) ** 2) ** 0.5
    assert entry(0, 4, 8) < hit < entry(4, 4, 8) and entry(0, 2, 3) is None
    d.line((hit, height), (392, height), "t d")
    d.arrow((start, height), (hit, height), "b")
    d.dot((start, height), "lb")
    d.dot((hit, height), "lb")
    d.line((hit, height + 4), (hit, 216), "t d")
    d.text((hit - 20, 232), "t_max after the hit", "lb s", "middle")
    d.text((entry(4, 4, 8), 232), "this box begins later", "la s")
    d.line((entry(4, 4, 8), 192), (entry(4, 4, 8), 216), "t d")
    #      node, place, size, order of the tests, class of the frame, words below
    nodes = (("0 .. 7", 210, 284, "1", "l", True), ("0 .. 3", 110, 344, "2", "a", True), ("4 .. 7", 310, 344, "5", "a", False),
             ("0 .. 1", 55, 404, "3", "c", False), ("2 .. 3", 165, 404, "4", "c", True), ("4 .. 5", 265, 404, "", "c", False),
             ("6 .. 7", 355, 404, "", "c", False))
    for parent, child in ((0, 1), (0, 2), (1, 3), (1, 4), (2, 5), (2, 6)):
        d.line((nodes[parent][1], nodes[parent][2] + 13), (nodes[child][1], nodes[child][2] - 13), "t")
    for name, x, y, order, style, entered in nodes:
        d.box((x - 24, y - 13), (x + 24, y + 13), "h")
        if entered:
            d.box((x - 24, y - 13), (x + 24, y + 13), "fb")
        d.lines([(x - 24, y - 13), (x + 24, y - 13), (x + 24, y + 13), (x - 24, y + 13), (x - 24, y - 13)], style if order else "t d")
        d.text((x, y + 5), name, "s" if order else "lt s", "middle")
        if order:
            d.text((x - 30, y + 5), order + ".", "lb", "end")
    for (x, y), words in (((55, 434), "beside"), ((165, 434), "hit: shorten"), ((310, 434), "never tested")):
        d.text((x, y), words, "s", "middle")
    d.text((342, 349), "behind", "s")
    return d
