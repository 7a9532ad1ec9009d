# SPDX-License-Identifier: GPL-3.0-or-later
"""The other side of surface_peer: times Blender's bevel and subdivision on given meshes.

blender -b --factory-startup -P surface_peer.py -- JOBS

JOBS is a text file with one job a line: "bevel MESH RADIUS SEGMENTS" or "subdivide MESH LEVEL". A
mesh file has lines "v x y z", "f i k ..." and, for edges to be bevelled, "e i k"; indices count
from 0. Prints "PEER job-number milliseconds edges faces" for each.
"""
import sys
import time

import bmesh
import bpy

REPEATS = 15


def read_mesh(path):
    points, faces, edges = [], [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            word, *numbers = line.split()
            if word == "v":
                points.append(tuple(float(x) for x in numbers))
            elif word == "f":
                faces.append([int(x) for x in numbers])
            else:
                edges.append(frozenset(int(x) for x in numbers))
    mesh = bpy.data.meshes.new("shape")
    mesh.from_pydata(points, [], faces)
    if mesh.validate():
        raise SystemExit(f"{path} is no mesh")
    return mesh, set(edges)


def bevel(path, radius, segments):
    mesh, wanted = read_mesh(path)
    times = []
    for _ in range(REPEATS):
        shape = bmesh.new()
        shape.from_mesh(mesh)
        chosen = [e for e in shape.edges if frozenset(v.index for v in e.verts) in wanted]
        start = time.perf_counter()
        bmesh.ops.bevel(shape, geom=chosen, offset=float(radius), segments=int(segments),
                        profile=0.5, affect="EDGES", clamp_overlap=True)
        times.append(time.perf_counter() - start)
        faces = len(shape.faces)
        shape.free()
    return min(times), len(chosen), faces


def subdivide(path, level):
    mesh, _ = read_mesh(path)
    thing = bpy.data.objects.new("shape", mesh)
    bpy.context.collection.objects.link(thing)
    modifier = thing.modifiers.new("smooth", "SUBSURF")
    modifier.levels = modifier.render_levels = int(level)
    layer = bpy.context.view_layer
    layer.update()
    times = []
    for _ in range(REPEATS):
        # A point that moves makes the surface be made anew.
        mesh.vertices[0].co.x += 1e-4
        mesh.update()
        thing.update_tag()
        start = time.perf_counter()
        layer.update()
        times.append(time.perf_counter() - start)
    seen = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    faces = len(seen.to_mesh().polygons)
    seen.to_mesh_clear()
    edges = len(mesh.edges)
    bpy.data.objects.remove(thing)
    return min(times), edges, faces


def main():
    jobs = {"bevel": bevel, "subdivide": subdivide}
    with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as lines:
        for number, line in enumerate(lines):
            name, *arguments = line.split()
            seconds, edges, faces = jobs[name](*arguments)
            print(f"PEER {number} {1e3 * seconds:.4f} {edges} {faces}", flush=True)


main()
