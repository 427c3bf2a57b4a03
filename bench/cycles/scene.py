"""Renders with Cycles what a job file (JSON, made by bench/cycles) describes. Blender 3.4.

    blender -b --factory-startup --python scene.py -- JOB.json

Lambent has Y up, Blender Z up: (x, y, z) is (x, -z, y) there. For each picture one line is printed:
"picture SECONDS CPU_SECONDS", from the scene as Blender holds it to the file on disk.
"""

import json
import os
import sys
import time

import bmesh
import bpy
import mathutils


def upright(v):
    return (v[0], -v[2], v[1])


def make_mesh(job):
    """The triangles as they are; vertices in the same place become one, or the shading would have seams."""
    mesh = bpy.data.meshes.new("sphere")
    mesh.from_pydata([upright(p) for p in job["positions"]], [], job["triangles"])
    shape = bmesh.new()
    shape.from_mesh(mesh)
    bmesh.ops.remove_doubles(shape, verts=shape.verts, dist=1e-6)
    shape.to_mesh(mesh)
    shape.free()
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    mesh.update()
    mesh.materials.append(None)
    off = max((v.normal - v.co.normalized()).length for v in mesh.vertices)
    print("normals off by at most %.2g radians" % off)
    return mesh


def make_material(roughness, distribution, reflectance):
    material = bpy.data.materials.new("white metal")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    glossy = nodes.new("ShaderNodeBsdfGlossy")
    glossy.distribution = distribution
    glossy.inputs["Color"].default_value = (reflectance, reflectance, reflectance, 1.0)
    glossy.inputs["Roughness"].default_value = roughness  # alpha is its square
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(glossy.outputs["BSDF"], output.inputs["Surface"])
    return material


def make_spheres(job):
    mesh = make_mesh(job)
    materials = {}
    for sphere in job["spheres"]:
        roughness = sphere["roughness"]
        if roughness not in materials:
            materials[roughness] = make_material(roughness, job["distribution"], job.get("reflectance", 1.0))
        ball = bpy.data.objects.new("sphere", mesh)
        ball.location = upright(sphere["centre"])
        ball.material_slots[0].link = "OBJECT"
        ball.material_slots[0].material = materials[roughness]
        bpy.context.scene.collection.objects.link(ball)


def make_world(panorama):
    world = bpy.data.worlds.new("panorama")
    world.use_nodes = True
    nodes = world.node_tree.nodes
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(panorama)
    picture.image.colorspace_settings.name = "Linear"
    world.node_tree.links.new(picture.outputs["Color"], nodes["Background"].inputs["Color"])
    bpy.context.scene.world = world


def make_camera(camera):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = camera["vertical_fov"]
    data.clip_start = 1e-3
    eye = bpy.data.objects.new("camera", data)
    axes = [upright(camera[axis]) for axis in ("right", "up", "back")]
    turn = mathutils.Matrix(axes).transposed().to_4x4()
    eye.matrix_world = mathutils.Matrix.Translation(upright(camera["position"])) @ turn
    bpy.context.scene.collection.objects.link(eye)
    bpy.context.scene.camera = eye


def set_integrator(job):
    """What would make a picture differ for another reason than its noise is off."""
    cycles = bpy.context.scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = job["adaptive"]
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.light_sampling_threshold = 0.0
    if job.get("reflectance", 1.0) < 1.0:
        cycles.min_light_bounces = job["bounces"]  # or by roulette hardly a path would leave a dark sphere
    # Cycles counts what comes after the first reflection.
    cycles.max_bounces = cycles.glossy_bounces = cycles.diffuse_bounces = job["bounces"] - 1


def set_output(job):
    render = bpy.context.scene.render
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = job["width"], job["height"]
    render.resolution_percentage = 100
    render.film_transparent = False
    render.threads_mode, render.threads = "FIXED", job["threads"]
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGB"
    render.image_settings.color_depth = "32"
    bpy.context.scene.view_settings.view_transform = "Raw"


def render(picture):
    scene = bpy.context.scene
    scene.cycles.samples = picture["samples"]
    scene.cycles.seed = picture["seed"]
    scene.render.filepath = picture["output"]
    wall, cpu = time.monotonic(), sum(os.times()[:2])
    bpy.ops.render.render(write_still=True)
    print("picture %.4f %.4f" % (time.monotonic() - wall, sum(os.times()[:2]) - cpu))


def main():
    with open(sys.argv[sys.argv.index("--") + 1]) as file:
        job = json.load(file)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    set_output(job)
    set_integrator(job)
    make_spheres(job)
    make_world(job["panorama"])
    make_camera(job["camera"])
    for picture in job["pictures"]:
        render(picture)


main()
