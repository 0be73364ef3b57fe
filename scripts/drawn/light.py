"""The drawings of part 3."""
import math

from drawn.canvas import Drawing, around, mix, n


def hemisphere():
    d = Drawing(410, 266, "Directions over a hemisphere")
    p, radius, theta = (172, 212), 160, 38
    d.ellipse(p, radius, 28, "p")
    d.ellipse(p, radius, 28, "t")
    d.arc(p, radius, 0, 180)
    top = around(p, radius + 34, 90)
    d.arrow(p, top, "l")
    d.text((top[0] + 8, top[1] + 12), "normal (z)")
    tip = around(p, radius, 90 - theta)
    d.polygon([p] + [around(p, radius, 90 - theta + a) for a in (-6, -3, 0, 3, 6)], "fa")
    center = around(p, radius, 90 - theta)
    d.parts.append(f'<ellipse cx="{n(center[0])}" cy="{n(center[1])}" rx="17" ry="7" transform="rotate({theta} {n(center[0])} {n(center[1])})" class="fa"/>')
    d.arrow(p, tip, "a")
    d.text((tip[0] + 20, tip[1] - 20), "dwi, a small", "la")
    d.text((tip[0] + 20, tip[1] - 2), "solid angle", "la")
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
    d.text((p[0] + radius + 2, p[1] - 42), "radius 1", "s")
    return d


def area_to_solid_angle():
    d = Drawing(400, 330, "From area to solid angle")
    p, q, tilt = (112, 296), (248, 84), 24
    along = (math.cos(math.radians(tilt)), math.sin(math.radians(tilt)))
    lamp = [(q[0] + s * along[0], q[1] + s * along[1]) for s in (-120, 120)]
    piece = [(q[0] + s * along[0], q[1] + s * along[1]) for s in (-24, 24)]
    d.line((8, p[1]), (392, p[1]))
    d.arc(p, 90, 0, 180, "t")
    d.text((p[0] - 54, p[1] - 80), "radius 1", "lt s", "end")
    angles = [math.degrees(math.atan2(p[1] - end[1], end[0] - p[0])) for end in piece]
    d.polygon([p] + piece, "fa")
    d.arc(p, 90, angles[1], angles[0], "b")
    d.text((around(p, 104, angles[1])[0] + 10, around(p, 104, angles[1])[1] + 14), "dw = dA cos θ' / d²", "lb")
    d.line(lamp[0], lamp[1])
    d.line(piece[0], piece[1], "c")
    for end in piece:
        d.line((end[0] + 7 * along[1], end[1] - 7 * along[0]), (end[0] - 7 * along[1], end[1] + 7 * along[0]), "c")
    d.text((q[0] + 10, q[1] - 16), "dA", "lc m")
    d.text((392, lamp[1][1] + 24), "lamp, area A", anchor="end")
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


def frames():
    d = Drawing(400, 372, "One direction in the local frame and in the world frame")
    p, unit, x, z = (212, 252), 150, (0.8, 0.6), (-0.6, 0.8)  # y of the local frame leads into the page

    def at(right, up, scale=unit):
        return (p[0] + scale * right, p[1] - scale * up)

    def local(a, c):
        return at(a * x[0] + c * z[0], a * x[1] + c * z[1])

    wi = (0.6, 0.8)
    d.line(local(-1.05, 0), local(1.2, 0))
    d.polygon([local(-1.05, 0), local(1.2, 0), local(1.2, -0.12), local(-1.05, -0.12)], "p")
    d.arrow(p, local(0, 1), "a")
    d.arrow(p, local(1, 0), "a")
    d.text((local(0, 1)[0] - 12, local(0, 1)[1] - 8), "z = n", "la m", "end")
    d.text((local(1, 0)[0] - 4, local(1, 0)[1] - 12), "x", "la m", "end")
    d.line(local(wi[0], 0), local(*wi), "a d")
    d.line(local(0, wi[1]), local(*wi), "a d")
    d.text((local(0, 0.45)[0] - 8, local(0, 0.45)[1] + 10), "0.8", "la s", "end")
    d.text((local(0.36, 0)[0] + 4, local(0.36, 0)[1] + 16), "0.6", "la s")
    d.arrow(p, local(*wi), "b")
    d.text((local(*wi)[0] + 8, local(*wi)[1] + 4), "wi", "lb m")
    d.dot(p)
    d.text((p[0] + 4, p[1] + 20), "p", "m")
    world = (310, 286)
    for end, name, shift in (((0, 56), "y", (8, 8)), ((56, 0), "x", (2, 20))):
        tip = (world[0] + end[0], world[1] - end[1])
        d.arrow(world, tip)
        d.text((tip[0] + shift[0], tip[1] + shift[1]), name, "m")
    d.dot(world)
    d.text((318, 270), "world", "s")
    d.text((270, 60), "the wall's own", "la s")
    d.text((270, 78), "(local) frame", "la s")
    d.text((186, 336), "local:  wi = (0.6, 0, 0.8)", "la")
    d.text((186, 360), "world:  wi = (0, 1, 0)")
    return d


def acne():
    d = Drawing(420, 236, "A ray from a computed point can meet the surface that the point is on")
    level, lamp = 152, 30
    panels = ((14, -14, "a little above", "free"), (154, 14, "a little below", "its own shadow"), (294, 14, "moved off", "free"))
    for left, error, words, result in panels:
        middle = left + 40
        d.line((left, level), (left + 112, level))
        d.polygon([(left, level), (left + 112, level), (left + 112, level + 30), (left, level + 30)], "p")
        d.polygon([(left + 64, lamp - 7), (left + 112, lamp - 7), (left + 112, lamp), (left + 64, lamp)], "lb")
        p, light = (middle, level + error), (left + 88, lamp)
        start = p
        if words == "moved off":
            start = (middle, level - 22)
            d.arrow(p, (middle, start[1] + 4), "c", 7)
        if result == "free":
            d.arrow(start, light, "a")
        else:
            meets = mix(p, light, error / (p[1] - light[1]))
            d.line(p, meets, "a")
            d.line(meets, light, "t d")
            d.circle(meets, 5, "lb")
        d.dot(p)
        if start != p:
            d.dot(start, "la")
        d.text((left + 56, 204), words, "s", "middle")
        d.text((left + 56, 226), result, "lb s" if result != "free" else "la s", "middle")
    d.text((70, 34), "lamp", "lb s", "end")
    d.text((334 + 8, level - 26), "spawn_ray", "lc s")
    return d
