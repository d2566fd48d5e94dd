"""Twelve scenes that are photographed, lit by their own panorama: six places, each in linear radiance and in codes."""
import math
import os

from gltf_parts import ball, box, joined, quad, write_gltf

SIZE = (80, 50)  # of the view
FOV_DEG = 40
FLOOR_M = -1.4  # below the camera, which is the panorama's centre
GREY, WOOD, WHITE = {"colour": (0.5, 0.5, 0.5)}, {"colour": (0.45, 0.3, 0.18)}, {"colour": (0.7, 0.68, 0.65)}
RED, GREEN = {"colour": (0.75, 0.12, 0.1)}, {"colour": (0.12, 0.6, 0.15)}
CLEAR_SKY = ["--environment-map", "builtin:clear_sky", "--environment-rotation", "163"]
OVERCAST = ["--environment", "0.9", "1", "1.1"]


def wide_floor():
    return quad([-40, FLOOR_M, 40], [40, FLOOR_M, 40], [40, FLOOR_M, -40], [-40, FLOOR_M, -40])


def room(left, right, panel):
    """4 m wide, 2.6 m high, 5 m long; a light below the ceiling."""
    x, y, top, near, far = 2, FLOOR_M, FLOOR_M + 2.6, 1.8, -3.2
    grey = joined([quad([-x, y, near], [x, y, near], [x, y, far], [-x, y, far]), quad([-x, y, far], [x, y, far], [x, top, far], [-x, top, far]),
                   quad([x, y, near], [-x, y, near], [-x, top, near], [x, top, near]), quad([-x, top, far], [x, top, far], [x, top, near], [-x, top, near])])
    cx, cz, half = panel
    light = quad([cx - half, top - 0.02, cz - half], [cx + half, top - 0.02, cz - half], [cx + half, top - 0.02, cz + half], [cx - half, top - 0.02, cz + half])
    return [(grey, WHITE), (quad([-x, y, near], [-x, y, far], [-x, top, far], [-x, top, near]), left),
            (quad([x, y, far], [x, y, near], [x, top, near], [x, top, far]), right), (light, {"emits": (9, 8.5, 8)})]


class Ball:
    """Stands on `foot`."""

    def __init__(self, foot, radius, colour=WHITE):
        self.foot, self.radius, self.colour, self.height = foot, radius, colour, 2 * radius
        self.centre = (foot[0], foot[1] + radius, foot[2])

    def shape(self):
        return ball(self.radius, (0, self.radius, 0), 32, 64)

    def met(self, d):
        """The distance along a ray from the camera; infinite where it is missed."""
        b = sum(d[k] * self.centre[k] for k in range(3))
        inside = b * b - sum(c * c for c in self.centre) + self.radius * self.radius
        return b - math.sqrt(inside) if inside >= 0 else math.inf


class Box:
    def __init__(self, foot, half, height, colour=WHITE):
        self.foot, self.radius, self.colour, self.height = foot, half, colour, height
        self.low, self.high = (foot[0] - half, foot[1], foot[2] - half), (foot[0] + half, foot[1] + height, foot[2] + half)

    def shape(self):
        return box([-self.radius, 0, -self.radius], [self.radius, self.height, self.radius])

    def met(self, d):
        near, far = 0.0, math.inf
        for k in range(3):
            if abs(d[k]) < 1e-12:
                if not self.low[k] <= 0 <= self.high[k]:
                    return math.inf
                continue
            a, b = sorted((self.low[k] / d[k], self.high[k] / d[k]))
            near, far = max(near, a), min(far, b)
        return near if near <= far else math.inf


