// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "AnisotropicCurvatureFlow.h"

#include "VertexRings.h"

#include <cmath>

namespace SurfaceDenoising
{

double AnisotropicWeight(double curvature, double lambda)
{
  constexpr double steepness = 10.0;
  const double excess = (std::abs(curvature) - lambda) / lambda;
  return excess > 0.0 ? 1.0 / (steepness * excess * excess + 1.0) : 1.0;
}

Vec3 AnisotropicCurvature(const TriangleMesh& mesh, Span<Index> star,
  const Buffer<Vec3>& faceNormals, Index v, double lambda, std::vector<CurvatureSpoke>& spokes)
{
  spokes.clear();
  auto add = [&spokes](Index vertex, const Vec3& n, double sign)
  {
    auto spoke = std::find_if(spokes.begin(), spokes.end(),
      [vertex](const CurvatureSpoke& s) { return s.Vertex == vertex; });
    if (spoke == spokes.end())
    {
      spoke = spokes.insert(spoke, { vertex, Vec3(0.0, 0.0, 0.0), 0.0, false });
    }
    spoke->NormalDifference += sign * n;
    spoke->Flat = spoke->Flat || n.squaredNorm() == 0.0;
  };
  for (const Index f : star)
  {
    const Triangle& t = mesh.Triangles[f];
    const int corner = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
    add(t[(corner + 1) % 3], faceNormals[f], -1.0);
    add(t[(corner + 2) % 3], faceNormals[f], 1.0);
  }

  Vec3 sum(0.0, 0.0, 0.0);
  for (CurvatureSpoke& spoke : spokes)
  {
    if (!spoke.Flat)
    {
      const Vec3 edge = mesh.Positions[spoke.Vertex] - mesh.Positions[v];
      spoke.Curvature = std::sqrt(spoke.NormalDifference.squaredNorm() * edge.squaredNorm());
      sum += AnisotropicWeight(spoke.Curvature, lambda) * spoke.NormalDifference.cross(edge);
    }
  }
  return 0.5 * sum;
}

namespace
{

/// Of the present positions; rings have each edge twice.
double MeanLength(const Buffer<Vec3>& positions, const CompressedRows& rings, Execution& execution)
{
  const double sum = OrderedSum(execution, positions.size(), 0.0,
    [&](std::size_t v)
    {
      double here = 0.0;
      for (const Index w : rings.Row(v))
      {
        here += (positions[w] - positions[v]).norm();
      }
      return here;
    });
  return sum / static_cast<double>(std::max<std::size_t>(1, rings.NumberOfIds()));
}

class Flow
{
public:
  Flow(PreparedMesh& prepared, const AnisotropicCurvatureFlowSettings& settings,
    Execution& execution)
    : Mesh(prepared.Mesh())
    , Stars(prepared.Stars())
    , Boundary(prepared.Edges().BoundaryVertex)
    , Settings(settings)
    , Exec(execution)
    , Rings(VertexRings(this->Mesh, this->Stars, execution))
    , Curvature(this->Mesh.NumberOfVertices())
    , Area(this->Mesh.NumberOfVertices())
  {
    if (settings.PrescribeCurvature)
    {
      this->Direction.resize(this->Mesh.NumberOfVertices());
      this->Prescribed.resize(this->Mesh.NumberOfVertices());
      this->Sort.resize(this->Mesh.NumberOfVertices());
    }
  }

  void Step()
  {
    const double length = MeanLength(this->Mesh.Positions, this->Rings, this->Exec);
    ComputeFaceGeometry(this->Mesh, length, this->Faces, this->Exec);
    this->FindCurvatures(this->Settings.EdgeThreshold * length);
    if (this->Settings.PrescribeCurvature)
    {
      this->Prescribe();
    }
    this->Move(this->Settings.TimeStep * length * length);
  }

private:
  enum VertexSort : unsigned char
  {
    Plain,
    Feature, ///< an edge has a weight below 1
    Ignored  ///< on the border or without area
  };

