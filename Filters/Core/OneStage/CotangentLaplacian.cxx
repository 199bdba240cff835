// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CotangentLaplacian.h"

#include "VertexRings.h"

namespace SurfaceDenoising
{

CotangentLaplacian::CotangentLaplacian(const TriangleMesh& mesh, const CompressedRows& stars,
  Execution& execution)
  : Mesh(mesh)
  , Stars(stars)
  , Rings(VertexRings(mesh, stars, execution))
  , Weights(this->Rings.NumberOfIds())
  , WeightSum(mesh.NumberOfVertices())
  , Mass(mesh.NumberOfVertices())
  , FaceAreas(mesh.NumberOfFaces())
  , HalfCotangents(mesh.NumberOfFaces())
{
}

void CotangentLaplacian::UpdateFaces(Execution& execution)
{
  // Holds cotangents below 5000. Angles below a hundredth of a degree mean nothing, but would make
  // the systems with this matrix hard to solve.
  constexpr double floor = 1e-4;
  execution.For(this->Mesh.NumberOfFaces(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        const Triangle& t = this->Mesh.Triangles[f];
        const Vec3 a = this->Mesh.Positions[t[2]] - this->Mesh.Positions[t[1]];
        const Vec3 b = this->Mesh.Positions[t[0]] - this->Mesh.Positions[t[2]];
        const Vec3 c = this->Mesh.Positions[t[1]] - this->Mesh.Positions[t[0]];
        const double doubleArea = b.cross(c).norm();
        const double squares = a.squaredNorm() + b.squaredNorm() + c.squaredNorm();
        const bool proper = t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && squares > 0.0;
        const double factor = proper ? -0.5 / std::max(doubleArea, floor * squares) : 0.0;
        this->HalfCotangents[f] = factor * Vec3(b.dot(c), c.dot(a), a.dot(b));
        this->FaceAreas[f] = 0.5 * doubleArea;
      }
    });
}

void CotangentLaplacian::Update(Execution& execution)
{
  this->UpdateFaces(execution);
  execution.For(this->Mesh.NumberOfVertices(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Span<Index> ring = this->Rings.Row(v);
        double* weights = this->Weights.data() + this->Rings.Offsets[v];
        std::fill(weights, weights + ring.size(), 0.0);
        double area = 0.0;
        double total = 0.0;
        // Faces come in the same order at both ends of an edge: the matrix is symmetric to the bit.
        for (const Index f : this->Stars.Row(v))
        {
          area += this->FaceAreas[f];
          const Triangle& t = this->Mesh.Triangles[f];
          const Vec3& cotangents = this->HalfCotangents[f];
          const int corner = t[0] == v ? 0 : (t[1] == v ? 1 : 2);
          const int next = (corner + 1) % 3;
          const int previous = (corner + 2) % 3;
          for (const auto& side :
            { std::make_pair(next, previous), std::make_pair(previous, next) })
          {
            if (t[side.first] != v)
            {
              weights[std::find(ring.begin(), ring.end(), t[side.first]) - ring.begin()] +=
                cotangents[side.second];
              total += cotangents[side.second];
            }
          }
        }
        this->WeightSum[v] = total;
        this->Mass[v] = area / 3.0;
      }
    });
}

}
