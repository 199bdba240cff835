// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NoisyCloud.h
 * @brief The points that benchmarks of point methods work on, in any number.
 */

#ifndef NoisyCloud_h
#define NoisyCloud_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

/**
 * So many points (double), evenly by area and triangle by triangle on the surface that CleanMesh()
 * (NoisySurface.h) reads, with noise of 0.3 spacings in random directions. The point normals are
 * those of the surface without noise, pointing outwards: as good as they can be, for methods that
 * need them. Null if there is no mesh.
 */
vtkSmartPointer<vtkPolyData> NoisyCloud(vtkIdType count);

/// The same points without the normals.
vtkSmartPointer<vtkPolyData> WithoutNormals(vtkPolyData* cloud);

#endif
