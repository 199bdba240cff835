// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkDenoiseSurface
 * @brief   removes the noise of a surface or a point cloud, with nothing to set
 *
 * The filter measures how noisy its input is, from the input alone, tries two dozen chains of
 * published methods on samples of it, and runs the one whose result is expected to be closest to
 * the surface without noise: sharp edges stay sharp, curved surfaces stay curved, and what is not
 * noisy stays as it is. Vertices and points that are far off the surface (impulsive noise,
 * outliers) are recognised and handled on their own. Strength is there for those who want more or
 * less than that.
 *
 * A surface with polygons or strips is denoised as a mesh, anything else as a point cloud by its
 * points. The cells, point, cell and field data of the input pass through; polygons that are not
 * triangles are cut for the work alone. Active normals of a mesh are no longer active, those of a
 * cloud are replaced. The output has besides
 *
 * - the point array "Displacement", a vector: where each point went;
 * - for clouds, the point arrays "Normals" and "Status", and "FeatureClass" if the method tells
 *   (see vtkPointDenoisingFilter);
 * - the field array "DenoisingReport", one tuple with named components: the noise that was found,
 *   and what was removed (mean, RMS and largest displacement; change of volume; feature edges
 *   before and after, flipped faces);
 * - the field array "DenoisingChoice", strings: the methods that were run, and why.
 *
 * Lengths in the report are relative to the input: in mean edge lengths for meshes, in mean
 * spacings for clouds.
 *
 * Results are the same on any number of threads. A mesh with a coordinate that is not finite is an
 * error; such points of a cloud stay as they are. Ghost cells and points (vtkGhostType) are treated
 * as all others. An empty input passes through; so does all of it if the user stops the filter. It
 * is then without arrays with the names of those above but "Normals", which a filter before has
 * added.
 *
 * How the choice is made for meshes: B. Efron, R. Tibshirani, "An Introduction to the Bootstrap",
 * 1993; C. Gourieroux, A. Monfort, E. Renault, "Indirect inference", Journal of Applied
 * Econometrics 8, 1993. For clouds: C. Stein, "Estimation of the mean of a multivariate normal
 * distribution", Annals of Statistics 9(6), 1981; S. Ramani, T. Blu, M. Unser, "Monte-Carlo SURE",
 * IEEE Trans. Image Processing 17(9), 2008. All of it is applied to normals here.
 */

#ifndef vtkDenoiseSurface_h
#define vtkDenoiseSurface_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSurfaceDenoisingAutomaticModule.h" // for export macro

#include <string>

namespace SurfaceDenoising
{
class DenoisingReport;
class Execution;
struct SurfaceChange;
}

class VTKSURFACEDENOISINGAUTOMATIC_EXPORT vtkDenoiseSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkDenoiseSurface* New();
  vtkTypeMacro(vtkDenoiseSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How much noise is assumed, relative to what was found: 1 (the default) trusts the estimate, 2
   * smooths more, 0.5 less, 0 does nothing. From 0 to 10.
   */
  vtkSetClampMacro(Strength, double, 0.0, 10.0);
  vtkGetMacro(Strength, double);
  ///@}

  /// What the surface is like.
  enum SurfaceTypes
  {
    ANY = 0,   ///< found out from the data
    SHARP = 1, ///< flat sides and sharp edges
    CURVED = 2 ///< curved, with detail but hardly an edge
  };

  ///@{
  /// Which methods may be chosen: those for any surface (the default), for sharp ones only, or for
  /// curved ones only. One of SurfaceTypes.
  vtkSetClampMacro(SurfaceType, int, ANY, CURVED);
  vtkGetMacro(SurfaceType, int);
  void SetSurfaceTypeToAny() { this->SetSurfaceType(ANY); }
  void SetSurfaceTypeToSharp() { this->SetSurfaceType(SHARP); }
  void SetSurfaceTypeToCurved() { this->SetSurfaceType(CURVED); }
  ///@}

  ///@{
  /// Denoise a surface by its points, as if it had no polygons: for polygons that say little about
  /// the surface. Default off.
  vtkSetMacro(PointsOnly, bool);
  vtkGetMacro(PointsOnly, bool);
  vtkBooleanMacro(PointsOnly, bool);
  ///@}

  ///@{
  /// The angle between the normals of two faces, in degrees, from which on the report counts their
  /// edge as a feature. Default 60.
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
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
  /// What the last execution found. The standard deviation of the noise along the normals, in mean
  /// edge lengths or spacings.
  vtkGetMacro(NoiseLevel, double);
  /// Points that are far off the surface: spikes of a mesh that were repaired, outliers of a cloud.
  vtkGetMacro(NumberOfOutliers, vtkIdType);
  /// The methods that were run, "None" if there was nothing to do.
  vtkGetMacro(ChosenMethods, std::string);
  /// Why: a sentence.
  vtkGetMacro(Reason, std::string);
  ///@}

  ///@{
  /// What the last execution did. Displacements are in mean edge lengths or spacings.
  vtkGetMacro(MeanDisplacement, double);
  vtkGetMacro(MaximumDisplacement, double);
  /// Relative to the volume before; NaN if the surface is not closed.
  vtkGetMacro(VolumeChange, double);
  vtkGetMacro(NumberOfFeatureEdgesBefore, vtkIdType);
  vtkGetMacro(NumberOfFeatureEdgesAfter, vtkIdType);
  /// Faces whose normals turned by more than 90 degrees.
  vtkGetMacro(NumberOfFlippedFaces, vtkIdType);
  ///@}

protected:
  vtkDenoiseSurface();
  ~vtkDenoiseSurface() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Strength = 1.0;
  int SurfaceType = ANY;
  bool PointsOnly = false;
  double FeatureAngle = 60.0;
  int NumberOfThreads = 0;

  double NoiseLevel = 0.0;
  vtkIdType NumberOfOutliers = 0;
  std::string ChosenMethods;
  std::string Reason;
  double MeanDisplacement = 0.0;
  double MaximumDisplacement = 0.0;
  double VolumeChange = 0.0;
  vtkIdType NumberOfFeatureEdgesBefore = 0;
  vtkIdType NumberOfFeatureEdgesAfter = 0;
  vtkIdType NumberOfFlippedFaces = 0;

private:
  vtkDenoiseSurface(const vtkDenoiseSurface&) = delete;
  void operator=(const vtkDenoiseSurface&) = delete;

  bool DenoiseMesh(vtkPolyData* input, vtkPolyData* output);
  bool DenoiseCloud(vtkPolyData* input, vtkPolyData* output);
  void ForgetReport();
  void Explain(const std::string& reason, std::size_t putBack);
  void TakeChange(const SurfaceDenoising::SurfaceChange& change,
    SurfaceDenoising::DenoisingReport& report);
  void WriteChoice(vtkPolyData* output) const;
};

#endif