class ContactCase:
    """Objects stand on a level surface `stand_m` high within `bounds` (x, z); `exposure_ev` is that of codes."""

    def __init__(self, name, parts, light, objects, exposure_ev, codes, stand_m=FLOOR_M, bounds=((-40, 40), (-40, 40))):
        self.name, self.parts, self.light, self.objects = f"{name}_{'codes' if codes else 'linear'}", parts, light, objects
        self.exposure_ev, self.codes, self.stand_m, self.bounds = exposure_ev, codes, stand_m, bounds

    def write(self, folder):
        write_gltf(os.path.join(folder, "place.gltf"), self.parts)
        text = ""
        for number, thing in enumerate(self.objects):
            write_gltf(os.path.join(folder, f"object{number}.gltf"), [(thing.shape(), thing.colour)])
            text += f'[[object]]\nfile = "object{number}.gltf"\nposition_m = {list(thing.foot)}\nheight_m = {thing.height}\nmaterials = "diffuse"\n'
        with open(os.path.join(folder, "objects.toml"), "w") as file:
            file.write(text)

    def look_at(self):
        foot = self.objects[0].foot
        return [foot[0], foot[1] + 0.4 * self.objects[0].height, foot[2]]

    def direction(self, x, y):
        """Through a place of the view, in pixels."""
        to = self.look_at()
        length = math.sqrt(sum(v * v for v in to))
        ahead = [v / length for v in to]
        across = math.hypot(ahead[0], ahead[2])
        right = [-ahead[2] / across, 0, ahead[0] / across]
        up = [right[1] * ahead[2] - right[2] * ahead[1], right[2] * ahead[0] - right[0] * ahead[2], right[0] * ahead[1] - right[1] * ahead[0]]
        width, height = SIZE
        half = math.tan(math.radians(FOV_DEG) / 2)
        u, v = (2 * x / width - 1) * half, (1 - 2 * y / height) * half * height / width
        d = [ahead[k] + u * right[k] + v * up[k] for k in range(3)]
        length = math.sqrt(sum(v * v for v in d))
        return [v / length for v in d]

    def stands_at(self, x, y):
        """Where the view's place shows the surface under the objects, and none of them before it."""
        d = self.direction(x, y)
        if d[1] >= -1e-6:
            return None
        distance = self.stand_m / d[1]
        point = [d[0] * distance, d[2] * distance]
        if any(thing.met(d) < distance for thing in self.objects):
            return None
        return point if all(low < p < high for p, (low, high) in zip(point, self.bounds)) else None

    def around_foot(self, reach):
        """Pixels that show nothing but that surface, by no more than `reach` radii from the first object's foot, the nearest first."""
        thing, found = self.objects[0], []
        for y in range(SIZE[1]):
            for x in range(SIZE[0]):
                points = [self.stands_at(x + i, y + j) for i, j in ((0.5, 0.5), (-0.5, -0.5), (1.5, -0.5), (-0.5, 1.5), (1.5, 1.5))]
                if not all(points):
                    continue
                away = math.hypot(points[0][0] - thing.foot[0], points[0][1] - thing.foot[2])
                if away < reach * thing.radius:
                    found.append((away, x, y))
        return [(x, y) for _, x, y in sorted(found)]


def contact_cases():
    inside = ((-1.98, 1.98), (-3.18, 1.78))
    table = joined([box([-0.7, -0.75, -2.6], [0.7, -0.7, -1.5])] + [box([x, FLOOR_M, z], [x + 0.05, -0.75, z + 0.05]) for x in (-0.68, 0.63) for z in (-2.58, -1.57)])
    places = [
        ("floor_sun", [(wide_floor(), GREY)], CLEAR_SKY, [Ball((0, FLOOR_M, -2.2), 0.4)], -0.5, {}),
        ("floor_overcast", [(wide_floor(), GREY)], OVERCAST, [Ball((0, FLOOR_M, -2.2), 0.4)], 0, {}),
        ("corner", room(WHITE, WHITE, (0, -1, 0.5)), [], [Ball((1.55, FLOOR_M, -2.7), 0.3)], 0, {"bounds": inside}),
        ("table", room(WHITE, WHITE, (-0.6, -1, 0.4)) + [(table, WOOD)], [], [Ball((0.1, -0.7, -2), 0.18)], 0, {"stand_m": -0.7, "bounds": ((-0.69, 0.69), (-2.59, -1.51))}),
        ("coloured_walls", room(RED, GREEN, (0, -1, 0.5)), [], [Ball((-1.1, FLOOR_M, -2.4), 0.35)], 0, {"bounds": inside}),
        ("two_objects", room(WHITE, RED, (0.3, -1, 0.5)), [], [Ball((-0.25, FLOOR_M, -2.2), 0.3), Box((0.45, FLOOR_M, -2.35), 0.25, 0.6, GREEN)], 0, {"bounds": inside}),
    ]
    return [ContactCase(name, parts, light, objects, exposure, codes, **more) for codes in (False, True) for name, parts, light, objects, exposure, more in places]
