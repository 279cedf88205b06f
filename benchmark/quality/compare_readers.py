#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether other programs read what meridian writes as it was meant.

usage: compare_readers.py PROGRAM MESH...

Every kind of file is written for each mesh, and its vertices, faces and texture coordinates are counted by Assimp,
Blender and VTK, as far as they read that kind, and from the text. Prints a line for each file; ends with 1 if two
counts differ. src/install-packages.sh readers installs what is needed; what is not there is left out, and said.
"""

import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile

IN_BLENDER = """
import bpy, json, sys
found = {}
for path in sys.argv[sys.argv.index('--') + 1:]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith('.obj'):
        bpy.ops.wm.obj_import(filepath=path)
    else:
        bpy.ops.import_mesh.ply(filepath=path)
    count = [0, 0, 0]
    for o in bpy.data.objects:
        m = o.data
        count[0] += len(m.vertices)
        count[1] += len(m.polygons)
        if m.uv_layers.active:
            uv = m.uv_layers.active.data
            count[2] += len({(l.vertex_index, *uv[l.index].uv) for l in m.loops})
    found[path] = count
print('COUNTS ' + json.dumps(found))
"""


def counts_in_text(path):
    """Vertices, faces and texture coordinates of an OBJ, OFF, PLY or VTP file, from its text."""
    with open(path, 'rb') as file:
        data = file.read()
    if path.endswith('.obj'):
        words = [line.split() for line in data.decode().split('\n') if line]
        texture = [tuple(struct.unpack('2f', struct.pack('2f', float(w[1]), float(w[2])))) for w in words if w[0] == 'vt']
        # readers take single precision, in which the two sides of a slit in a flat part can be one
        corners = {tuple(c.split('/')[:2]) for w in words if w[0] == 'f' for c in w[1:] if '/' in c}
        distinct = {(v, texture[int(t) - 1]) for v, t in corners}
        return [sum(w[0] == key for w in words) for key in ('v', 'f')] + [len(distinct)]
    if path.endswith('.off'):
        vertices, faces = re.search(rb'OFF\s+(\d+)\s+(\d+)', data).groups()
    elif path.endswith('.ply'):
        vertices, faces = (re.search(rb'element ' + e + rb' (\d+)', data).group(1) for e in (b'vertex', b'face'))
    else:
        vertices, faces = (re.search(n + rb'="(\d+)"', data).group(1) for n in (b'NumberOfPoints', b'NumberOfPolys'))
    is_textured = b'property double s\n' in data[:1000] or b'TCoords' in data
    return [int(vertices), int(faces), int(vertices) if is_textured else 0]


def counts_of_assimp(path):
    """Assimp doubles vertices: faces, and whether all that it has have texture coordinates, can be compared."""
    dump = path + '.assxml'
    subprocess.run(['assimp', 'dump', path, dump], check=True, stdout=subprocess.DEVNULL)
    with open(dump, encoding='utf-8') as file:
        text = file.read()
    os.remove(dump)
    points = re.findall(r'<Positions num="(\d+)"', text)
    textured = re.findall(r'<TextureCoords num="(\d+)"', text)
    return [None, sum(map(int, re.findall(r'<FaceList num="(\d+)"', text))), points == textured]


def counts_of_vtk(path):
    """As VTK's reader of that kind sees it. It has a point for each corner of a textured file: those alike are one."""
    import vtk
    readers = {'.obj': vtk.vtkOBJReader, '.ply': vtk.vtkPLYReader, '.vtp': vtk.vtkXMLPolyDataReader}
    reader = readers[os.path.splitext(path)[1]]()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    texture = mesh.GetPointData().GetTCoords()
    if not texture: # of PLY files it does not read s and t
        return [mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys(), None if path.endswith('.ply') else 0]
    corners = {mesh.GetPoint(i) + texture.GetTuple2(i) for i in range(mesh.GetNumberOfPoints())}
    return [None, mesh.GetNumberOfPolys(), len(corners)]


def counts_of_blender(paths):
    """Blender is started once for all."""
    run = subprocess.run(['blender', '-b', '--python-expr', IN_BLENDER, '--'] + paths, capture_output=True, text=True,
                         check=True)
    return json.loads(re.search('COUNTS (.*)', run.stdout).group(1))


def write_all(program, mesh, folder):
    """Every kind of output with faces, as name and path."""
    stem = os.path.join(folder, os.path.basename(mesh).split('.')[0])
    files = {f'cut {e}': f'{stem}.cut.{e}' for e in ('off', 'obj', 'ply', 'vtp')}
    for path in files.values():
        subprocess.run([program, 'cut', mesh, '-o', path, '--quiet'], check=True)
    files.update({'unwrap obj': f'{stem}.uv.obj', 'distortion ply': f'{stem}.d.ply', 'distortion vtp': f'{stem}.d.vtp',
                  'doubled ply': f'{stem}.2.ply', 'doubled vtp': f'{stem}.2.vtp', 'charts obj': f'{stem}.charts.obj', 'pack obj': f'{stem}.packed.obj'})
    subprocess.run([program, 'unwrap', mesh, '-o', files['unwrap obj'], '--png', f'{stem}.png', '--quiet',
                    '--distortion', files['distortion ply'], '--doubled', files['doubled ply']], check=True)
    subprocess.run([program, 'unwrap', mesh, '-o', files['charts obj'], '--charts', 'auto', '--quiet',
                    '--distortion', files['distortion vtp'], '--doubled', files['doubled vtp']], check=True)
    subprocess.run([program, 'pack', files['charts obj'], '-o', files['pack obj'], '--quiet'], check=True)
    return files


def differs(kind, path, reader, counts, expected):
    """Prints a line. What a reader cannot tell is None; of texture coordinates Assimp tells only whether all have them."""
    if reader == 'assimp':
        counts[2] = expected[2] if counts[2] or not expected[2] else 0
    wrong = [i for i in range(3) if counts[i] is not None and counts[i] != expected[i]]
    print(f'{os.path.basename(path)} | {kind} | {reader} | {counts} | {"DIFFERS from " + str(expected) if wrong else "same"}')
    return bool(wrong)


def main():
    program, meshes = os.path.abspath(sys.argv[1]), sys.argv[2:]
    has = {'assimp': shutil.which('assimp'), 'blender': shutil.which('blender')}
    try:
        import vtk
        has['vtk'] = vtk
    except ImportError:
        has['vtk'] = None
    for name, found in has.items():
        if not found:
            print(f'{name}: not here, and left out')
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        files = [(kind, path) for mesh in meshes for kind, path in write_all(program, mesh, folder).items()]
        in_blender = {}
        if has['blender']:
            in_blender = counts_of_blender([path for _, path in files if path.endswith(('.obj', '.ply'))])
        for kind, path in files:
            expected = counts_in_text(path)
            if has['assimp'] and not path.endswith('.vtp'):
                wrong += differs(kind, path, 'assimp', counts_of_assimp(path), expected)
            if path in in_blender:
                wrong += differs(kind, path, 'blender', in_blender[path], expected)
            if has['vtk'] and not path.endswith('.off'):
                wrong += differs(kind, path, 'vtk', counts_of_vtk(path), expected)
    print(f'{wrong} counts differ')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
