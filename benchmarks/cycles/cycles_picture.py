"""A glTF scene rendered by Blender's Cycles as `seamline picture` renders it: the same camera, light, filter and number of bounces.

blender -b --factory-startup -P cycles_picture.py -- SCENE.glb OUT.exr KEY=VALUE...

width, height, spp, bounces, seed, threads; map (an EXR file) and rotation (degrees, as of --environment-rotation), or environment=R,G,B;
look_at=X,Y,Z and fov (horizontal, degrees): a camera in the origin in place of the file's; objects=FILE:X:Y:Z;... more files, moved there;
exposure (stops): of OUT.png, whose codes are sRGB's;
materials: diffuse      base colours alone, Lambert's law (seamline's --materials diffuse)
           gltf         seamline's: Lambert's law below a layer of GGX, which keeps from it what it sends back itself (a table of the viewer's
                        cosine and the roughness, integrated here); the layer and metals are Principled's speculars
           principled   what Blender's importer makes of them
specular   of the layer, in Principled's words: 0.5 is Fresnel's law of index 1.5. Schlick's term of f0 = 0.04, which is glTF's and seamline's, sends
           back 0.0857 of light from everywhere, Fresnel's 0.0918; 0.4356 makes Fresnel's as much
multiple   1: GGX with all of its scatterings (Cycles' own), 0: with one
"""
import math
import sys
import time

import bpy
import mathutils
import numpy

if not hasattr(numpy, "bool"):
    numpy.bool = bool  # Blender 3.4's importer beside a newer numpy


def settings(arguments):
    scene_file, out = arguments[:2]
    values = {"width": 480, "height": 270, "spp": 64, "bounces": 4, "seed": 1, "threads": 0, "map": "", "rotation": 0.0,
              "materials": "gltf", "multiple": 1, "specular": 0.5, "environment": "", "look_at": "", "fov": 40.0, "objects": "", "exposure": 0.0}
    for argument in arguments[2:]:
        key, value = argument.split("=", 1)
        if key not in values:
            sys.exit(f"cycles_picture.py: no setting is called {key}")
        values[key] = type(values[key])(value)
    return scene_file, out, values


