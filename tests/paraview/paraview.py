#!/usr/bin/env python3
"""Reads the pictures of a kept simulation with foreign readers and compares their numbers with the answer's.

usage: pictures.py PROGRAM

Cells (.vtu) are read by meshio. It knows no images, so flows (.vti) are read by the few lines below and, where
python3-vtk9 is installed, by VTK's own reader too.
"""
import base64
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

import meshio
import numpy as np

try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError:
    vtk = None

PROGRAM = None
ROUNDING = 1e-10     # of double precision, summed over some thousand elements
SINGLE = 3e-7        # of single precision
KINDS = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}


class Image:
    """A .vti file."""

    def __init__(self, path):
        root = ET.parse(path).getroot()
        assert root.attrib["type"] == "ImageData" and root.attrib["header_type"] == "UInt64"
        grid = root.find("ImageData")
        extent = [int(word) for word in grid.attrib["WholeExtent"].split()]
        self.nodes = [extent[2 * i + 1] - extent[2 * i] + 1 for i in range(3)]
        self.origin = np.array([float(word) for word in grid.attrib["Origin"].split()])
        self.spacing = [float(word) for word in grid.attrib["Spacing"].split()]
        self.fields = {}
        for array in grid.iter("DataArray"):
            data = base64.b64decode(array.text.strip(), validate=True)
            assert int.from_bytes(data[:8], "little") == len(data) - 8
            numbers = np.frombuffer(data[8:], KINDS[array.attrib["type"]])
            parts = int(array.attrib.get("NumberOfComponents", "1"))
            shape = self.nodes[::-1] + ([parts] if parts > 1 else [])
            self.fields[array.attrib["Name"]] = numbers.reshape(shape)

    def of_the_sum(self):
        """What a sum over the rows leaves of a flow: second order in their distance."""
        return 1.0 / self.nodes[1] ** 2

    def flux(self, column):
        """Volume flow through a column of an axisymmetric flow."""
        rows = self.origin[1] + self.spacing[1] * np.arange(self.nodes[1])
        velocity = self.fields["velocity"][0, :, column, 0].astype(float)
        return float(np.sum(2 * math.pi * rows * velocity) * self.spacing[1])


def timeline(directory, name):
    """(time, path) of every entry of a .pvd file."""
    root = ET.parse(directory / name).getroot()
    assert root.attrib["type"] == "Collection"
    return [(float(entry.attrib["timestep"]), directory / entry.attrib["file"]) for entry in root.iter("DataSet")]


def ring_volumes(points, triangles):
    """Volumes of the rings with triangular section about the x axis, by Pappus."""
    corner = points[triangles]
    side, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    area = 0.5 * (side[:, 0] * other[:, 1] - side[:, 1] * other[:, 0])
    return 2 * math.pi * corner[:, :, 1].mean(axis=1) * area


