"""Small scenes of all kinds that a user might bring, as study files of 64 x 36 pixels."""
import os

from gltf_parts import ball, box, hdr, joined, png, quad, ring_band, write_gltf

WALL = {"colour": (0.7, 0.68, 0.62)}
RED, WHITE, BLACK = {"colour": (0.8, 0.2, 0.15)}, {"colour": (0.9, 0.9, 0.9)}, {"colour": (0.02, 0.02, 0.02)}
FLOOR = quad([-3, 0, 3], [3, 0, 3], [3, 0, -4], [-3, 0, -4])
BACK = quad([-3, 0, -4], [3, 0, -4], [3, 3, -4], [-3, 3, -4])
LEFT = quad([-3, 0, 3], [-3, 0, -4], [-3, 3, -4], [-3, 3, 3])
RIGHT = quad([3, 0, -4], [3, 0, 3], [3, 3, 3], [3, 3, -4])
CEILING = quad([-3, 3, -4], [3, 3, -4], [3, 3, 3], [-3, 3, 3])
FRONT = quad([3, 0, 3], [-3, 0, 3], [-3, 3, 3], [3, 3, 3])
OPEN = [(joined([FLOOR, BACK, RIGHT]), WALL), (LEFT, RED)]
CLOSED = OPEN + [(joined([CEILING, FRONT]), WALL)]
CAMERA = ([0, 1.2, 1.0], 0.8)

DAY = {"environment_radiance": "[0.3, 0.35, 0.45]", "suns": "[{to_sun = [0.5, 1, 0.3], irradiance_w_m2 = [6, 5.5, 5]}]"}
GREY = {"environment_radiance": "[0.5, 0.5, 0.5]", "suns": "[]"}
NIGHT = {"environment_radiance": "[0, 0, 0]", "suns": "[]"}


def lamps(*places):
    return "[" + ", ".join(f"{{position_m = [{x}, {y}, {z}], intensity_w_sr = [{w}, {w}, {w}]}}" for x, y, z, w in places) + "]"


def facing_panel(x, y, z, half):
    """A square that faces the camera."""
    return quad([x - half, y - half, z], [x + half, y - half, z], [x + half, y + half, z], [x - half, y + half, z])


def lying_panel(x, y, z, half):
    """A square under the ceiling."""
    return quad([x - half, y, z - half], [x + half, y, z - half], [x + half, y, z + half], [x - half, y, z + half])


def rods():
    return joined([box([x - 0.0025, 0, -2.2], [x + 0.0025, 2.2, -2.195]) for x in (-1.1, -0.7, -0.3, 0.1, 0.5, 0.9)] +
                  [box([-1.5, y, -2.3], [1.5, y + 0.004, -2.296]) for y in (0.5, 1.0, 1.5)])


