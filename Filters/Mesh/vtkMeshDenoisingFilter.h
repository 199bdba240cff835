// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkMeshDenoisingFilter
 * @brief   base of all filters that move the points of a surface to remove noise
 *
 * This class holds what all such filters share: the way of the surface in and out, threads, and the
 * report. Subclasses say where the points go.
 *
 * The input may have any polygons and triangle strips. Polygons with more than three points are cut
 * into triangles for the work, and the output has the original cells with their points moved. The
 * input's point, cell and field data pass through, and vertices and lines stay. Active normals stay
 * as arrays but are no longer active, because they describe the surface before the points moved.
 * What was found and done is the field array "DenoisingReport": one tuple with named components. If
 * nothing was done, because there are no polygons or the user stopped it, the input passes through
 * without such an array of a filter before.
 *
 * Inputs that are not perfect: faces that run against their neighbours are treated as if they did
 * not; boundary points stored several times at the same place (seams of texture charts, STL files)
 * move as one; edges with three or more faces connect all of them. Points without polygons never
 * move. A polygon with a NaN or infinite coordinate, or with a point that does not exist, is an
 * error, and the output is empty. A surface without polygons passes through with a warning. Ghost
 * cells and points (vtkGhostType) are treated as all others: pieces of a surface are to be merged
 * first, or each is denoised with borders of its own.
 *
 * Where a property says "0: from the data", the value is chosen in each execution: the one that
 * promises the smallest error of the normals, by Stein's unbiased risk estimate, for the noise that
 * the surface has. Several open properties are chosen together. Values are tried on the surface, or
 * on parts of a large one, which takes from a second to a minute for methods with many iterations.
 * A surface without noise passes through with a warning.
 *
 * Results are the same on any number of threads. Lengths are relative to the model, in mean edge
 * lengths where not said otherwise, so that the same settings serve models of any size.
 */

#ifndef vtkMeshDenoisingFilter_h
#define vtkMeshDenoisingFilter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSurfaceDenoisingMeshModule.h" // for export macro

#include <functional> // for what a method does to a mesh
#include <memory>     // for the settings that the data choose

namespace SurfaceDenoising
{
struct MeshFacts;
struct SurfaceWork;
struct TriangleMesh;
class Execution;
class OpenSettings;
}

class VTKSURFACEDENOISINGMESH_EXPORT vtkMeshDenoisingFilter : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkMeshDenoisingFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of threads, 0 (the default) for all that vtkSMPTools offers. If its backend is the
   * sequential one, as in many builds, standard threads are used for the time of the execution.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * What the last execution found; lengths in the units of the model. The same figures are
   * components of the field array "DenoisingReport".
   */
  vtkGetMacro(MeanEdgeLength, double);
  /// Triangles without area.
  vtkGetMacro(NumberOfDegenerateFaces, vtkIdType);
  vtkGetMacro(NumberOfBoundaryEdges, vtkIdType);
  vtkGetMacro(NumberOfNonManifoldEdges, vtkIdType);
  /// Points that were stored again at the place of another one and moved with it.
  vtkGetMacro(NumberOfSeamPoints, vtkIdType);
  /// Triangles that ran against their neighbours.
  vtkGetMacro(NumberOfTurnedFaces, vtkIdType);
  ///@}

  /**
   * The value that the last execution chose for a property that was 0, by its name, say
   * "RangeScale"; NaN for the others and before. The same figures are components of the field array
   * "DenoisingReport", for example "Chosen RangeScale".
   */
  double GetChosenValue(const char* property) const;

protected:
  vtkMeshDenoisingFilter();
  ~vtkMeshDenoisingFilter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// How the work of a subclass ended.
  enum Outcome
  {
    FINISHED,
    STOPPED, ///< on request: the input passes through
    FAILED   ///< with an error message: the output is empty
  };

  /// Subclasses move the vertices of work.View.Mesh and report. Not called without polygons.
  virtual Outcome Denoise(SurfaceDenoising::SurfaceWork& work) = 0;

  /// True if the output has the array "FilteredNormals".
  virtual bool FiltersNormals() const { return false; }

  /// Figures of the last execution become those of a surface nobody has looked at.
  virtual void ForgetReport();

  /// Keeps the facts and adds them to the figures of the work.
  void TakeFacts(const SurfaceDenoising::MeshFacts& facts, SurfaceDenoising::SurfaceWork* work);

  /// The settings that the data choose in this execution. Subclasses take their properties there.
  std::unique_ptr<SurfaceDenoising::OpenSettings> Open;

  /// Chooses them for what move does to a mesh. Returns FINISHED or STOPPED; noisy is false if
  /// there is no noise to choose for.
  Outcome ChooseSettings(SurfaceDenoising::SurfaceWork& work,
    const std::function<bool(SurfaceDenoising::TriangleMesh&, SurfaceDenoising::Execution&)>& move,
    bool& noisy);

  int NumberOfThreads = 0;

  double MeanEdgeLength = 0.0;
  vtkIdType NumberOfDegenerateFaces = 0;
  vtkIdType NumberOfBoundaryEdges = 0;
  vtkIdType NumberOfNonManifoldEdges = 0;
  vtkIdType NumberOfSeamPoints = 0;
  vtkIdType NumberOfTurnedFaces = 0;

private:
  vtkMeshDenoisingFilter(const vtkMeshDenoisingFilter&) = delete;
  void operator=(const vtkMeshDenoisingFilter&) = delete;

  bool Process(vtkPolyData* input, vtkPolyData* output);
  void PassThrough(vtkPolyData* input, vtkPolyData* output) const;
};

#endif
