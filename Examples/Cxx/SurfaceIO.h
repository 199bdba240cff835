// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file SurfaceIO.h
 * @brief Surfaces from and to files, by extension.
 */

#ifndef SurfaceIO_h
#define SurfaceIO_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

std::string ReadableExtensions();
std::string WritableExtensions();

bool CanWrite(const std::string& file);

/// Null if the file does not hold a surface; error then says why.
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& file, std::string& error);

/// False if the file could not be written; error then says why.
bool WriteSurface(vtkPolyData* surface, const std::string& file, std::string& error);

#endif
