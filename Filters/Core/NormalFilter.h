// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file NormalFilter.h
 * @brief The engine: robust weighted means of normals over a neighbourhood graph.
 *
 * Site i, a face or a point, gives its neighbours j, and itself if it counts among them, the
 * weights
 *
 *   w_ij = a_j f(|c_i - c_j|) g(x_ij).
 *
 * g is the weight function of an error norm, x_ij measures how much the normals differ, f is the
 * spatial kernel, a_j an area or another fixed factor. A sweep turns the weights into new normals,
 *
 *   average    n_i' = normalise( sum_j w_ij n_j )
 *   diffusion  n_i' = normalise( n_i + s / F_i  sum_j w_ij (n_j - n_i) ),   F_i = sum_j a_j f_ij
 *
 * and all methods are settings of it. Those that make something else of the weights visit them row
 * by row.
 *
 * The part a_j f stays the same while only normals change. It is computed once, so that a sweep
 * streams through two flat arrays. A sweep reads one field and writes another (Jacobi): the result
 * depends neither on the order of sites nor on the number of threads.
 */

#ifndef SurfaceDenoising_NormalFilter_h
#define SurfaceDenoising_NormalFilter_h

#include "ErrorNorm.h"
#include "NeighborGraph.h"

namespace SurfaceDenoising
{

/// x_ij, what an error norm is applied to.
enum class NormalArgument : int
{
  Chord,                ///< |n_i - n_j|, in [0, 2]
  Angle,                ///< angle between n_i and n_j in radians, in [0, pi]
  DirectionalCurvature, ///< angle / |c_i - c_j|, in radians per length
  NormalGradient,       ///< |n_i - n_j| / |c_i - c_j|, per length
  SiteCurvature,        ///< x belongs to a site, not to a pair: the weight is (g(x_i) + g(x_j)) / 2
  Height, ///< |n_i . (c_j - c_i)|, the distance of the neighbour from the plane, a length
  /// sqrt(s^2 + C kappa^2), a length: the arc from site to site and the bend along it, kappa = |n_i
  /// - n_j| / d and s = angle / kappa with d = |c_i - c_j|. M. K. Park et al. 2013.
  BentArc,
  NeighborHeight ///< |n_j . (c_j - c_i)|, the distance from the plane of the neighbour, a length
};

/// True if the argument has the unit of a curvature, 1 / length.
constexpr bool IsCurvature(NormalArgument argument)
{
  return argument == NormalArgument::DirectionalCurvature ||
    argument == NormalArgument::NormalGradient || argument == NormalArgument::SiteCurvature;
}

/// True if the argument is a length.
constexpr bool IsLength(NormalArgument argument)
{
  return argument == NormalArgument::Height || argument == NormalArgument::NeighborHeight ||
    argument == NormalArgument::BentArc;
}

/// a_j, the fixed weight of a neighbour.
enum class SiteWeight : int
{
  Uniform, ///< 1
  Area,    ///< the area of site j
  Coupling ///< c_ij = length of the wall between the sites / |c_i - c_j|: finite volumes
};

/// How weights become new normals.
enum class NormalStep : int
{
  Average,
  Diffusion
};

struct NormalFilterSettings
{
  ErrorNorm Norm = GaussianNorm{ 0.35 };
  NormalArgument Argument = NormalArgument::Chord;
  double SpatialSigma = 0.0; ///< f(d) = exp(-d^2 / (2 SpatialSigma^2)), a length; 0: f = 1
  SiteWeight Weighting = SiteWeight::Area;
  bool IncludeOwn = false; ///< site i is one of its own neighbours
  NormalStep Step = NormalStep::Average;
  double StepLength = 0.5;     ///< s of the diffusion, stable in [0, 1]
  bool TangentialFlux = false; ///< diffusion: only the part of the sum across n_i counts
  /// n and -n are the same normal: a neighbour's is taken with the sign that makes an acute angle
  /// with that of the site, in arguments as in sums.
  bool Unoriented = false;
  double BendFactor = 0.0; ///< C of BentArc, a length to the fourth power
  /// False: a_j f is computed again by every sweep. That takes less memory, and less time as well
  /// if there are only two sweeps.
  bool KeepFixedWeights = true;
};

/// Where sites are and how large they are.
struct SiteGeometry
{
  const Buffer<Vec3>& Positions;
  /// 0: degenerate, no weight whatever the weighting. Without any, all are 1.
  const Buffer<double>& Areas;
  double Shortest; ///< divisors are at least that; a length

  const Buffer<double>* SpatialSigmas = nullptr; ///< per site, instead of SpatialSigma
  const Buffer<double>* Couplings = nullptr;     ///< per entry of the graph, for Coupling
  const Buffer<double>* Curvatures = nullptr;    ///< per site, for SiteCurvature
  /// Per site: a factor for the scale of the norm, and for all lengths of BentArc: Shortest as
  /// well, and BendFactor by its fourth power. Must outlive the sweeps.
  const Buffer<double>* NormScaleFactors = nullptr;
  /// Per site: the place c_i that distances and heights are measured from, if that is not where the
  /// site is. The site itself then is as far away as it is. Must outlive the sweeps.
  const Buffer<Vec3>* Centres = nullptr;
};

class NormalFilter
{
public:
  /// The graph must outlive the filter.
  NormalFilter(const NeighborGraph& graph, const NormalFilterSettings& settings);

  /// To be called before sweeps, and again when sites moved. Heights are those of the positions
  /// given here, which must outlive the sweeps; so must everything given here, unchanged, if fixed
  /// weights are not kept.
  void SetGeometry(const SiteGeometry& geometry, Execution& execution);

