// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkPointDenoisingFilter
 * @brief   base of all filters that remove noise from a point set
 *
 * This class holds what all such filters share: the way of the points in and out, the normals to
 * start with, threads, and the report. Subclasses say where the points go.
 *
 * The input is the points of a polydata, whether cells use them or not. All cells and arrays pass
 * through: a mesh keeps its polygons, and its points are denoised without them (but they tell on
 * which side of the surface is outside, if there are no point normals). The output has
 * - the point normals "Normals" (double, unit length, zero where there is none), in place of the
 *   input's if they have this name;
 * - the point array "Displacement": how far each point moved;
 * - the point array "Status" of PointStatus;
 * - for methods that tell, the point array "FeatureClass" of FeatureClasses;
 * - the field array "DenoisingReport" with what was found and done, one tuple with named
 *   components.
 *
 * Normals to start with are those of the input, if there are any: the array that is named with
 * SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name), the active point
 * normals, or, without polygons and strips, a point array called "Normals" (on a surface, that is
 * what a filter left of the surface before). See NormalSource. Points with a zero or infinite
 * normal get one of a fit.
 *
 * Inputs that are not perfect: points with a NaN or infinite coordinate stay as they are and are
 * nobody's neighbours. Points stored twice are two points. A point with fewer than three
 * neighbours, or with neighbours at one place or on a line, stays where it is. All these are marked
 * in "Status". Ghost points (vtkGhostType) are treated as all others. An empty input passes
 * through; so does all of it if the user stops the filter. It is then without arrays with the names
 * of those above but "Normals", which a filter before has added.
 *
 * Where a property says "0: from the data", the value is chosen in each execution: the one that
 * promises the smallest distance from the surface, by Stein's unbiased risk estimate, for the noise
 * that the points have. Several open properties are chosen together. Values are tried on some parts
 * of the cloud, which takes about a second. Points without noise stay, with a warning.
 *
 * Results are the same on any number of threads and in any order of the points. Lengths are
 * relative to the model, in mean spacings: the median over the points of r sqrt(pi / 16), where r
 * is the distance of the 16th nearest point; the spacing of a square grid with as many points per
 * area.
 */

#ifndef vtkPointDenoisingFilter_h
#define vtkPointDenoisingFilter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSurfaceDenoisingPointsModule.h" // for export macro

#include <memory> // for the settings that the data choose

namespace SurfaceDenoising
{
enum class PointMethod : int;
struct PointDenoisingReport;
struct PointDenoisingSettings;
struct PointView;
class DenoisingReport;
class Execution;
class OpenSettings;
}

class VTKSURFACEDENOISINGPOINTS_EXPORT vtkPointDenoisingFilter : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkPointDenoisingFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the normals come from that a method starts with.
  enum NormalSources
  {
    AUTOMATIC = 0, ///< the input's, if it has any; else ROBUST_FIT
    INPUT = 1,     ///< the input's, or those of its polygons; without any it is an error
    PLANE_FIT = 2, ///< of the plane that fits the nearest points best (Hoppe et al. 1992)
    ROBUST_FIT = 3 ///< the same with points on other planes left out: sharp at edges
  };

  /// What is done about the signs of normals.
  enum NormalOrientations
  {
    AUTOMATIC_ORIENTATION = 0, ///< SPANNING_TREE, unless normals of the input agree with their
                               ///< neighbours already
    KEEP_ORIENTATION = 1,      ///< signs as they come; those of fits are arbitrary
    SPANNING_TREE = 2          ///< neighbours agree along a minimum spanning tree, outwards
  };

  /// Values of the array "Status".
  enum PointStatus
  {
    FILTERED = 0,
    KEPT = 1,      ///< too few neighbours, no weight, or moved too far: left as it was
    NOT_FINITE = 2 ///< a coordinate is not a finite number
  };

  /// Values of the array "FeatureClass".
  enum FeatureClasses
  {
    FLAT = 0,
    EDGE = 1,
    CORNER = 2
  };

  ///@{
  /// Where normals come from, one of NormalSources. Default AUTOMATIC.
  vtkSetClampMacro(NormalSource, int, AUTOMATIC, ROBUST_FIT);
  vtkGetMacro(NormalSource, int);
  void SetNormalSourceToAutomatic() { this->SetNormalSource(AUTOMATIC); }
  void SetNormalSourceToInput() { this->SetNormalSource(INPUT); }
  void SetNormalSourceToPlaneFit() { this->SetNormalSource(PLANE_FIT); }
  void SetNormalSourceToRobustFit() { this->SetNormalSource(ROBUST_FIT); }
  ///@}

  ///@{
  /// What is done about signs, one of NormalOrientations. Default AUTOMATIC_ORIENTATION.
  vtkSetClampMacro(NormalOrientation, int, AUTOMATIC_ORIENTATION, SPANNING_TREE);
  vtkGetMacro(NormalOrientation, int);
  void SetNormalOrientationToAutomatic() { this->SetNormalOrientation(AUTOMATIC_ORIENTATION); }
  void SetNormalOrientationToKeep() { this->SetNormalOrientation(KEEP_ORIENTATION); }
  void SetNormalOrientationToSpanningTree() { this->SetNormalOrientation(SPANNING_TREE); }
  ///@}

  ///@{
  /// How many nearest points fits of normals look at, at least 3. Default 16, or 24 of methods that
  /// filter these normals. 30 to 40 for noise of half a spacing, 80 for noise of a whole one: with
  /// too few, edges are lost from the start. 0: from the data.
  vtkSetClampMacro(NumberOfNormalNeighbors, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfNormalNeighbors, int);
  ///@}

  ///@{
  /**
   * How often the method runs; every outer iteration goes on from the points and normals of the one
   * before. The default is that of the method. More remove more noise. 0: from the data;
   * -1: none, the normals are oriented and the points stay.
   */
  vtkSetClampMacro(NumberOfOuterIterations, int, -1, VTK_INT_MAX);
  vtkGetMacro(NumberOfOuterIterations, int);
  ///@}

  ///@{
  /**
   * End the outer iterations as soon as the points moved as far along their normals as the noise
   * that they have (standard deviation, told from medians): the number of iterations is then the
   * most there may be. Points without noise stay. Default off.
   */
  vtkSetMacro(StopAtNoise, bool);
  vtkGetMacro(StopAtNoise, bool);
  vtkBooleanMacro(StopAtNoise, bool);
  ///@}

  ///@{
  /**
   * How far a point may end up from where it was, in mean spacings. A step that leads farther is
   * not taken, and the point is marked as KEPT. 0: as far as it goes. The default is that of the
   * method.
   */
  vtkSetClampMacro(MaximumDisplacement, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDisplacement, double);
  ///@}

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
   * What the last execution found and did: the mean spacing in the units of the model, points that
   * could not be filtered in the last iteration, points that are not finite, normals that were
   * fitted, and connected parts of the spanning tree (0 if there was none). The same figures are
   * components of the field array "DenoisingReport".
   */
  vtkGetMacro(MeanSpacing, double);
  vtkGetMacro(NumberOfKeptPoints, vtkIdType);
  vtkGetMacro(NumberOfPointsNotFinite, vtkIdType);
  vtkGetMacro(NumberOfFittedNormals, vtkIdType);
  vtkGetMacro(NumberOfParts, vtkIdType);
  ///@}

  /**
   * The value that the last execution chose for a property that was 0, by its name, say
   * "NumberOfNeighbors"; NaN for the others and before. The same figures are components of the
   * field array "DenoisingReport", for example "Chosen NumberOfNeighbors".
   */
  double GetChosenValue(const char* property) const;