  /// The anisotropic curvature and the area of every vertex.
  void FindCurvatures(double lambda)
  {
    this->Exec.For(this->Mesh.NumberOfVertices(),
      [&](std::size_t begin, std::size_t end)
      {
        std::vector<CurvatureSpoke> spokes;
        for (std::size_t v = begin; v < end; ++v)
        {
          const Span<Index> star = this->Stars.Row(v);
          this->Area[v] = 0.0;
          for (const Index f : star)
          {
            this->Area[v] += this->Faces.Areas[f];
          }
          this->Curvature[v] = AnisotropicCurvature(this->Mesh, star, this->Faces.Normals,
            static_cast<Index>(v), lambda, spokes);
          if (this->Settings.PrescribeCurvature)
          {
            const bool feature = std::any_of(spokes.begin(), spokes.end(),
              [lambda](const CurvatureSpoke& spoke) { return spoke.Curvature > lambda; });
            const bool ignored = this->Boundary[v] || !(this->Area[v] > 0.0);
            this->Sort[v] = ignored ? Ignored : (feature ? Feature : Plain);
          }
        }
      });
  }

  /// The directions V and curvatures f of all vertices.
  void Prescribe()
  {
    this->Exec.For(this->Mesh.NumberOfVertices(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          Vec3 direction(0.0, 0.0, 0.0);
          for (const Index f : this->Stars.Row(v))
          {
            direction += this->Faces.Areas[f] / 3.0 * this->Faces.Normals[f];
          }
          if (this->Sort[v] == Feature)
          {
            const Vec3 across = this->Curvature[v] + this->FeatureMean(v);
            const double length = std::copysign(across.norm(), across.dot(direction));
            if (length != 0.0)
            {
              direction = direction.norm() / length * across;
            }
          }
          const double square = direction.squaredNorm();
          this->Direction[v] = direction;
          this->Prescribed[v] = square > 0.0 ? this->Curvature[v].dot(direction) / square : 0.0;
        }
      });
  }

  /// The mean curvature vector of the neighbours that are features.
  Vec3 FeatureMean(std::size_t v) const
  {
    Vec3 sum(0.0, 0.0, 0.0);
    double count = 0.0;
    for (const Index w : this->Rings.Row(v))
    {
      if (this->Sort[w] == Feature)
      {
        sum += this->Curvature[w];
        count += 1.0;
      }
    }
    return sum / std::max(1.0, count);
  }

  /// f V with f averaged over the ring, of features over features only.
  Vec3 PrescribedCurvature(std::size_t v) const
  {
    double sum = this->Prescribed[v];
    double count = 1.0;
    for (const Index w : this->Rings.Row(v))
    {
      if (this->Sort[w] != Ignored && (this->Sort[v] == Plain || this->Sort[w] == Feature))
      {
        sum += this->Prescribed[w];
        count += 1.0;
      }
    }
    return sum / count * this->Direction[v];
  }

  void Move(double dt)
  {
    this->Exec.For(this->Mesh.NumberOfVertices(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = begin; v < end; ++v)
        {
          if ((this->Settings.FixBoundary && this->Boundary[v]) || !(this->Area[v] > 0.0))
          {
            continue;
          }
          Vec3 gradient = this->Curvature[v];
          if (this->Settings.PrescribeCurvature && this->Sort[v] != Ignored)
          {
            gradient -= this->PrescribedCurvature(v);
          }
          this->Mesh.Positions[v] -=
            std::min(3.0 * dt / this->Area[v], this->Settings.MaximumRate) * gradient;
        }
      });
  }

  TriangleMesh& Mesh;
  const CompressedRows& Stars;
  const Buffer<unsigned char>& Boundary;
  const AnisotropicCurvatureFlowSettings& Settings;
  Execution& Exec;
  const CompressedRows Rings;
  FaceGeometry Faces;
  Buffer<Vec3> Curvature; ///< HA
  Buffer<double> Area;    ///< of the faces around the vertex
  // With prescribed curvature only:
  Buffer<Vec3> Direction;    ///< V
  Buffer<double> Prescribed; ///< f before the average
  Buffer<VertexSort> Sort;
};

}

bool FlowByAnisotropicCurvature(PreparedMesh& prepared,
  const AnisotropicCurvatureFlowSettings& settings, Execution& execution)
{
  if (settings.Steps <= 0)
  {
    return true;
  }
  Flow flow(prepared, settings, execution);
  for (int step = 0; step < settings.Steps; ++step)
  {
    if (!execution.Proceed(0.03 + 0.97 * step / settings.Steps))
    {
      return false;
    }
    flow.Step();
  }
  return execution.Proceed(1.0);
}

}
