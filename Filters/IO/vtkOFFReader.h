// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOFFReader
 * @brief read a surface from an OFF file (Object File Format of Geomview)
 *
 * An OFF file holds a keyword, the numbers of vertices, faces and edges, then the vertices, then
 * the faces as corner counts followed by vertex indices from 0 on. The reader understands the
 * keyword with the prefixes ST (texture coordinates), C (vertex colors) and N (vertex normals), in
 * ASCII and, after the word BINARY, in big-endian binary. In ASCII it forgives what is common in
 * practice: comments, blank lines, counts on the line of the keyword or glued to it, no edge count.
 *
 * The output holds
 * - the vertices as points in double precision, whatever the precision of the file;
 * - faces of three or more corners as polygons, of two as lines, of one as vertex cells; a file
 *   without faces gets one vertex cell per point, so that the points are seen;
 * - vertex normals (N) as point normals "Normals";
 * - vertex colors (C) as point scalars "Colors";
 * - texture coordinates (ST) as point texture coordinates "TextureCoordinates";
 * - face colors as cell scalars "Colors", if all faces have equally many components.
 *
 * Three or four color components become unsigned char; components written as fractions in [0, 1]
 * are multiplied by 255. A single component is an index into a color map and becomes an int.
 *
 * A file that is missing, is no OFF file, ends early, announces more elements than it has room for,
 * refers to a vertex that does not exist or holds something that is no finite number raises an
 * error that names the line (or the byte, in binary), sets the error code and leaves the output
 * empty. An abort leaves the output empty without an error.
 *
 * @warning
 * Four-dimensional and n-dimensional files (4OFF, nOFF) are refused.
 */

#ifndef vtkOFFReader_h
#define vtkOFFReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkSurfaceDenoisingIOModule.h" // For export macro
#include "vtkWrappingHints.h"            // For VTK_FILEPATH

class VTKSURFACEDENOISINGIO_EXPORT vtkOFFReader : public vtkAbstractPolyDataReader
{
public:
  static vtkOFFReader* New();
  vtkTypeMacro(vtkOFFReader, vtkAbstractPolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Return 1 if the file begins like an OFF file that this class can read, else 0. Looks at the
   * keyword only and raises no error.
   */
  static int CanReadFile(VTK_FILEPATH const char* filename);

protected:
  vtkOFFReader() = default;
  ~vtkOFFReader() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOFFReader(const vtkOFFReader&) = delete;
  void operator=(const vtkOFFReader&) = delete;
};

#endif