def set_world(path, rotation_deg, constant):
    world = bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    background = nodes["Background"]
    if not path:
        background.inputs["Color"].default_value = [float(v) for v in constant.split(",")] + [1] if constant else (0, 0, 0, 1)
        return
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(path)
    texture.image.colorspace_settings.name = "Linear"
    texture.interpolation = "Linear"
    mapping = nodes.new("ShaderNodeMapping")
    place = nodes.new("ShaderNodeTexCoord")
    # A map's middle looks along glTF's -Z, which is Blender's +Y; Blender's own looks along +X.
    mapping.inputs["Rotation"].default_value = (0, 0, -math.pi / 2 - math.radians(rotation_deg))
    links.new(place.outputs["Generated"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
    links.new(texture.outputs["Color"], background.inputs["Color"])
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = texture.image.size[0]


def source(material, principled, name):
    """What feeds an input: the socket of a link, or the number itself."""
    entry = principled.inputs[name]
    return entry.links[0].from_socket if entry.links else entry.default_value


def feed(links, value, entry):
    if isinstance(value, bpy.types.NodeSocket):
        links.new(value, entry)
    else:
        entry.default_value = value


def layer_reflectance(cosines, roughnesses, samples=4096):
    """What a layer of GGX over glass of index 1.5 (Schlick's f0 = 0.04) sends back, rows by roughness, columns by the viewer's cosine: visible
    normals are sampled (Heitz 2018), and each weighs F G2 / G1."""
    table = numpy.zeros((len(roughnesses), len(cosines)))
    side = int(math.sqrt(samples))
    u, v = (grid.ravel() for grid in numpy.meshgrid((numpy.arange(side) + 0.5) / side, (numpy.arange(side) + 0.5) / side))
    for row, roughness in enumerate(roughnesses):
        alpha = max(roughness * roughness, 1e-3)
        for column, cosine in enumerate(cosines):
            sine = math.sqrt(1 - cosine * cosine)
            length = math.hypot(alpha * sine, cosine)
            x, z = alpha * sine / length, cosine / length
            radius, turn = numpy.sqrt(u), 2 * math.pi * v
            first, second = radius * numpy.cos(turn), radius * numpy.sin(turn)
            half = 0.5 * (1 + z)
            second = (1 - half) * numpy.sqrt(1 - first**2) + half * second
            third = numpy.sqrt(numpy.maximum(0, 1 - first**2 - second**2))
            # Axes: y, then (x, 0, z) x y = (-z, 0, x), then (x, 0, z).
            normal = numpy.stack([alpha * (third * x - second * z), alpha * first, numpy.maximum(0, second * x + third * z)])
            normal /= numpy.linalg.norm(normal, axis=0)
            along = sine * normal[0] + cosine * normal[2]
            out = 2 * along * normal[2] - cosine
            shadow = lambda c: 0.5 * (numpy.sqrt(1 + alpha**2 * (1 / numpy.maximum(c, 1e-6)**2 - 1)) - 1)
            fresnel = 0.04 + 0.96 * (1 - numpy.clip(along, 0, 1))**5
            table[row, column] = numpy.mean(numpy.where(out > 0, fresnel * (1 + shadow(cosine)) / (1 + shadow(cosine) + shadow(out)), 0))
    return table


def passed_by_layer(nodes, links, colour, roughness, normal):
    """The base's colour times what the layer above it lets through."""
    side = 32
    image = bpy.data.images.get("layer")
    if image is None:
        steps = (numpy.arange(side) + 0.5) / side
        image = bpy.data.images.new("layer", side, side, float_buffer=True, is_data=True)
        kept = 1 - layer_reflectance(steps, steps)
        image.pixels = numpy.stack([kept, kept, kept, numpy.ones_like(kept)], axis=-1).ravel().tolist()
        image.pack()
    geometry, dot = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeVectorMath")
    dot.operation = "DOT_PRODUCT"
    links.new(normal if isinstance(normal, bpy.types.NodeSocket) else geometry.outputs["Normal"], dot.inputs[0])
    links.new(geometry.outputs["Incoming"], dot.inputs[1])
    place, table = nodes.new("ShaderNodeCombineXYZ"), nodes.new("ShaderNodeTexImage")
    links.new(dot.outputs["Value"], place.inputs[0])
    feed(links, roughness, place.inputs[1])
    table.image, table.extension, table.interpolation = image, "EXTEND", "Linear"
    links.new(place.outputs[0], table.inputs["Vector"])
    product = nodes.new("ShaderNodeMixRGB")
    product.blend_type = "MULTIPLY"
    product.inputs["Fac"].default_value = 1
    feed(links, colour, product.inputs["Color1"])
    links.new(table.outputs["Color"], product.inputs["Color2"])
    return product.outputs["Color"]


def by_words_of_gltf(material, values):
    nodes, links = material.node_tree.nodes, material.node_tree.links
    principled = next((node for node in nodes if node.type == "BSDF_PRINCIPLED"), None)
    if principled is None:
        return
    if values["materials"] == "principled":
        principled.distribution = "MULTI_GGX" if values["multiple"] else "GGX"
        return
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    colour, metallic, roughness, normal = (source(material, principled, name)
                                           for name in ("Base Color", "Metallic", "Roughness", "Normal"))
    glow = source(material, principled, "Emission")
    strength = source(material, principled, "Emission Strength")

    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Roughness"].default_value = 0
    feed(links, colour, diffuse.inputs["Color"])
    surface = diffuse
    if values["materials"] == "gltf":
        distribution = "MULTI_GGX" if values["multiple"] else "GGX"
        layer, metal = nodes.new("ShaderNodeBsdfPrincipled"), nodes.new("ShaderNodeBsdfPrincipled")
        for node in (layer, metal):
            node.distribution = distribution
            feed(links, roughness, node.inputs["Roughness"])  # Cycles squares it itself
        layer.inputs["Base Color"].default_value = (0, 0, 0, 1)
        layer.inputs["Specular"].default_value = values["specular"]
        metal.inputs["Metallic"].default_value = 1
        feed(links, colour, metal.inputs["Base Color"])
        links.new(passed_by_layer(nodes, links, colour, roughness, normal), diffuse.inputs["Color"])
        layered, mixed = nodes.new("ShaderNodeAddShader"), nodes.new("ShaderNodeMixShader")
        links.new(diffuse.outputs[0], layered.inputs[0])
        links.new(layer.outputs[0], layered.inputs[1])
        feed(links, metallic, mixed.inputs[0])
        links.new(layered.outputs[0], mixed.inputs[1])
        links.new(metal.outputs[0], mixed.inputs[2])
        surface = mixed
        if isinstance(normal, bpy.types.NodeSocket):
            for node in (diffuse, layer, metal):
                links.new(normal, node.inputs["Normal"])
    emission, added = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeAddShader")
    feed(links, glow, emission.inputs["Color"])
    feed(links, strength, emission.inputs["Strength"])
    links.new(surface.outputs[0], added.inputs[0])
    links.new(emission.outputs[0], added.inputs[1])
    links.new(added.outputs[0], output.inputs["Surface"])


def in_blender(x, y, z):
    """glTF's y is up, Blender's z."""
    return mathutils.Vector((x, -z, y))


def look_at(place, fov_deg):
    camera = bpy.data.objects.new("view", bpy.data.cameras.new("view"))
    camera.data.sensor_fit, camera.data.angle = "HORIZONTAL", math.radians(fov_deg)
    camera.data.clip_start = 0.01
    camera.rotation_euler = in_blender(*(float(v) for v in place.split(","))).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(camera)
    return camera


def add_object(described):
    file, *place = described.rsplit(":", 3)
    before = set(bpy.context.scene.objects)
    bpy.ops.import_scene.gltf(filepath=file)
    for thing in set(bpy.context.scene.objects) - before:
        if thing.parent is None:
            thing.location += in_blender(*(float(v) for v in place))


def main():
    scene_file, out, values = settings(sys.argv[sys.argv.index("--") + 1:])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=scene_file)
    scene = bpy.context.scene
    for described in filter(None, values["objects"].split(";")):
        add_object(described)
    scene.camera = look_at(values["look_at"], values["fov"]) if values["look_at"] else next(thing for thing in scene.objects if thing.type == "CAMERA")
    for light in bpy.data.lights:
        if light.type != "SUN":
            light.shadow_soft_size = 0
    for material in bpy.data.materials:
        if material.use_nodes:
            by_words_of_gltf(material, values)
    set_world(values["map"], values["rotation"], values["environment"])

    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = values["width"], values["height"], 100
    render.threads_mode, render.threads = ("FIXED", values["threads"]) if values["threads"] else ("AUTO", 0)
    cycles.device = "CPU"
    cycles.samples, cycles.seed = values["spp"], values["seed"]
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    # A path's first surface is no bounce of ours, and is none of Cycles'.
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = values["bounces"]
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = True
    cycles.light_sampling_threshold = 0
    cycles.min_light_bounces = cycles.min_transparent_bounces = values["bounces"]
    codes = out.endswith(".png")
    render.image_settings.file_format = "PNG" if codes else "OPEN_EXR"
    render.image_settings.color_mode, render.image_settings.color_depth = "RGB", "8" if codes else "32"
    scene.view_settings.view_transform = "Standard" if codes else "Raw"
    scene.view_settings.exposure = values["exposure"]
    render.dither_intensity = 0
    render.filepath = out
    render.use_file_extension = False
    begun = time.monotonic()
    bpy.ops.render.render(write_still=True)
    print(f"cycles_seconds {time.monotonic() - begun:.3f}")


main()
