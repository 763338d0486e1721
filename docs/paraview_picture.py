"""A picture of one stage of a run: the deviation on the surface, what is beyond the gate, the toolpath.

    pvpython docs/paraview_picture.py STAGE_FOLDER GATE_MM PICTURE.png
"""

import sys

from paraview.simple import (CellDatatoPointData, Clip, ColorBy, CreateRenderView, ExtractSurface,
                             GetColorTransferFunction, GetScalarBar, SaveScreenshot, Show, Threshold,
                             Transform, Tube, XMLPolyDataReader)

stage, gate_mm, picture = sys.argv[1], float(sys.argv[2]), sys.argv[3]

view = CreateRenderView()
view.ViewSize = [900, 500]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0


def add_bar(colours, shown, title, place):
    """The colour bar of what is shown, dark on white."""
    bar = GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = title, ''
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.WindowLocation, bar.Position = 'Any Location', place
    bar.ScalarBarLength = 0.5
    shown.SetScalarBarVisibility(view, True)


# The deviation, on a diverging scale: blue is cut too deep, red is left standing.
deviation = XMLPolyDataReader(FileName=[stage + '/deviation.vtp'])
surface = Show(deviation, view)
ColorBy(surface, ('POINTS', 'deviation_mm'))
colours = GetColorTransferFunction('deviation_mm')
colours.ApplyPreset('Cool to Warm', True)
colours.RescaleTransferFunction(-2 * gate_mm, 2 * gate_mm)
add_bar(colours, surface, 'deviation, mm', [0.03, 0.4])

# What stands beyond the gate, in yellow, a little above it so that it is seen.
beyond = Clip(Input=deviation, ClipType='Scalar', Scalars=['POINTS', 'uncut_mm'], Value=gate_mm)
beyond.Invert = 0
lifted = Transform(Input=ExtractSurface(Input=beyond))
lifted.Transform.Translate = [0, 0, 0.03]
places = Show(lifted, view)
ColorBy(places, ('POINTS', None))
places.AmbientColor = places.DiffuseColor = [1.0, 0.85, 0.1]

# Half of the feed moves as a tube, coloured by what they removed.
path = XMLPolyDataReader(FileName=[stage + '/toolpath.vtp'])
feeds = Threshold(Input=path, Scalars=['CELLS', 'kind'])
feeds.ThresholdMethod = 'Between'
feeds.LowerThreshold = feeds.UpperThreshold = 1
tube = Tube(Input=CellDatatoPointData(Input=ExtractSurface(Input=feeds)))
tube.Radius = 0.07
half = Clip(Input=tube, ClipType='Plane')
half.ClipType.Origin, half.ClipType.Normal = [0, 0, 0], [1, 0, 0]
lines = Show(half, view)
ColorBy(lines, ('POINTS', 'removal_rate_mm3_min'))
rates = GetColorTransferFunction('removal_rate_mm3_min')
rates.ApplyPreset('Viridis (matplotlib)', True)
rates.RescaleTransferFunction(0, 3000)
add_bar(rates, lines, 'removal rate, mm³/min', [0.86, 0.4])

view.CameraViewUp = [0, 0, 1]
view.CameraFocalPoint = [-1, -1, 0]
view.CameraPosition = [-18, -30, 40]
view.CameraParallelProjection = 1
view.CameraParallelScale = 11.5
SaveScreenshot(picture, view, CompressionLevel='9')
