#!/usr/bin/env python3
"""Turns a Gmsh 2.2 mesh of a ball into the project's compact text form.

    tetrahedra 1
    NODES ELEMENTS
    x y z          one line a node, radius 1; nodes of the surface lie on it to the last digit
    a b c d        one line a tetrahedron, nodes counted from 0, positive volume
"""
import math
import sys


def read(path):
    nodes, tetrahedra = {}, []
    with open(path, encoding="ascii") as file:
        lines = iter(file)
        for line in lines:
            if line.startswith("$Nodes"):
                for _ in range(int(next(lines))):
                    tag, x, y, z = next(lines).split()
                    nodes[int(tag)] = [float(x), float(y), float(z)]
            elif line.startswith("$Elements"):
                for _ in range(int(next(lines))):
                    field = [int(word) for word in next(lines).split()]
                    if field[1] == 4:
                        tetrahedra.append(field[3 + field[2]:])
    return nodes, tetrahedra


def volume(a, b, c, d):
    u, v, w = ([q[i] - a[i] for i in range(3)] for q in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6.0


def main(source, target):
    nodes, tetrahedra = read(source)
    used = sorted({tag for element in tetrahedra for tag in element})
    number = {tag: i for i, tag in enumerate(used)}
    for point in nodes.values():
        radius = math.hypot(*point)
        if abs(radius - 1.0) < 1e-6:
            point[:] = [x / radius for x in point]
        point[:] = [0.0 if abs(x) < 1e-9 else x for x in point]
    with open(target, "w", encoding="ascii") as file:
        file.write(f"tetrahedra 1\n{len(used)} {len(tetrahedra)}\n")
        for tag in used:
            file.write("{:.9g} {:.9g} {:.9g}\n".format(*nodes[tag]))
        for element in tetrahedra:
            if volume(*(nodes[tag] for tag in element)) < 0.0:
                element[0], element[1] = element[1], element[0]
            file.write("{} {} {} {}\n".format(*(number[tag] for tag in element)))
    total = sum(abs(volume(*(nodes[tag] for tag in element))) for element in tetrahedra)
    print(f"{target}: {len(used)} nodes, {len(tetrahedra)} tetrahedra, volume {total:.5f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
