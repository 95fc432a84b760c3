// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SiteSolver.h"

#include "BandCholesky.h"

#include <Eigen/SparseCholesky>

#include <optional>

namespace SeismicHorizons
{
namespace
{
using SparseMatrix = Eigen::SparseMatrix<double>;

// Multiplications up to which the band takes less time than a sparse method.
constexpr double MostBandWork = 5e6;

template <int Radius>
SparseMatrix ToSparse(const SiteSystem<Radius>& system)
{
  SparseMatrix result(Eigen::Index(system.Sites.Size()), Eigen::Index(system.Sites.Size()));
  result.reserve(Eigen::VectorXi::Constant(result.cols(), StencilMatrix<Radius>::Length / 2 + 1));
  for (std::size_t site = 0; site < system.Sites.Size(); ++site)
  {
    for (int n = StencilMatrix<Radius>::Centre; n < StencilMatrix<Radius>::Length; ++n)
    {
      const std::int32_t other = system.Sites.Number[std::size_t(system.Sites.Place[site] + system.Matrix.Step(n))];
      if (other != NoSite && system.Matrix[site][std::size_t(n)] != 0.0)
      {
        result.insert(other, Eigen::Index(site)) = system.Matrix[site][std::size_t(n)];
      }
    }
  }
  result.makeCompressed();
  return result;
}
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
struct SiteSolver<Radius>::Factors
{
  explicit Factors(const SiteSystem<Radius>& system)
  {
    const std::size_t width = BandWidth(system.Sites, Radius);
    if (double(system.Sites.Size()) * double(width) * double(width) <= MostBandWork)
    {
      this->Band.emplace(system.Sites, system.Matrix, width);
      return;
    }
    const SparseMatrix matrix = ToSparse(system);
    this->Sparse.emplace(matrix);
    this->IsSparseDefinite = this->Sparse->info() == Eigen::Success &&
      (this->Sparse->vectorD().array() > SmallestPivot * matrix.diagonal().maxCoeff()).all();
  }

  std::optional<BandCholesky> Band;
  std::optional<Eigen::SimplicialLDLT<SparseMatrix>> Sparse;
  bool IsSparseDefinite = false;
};

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
SiteSolver<Radius>::SiteSolver(const SiteSystem<Radius>& system)
{
  if (system.Sites.Size() < MultigridSize)
  {
    this->Direct = std::make_unique<Factors>(system);
  }
  else
  {
    this->Levels = std::make_unique<Multigrid<Radius>>(system.Sites, system.Matrix);
  }
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
SiteSolver<Radius>::~SiteSolver() = default;

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
bool SiteSolver<Radius>::IsDefinite() const
{
  return !this->Direct || (this->Direct->Band ? this->Direct->Band->IsDefinite() : this->Direct->IsSparseDefinite);
}

//----------------------------------------------------------------------------------------------------------------------
template <int Radius>
void SiteSolver<Radius>::Solve(std::vector<double>& values, const Monitor& monitor) const
{
  if (!this->Direct)
  {
    this->Levels->Solve(values, monitor);
  }
  else if (this->Direct->Band)
  {
    this->Direct->Band->Solve(values);
  }
  else
  {
    const Eigen::VectorXd solution =
      this->Direct->Sparse->solve(Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size())));
    values.assign(solution.begin(), solution.end());
  }
}

template class SiteSolver<1>;
template class SiteSolver<2>;
}
