// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NoisySurface.h
 * @brief The surface that benchmarks work on, in any size.
 */

#ifndef NoisySurface_h
#define NoisySurface_h

#include "TriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

/// A surface of triangles from an OFF file. Empty, after a message, if it cannot be read
/// or has other faces.
SurfaceDenoising::TriangleMesh ReadMesh(const char* file);

/// The OFF file that the environment variable SURFACE_DENOISING_BENCHMARK_MESH names. Empty if it
/// cannot be read.
SurfaceDenoising::TriangleMesh CleanMesh();

/// Cuts every triangle into k * k of the same shape.
SurfaceDenoising::TriangleMesh Subdivide(const SurfaceDenoising::TriangleMesh& coarse, int k);

/**
 * The clean mesh with every triangle cut into k * k and noise of 0.2 mean edge lengths in random
 * directions. If shuffled, points and triangles are in random order, otherwise in that of the file.
 * Empty if the file cannot be read.
 */
SurfaceDenoising::TriangleMesh NoisyMesh(int k, bool shuffled = false);

/// A surface with the points (double) and triangles of the mesh.
vtkSmartPointer<vtkPolyData> ToPolyData(const SurfaceDenoising::TriangleMesh& mesh);

#endif
