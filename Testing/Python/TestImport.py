# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package gives every class of every wrapped module, and they work beside vtkmodules."""

import surfacedenoising
from surfacedenoising import vtkOFFReader
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

classes = [name for name in dir(surfacedenoising) if name.startswith("vtk") and
           isinstance(getattr(surfacedenoising, name), type)]
assert "vtkOFFReader" in classes and "vtkXYZReader" in classes, classes
assert "vtkDenoisingMethods" in classes and "vtkPointDenoisingMethods" in classes, classes
for name in classes:
    cls = getattr(surfacedenoising, name)
    assert issubclass(cls, vtkAlgorithm) or name.endswith("DenoisingMethods"), name
    try:
        assert cls().GetClassName() == name, name
    except TypeError as error:
        assert "abstract" in str(error), error

methods = surfacedenoising.vtkPointDenoisingMethods
for i in range(methods.GetNumberOfMethods()):
    made = methods.NewFilter(i)
    assert made.GetClassName() == "vtk" + methods.GetFilter(i), methods.GetName(i)
    assert made.GetReferenceCount() == 1, methods.GetName(i)
assert methods.NewFilter(-1) is None

assert vtkOFFReader is surfacedenoising.vtkOFFReader
assert surfacedenoising.__version__.count(".") == 2, surfacedenoising.__version__
