// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace SurfaceDenoising;

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

Execution Serial;

/// The box [0, x] x [0, y] x [0, z] of twelve triangles that look outwards.
TriangleMesh MakeBox(double x, double y, double z)
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Positions.push_back(Vec3(i & 1 ? x : 0.0, i & 2 ? y : 0.0, i & 4 ? z : 0.0));
  }
  for (const std::array<Index, 4>& q : { std::array<Index, 4>{ 0, 2, 3, 1 }, { 4, 5, 7, 6 },
         { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    mesh.Triangles.push_back({ q[0], q[1], q[2] });
    mesh.Triangles.push_back({ q[0], q[2], q[3] });
  }
  return mesh;
}

/// A strip of squares in z = 0, two triangles each; folding turns those from the fold on up the z
/// axis.
TriangleMesh MakeFoldedStrip(int squares, int fold)
{
  TriangleMesh mesh;
  for (int i = 0; i <= squares; ++i)
  {
    const double x = std::min(i, fold);
    const double z = std::max(i - fold, 0);
    mesh.Positions.push_back(Vec3(x, 0.0, z));
    mesh.Positions.push_back(Vec3(x, 1.0, z));
  }
  for (Index a = 0; a < 2 * static_cast<Index>(squares); a += 2)
  {
    mesh.Triangles.push_back({ a, a + 2, a + 3 });
    mesh.Triangles.push_back({ a, a + 3, a + 1 });
  }
  return mesh;
}

FaceGeometry Geometry(const TriangleMesh& mesh)
{
  FaceGeometry geometry;
  ComputeFaceGeometry(mesh, 1.0, geometry, Serial);
  return geometry;
}

EdgeCensus Census(const TriangleMesh& mesh)
{
  return TakeEdgeCensus(mesh, VertexStars(mesh), Serial);
}

Buffer<double> Values(std::initializer_list<double> values)
{
  return Buffer<double>(values.begin(), values.end());
}

}

TEST(Metrics, AngleBetween)
{
  const Vec3 x(1.0, 0.0, 0.0);
  EXPECT_EQ(AngleBetween(x, Vec3(5.0, 0.0, 0.0)), 0.0);
  EXPECT_DOUBLE_EQ(AngleBetween(x, Vec3(0.0, 2.0, 0.0)), 90.0);
  EXPECT_DOUBLE_EQ(AngleBetween(x, Vec3(-1.0, 0.0, 0.0)), 180.0);
  EXPECT_DOUBLE_EQ(AngleBetween(x, Vec3(1.0, 0.0, 1.0)), 45.0);
  const double tiny = 1e-9; // the cosine of such an angle is 1
  EXPECT_NEAR(AngleBetween(x, Vec3(1.0, tiny, 0.0)), tiny * 180.0 / std::acos(-1.0), 1e-20);
  EXPECT_TRUE(std::isnan(AngleBetween(x, Vec3(0.0, 0.0, 0.0))));
}

TEST(Metrics, Percentile)
{
  Buffer<double> values = Values({ 5.0, 1.0, 3.0, 2.0, 4.0 });
  EXPECT_EQ(Percentile(values, 0.0), 1.0);
  EXPECT_EQ(Percentile(values, 0.5), 3.0);
  EXPECT_EQ(Percentile(values, 1.0), 5.0);
  EXPECT_DOUBLE_EQ(Percentile(values, 0.95), 4.8); // position 3.8
  values = Values({ 1.0, 2.0 });
  EXPECT_DOUBLE_EQ(Percentile(values, 0.5), 1.5);
  values = Values({ 7.0 });
  EXPECT_EQ(Percentile(values, 0.95), 7.0);
  values.clear();
  EXPECT_TRUE(std::isnan(Percentile(values, 0.5)));
}

TEST(Metrics, SummarizeLeavesOutWhatIsNoNumber)
{
  const Statistics s =
    Summarize(Values({ 1.0, NotANumber, 3.0, 8.0 }), Values({ 1.0, 100.0, 2.0, 1.0 }), Serial);
  EXPECT_EQ(s.Count, 3u);
  EXPECT_DOUBLE_EQ(s.Mean, 4.0);
  EXPECT_DOUBLE_EQ(s.RootMeanSquare, std::sqrt(74.0 / 3.0));
  EXPECT_DOUBLE_EQ(s.Median, 3.0);
  EXPECT_DOUBLE_EQ(s.Percentile95, 7.5);
  EXPECT_DOUBLE_EQ(s.Maximum, 8.0);
  EXPECT_DOUBLE_EQ(s.WeightedMean, 15.0 / 4.0);
}