def tetra_volumes(points, tetrahedra):
    corner = points[tetrahedra]
    edges = corner[:, 1:] - corner[:, :1]
    return np.einsum("ij,ij->i", edges[:, 0], np.cross(edges[:, 1], edges[:, 2])) / 6


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="bioprint-pictures-")
        cls.runs = {}

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def run_of(self, name, *options):
        """The directory of a run, simulated once, and its answer."""
        if name not in self.runs:
            directory = pathlib.Path(self.scratch.name) / name
            subprocess.run([PROGRAM, "-q", *options, "--out", str(directory)],
                           check=True, stdout=subprocess.DEVNULL)
            self.runs[name] = directory
        directory = self.runs[name]
        return directory, json.loads((directory / "answer.json").read_text())

    def series(self, directory):
        with open(directory / "series.csv", newline="") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def check_cells(self, directory):
        rows = {row["time [s]"]: row for row in self.series(directory)}
        entries = timeline(directory, "cell.pvd")
        times = [time for time, _ in entries]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual(times[-1], max(rows))
        for time, path in entries:
            mesh = meshio.read(path)
            row = rows[time]  # every picture is of a row of the series
            triangles = mesh.cells_dict["triangle"]
            rest = ring_volumes(mesh.points - mesh.point_data["displacement"], triangles)
            now = ring_volumes(mesh.points, triangles)
            stress = mesh.cell_data["von_mises"][0]
            self.assertAlmostEqual(now.sum() / rest.sum() / row["volume"], 1.0, delta=ROUNDING)
            self.assertAlmostEqual((stress * rest).sum() / rest.sum() / row["von_mises [Pa]"], 1.0, delta=ROUNDING)
            np.testing.assert_allclose(mesh.cell_data["jacobian"][0], now / rest, rtol=1e-8)
            centre = mesh.points[:, 0].mean()
            self.assertLess(abs(centre - row["x [m]"]), 8e-7)  # a tenth of the cell's radius
        return entries

    def test_cells_in_the_exit_have_the_volume_and_stress_of_the_series(self):
        directory, _ = self.run_of("exit", "--simulate=exit", "--resolution", "3")
        entries = self.check_cells(directory)
        self.assertGreater(len(entries), 30)  # twenty of each of two stages, but for those that come at once

    def test_cells_in_the_channel_have_the_volume_and_stress_of_the_series(self):
        directory, _ = self.run_of("channel", "--simulate=channel", "--resolution", "3", "--snapshots", "40")
        self.check_cells(directory)

    def test_a_cell_in_space_has_the_volume_and_stress_of_the_series(self):
        directory, _ = self.run_of("channel in space", "--simulate=channel", "--offset", "1.5Rc", "--resolution", "3",
                                   "--channel-time", "0.3ms", "--snapshots", "4")
        rows = {row["time [s]"]: row for row in self.series(directory)}
        entries = timeline(directory, "cell.pvd")
        self.assertGreaterEqual(len(entries), 4)
        for time, path in entries:
            mesh = meshio.read(path)
            tetrahedra = mesh.cells_dict["tetra"]
            rest = tetra_volumes(mesh.points - mesh.point_data["displacement"], tetrahedra)
            now = tetra_volumes(mesh.points, tetrahedra)
            mean = (mesh.cell_data["von_mises"][0] * rest).sum() / rest.sum()
            self.assertAlmostEqual(2 * rest.sum() / (4 / 3 * math.pi * 8e-6 ** 3), 1.0, delta=ROUNDING)
            self.assertAlmostEqual(now.sum() / rest.sum() / rows[time]["volume"], 1.0, delta=ROUNDING)
            self.assertAlmostEqual(mean / rows[time]["von_mises [Pa]"], 1.0, delta=ROUNDING)
            self.assertGreaterEqual(mesh.points[:, 2].min(), 0.0)

    def test_the_flow_keeps_its_volume_and_its_largest_velocity(self):
        directory, answer = self.run_of("exit", "--simulate=exit", "--resolution", "3")
        entries = timeline(directory, "flow.pvd")
        self.assertEqual([time for time, _ in entries], [time for time, _ in timeline(directory, "cell.pvd")])
        flow_rate, velocity_max = answer["nozzle"]["flow_rate"], answer["nozzle"]["velocity_max"]
        first = Image(entries[0][1])
        self.assertAlmostEqual(first.origin[1], 0.5 * first.spacing[1])
        for column in (0, first.nodes[0] - 1):
            self.assertAlmostEqual(first.flux(column) / flow_rate, 1.0, delta=first.of_the_sum())
        # 19 nodes a radius: the axis is half a spacing below the first row.
        self.assertAlmostEqual(first.fields["velocity"][..., 0].max() / velocity_max, 1.0, delta=5e-3)
        for _, path in entries:
            image = Image(path)
            for name, field in image.fields.items():
                self.assertTrue(np.isfinite(field).all(), name)
            np.testing.assert_allclose(image.fields["viscosity"] * image.fields["shear_rate"],
                                       image.fields["stress"], rtol=SINGLE)
        plug = Image(entries[-1][1]).fields["velocity"][..., 0]
        self.assertAlmostEqual(plug.mean() / answer["nozzle"]["velocity_average"], 1.0, delta=1e-2)

    def test_the_flow_without_a_cell_is_one_picture(self):
        directory, answer = self.run_of("exit-flow", "--simulate=exit-flow", "--resolution", "4")
        self.assertFalse((directory / "cell.pvd").exists())
        (time, path), = timeline(directory, "flow.pvd")
        self.assertEqual(time, 0.0)
        image = Image(path)
        simulated = answer["simulation"]["simulated"]
        largest = np.abs(image.fields["velocity"][..., 1]).max()
        self.assertAlmostEqual(largest / simulated["radial_velocity_max"], 1.0, delta=5e-2)
        self.assertAlmostEqual(image.flux(0) / answer["nozzle"]["flow_rate"], 1.0, delta=image.of_the_sum())
        self.assertLess(image.origin[0], 0.0)  # the lip is at 0
        self.assertGreater(image.origin[0] + image.nodes[0] * image.spacing[0], 0.0)

    @unittest.skipUnless(vtk, "python3-vtk9 is not installed")
    def test_vtk_reads_the_same(self):
        directory, _ = self.run_of("exit", "--simulate=exit", "--resolution", "3")
        for _, path in timeline(directory, "flow.pvd"):
            reader = vtk.vtkXMLImageDataReader()
            reader.SetFileName(str(path))
            reader.Update()
            data = reader.GetOutput().GetPointData()
            for name, field in Image(path).fields.items():
                np.testing.assert_array_equal(vtk_to_numpy(data.GetArray(name)).ravel(), field.ravel())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
