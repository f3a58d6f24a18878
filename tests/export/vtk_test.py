"""VTK reads what `trocar export` writes: Debian's python3-vtk9, or the VTK in python3-paraview. It draws on an X server,
such as xvfb-run's.

xvfb-run -a /usr/bin/python3 vtk_test.py PROGRAM PICTURES
"""

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from exported_case import ExportedCase, run_tests

BACKGROUND = (1.0, 1.0, 1.0)


def read(reader, path):
    reader.SetFileName(str(path))
    problems = []
    reader.AddObserver("ErrorEvent", lambda *_: problems.append(f"{path.name}: VTK reports an error"))
    reader.Update()
    if problems:
        raise AssertionError(problems[0])
    return reader.GetOutput()


def points(surface):
    """As float32, which is what is stored; some of VTK's readers give doubles."""
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(np.float32)


def facets(surface):
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    ends = vtk_to_numpy(surface.GetPolys().GetOffsetsArray())
    np.testing.assert_array_equal(ends, np.arange(0, 3 * surface.GetNumberOfPolys() + 1, 3))
    return corners.reshape(-1, 3)


def array(data, name):
    found = data.GetArray(name)
    if found is None:
        raise AssertionError(f"there is no {name}, but {[data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]}")
    return vtk_to_numpy(found)


class Vtk(ExportedCase):
    def check_series(self, make_reader, ending):
        """Every step, to the last bit of what is stored."""
        for step in range(len(self.times)):
            for moment in ("found", "handled", "deformed"):
                organ = read(make_reader(), self.folder / f"organ_{moment}_{step:04}.{ending}")
                np.testing.assert_array_equal(points(organ), self.stored[moment][step])
                np.testing.assert_array_equal(facets(organ), self.stored["facets"])
            tool = read(make_reader(), self.folder / f"tool_{step:04}.{ending}")
            # Stored as the tool at rest and its pose, placed in float32 by the program and in float64 here.
            np.testing.assert_allclose(points(tool), self.stored["tool_placed"][step], rtol=0, atol=2e-5)
            np.testing.assert_array_equal(facets(tool), self.stored["tool_facets"])

    def test_obj(self):
        self.check_series(vtk.vtkOBJReader, "obj")

    def test_ply(self):
        self.check_series(vtk.vtkPLYReader, "ply")

    def test_vtp(self):
        self.check_series(vtk.vtkXMLPolyDataReader, "vtp")

    def test_vtp_says_what_the_strategy_did(self):
        step = self.busiest_step()
        for moment in ("found", "handled", "deformed"):
            organ = read(vtk.vtkXMLPolyDataReader(), self.folder / f"organ_{moment}_{step:04}.vtp")
            data = organ.GetPointData()
            found, handled, now = (self.stored[name][step].astype(float) for name in ("found", "handled", moment))
            np.testing.assert_array_equal(array(data, "displacement"), handled - found)
            np.testing.assert_array_equal(array(data, "from_rest"), now - self.stored["rest_positions"].astype(float))
            np.testing.assert_array_equal(np.flatnonzero(array(data, "moved")), np.sort(self.moved(step)))
            self.assertEqual(array(organ.GetFieldData(), "TimeValue").tolist(), [self.times[step]])

    def test_what_is_inside_the_tool_vtk_finds_inside_too(self):
        step = self.busiest_step()
        distance = vtk.vtkImplicitPolyDataDistance()  # negative inside
        distance.SetInput(read(vtk.vtkXMLPolyDataReader(), self.folder / f"tool_{step:04}.vtp"))
        counts = {}
        for moment in ("found", "deformed"):
            organ = read(vtk.vtkXMLPolyDataReader(), self.folder / f"organ_{moment}_{step:04}.vtp")
            depths = np.array([distance.EvaluateFunction(point) for point in points(organ).astype(float)])
            clear = np.abs(depths) > 1e-3  # mm: not at the surface itself
            inside = array(organ.GetPointData(), "inside_tool").astype(bool)
            np.testing.assert_array_equal(inside[clear], depths[clear] < 0)
            touching = array(organ.GetCellData(), "in_tool").astype(bool)
            self.assertTrue(touching[inside[facets(organ)].any(axis=1)].all())
            counts[moment] = inside.sum()
        self.assertGreater(counts["found"], counts["deformed"])

    def test_a_frame_is_drawn(self):
        step = self.busiest_step()
        pixels = self.draw([f"organ_handled_{step:04}.vtp", f"tool_{step:04}.vtp"])
        shown = (pixels != 255).any(axis=2)
        self.assertGreater(shown.mean(), 0.03, "the picture is all but empty")
        self.assertGreater(len(np.unique(pixels[shown], axis=0)), 50, "the picture is not shaded")

    def draw(self, names):
        scene = vtk.vtkRenderer()
        scene.SetBackground(*BACKGROUND)
        for name, color in zip(names, ((0.80, 0.45, 0.40), (0.45, 0.50, 0.60))):
            mapper = vtk.vtkPolyDataMapper()
            mapper.SetInputData(read(vtk.vtkXMLPolyDataReader(), self.folder / name))
            mapper.ScalarVisibilityOff()
            actor = vtk.vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetColor(*color)
            scene.AddActor(actor)
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetSize(600, 450)
        window.AddRenderer(scene)
        window.Render()
        picture = vtk.vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.ReadFrontBufferOff()
        writer = vtk.vtkPNGWriter()
        writer.SetFileName(str(self.pictures / "vtk.png"))
        writer.SetInputConnection(picture.GetOutputPort())
        writer.Write()
        image = picture.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


if __name__ == "__main__":
    run_tests()
