// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// What published methods add to the weights, worked out by hand on the four faces.

#include "FourFaces.h"
#include "NormalMedian.h"
#include "PatchGuidance.h"
#include "VotingTensor.h"

namespace
{

/// A triangle with the given number of flaps at its edges, one more face each.
TriangleMesh Flaps(int count)
{
  TriangleMesh mesh;
  mesh.Positions = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0),
    Vec3(-1, 1, 0) };
  const Triangle flaps[] = { { 1, 0, 3 }, { 2, 1, 4 }, { 0, 2, 5 } };
  mesh.Triangles = { { 0, 1, 2 } };
  mesh.Triangles.insert(mesh.Triangles.end(), flaps, flaps + count);
  return mesh;
}

}

// Belyaev, Ohtake 2001 is in TestWorkedNumbers.cxx: directional curvature.

TEST_F(FourFaces, AngularMedian)
{
  Execution serial;
  Buffer<Vec3> medians;
  const TriangleMesh mesh = Flaps(3);
  EXPECT_EQ(AngularMedians(this->Graph, mesh, {}, this->Normals, medians, serial), 3u);
  EXPECT_EQ(medians[0], this->Normals[2]); // 10, 20, 90 degrees
  EXPECT_EQ(medians[1], this->Normals[1]); // no neighbours

  // An even number has a lower middle; what counts twice moves it.
  this->Graph.Offsets = { 0, 2, 2, 2, 2 };
  AngularMedians(this->Graph, mesh, {}, this->Normals, medians, serial);
  EXPECT_EQ(medians[0], this->Normals[1]);
  this->Graph.Offsets = { 0, 3, 3, 3, 3 };
  AngularMedians(this->Graph, mesh, { 0, 1 }, this->Normals, medians, serial);
  EXPECT_EQ(medians[0], this->Normals[0]); // all share an edge and do not count: it stays
}

TEST_F(FourFaces, DirectionalMedian)
{
  Execution serial;
  Buffer<Vec3> medians;
  // Sums of angles: 2.094395, 1.959459, 2.308525, 4.537856.
  DirectionalMedians(this->Graph, this->Normals, medians, serial);
  EXPECT_EQ(medians[0], this->Normals[1]);
  EXPECT_EQ(medians[3], this->Normals[3]);
  this->Normals[1] = Vec3(0, 0, 0);
  DirectionalMedians(this->Graph, this->Normals, medians, serial);
  EXPECT_EQ(medians[0], this->Normals[0]); // 1.919862, against 1.919862 + ... of the others
  EXPECT_EQ(medians[1], Vec3(0, 0, 0));
}

TEST_F(FourFaces, FuzzyVectorMedian)
{
  Execution serial;
  Buffer<Vec3> medians;
  DirectionalMedians(this->Graph, this->Normals, medians, serial);
  const std::pair<double, Vec3> rows[] = { { 0.35 / std::sqrt(2.0),
                                             Vec3(0.084580, 0.049296, 0.995196) },
    { 0.35, Vec3(0.073056, 0.077748, 0.994293) } };
  for (const auto& row : rows)
  {
    this->Settings.Norm = GaussianNorm{ row.first };
    this->Settings.Weighting = SiteWeight::Uniform;
    this->Settings.IncludeOwn = true;
    NormalFilter filter(this->Graph, this->Settings);
    filter.SetGeometry({ this->Centroids, this->Areas, 1e-12 }, serial);
    Buffer<Vec3> filtered;
    filter.Sweep({ this->Normals, medians, this->Normals, this->Normals }, filtered, serial);
    EXPECT_LT((filtered[0] - row.second).cwiseAbs().maxCoeff(), Digits);
  }
}

TEST_F(FourFaces, VotingTensor)
{
  Execution serial;
  Buffer<Vec3> filtered;
  auto vote = [&]
  {
    NormalFilter filter(this->Graph, this->Settings);
    filter.SetGeometry({ this->Centroids, this->Areas, 1e-12 }, serial);
    const NormalFilter::Fields fields{ this->Normals, this->Normals, this->Normals, this->Normals };
    VoteOnNormals(filter, fields, this->Centroids, { 0.3, 3.0, false }, filtered, serial);
    return filtered[0];
  };
  this->Settings.Norm = BoxNorm{ 0.8 };
  this->Settings.Argument = NormalArgument::Angle;
  this->Settings.IncludeOwn = true;
  EXPECT_LT((vote() - Vec3(0.011176, 0.043213, 0.999003)).cwiseAbs().maxCoeff(), Digits);
  // With all votes alike it is an edge.
  this->Settings.Norm = L2Norm{ 1.0 };
  this->Settings.Weighting = SiteWeight::Uniform;
  EXPECT_LT((vote() - Vec3(0.000611, 0.028971, 0.999580)).cwiseAbs().maxCoeff(), Digits);
}

TEST_F(FourFaces, RotatedVotesOfACircleAreOne)
{
  Execution serial;
  // Two sites on the unit circle: the vote of the second, turned along the arc, is the normal of
  // the first.
  this->Graph.Offsets = { 0, 1, 1 };
  this->Graph.Ids = { 1 };
  this->Normals = { Vec3(1, 0, 0), Vec3(std::cos(0.3), std::sin(0.3), 0) };
  this->Centroids = this->Normals;
  this->Areas = { 1.0, 1.0 };
  this->Settings.Norm = L2Norm{ 1.0 };
  NormalFilter filter(this->Graph, this->Settings);
  filter.SetGeometry({ this->Centroids, this->Areas, 1e-12 }, serial);
  const NormalFilter::Fields fields{ this->Normals, this->Normals, this->Normals, this->Normals };
  Buffer<Vec3> filtered;
  VoteOnNormals(filter, fields, this->Centroids, { 0.3, 0.0, true }, filtered, serial);
  EXPECT_LT((filtered[0] - this->Normals[0]).norm(), 1e-15);
  VoteOnNormals(filter, fields, this->Centroids, { 0.3, 0.0, false }, filtered, serial);
  EXPECT_LT((filtered[0] - this->Normals[1]).norm(), 1e-15);
}