def checks(x, y):
    return (230, 230, 220, 255) if (x // 2 + y // 2) % 2 else (25, 25, 30, 255)


def leaves(x, y):
    return (60, 140, 40, 255 if (x * 7 + y * 13) % 5 < 2 else 0)


def one_texel(x, y):
    return (255, 255, 255, 255) if (x, y) == (37, 22) else (0, 0, 0, 255)


def sun_texel(strength):
    return lambda x, y: (strength,) * 3 if (x, y) == (40, 8) else ((0.35, 0.45, 0.7) if y < 16 else (0.12, 0.1, 0.08))


class Case:
    """One stimulus: a room, what it is lit by, an object, and what the depth map answers."""

    def __init__(self, name, room=OPEN, object_parts=None, light=None, artifact="receiver", scene=None, study="", tables="", camera=CAMERA, size=(64, 36), width=128, same_seed=False, truth_times=1, object_number=1, map=None, pattern=None, listed=None, **keys):
        self.name, self.room, self.camera, self.object_number, self.map = name, room, camera, object_number, map
        self.object_parts = object_parts or [(ball(0.35, (0, 0.351, 0)), WHITE)]
        self.artifact, self.study, self.tables, self.size, self.width, self.same_seed, self.truth_times = artifact, study, tables, size, width, same_seed, truth_times
        self.scene = {"bounces": "4", "albedo": "0.5", "materials": '"gltf"', "exposure_ev": "0"} | (light or DAY) | (scene or {}) | keys
        self.pattern = pattern or f"{name}-{artifact}-o{object_number}-*"
        self.listed = listed or self.pattern  # as the set's manifest calls it

    def write(self, folder, seed):
        """The study file's path."""
        write_gltf(os.path.join(folder, "room.gltf"), self.room, self.camera)
        write_gltf(os.path.join(folder, "object.gltf"), self.object_parts)
        if self.map:
            hdr(os.path.join(folder, "map.hdr"), 64, 32, self.map)
        level = f"depth_width_px = [{self.width}]\n" if self.width else ""
        text = f'format = "seamline study 1"\nname = "told"\nwidth_px = {self.size[0]}\nheight_px = {self.size[1]}\nsamples_per_pixel = 16\nseed = {seed}\n{level}{self.study}\n{self.tables}\n'
        if "isolation" not in self.study:
            text = text.replace("samples_per_pixel", 'isolation = "query"\nsamples_per_pixel', 1)
        text += f'[[scene]]\nname = "{self.name}"\nfile = "room.gltf"\nartifacts = ["{self.artifact}"]\n'
        camera = self.scene.get("camera")
        text += "".join(f"{key} = {value}\n" for key, value in self.scene.items() if key not in ("camera", "path"))
        if camera:
            text += f"[scene.camera]\n{camera}\n"
        for number, x in enumerate((-1.3, 0.0, 1.3)):
            z = -1.3 if number == 1 else -1.5
            text += f'[[scene.object]]\nname = "o{number}"\nfile = "object.gltf"\nposition_m = [{x}, 0.001, {z}]\n'
            if "path" in self.scene:
                text += f'path = {{kind = "line", to_m = [{x}, 0.001, {z - 0.6}], speed_m_s = 0.5}}\n'
        path = os.path.join(folder, f"study_{seed}.toml")
        with open(path, "w") as file:
            file.write(text)
        return path


def gloss(metallic, roughness):
    return [(ball(0.35, (0, 0.351, 0)), {"colour": (0.9, 0.85, 0.8), "metallic": metallic, "roughness": roughness})]


def cases():
    mirror_wall = [(joined([FLOOR, RIGHT]), WALL), (LEFT, RED), (BACK, {"colour": (0.95, 0.95, 0.95), "metallic": 1, "roughness": 0.0})]
    small_lamp = (facing_panel(0.4, 1.9, -2.0, 0.01), {"emits": (400, 380, 340)})
    lamp_behind = (lying_panel(0.6, 2.2, 0.8, 0.02), {"emits": (900, 850, 800)})
    slit_room = OPEN + [(FRONT, WALL), (quad([-3, 3, -4], [3, 3, -4], [3, 3, 2.9], [-3, 3, 2.9]), WALL)]
    box_lamp = [(ball(0.35, (0, 0.351, 0)), {"colour": (0.5, 0.5, 0.5), "emits": (2, 1.6, 1)})]
    out = [Case(f"metal_{int(100 * r):02d}", object_parts=gloss(1, r), artifact="reflection") for r in (0.0, 0.05, 0.2, 0.5)]
    out += [Case(f"gloss_{int(100 * r):02d}", object_parts=gloss(0, r), artifact="all") for r in (0.0, 0.3)]
    out += [
        Case("floor_gloss", room=[(joined([BACK, RIGHT]), WALL), (LEFT, RED), (FLOOR, {"colour": (0.5, 0.4, 0.3), "roughness": 0.1})]),
        Case("floor_metal", room=[(joined([BACK, RIGHT]), WALL), (LEFT, RED), (FLOOR, {"colour": (0.7, 0.7, 0.7), "metallic": 1, "roughness": 0.3})]),
        Case("lamp_in_view", room=CLOSED + [small_lamp], light=NIGHT, bounces="6"),
        Case("lamp_in_mirror_wall", room=mirror_wall + [(lying_panel(0.0, 2.0, 0.2, 0.02), {"emits": (300, 280, 250)})], light=GREY),
        Case("lamp_in_mirror_ball", room=CLOSED + [lamp_behind], object_parts=gloss(1, 0.0), light=GREY, artifact="none"),
        Case("lamp_in_mirror_ball_depth", room=CLOSED + [lamp_behind], object_parts=gloss(1, 0.05), light=GREY, artifact="all"),
        Case("texture", room=[(joined([BACK, RIGHT]), WALL), (LEFT, RED), (FLOOR, {"colour": (1, 1, 1), "picture": png(32, 32, checks)})]),
        Case("lit_texel_in_view", room=CLOSED + [(facing_panel(0.8, 1.6, -3.9, 0.6), {"colour": (0.1, 0.1, 0.1), "emits": (3000, 3000, 3000), "emits_picture": png(64, 64, one_texel)})], light=GREY),
        Case("lit_texel_behind", room=OPEN + [(quad([1.5, 0.5, 2.8], [-1.5, 0.5, 2.8], [-1.5, 2.5, 2.8], [1.5, 2.5, 2.8]), {"colour": (0.1, 0.1, 0.1), "emits": (20000, 20000, 20000), "emits_picture": png(64, 64, one_texel)})], light=GREY),
        Case("lamp_near_floor", light={"environment_radiance": "[0.05, 0.05, 0.05]", "suns": "[]"}, lamps=lamps((0.0, 0.75, -1.3, 2), (0.95, 0.61, -2.7, 0.3))),
        Case("lamp_near_wall", light=NIGHT, lamps=lamps((1.2, 1.2, -3.97, 1.5))),
        Case("lamp_near_wall_closed", room=CLOSED, light=NIGHT, lamps=lamps((2.95, 1.4, -2.5, 2))),
        Case("lamp_in_closed_room", truth_times=2, room=CLOSED, light=NIGHT, lamps=lamps((0.5, 2.4, -1.0, 6))),
        Case("spot", truth_times=2, room=CLOSED, light=NIGHT, lamps="[{position_m = [0, 2.8, -1], intensity_w_sr = [12, 12, 11], shines_along = [0.2, -1, -0.2], outer_deg = 25, inner_deg = 15}]"),
        Case("lamps_64", room=CLOSED, light=NIGHT, lamps=lamps(*[(-2.6 + 0.74 * i, 2.7, -3.6 + 0.85 * j, 0.25) for i in range(8) for j in range(8)])),
        Case("panel", truth_times=2, room=CLOSED + [(lying_panel(0, 2.98, -1.5, 0.6), {"emits": (6, 6, 5.5)})], light=NIGHT),
        Case("panel_small", room=CLOSED + [(lying_panel(0, 2.9, -1.5, 0.03), {"emits": (2000, 1900, 1700)})], light=NIGHT),
        Case("thing_that_glows", object_parts=box_lamp, light=GREY, artifact="all"),
        Case("thing_that_glows_closed", truth_times=2, room=CLOSED, object_parts=[(ball(0.35, (0, 0.351, 0)), {"emits": (8, 7, 6)})], light={"environment_radiance": "[0, 0, 0]", "suns": "[]"}, lamps=lamps((-1.5, 2.5, -2, 2)), artifact="bounce"),
        Case("sky_map", light={"environment": '"builtin:clear_sky"', "suns": "[]"}, exposure_ev="-1"),
        Case("map_sun_texel", light={"environment": '"map.hdr"', "suns": "[]"}, map=sun_texel(600)),
        Case("map_sun_texel_strong", truth_times=4, light={"environment": '"map.hdr"', "suns": "[]"}, map=sun_texel(20000), exposure_ev="-5"),
        Case("map_sun_texel_metal", light={"environment": '"map.hdr"', "suns": "[]"}, map=sun_texel(600), object_parts=gloss(1, 0.15), artifact="all"),
        Case("slit", truth_times=16, room=slit_room, light={"environment_radiance": "[20, 20, 20]", "suns": "[]"}),
        Case("slit_sun", truth_times=16, room=slit_room, light={"environment_radiance": "[2, 2, 2]", "suns": "[{to_sun = [0.0, 1, -0.06], irradiance_w_m2 = [60, 60, 60]}]"}),
        Case("ring_caustic", object_parts=[(ring_band(0.3, 0.25), {"colour": (0.95, 0.9, 0.7), "metallic": 1, "roughness": 0.02})]),
        Case("ring_caustic_lamp", room=CLOSED, object_parts=[(ring_band(0.3, 0.25), {"colour": (0.95, 0.9, 0.7), "metallic": 1, "roughness": 0.02})], light=NIGHT, lamps=lamps((0.8, 1.6, -0.9, 5))),
        Case("thin_rods", room=OPEN + [(rods(), BLACK)], artifact="occlusion"),
        Case("thin_rods_shadow", room=OPEN + [(rods(), BLACK)], artifact="overlap"),
        Case("leaves", room=OPEN + [(quad([-1.2, 0, -1.0], [0.9, 0, -1.0], [0.9, 1.8, -1.0], [-1.2, 1.8, -1.0]), {"colour": (1, 1, 1), "picture": png(32, 32, leaves), "alpha": "MASK"})], artifact="occlusion"),
        Case("depth_noise", width=None, same_seed=True, artifact="all", tables='[level]\nquantity = "depth_noise"\nvalues = [1]\n[depth]\nsource = "pinhole"\npreset = "tof_160x120"\n'),
        Case("structured_light", width=None, same_seed=True, artifact="receiver", tables='[level]\nquantity = "depth_noise"\nvalues = [1]\n[depth]\nsource = "pinhole"\npreset = "structured_light_640x480"\n'),
        Case("mask_shadow", study='isolation = "mask"', artifact="shadow"),
        Case("mask_overlap", study='isolation = "mask"', artifact="overlap", width=64),
        Case("mask_receiver_closed", study='isolation = "mask"', room=CLOSED, light=NIGHT, lamps=lamps((0.5, 2.4, -1.0, 6)), width=64),
        Case("mask_occlusion", study='isolation = "mask"', room=OPEN + [(box([-0.25, 0, -0.8], [0.1, 0.6, -0.6]), RED)], artifact="occlusion", width=64),
        Case("matte", truth_times=2, artifact="overlap", tables='[mitigation]\nshadow = "matte"\nmatte_width_px = 512\n', room=OPEN + [(box([-0.5, 0, -2.6], [0.4, 1.2, -2.3]), RED)]),
        Case("occlusion_mask", artifact="occlusion", tables='[mitigation]\nocclusion = "mask"\nmask_width_px = 512\n', room=OPEN + [(box([-0.25, 0, -0.8], [0.1, 0.6, -0.6]), RED)]),
        Case("panorama", size=(128, 64), camera=([0, 1.2, 1.0], 0.8), artifact="all", tables="[look]\nview_px = [64, 64]\nhorizontal_fov_deg = 60\n", scene={"camera": 'projection = "panorama"\nposition_m = [0, 1.2, 1.0]\nlook_at_m = [0, 1.0, -4]'}),
        Case("anaglyph", artifact="all", tables='[view]\nkind = "anaglyph"\nzero_parallax_m = 2.5\n'),
        Case("side_by_side", artifact="all", tables='[view]\nkind = "side_by_side"\nzero_parallax_m = 2.5\n'),
        Case("clip", artifact="shadow", scene={"path": ""}, tables='[clip]\nframes = 2\nframes_per_s = 4\n', pattern="clip-shadow-o1@*", listed="clip-shadow-o1-*"),
        Case("ambient_occlusion", light={"environment_radiance": "[1, 1, 1]"}, artifact="all", ambient_occlusion="true", ao_distance_m="1.5"),
        Case("photograph_albedo", artifact="bounce", study='mesh_albedo = "photograph"'),
        Case("soft_sun", light={"environment_radiance": "[0.3, 0.35, 0.45]", "suns": "[{to_sun = [0.5, 1, 0.3], irradiance_w_m2 = [6, 5.5, 5], angular_radius_deg = 6}]"}, artifact="all"),
        Case("shadow_map", artifact="shadow", tables='[pipeline]\nshadows = "shadow_map"\nshadow_map_px = 256\n'),
        Case("additive", artifact="all", tables='[pipeline]\ncompositing = "additive"\n'),
        Case("plus_3_ev", exposure_ev="3", light={"environment_radiance": "[0.1, 0.1, 0.12]", "suns": "[]"}, artifact="all", room=CLOSED[:2] + [(CEILING, WALL)]),
        Case("minus_4_ev", exposure_ev="-4", light={"environment_radiance": "[4, 5, 6]", "suns": "[{to_sun = [0.5, 1, 0.3], irradiance_w_m2 = [90, 80, 70]}]"}, artifact="all"),
        Case("white_closed", room=[(s, WHITE) for s, _ in CLOSED], light=NIGHT, lamps=lamps((0.5, 2.4, -1.0, 3)), albedo="0.9", bounces="12", artifact="all"),
        Case("black_room", room=[(s, BLACK) for s, _ in CLOSED], light=NIGHT, lamps=lamps((0.5, 2.4, -1.0, 20)), artifact="all"),
    ]
    return out
