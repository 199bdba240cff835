// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file TextbookInternals.h
 * @brief What the files of the textbook share, and no test needs.
 */

#ifndef TextbookInternals_h
#define TextbookInternals_h

#include "Textbook.h"

#include <map>
#include <utility>

namespace Textbook
{

using Edge = std::pair<int, int>; // smaller number first

/// The faces of every edge; a face that runs along an edge twice counts twice.
std::map<Edge, std::vector<int>> FacesOfEdges(const Mesh& mesh);

/// The faces of every point, each once.
std::vector<std::vector<int>> FacesOfPoints(const Mesh& mesh);

/// Points that share a face with the point, each once.
std::vector<std::vector<int>> Rings(const Mesh& mesh);

/// True for points that have faces and are not at a boundary.
std::vector<bool> MovingPoints(const Mesh& mesh);

/// Solves matrix * x = right for all three coordinates at once, by elimination.
std::vector<Vector> Solve(std::vector<std::vector<double>> matrix, std::vector<Vector> right);

/// What does not change while normals are filtered.
struct Surroundings
{
  Neighbors Averaged;
  Neighbors AtEdges;  // for what asks for them
  Neighbors AtPoints; // for patches
  std::vector<Vector> Centroids;
  std::vector<double> Areas;      // 0: degenerate
  std::vector<Vector> Normals;    // of the points, not filtered; zero: degenerate
  std::vector<double> Curvatures; // for the weights that look at them
  std::vector<double> SpatialSigmas;
  double NormScale = 0.0;
  double ShortestDistance = 0.0;
  const Mesh* Surface = nullptr;
};

/// The normals of one iteration: a weight compares Centres[i] with Compared[j].
struct Fields
{
  std::vector<Vector> Current;
  std::vector<Vector> Centres;
  std::vector<Vector> Compared;
  std::vector<Vector> Averaged;
};

/// The weight of a pair of faces is the product of both.
struct PairWeight
{
  double Fixed = 0.0; // by geometry
  double Range = 0.0; // by the norm
};

using Margins = std::vector<double>;

/// Face j must not be degenerate.
PairWeight WeightOf(const Surroundings& here, const Settings& settings, const Fields& fields, int i,
  int j, Margins& margins);

/// The mean curvature of every face, the mean of its corners.
std::vector<double> FaceCurvatures(const Mesh& mesh, const std::vector<Vector>& normals);

Fields LookAt(const Surroundings& here, const Settings& settings,
  const std::vector<Vector>& current, const std::vector<Vector>& original, Margins& margins);

using Filter = std::vector<Vector>(const Surroundings& here, const Settings& settings,
  const Fields& fields, Margins& margins);
Filter Average;
Filter Diffuse;
Filter SolveGlobally;
Filter SelectMedians;
Filter VoteByTensor;

}

#endif