  /// Another norm of another argument for the same geometry. Neither argument may be a curvature or
  /// a bent arc.
  void SetNorm(const ErrorNorm& norm, NormalArgument argument);

  /// The fields of normals that a sweep reads.
  struct Fields
  {
    const Buffer<Vec3>& Current;  ///< kept where there is nothing to average
    const Buffer<Vec3>& Centre;   ///< x_ij compares Centre[i] ...
    const Buffer<Vec3>& Compared; ///< ... with Compared[j]
    const Buffer<Vec3>& Data;     ///< what is averaged
  };

  /**
   * One sweep. Normals are unit vectors or zero. A site whose centre is zero has no opinion: all
   * its neighbours get the weight of x = 0. A site keeps its current normal if no neighbour has
   * weight or the weighted normals cancel; the number of such sites is returned. filtered must be
   * none of the fields.
   */
  std::size_t Sweep(const Fields& fields, Buffer<Vec3>& filtered, Execution& execution) const;

  /// The usual sweep: the current normals are centre, compared and averaged.
  std::size_t Sweep(const Buffer<Vec3>& current, Buffer<Vec3>& filtered, Execution& execution) const
  {
    return this->Sweep({ current, current, current, current }, filtered, execution);
  }

  /// From now on VisitWeights has the weights of these fields, whatever it is given: for sweeps
  /// that leave the fields as they are, and what the argument depends on.
  void FreezeWeights(const Fields& fields, Execution& execution);

  /**
   * Calls use(i, weights) for every site, on several threads at a time: the weight of the site
   * itself first, if it is included, then those of its row in the graph.
   */
  template <typename Use>
  void VisitWeights(const Fields& fields, Execution& execution, Use use) const
  {
    execution.For(this->Graph.NumberOfRows(),
      [&](std::size_t begin, std::size_t end)
      {
        Workspace work(this->Capacity);
        this->ForBlocks(begin, end,
          [&](const Block& block)
          {
            const double* known =
              this->WeightsOf(block, fields, this->FixedWeightsOf(block, work), work);
            for (std::size_t i = block.First; i < block.Last; ++i)
            {
              use(i, known + (this->EntryOf(i) - block.Entry));
            }
          });
      });
  }

  const NeighborGraph& Neighbors() const { return this->Graph; }
  bool IncludesOwn() const { return this->Settings.IncludeOwn; }

  /// Sums of weights below this are none: their squares would lose digits, and normals their
  /// length.
  static constexpr double NoWeight = 1e-140;

private:
  /// Rows [First, Last) of the graph; their entries begin at Entry in the arrays of fixed values.
  struct Block
  {
    std::size_t First;
    std::size_t Last;
    std::size_t Entry;
    std::size_t Count;
  };

  /// What a thread needs for a block.
  struct Workspace
  {
    explicit Workspace(std::size_t capacity)
      : Weights(capacity)
      , Fixed(capacity)
      , Squares(capacity)
    {
    }

    Buffer<double> Weights;
    Buffer<double> Fixed;
    Buffer<double> Squares;
  };

  /// Entries of row i, first the site itself if it is included, begin here.
  std::size_t EntryOf(std::size_t i) const
  {
    return this->Graph.Offsets[i] + (this->Settings.IncludeOwn ? i : 0);
  }

  /// True if the argument is one per distance.
  bool NeedsDistances() const
  {
    const NormalArgument argument = this->Settings.Argument;
    return argument == NormalArgument::DirectionalCurvature ||
      argument == NormalArgument::NormalGradient || argument == NormalArgument::BentArc;
  }

  /// Calls use(block) for rows [begin, end), cut into blocks that fit the capacity.
  template <typename Use>
  void ForBlocks(std::size_t begin, std::size_t end, Use use) const
  {
    for (std::size_t first = begin; first < end;)
    {
      const std::size_t entry = this->EntryOf(first);
      std::size_t last = first + 1;
      while (last < end && this->EntryOf(last + 1) - entry <= this->BlockEntries)
      {
        ++last;
      }
      use(Block{ first, last, entry, this->EntryOf(last) - entry });
      first = last;
    }
  }

  bool AllWeighOne() const;
  void ResizeFixedWeights();
  void SquareDistances(const Block& block, double* squares) const;
  bool ComputeFixedWeights(const Block& block, double* squares, double* fixed) const;
  void ComputeInverseDistances(const Block& block, double* squares);
  const double* FixedWeightsOf(const Block& block, Workspace& work) const;
  const double* WeightsOf(const Block& block, const Fields& fields, const double* fixed,
    Workspace& work) const;
  void ComputeWeights(const Block& block, const Fields& fields, const double* fixed,
    double* weights) const;

  const NeighborGraph& Graph;
  NormalFilterSettings Settings;
  std::size_t BlockEntries = 0; ///< entries of a block: some hundred, or those of the longest row
  std::size_t Capacity = 0;     ///< room for a block and what vectors read beyond it

  Buffer<double> FixedWeights; ///< a_j f; if they are frozen, all
  bool Kept = true;            ///< or computed when they are needed
  bool Frozen = false;
  Buffer<double> InverseSquaredDistances; ///< for curvatures along the line between two sites
  Buffer<double> SiteFactors;             ///< g(x_i), for SiteCurvature

  /// Of SetGeometry.
  const Buffer<double>* Areas = nullptr;
  double Shortest = 0.0;
  const Buffer<double>* SpatialSigmas = nullptr;
  const Buffer<double>* Couplings = nullptr;
  const Buffer<Vec3>* Positions = nullptr;
  const Buffer<Vec3>* Centres = nullptr;
  const Buffer<double>* NormScaleFactors = nullptr;
};

}

#endif
