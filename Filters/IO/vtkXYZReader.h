// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkXYZReader
 * @brief read a point cloud from a text with one point per line (.xyz, .xyzn, .pts, .asc)
 *
 * Each line holds the coordinates of a point and what else is known of it, in columns separated by
 * blanks, tabs, commas or semicolons. Lines that are blank and comments, from '#' or '//' to the
 * end of the line, are skipped. Before the first point there may be, in any order,
 * - a line with the number of points alone;
 * - a header: a line of words, or a comment, that names the columns. Words may be in double quotes.
 *
 * Columns are taken by their names if the header has x, y and z: nx, ny, nz (or normal_x, ...) are
 * normals, r, g, b (or red, ...) colors, i or intensity intensities. Small and capital letters are
 * the same. A line of other words is skipped. Columns without names are, by their number,
 *
 * | columns | meaning |
 * |---|---|
 * | 3 | x y z |
 * | 4 | x y z intensity |
 * | 6 | x y z and a normal or a color, see SixColumns |
 * | 7 | x y z intensity r g b |
 *
 * The output holds
 * - the points in double precision, whatever the precision of the file;
 * - one vertex cell per point, as vtkSimplePointsReader makes them: points are seen at once, and
 *   filters that pick cells, such as vtkThreshold, can pick points;
 * - normals as point normals "Normals", as long as they are in the file;
 * - colors as point scalars "RGB" of type unsigned char. They are numbers from 0 to 255; if none is
 *   above 1 and not all are whole, they are fractions and are multiplied by 255;
 * - intensities as the point array "Intensity", the scalars if there are no colors;
 * - other columns that a header names as point arrays of these names.
 *
 * Numbers have a decimal point and an exponent with e or E; the locale does not matter. "nan" and
 * "inf" are read as they are, in all columns but colors.
 *
 * A file that is missing, holds no point and does not announce 0 of them, has lines with different
 * numbers of columns, an empty column, a number of columns that has no meaning, more or fewer
 * points than it announces or something that is no number raises an error that names the line, sets
 * the error code and leaves the output empty. So do colors outside of 0 to 255 (the error names the
 * point, from 0 on), files of atoms, which chemists also name .xyz, and numbers with decimal
 * commas. An abort leaves the output empty without an error.
 *
 * @sa
 * vtkOFFReader
 */

#ifndef vtkXYZReader_h
#define vtkXYZReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkSurfaceDenoisingIOModule.h" // For export macro
#include "vtkWrappingHints.h"            // For VTK_FILEPATH

class VTKSURFACEDENOISINGIO_EXPORT vtkXYZReader : public vtkAbstractPolyDataReader
{
public:
  static vtkXYZReader* New();
  vtkTypeMacro(vtkXYZReader, vtkAbstractPolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the last three of six columns without names are.
  enum SixColumnsTypes
  {
    /**
     * Colors if all of them, in the whole file, are whole numbers from 0 to 255 and one at least
     * is above 1; else normals. So unit vectors along the axes and zeros are normals, and colors
     * in fractions are not recognized.
     */
    Automatic = 0,
    Normals, ///< always normals
    Colors   ///< always colors
  };

  ///@{
  /// Default: Automatic.
  vtkSetClampMacro(SixColumns, int, Automatic, Colors);
  vtkGetMacro(SixColumns, int);
  void SetSixColumnsToAutomatic() { this->SetSixColumns(Automatic); }
  void SetSixColumnsToNormals() { this->SetSixColumns(Normals); }
  void SetSixColumnsToColors() { this->SetSixColumns(Colors); }
  ///@}

  /**
   * Return 1 if the file begins like one that this class can read, up to the first point, else 0.
   * Raises no error.
   */
  static int CanReadFile(VTK_FILEPATH const char* filename);

protected:
  vtkXYZReader() = default;
  ~vtkXYZReader() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SixColumns = Automatic;

private:
  vtkXYZReader(const vtkXYZReader&) = delete;
  void operator=(const vtkXYZReader&) = delete;
};

#endif
