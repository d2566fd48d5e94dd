"""Composites of 64 x 36 pixels: an object in a view of a panorama that the program rendered."""
import os
import re

from gltf_parts import ball, write_gltf
from scene_cases import CAMERA, CLOSED, OPEN, WHITE, gloss, lying_panel

SUN = ["--to-sun", "0.5,1,0.3", "--sun-irradiance", "6,5.5,5"]
SKY = ["--environment", "0.3,0.35,0.45"]
VIEW = ["--position", "0,-1.199,-2.3", "--look-at", "0,-0.3,-1", "--fov", "60"]
LIT_ROOM = CLOSED + [(lying_panel(0, 2.98, -1.5, 0.6), {"emits": (6, 6, 5.5)})]
SMALL_LAMP = CLOSED + [(lying_panel(0.6, 2.5, -1.5, 0.05), {"emits": (700, 650, 600)})]


class CompositeCase:
    def __init__(self, name, room, photographed, light, more=(), object_parts=None):
        self.name, self.room, self.photographed, self.light, self.more = "composite_" + name, room, photographed, light, list(more)
        self.size = (64, 36)
        self.object_parts = object_parts or [(ball(0.35, (0, 0.351, 0)), WHITE)]

    def prepare(self, program, folder, run):
        """Makes photograph and depth."""
        write_gltf(os.path.join(folder, "room.gltf"), self.room, CAMERA)
        write_gltf(os.path.join(folder, "object.gltf"), self.object_parts)
        for command in (["picture", "room.gltf", "--panorama", "--width", "256", "--height", "128", "--spp", "32", "--out", "photograph.exr"] + self.photographed,
                        ["capture", "room.gltf", "--width", "256", "--out", "depth.exr"]):
            status, lines, _ = run([program] + command, folder)
            if status != 0:
                return " ".join(lines)
        return None

    def command(self, program, out, estimator, seed, samples):
        return [program, "composite", "--background", "photograph.exr", "--depth", "depth.exr", "--object", "object.gltf", "--out", out, "--estimator", estimator, "--seed", str(seed), "--threads", "1", "--view", f"{self.size[0]}x{self.size[1]}"] + VIEW + self.light + self.more + samples

    @staticmethod
    def told(lines):
        return float(re.search(r"estimated error ([0-9.]+)", " ".join(lines)).group(1))


def near_lamps(dim):
    """Lamps without size 4 cm from a surface: virtual ones, and real ones that the photograph shows, too."""
    sky = ["--environment", "0.06,0.07,0.09"]
    wall, floor, under = "-0.5,-0.6,-4.96,4,3.7,3.3", "0.6,-1.16,-2.3,4,3.7,3.3", "0,-0.3,-2.05,4,3.7,3.3"
    return [
        CompositeCase("lamp_at_wall", OPEN, dim, sky + ["--lamp", wall]),
        CompositeCase("lamp_at_floor", OPEN, dim, sky + ["--lamp", floor]),
        CompositeCase("lamp_at_object", OPEN, dim, sky + ["--lamp", under]),
        CompositeCase("lamp_at_wall_additive", OPEN, dim, sky + ["--lamp", wall], ["--additive"]),
        CompositeCase("lamp_at_wall_plus_3_ev", OPEN, dim, sky + ["--lamp", wall], ["--exposure", "3"]),
        CompositeCase("lamp_at_floor_closed", CLOSED + [(lying_panel(0, 2.98, -1.5, 0.6), {"emits": (6, 6, 5.5)})], [], ["--lamp", floor]),
    ]


def composite_cases():
    day = ["--environment", "0.3", "0.35", "0.45", "--to-sun", "0.5", "1", "0.3", "--sun-irradiance", "6", "5.5", "5"]
    dim = ["--environment", "0.06", "0.07", "0.09"]
    return [
        CompositeCase("open", OPEN, day, SKY + SUN),
        CompositeCase("additive", OPEN, day, SKY + SUN, ["--additive"]),
        CompositeCase("plus_3_ev", OPEN, dim, ["--environment", "0.06,0.07,0.09"], ["--exposure", "3"]),
        CompositeCase("closed", LIT_ROOM, [], ["--light-from-photograph"]),
        CompositeCase("small_lamp", SMALL_LAMP, [], ["--light-from-photograph"]),
        *near_lamps(dim),
        CompositeCase("metal", OPEN, day, SKY + SUN, object_parts=gloss(1, 0.1)),
    ]