// Tasdizen et al.: conductance of the gradient, edge lengths of 1 over distances as couplings.
TEST_F(FourFaces, CurvatureDiffusion)
{
  Execution serial;
  this->Settings.Norm = GaussianNorm{ 0.5 / std::sqrt(2.0) };
  this->Settings.Argument = NormalArgument::NormalGradient;
  this->Settings.Weighting = SiteWeight::Coupling;
  this->Settings.Step = NormalStep::Diffusion;
  this->Settings.TangentialFlux = true;
  const Buffer<double> couplings = { 1.0, 1.0, std::sqrt(2.0) };
  const std::pair<double, Vec3> rows[] = { { 0.5, Vec3(0.022503, 0.030895, 0.999269) },
    { 0.1 * 3.414214, Vec3(0.015372, 0.021104, 0.999659) } };
  for (const auto& row : rows)
  {
    this->Settings.StepLength = row.first;
    NormalFilter filter(this->Graph, this->Settings);
    SiteGeometry geometry{ this->Centroids, this->Areas, 1e-12 };
    geometry.Couplings = &couplings;
    filter.SetGeometry(geometry, serial);
    Buffer<Vec3> filtered;
    EXPECT_EQ(filter.Sweep(this->Normals, filtered, serial), 3u); // those without neighbours
    EXPECT_LT((filtered[0] - row.second).cwiseAbs().maxCoeff(), Digits);
  }
}

// Centin, Signoroni: the weight of a pair is the mean of the weights of its faces.
TEST_F(FourFaces, DiffusionByFaceCurvature)
{
  Execution serial;
  this->Settings.Norm = CentinNorm{ 0.1 };
  this->Settings.Argument = NormalArgument::SiteCurvature;
  this->Settings.Step = NormalStep::Diffusion;
  this->Settings.StepLength = 0.5;
  const Buffer<double> curvatures = { 0.05, 0.05, 0.2, 0.6 };
  NormalFilter filter(this->Graph, this->Settings);
  SiteGeometry geometry{ this->Centroids, this->Areas, 1e-12 };
  geometry.Curvatures = &curvatures;
  filter.SetGeometry(geometry, serial);
  Buffer<Vec3> filtered;
  filter.Sweep(this->Normals, filtered, serial);
  EXPECT_LT((filtered[0] - Vec3(0.093313, 0.069092, 0.993237)).cwiseAbs().maxCoeff(), Digits);
}

// Yadav et al. 2018: a spatial width of its own for every face.
TEST_F(FourFaces, TukeyWithLocalWidths)
{
  Execution serial;
  this->Settings.Norm = TukeyNorm{ 0.5 };
  NormalFilter filter(this->Graph, this->Settings);
  const Buffer<double> widths = { 1.0, 7.0, 7.0, 7.0 };
  SiteGeometry geometry{ this->Centroids, this->Areas, 1e-12 };
  geometry.SpatialSigmas = &widths;
  filter.SetGeometry(geometry, serial);
  Buffer<Vec3> filtered;
  filter.Sweep(this->Normals, filtered, serial);
  EXPECT_LT((filtered[0] - Vec3(0.104397, 0.142739, 0.984239)).cwiseAbs().maxCoeff(), Digits);
}

// Zhang et al.: without the face across the edge, the patch is more consistent.
TEST_F(FourFaces, PatchGuidance)
{
  Execution serial;
  const std::pair<int, double> rows[] = { { 2, 0.257153 }, { 3, 1.033153 } };
  for (const auto& row : rows)
  {
    const TriangleMesh mesh = Flaps(row.first);
    const CompressedRows stars = VertexStars(mesh);
    const NeighborGraph beside = EdgeAdjacentFaces(mesh, stars, serial);
    const NeighborGraph around = VertexSharingFaces(mesh, stars, serial);
    PatchGuidance patches(mesh, beside, around, serial);
    const Buffer<Vec3> normals(this->Normals.begin(), this->Normals.begin() + row.first + 1);
    const Buffer<double> areas(this->Areas.begin(), this->Areas.begin() + row.first + 1);
    Buffer<Vec3> guidance;
    patches.Compute(normals, areas, guidance, serial);
    EXPECT_NEAR(patches.Inconsistencies()[0], row.second, Digits);
    if (row.first == 2)
    {
      EXPECT_LT((guidance[0] - Vec3(0.044207, 0.174140, 0.983728)).cwiseAbs().maxCoeff(), Digits);
    }
  }
}

TEST_F(FourFaces, PatchOfOneFaceIsNone)
{
  Execution serial;
  const TriangleMesh mesh = Flaps(0);
  const CompressedRows stars = VertexStars(mesh);
  const NeighborGraph beside = EdgeAdjacentFaces(mesh, stars, serial);
  const NeighborGraph around = VertexSharingFaces(mesh, stars, serial);
  PatchGuidance patches(mesh, beside, around, serial);
  Buffer<Vec3> guidance;
  patches.Compute({ Vec3(0, 1, 0) }, { 1.0 }, guidance, serial);
  EXPECT_EQ(guidance[0], Vec3(0, 1, 0));
  EXPECT_TRUE(std::isinf(patches.Inconsistencies()[0]));
}