TEST(Metrics, SummarizeOfNothingIsUndefined)
{
  for (const Statistics& s :
    { Summarize({}, {}, Serial), Summarize(Values({ NotANumber }), {}, Serial) })
  {
    EXPECT_EQ(s.Count, 0u);
    EXPECT_TRUE(std::isnan(s.Mean));
    EXPECT_TRUE(std::isnan(s.RootMeanSquare));
    EXPECT_TRUE(std::isnan(s.Median));
    EXPECT_TRUE(std::isnan(s.Percentile95));
    EXPECT_TRUE(std::isnan(s.Maximum));
    EXPECT_TRUE(std::isnan(s.WeightedMean));
  }
}

TEST(Metrics, VolumeDoesNotDependOnThePosition)
{
  TriangleMesh box = MakeBox(2.0, 3.0, 4.0);
  EXPECT_DOUBLE_EQ(SignedVolume(box, Serial), 24.0);
  for (Vec3& p : box.Positions)
  {
    p += Vec3(1048576.0, -1048576.0, 1048576.0); // exact in double
  }
  EXPECT_DOUBLE_EQ(SignedVolume(box, Serial), 24.0);
  for (Triangle& t : box.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  EXPECT_DOUBLE_EQ(SignedVolume(box, Serial), -24.0);
}

TEST(Metrics, VolumeDoesNotKnowVerticesWithoutFaces)
{
  TriangleMesh box = MakeBox(2.0, 3.0, 4.0);
  box.Positions.insert(box.Positions.begin(), Vec3::Constant(NotANumber));
  for (Triangle& triangle : box.Triangles)
  {
    for (Index& v : triangle)
    {
      ++v;
    }
  }
  EXPECT_DOUBLE_EQ(SignedVolume(box, Serial), 24.0);
}

TEST(Metrics, IsClosed)
{
  TriangleMesh box = MakeBox(1.0, 1.0, 1.0);
  EXPECT_TRUE(IsClosed(Census(box)));
  std::swap(box.Triangles[3][0], box.Triangles[3][1]);
  EXPECT_FALSE(IsClosed(Census(box))) << "one face looks inwards";
  box.Triangles.erase(box.Triangles.begin() + 3);
  EXPECT_FALSE(IsClosed(Census(box))) << "one face is missing";
  EXPECT_FALSE(IsClosed(Census(TriangleMesh())));
}

TEST(Metrics, AreaWeightedDistanceWeighsVerticesByTheirFaces)
{
  // Two triangles of areas 1/2 and 3/2 with the edge 1-2 in common.
  TriangleMesh mesh;
  mesh.Positions.assign(
    { Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(2.0, 2.0, 0.0) });
  mesh.Triangles.assign({ Triangle{ 0, 1, 2 }, Triangle{ 2, 1, 3 } });
  const Buffer<double> areas = Geometry(mesh).Areas;
  ASSERT_DOUBLE_EQ(areas[0], 0.5);
  ASSERT_DOUBLE_EQ(areas[1], 1.5);

  EXPECT_DOUBLE_EQ(AreaWeightedDistance(mesh, areas, Values({ 3.0, 3.0, 3.0, 3.0 }), Serial), 3.0);
  // Vertex 0 has weight 1/2 of 3 * 2, vertex 1 has all 2 of 3 * 2.
  EXPECT_DOUBLE_EQ(AreaWeightedDistance(mesh, areas, Values({ 1.0, 0.0, 0.0, 0.0 }), Serial),
    std::sqrt(0.5 / 6.0));
  EXPECT_DOUBLE_EQ(AreaWeightedDistance(mesh, areas, Values({ 0.0, 1.0, 0.0, 0.0 }), Serial),
    std::sqrt(2.0 / 6.0));
  EXPECT_TRUE(std::isnan(AreaWeightedDistance(TriangleMesh(), {}, {}, Serial)));
}

TEST(Metrics, TriangleQuality)
{
  TriangleMesh mesh;
  mesh.Positions.assign({ Vec3(0.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0), Vec3(1.0, std::sqrt(3.0), 0.0),
    Vec3(0.0, 2.0, 0.0) });
  const double equilateral = 1.0 / std::sqrt(3.0);
  const double right = 1.0 / std::sqrt(2.0);

  mesh.Triangles.assign({ Triangle{ 0, 1, 2 } });
  EXPECT_DOUBLE_EQ(TriangleQuality(mesh, Geometry(mesh).Areas, Serial), equilateral);
  mesh.Triangles.assign({ Triangle{ 0, 1, 3 } });
  EXPECT_DOUBLE_EQ(TriangleQuality(mesh, Geometry(mesh).Areas, Serial), right);
  mesh.Triangles.assign({ Triangle{ 0, 1, 2 }, Triangle{ 0, 1, 3 }, Triangle{ 0, 1, 1 } });
  EXPECT_DOUBLE_EQ(TriangleQuality(mesh, Geometry(mesh).Areas, Serial),
    0.5 * (equilateral + right));
  mesh.Triangles.assign({ Triangle{ 0, 1, 1 } });
  EXPECT_TRUE(std::isnan(TriangleQuality(mesh, Geometry(mesh).Areas, Serial)));
}

TEST(Metrics, CompareFeatureEdges)
{
  auto folded = [](int fold) { return MakeFoldedStrip(3, fold); };
  const TriangleMesh flat = folded(3);
  const NeighborGraph edges = EdgeAdjacentFaces(flat, VertexStars(flat), Serial);
  auto compare = [&](int fold, int referenceFold, double angle)
  {
    return CompareFeatureEdges(edges, Geometry(folded(fold)).Normals,
      Geometry(folded(referenceFold)).Normals, angle, Serial);
  };
  auto expect = [](const FeatureAgreement& a, std::size_t reference, std::size_t found,
                  std::size_t missed, std::size_t invented)
  {
    EXPECT_EQ(a.Reference, reference);
    EXPECT_EQ(a.Found, found);
    EXPECT_EQ(a.Missed(), missed);
    EXPECT_EQ(a.Invented, invented);
  };
  expect(compare(1, 1, 70.0), 1, 1, 0, 0);
  expect(compare(3, 1, 70.0), 1, 0, 1, 0);
  expect(compare(2, 1, 70.0), 1, 0, 1, 1);
  expect(compare(1, 3, 70.0), 0, 0, 0, 1);
  expect(compare(1, 1, 91.0), 0, 0, 0, 0);
}

TEST(Metrics, FacesNearFeatures)
{
  auto near = [](const TriangleMesh& mesh, double angle, int rings)
  {
    const CompressedRows stars = VertexStars(mesh);
    const Buffer<unsigned char> marks = FacesNearFeatures(mesh, stars,
      EdgeAdjacentFaces(mesh, stars, Serial), Geometry(mesh).Normals, angle, rings, Serial);
    std::string text;
    for (const unsigned char mark : marks)
    {
      text += mark ? '+' : '.';
    }
    return text;
  };
  // Every ring is one more square on either side of the fold at 3.
  const TriangleMesh strip = MakeFoldedStrip(8, 3);
  EXPECT_EQ(near(strip, 70.0, 0), "................");
  EXPECT_EQ(near(strip, 70.0, 1), "....++++........");
  EXPECT_EQ(near(strip, 70.0, 2), "..++++++++......");
  EXPECT_EQ(near(strip, 70.0, 3), "++++++++++++....");
  EXPECT_EQ(near(strip, 70.0, 4), "++++++++++++++..");
  EXPECT_EQ(near(strip, 70.0, std::numeric_limits<int>::max()), "++++++++++++++++");
  EXPECT_EQ(near(strip, 91.0, 2), "................");
  EXPECT_EQ(near(MakeFoldedStrip(4, 4), 70.0, 9), "........") << "a boundary is no feature";
  EXPECT_EQ(near(MakeBox(1.0, 1.0, 1.0), 70.0, 1), "++++++++++++");
  EXPECT_EQ(near(TriangleMesh(), 70.0, 2), "");

  // A face without area is no end of a feature, but is near one if it touches one.
  TriangleMesh sliver = MakeFoldedStrip(2, 1);
  sliver.Triangles.push_back({ 2, 3, 3 });
  sliver.Triangles.push_back({ 4, 5, 5 });
  EXPECT_EQ(near(sliver, 70.0, 1), "+++++.");
}

TEST(Metrics, MeansByMark)
{
  auto marks = [](std::initializer_list<unsigned char> list)
  { return Buffer<unsigned char>(list.begin(), list.end()); };
  const Buffer<double> values = Values({ 1.0, NotANumber, 3.0, 8.0, NotANumber });
  DividedMean mean = MeansByMark(values, marks({ 1, 1, 1, 0, 0 }), Serial);
  EXPECT_DOUBLE_EQ(mean.Inside, 2.0);
  EXPECT_DOUBLE_EQ(mean.Outside, 8.0);
  mean = MeansByMark(values, marks({ 0, 1, 0, 0, 1 }), Serial);
  EXPECT_TRUE(std::isnan(mean.Inside));
  EXPECT_DOUBLE_EQ(mean.Outside, 4.0);
  mean = MeansByMark(values, marks({ 1, 1, 1, 1, 1 }), Serial);
  EXPECT_DOUBLE_EQ(mean.Inside, 4.0);
  EXPECT_TRUE(std::isnan(mean.Outside));
}
