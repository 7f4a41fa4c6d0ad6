"""Scenes as VTK writes them. Usage: with_vtk.py FOLDER"""
import os
import sys

import vtk

os.chdir(sys.argv[1])


def export(name, *sources, opacity=1.0):
    renderer = vtk.vtkRenderer()
    for i, source in enumerate(sources):
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(1.2 * i, 0, 0)
        actor.GetProperty().SetColor(.9, .4 + .2 * i, .2)
        actor.GetProperty().SetSpecular(.4)
        actor.GetProperty().SetOpacity(opacity)
        renderer.AddActor(actor)
    renderer.SetBackground(.1, .2, .3)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(160, 120)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    exporter = vtk.vtkPOVExporter()
    exporter.SetRenderWindow(window)
    exporter.SetFileName(f'vtk_{name}.pov')
    exporter.Write()


sphere, cone = vtk.vtkSphereSource(), vtk.vtkConeSource()
sphere.SetThetaResolution(24)
sphere.SetPhiResolution(16)
cone.SetResolution(20)
export('shapes', sphere, cone, vtk.vtkCubeSource())
export('glass', sphere, cone, opacity=.5)
