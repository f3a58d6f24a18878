"""Inside ParaView: opens a file, steps through its times and says as JSON what it sees; draws a chosen step and the last.

pvbatch paraview_frames.py FILE READER CHOSEN PICTURES
"""

import json
import sys
from pathlib import Path

from paraview import simple
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy

FILE, READER, CHOSEN, PICTURES = sys.argv[1], sys.argv[2], int(sys.argv[3]), Path(sys.argv[4])


def surfaces(data):
    """The meshes of a data set of many blocks, one after the other."""
    found = []
    places = data.NewIterator()
    while not places.IsDoneWithTraversal():
        found.append(places.GetCurrentDataObject())
        places.GoToNextItem()
    return found


def seen(reader, time):
    reader.UpdatePipeline(time)
    return [
        {"points": vtk_to_numpy(one.GetPoints().GetData()).tolist(), "facets": one.GetNumberOfCells(),
         "arrays": [one.GetPointData().GetArrayName(i) for i in range(one.GetPointData().GetNumberOfArrays())]}
        for one in surfaces(Fetch(reader))
    ]  # fmt: skip


def draw(reader, times):
    view = simple.CreateView("RenderView")
    view.ViewSize = [600, 450]
    view.OrientationAxesVisibility = 0
    simple.Show(reader, view)
    for name, time in (("chosen", times[CHOSEN]), ("last", times[-1])):
        view.ViewTime = time
        simple.ResetCamera(view)
        simple.Render(view)
        simple.SaveScreenshot(str(PICTURES / f"paraview_{Path(FILE).name}_{name}.png"), view)


reader = getattr(simple, READER)(FileName=FILE)
reader.UpdatePipelineInformation()
times = list(reader.TimestepValues)
steps = {step: seen(reader, times[step]) for step in (0, CHOSEN, len(times) - 1)}
draw(reader, times)
print("seen " + json.dumps({"times": times, "steps": steps}))