protected:
  /// Defaults are the settings, which must outlive the filter.
  explicit vtkPointDenoisingFilter(const SurfaceDenoising::PointDenoisingSettings& defaults);

  /// Defaults are those of a method in the table of methods.
  explicit vtkPointDenoisingFilter(SurfaceDenoising::PointMethod method);

  ~vtkPointDenoisingFilter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Figures of the last execution become those of points nobody has looked at.
  void ForgetReport();

  /// Subclasses complete the settings, which are the defaults with the members of the bases.
  virtual void Configure(SurfaceDenoising::PointDenoisingSettings& settings);

  /// The way back: members get the values of the settings. Constructors call it, and so does who
  /// copies a method.
  virtual void TakeSettings(const SurfaceDenoising::PointDenoisingSettings& settings);

  /// True if the output has the array "FeatureClass" once points were filtered.
  virtual bool TellsClasses() const { return false; }

  /// Runs the method on the points. Returns false if the execution asked to stop.
  virtual bool Denoise(SurfaceDenoising::PointView& view,
    const SurfaceDenoising::PointDenoisingSettings& settings,
    SurfaceDenoising::PointDenoisingReport& report, SurfaceDenoising::Execution& execution);

  /// Subclasses that have more to tell take it from here, after an execution.
  virtual void TakeReport(const SurfaceDenoising::PointDenoisingReport& report);

  const SurfaceDenoising::PointDenoisingSettings& Defaults() const { return this->Standard; }

  /// A number as people write it: without the dust of conversions.
  static double Rounded(double value);

  /// A count of neighbours that means something; 0 stays.
  static int AtLeastThree(int count);

  /// The settings that the data choose in this execution. Subclasses take their properties there.
  std::unique_ptr<SurfaceDenoising::OpenSettings> Open;

  int NormalSource = AUTOMATIC;
  int NormalOrientation = AUTOMATIC_ORIENTATION;
  int NumberOfNormalNeighbors;
  int NumberOfOuterIterations;
  bool StopAtNoise = false;
  double MaximumDisplacement;
  int NumberOfThreads = 0;

  double MeanSpacing = 0.0;
  vtkIdType NumberOfKeptPoints = 0;
  vtkIdType NumberOfPointsNotFinite = 0;
  vtkIdType NumberOfFittedNormals = 0;
  vtkIdType NumberOfParts = 0;

private:
  vtkPointDenoisingFilter(const vtkPointDenoisingFilter&) = delete;
  void operator=(const vtkPointDenoisingFilter&) = delete;

  bool Process(vtkPolyData* input, vtkPolyData* output);
  void PassThrough(vtkPolyData* input, vtkPolyData* output) const;
  bool MeetNoise(const SurfaceDenoising::PointView& view,
    SurfaceDenoising::PointDenoisingSettings& settings, SurfaceDenoising::DenoisingReport& figures,
    SurfaceDenoising::Execution& execution);
  bool FindNormals(vtkPolyData* input, vtkDataArray*& normals);

  const SurfaceDenoising::PointDenoisingSettings& Standard;
};

#endif
